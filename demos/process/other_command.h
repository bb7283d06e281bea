#pragma once

#include <string>
#include <vector>

namespace demos {

struct CommandResult {
  int status = -1;   ///< exit status; 127 if there is no such command
  std::string text;  ///< both outputs
};
/// Calls `command` with its arguments, without a shell, and waits for it. Throws Interrupted when
/// the user asks to stop.
CommandResult callCommand(const std::vector<std::string>& command);

/// A command that runs beside this process; its outputs are thrown away.
class CommandBeside {
 public:
  explicit CommandBeside(const std::vector<std::string>& command);
  /// Asks it politely to end, and waits until it has.
  ~CommandBeside();
  CommandBeside(const CommandBeside&) = delete;
  CommandBeside& operator=(const CommandBeside&) = delete;

  /// True when it has ended.
  bool ended();
  /// Waits for its end, or until the user asks this process to stop.
  void wait();

 private:
  int process_;
};

}  // namespace demos
