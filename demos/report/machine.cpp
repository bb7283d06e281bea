#include "demos/report/machine.h"

#include <btBulletDynamicsCommon.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <Eigen/Core>
#include <ctime>
#include <fstream>

#include "demos/process/other_command.h"
#include "demos/subject.h"
#include "demos/table.h"

namespace demos::report {

namespace {

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  std::string line;
  while (std::getline(info, line))
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

std::string memory() {
  const double bytes = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));
  return shortNumber(bytes / double(1 << 30)) + " GiB";
}

std::string system() {
  utsname name{};
  uname(&name);
  return std::string(name.sysname) + " " + name.release + " " + name.machine;
}

/// The kind of build, as far as the compiler reveals its flags.
std::string buildKind() {
  std::string kind;
#ifdef __OPTIMIZE__
  kind += "optimised";
#else
  kind += "NOT OPTIMISED: times say nothing";
#endif
#ifdef NDEBUG
  kind += ", without assertions";
#else
  kind += ", with assertions";
#endif
#if defined(__AVX512F__)
  kind += ", AVX-512";
#elif defined(__AVX2__)
  kind += ", AVX2";
#elif defined(__SSE2__)
  kind += ", SSE2";
#endif
#ifdef __FAST_MATH__
  kind += ", fast-math";
#endif
  return kind;
}

std::string gnuplotVersion() {
  const CommandResult answer = callCommand({"gnuplot", "--version"});
  return answer.status == 0 ? answer.text.substr(0, answer.text.find('\n')) : "no gnuplot";
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  char date[32];
  std::strftime(date, sizeof date, "%Y-%m-%d", std::gmtime(&now));
  return date;
}

}  // namespace

std::string describeMachine() {
  const std::string eigen = std::to_string(EIGEN_WORLD_VERSION) + "." +
                            std::to_string(EIGEN_MAJOR_VERSION) + "." +
                            std::to_string(EIGEN_MINOR_VERSION);
  return "- " + processor() + ", " + std::to_string(sysconf(_SC_NPROCESSORS_ONLN)) + " cores, " +
         memory() + ", " + system() + "; every solver on one thread\n- built by " +
         "GCC-compatible " __VERSION__ ", " + buildKind() + "; Bullet " +
         std::to_string(btGetVersion()) + " in " + precisionName() + " precision, Eigen " + eigen +
         ", " + gnuplotVersion() + "\n- " + today() + "\n";
}

}  // namespace demos::report
