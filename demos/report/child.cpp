#include "demos/report/child.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace demos::report {

namespace {

volatile sig_atomic_t interruptAsked = 0;

void ask(int) { interruptAsked = 1; }

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

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

/// In a process that was just started: it gets `signal` when its parent ends, in whatever way.
void dieWith(pid_t parent, int signal) {
  prctl(PR_SET_PDEATHSIG, signal);
  // The parent may have ended before that.
  if (getppid() != parent) _exit(1);
}

/// The life of the copy. Nothing of this process may run at its end: no destructors, no flushing of
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

/// Reads to the end, or to the time limit.
bool readAll(int in, double seconds, std::chrono::steady_clock::time_point start,
             std::string& text) {
  char buffer[1 << 16];
  while (true) {
    const double left = seconds - secondsSince(start);
    if (left <= 0 || InterruptWatch::asked()) return false;
    pollfd waiting{in, POLLIN, 0};
    // Short waits, so that Ctrl-C is seen soon.
    const int ready = poll(&waiting, 1, int(std::min(left * 1000 + 1, 200.0)));
    if (ready <= 0) continue;
    const ssize_t size = read(in, buffer, sizeof buffer);
    if (size <= 0) return true;
    text.append(buffer, std::size_t(size));
  }
}

struct Pipe {
  int ends[2];
  Pipe() {
    if (pipe(ends) != 0) throw std::runtime_error("no pipe to a process of its own");
  }
};

/// Starts `command` with both outputs to `out`.
pid_t startCommand(const std::vector<std::string>& command, int out) {
  const pid_t parent = getpid(), child = fork();
  if (child < 0) throw std::runtime_error("no process for '" + command.front() + "'");
  if (child > 0) return child;
  dieWith(parent, SIGTERM);
  dup2(out, STDOUT_FILENO);
  dup2(out, STDERR_FILENO);
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  execvp(words[0], words.data());
  _exit(127);
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

CommandResult callCommand(const std::vector<std::string>& command) {
  const Pipe pipe;
  const pid_t child = startCommand(command, pipe.ends[1]);
  close(pipe.ends[1]);
  CommandResult result;
  constexpr double patience = 300;  // seconds
  if (!readAll(pipe.ends[0], patience, std::chrono::steady_clock::now(), result.text))
    kill(child, SIGKILL);
  close(pipe.ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  InterruptWatch::throwIfAsked();
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

CommandBeside::CommandBeside(const std::vector<std::string>& command) {
  const int silence = open("/dev/null", O_WRONLY);
  process_ = startCommand(command, silence);
  close(silence);
}

CommandBeside::~CommandBeside() {
  if (process_ == 0) return;
  kill(process_, SIGTERM);
  waitpid(process_, nullptr, 0);
}

bool CommandBeside::ended() {
  if (process_ != 0 && waitpid(process_, nullptr, WNOHANG) == process_) process_ = 0;
  return process_ == 0;
}

void CommandBeside::wait() {
  constexpr int tick = 100;  // milliseconds
  while (!ended() && !InterruptWatch::asked()) poll(nullptr, 0, tick);
}

InterruptWatch::InterruptWatch() {
  interruptAsked = 0;
  signal(SIGINT, ask);
  signal(SIGTERM, ask);
}

InterruptWatch::~InterruptWatch() {
  interruptAsked = 0;
  signal(SIGINT, SIG_DFL);
  signal(SIGTERM, SIG_DFL);
}

bool InterruptWatch::asked() { return interruptAsked != 0; }

void InterruptWatch::throwIfAsked() {
  if (asked()) throw Interrupted();
}

}  // namespace demos::report
