#include "demos/process/apart.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "demos/process/child.h"
#include "demos/process/interrupt.h"

namespace demos {

namespace {

bool writeAll(int file, const void* data, std::size_t size) {
  const char* next = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = write(file, next, size);
    if (written <= 0) return false;
    next += written;
    size -= std::size_t(written);
  }
  return true;
}

/// Sanitizers reserve more address space than any machine has.
void limitMemory([[maybe_unused]] double bytes) {
#ifndef __SANITIZE_ADDRESS__
  long used = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%ld", &used) != 1) used = 0;
    std::fclose(file);
  }
  const rlim_t limit = rlim_t(bytes + double(used) * double(sysconf(_SC_PAGESIZE)));
  const rlimit both{limit, limit};
  setrlimit(RLIMIT_AS, &both);
#endif
}

/// Runs in the copy. At its end no code of this process may run: no destructors, no flushing of
/// streams.
[[noreturn]] void workAndLeave(const std::function<std::vector<double>()>& work, double bytes,
                               int out) {
  signal(SIGINT, SIG_IGN);
  const int silence = open("/dev/null", O_WRONLY);
  dup2(silence, STDOUT_FILENO);
  dup2(silence, STDERR_FILENO);
  limitMemory(bytes);
  bool good = false;
  try {
    const std::vector<double> numbers = work();
    good = writeAll(out, numbers.data(), numbers.size() * sizeof(double));
  } catch (...) {
  }
  _exit(good ? 0 : 1);
}

}  // namespace

std::string toString(Ending ending) {
  switch (ending) {
    case Ending::Done:
      return "done";
    case Ending::TimeLimit:
      return "time limit";
    case Ending::Crashed:
      return "crashed";
  }
  return "";
}

ApartResult runApart(const std::function<std::vector<double>()>& work, const Limits& limits) {
  const auto start = std::chrono::steady_clock::now();
  const Pipe pipe;
  const pid_t parent = getpid(), child = fork();
  if (child < 0) throw std::runtime_error("no process for work apart");
  if (child == 0) {
    dieWith(parent, SIGKILL);
    close(pipe.ends[0]);
    workAndLeave(work, limits.bytes, pipe.ends[1]);
  }
  close(pipe.ends[1]);
  std::string bytes;
  const bool inTime = readAll(pipe.ends[0], limits.seconds, start, bytes);
  close(pipe.ends[0]);
  if (!inTime) kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  if (!inTime) InterruptWatch::throwIfAsked();

  ApartResult result;
  result.seconds = secondsSince(start);
  result.ending = !inTime                                         ? Ending::TimeLimit
                  : WIFEXITED(status) && WEXITSTATUS(status) == 0 ? Ending::Done
                                                                  : Ending::Crashed;
  if (result.ending == Ending::Done && !bytes.empty()) {
    result.numbers.resize(bytes.size() / sizeof(double));
    std::memcpy(result.numbers.data(), bytes.data(), result.numbers.size() * sizeof(double));
  }
  return result;
}

}  // namespace demos
