#include "demos/process/other_command.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <stdexcept>

#include "demos/process/child.h"
#include "demos/process/interrupt.h"

namespace demos {

namespace {

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

}  // namespace demos
