#include "demos/report/memory_peak.h"

#include <malloc.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace demos::report {

namespace {

/// A line of Linux's /proc/self/status, in bytes.
double statusBytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word) {
    if (word != key + ":") continue;
    double kilobytes = 0;
    status >> kilobytes;
    return 1024 * kilobytes;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

void MemoryPeak::beforeGroup(const GroupInput&) {
  // Returns free memory to the system: otherwise its reuse would not be seen.
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";  // sets the high-water mark back to now
  before_ = statusBytes("VmRSS");
}

void MemoryPeak::afterGroup(const GroupInput&) {
  const double taken = statusBytes("VmHWM") - before_;
  peak_ = taken >= 0 ? std::max(peak_, taken) : taken;
}

}  // namespace demos::report
