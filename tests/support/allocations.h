#pragma once

namespace delassus::test {

/// How often this thread has asked for memory; allocation_test.cpp counts.
extern thread_local long allocations;

}  // namespace delassus::test
