#pragma once

namespace delassus::testing {

/// How often this thread has asked for memory; counted by allocation_test.cpp.
extern thread_local long allocations;

}  // namespace delassus::testing
