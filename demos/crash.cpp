#include "demos/crash.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>

#include "demos/command.h"

namespace demos {
namespace {

constexpr std::size_t longest = 4096, stackSize = 1 << 16;
char line[longest];  // where a signal handler can read it
std::size_t length = 0;
char stack[stackSize];  // of the handler: the usual one may be what overflowed

/// Memory may be broken: nothing of the process runs any more but two system calls.
void tellAndLeave(int) {
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, line, length);
  _exit(exitFailed);
}

}  // namespace

void blameCrashesOn(const std::string& file) {
  const std::string text =
      "delassus: " + file +
      ": crashes Bullet or this program: the file is damaged, or one of them has an error\n";
  length = std::min(text.size(), longest);
  std::memcpy(line, text.data(), length);

  stack_t own{};
  own.ss_sp = stack;
  own.ss_size = stackSize;
  sigaltstack(&own, nullptr);
  struct sigaction action {};
  action.sa_handler = tellAndLeave;
  action.sa_flags = SA_ONSTACK;
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
    sigaction(signal, &action, nullptr);
}

}  // namespace demos
