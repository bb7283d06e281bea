/// A target as libFuzzer drives it. CMakeLists.txt says how to build and run it.

#include <pthread.h>
#include <sanitizer/common_interface_defs.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/target.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maxSize);

namespace {

/// Work in a process apart may crash, and its parent says what that means. libFuzzer must not
/// report such crashes.
void dieWithoutReport() {
  for (const int fatal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL}) std::signal(fatal, SIG_DFL);
  __sanitizer_set_death_callback(nullptr);
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  return pthread_atfork(nullptr, nullptr, dieWithoutReport);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const delassus::test::Outcome outcome = delassus::test::target.ask(bytes);
  for (const std::string& fault : outcome.faults) std::fprintf(stderr, "%s\n", fault.c_str());
  if (!outcome.faults.empty()) std::abort();
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t maxSize, unsigned int number) {
  using delassus::test::target;
  delassus::Random random(number);
  if (size > 0 && delassus::test::chance(random, 0.5)) return LLVMFuzzerMutate(data, size, maxSize);
  const std::string bytes =
      size > 0 ? std::string(reinterpret_cast<const char*>(data), size) : target.seed(random);
  const std::string changed = target.mutated(bytes, random).substr(0, maxSize);
  std::copy(changed.begin(), changed.end(), data);
  return changed.size();
}
