#include "demos/crash.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "demos/command.h"

namespace demos {
namespace {

constexpr std::size_t longest = 4096, stackSize = 1 << 16;
// The line, and the text for standard output before it, where a signal handler can read them.
char line[longest];
std::size_t length = 0, finishedLength = 0;
const char* finishedText = nullptr;
char stack[stackSize];  // for the handler: the usual stack may have overflowed

/// Memory may be broken: uses nothing of the process but a few system calls.
void tellAndLeave(int) {
  [[maybe_unused]] ssize_t written = write(STDOUT_FILENO, finishedText, finishedLength);
  written = write(STDERR_FILENO, line, length);
  _exit(exitFailed);
}

/// Sets the handler of all signals that a crash may raise.
void handleBy(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_ONSTACK;
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
    sigaction(signal, &action, nullptr);
}

/// Sets the line that a crash prints. Without a text, as at first, crashes are left to the system.
void sayAtCrash(const std::string& text) {
  length = std::min(text.size(), longest);
  std::memcpy(line, text.data(), length);

  stack_t own{};
  own.ss_sp = stack;
  own.ss_size = stackSize;
  sigaltstack(&own, nullptr);
  handleBy(text.empty() ? SIG_DFL : tellAndLeave);
}

/// `text` as a line of its own, even over a progress bar.
std::string asLine(const std::string& text) {
  return (isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "") + ("delassus: " + text) + "\n";
}

}  // namespace

void blameCrashesOn(const std::string& file) {
  sayAtCrash(asLine(
      file + ": crashes Bullet or this program: the file is damaged, or one of them has an error"));
}

CrashBlame::CrashBlame(const std::string& line, std::string finished)
    : before_(demos::line, length), finished_(std::move(finished)) {
  std::fflush(stdout);  // a crash would lose output that is not written yet
  finishedText = finished_.data();
  finishedLength = finished_.size();
  sayAtCrash(asLine(line));
}

CrashBlame::~CrashBlame() {
  sayAtCrash(before_);
  finishedLength = 0;
}

}  // namespace demos
