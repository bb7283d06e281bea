#pragma once

namespace delassus::test {

/// How often this thread has asked for memory; counted by allocation_test.cpp.
extern thread_local long allocations;

}  // namespace delassus::test
