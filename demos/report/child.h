#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace demos::report {

/// What a piece of work may use, in a process of its own.
struct Limits {
  double seconds;
  double bytes = 6e9;  ///< of address space beyond that of this process
};

enum class Ending {
  Done,
  TimeLimit,
  Crashed,  ///< also: out of memory
};
std::string toString(Ending ending);

struct ApartResult {
  Ending ending = Ending::Crashed;
  double seconds = 0;
  std::vector<double> numbers;  ///< what the work returned, if it is done
};

/// Runs `work` in a copy of this process and brings back the numbers it returns.
///
/// Work that takes too long is ended, and work that crashes takes nothing with it: Bullet's
/// pivoting solvers can do both. Whatever it changes in the world is changed in the copy alone.
/// Throws Interrupted when the user asks to stop.
ApartResult runApart(const std::function<std::vector<double>()>& work, const Limits& limits);

/// Calls `command` with its arguments, without a shell, and waits for it. Both outputs are returned
/// as one text.
struct CommandResult {
  int status = -1;  ///< exit status; 127 if there is no such command
  std::string text;
};
CommandResult callCommand(const std::vector<std::string>& command);

/// A command that runs beside this process; both its outputs are thrown away.
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

/// The user pressed Ctrl-C: what is finished is kept.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

/// While one lives, Ctrl-C and a polite kill end the work at the next call of `throwIfAsked`
/// instead of the process.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  static bool asked();
  static void throwIfAsked();
};

}  // namespace demos::report
