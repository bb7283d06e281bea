#pragma once
/// The sub-commands of `delassus`. Each has a file of its own, which adds its flags and says what
/// it does when chosen.

#include <functional>
#include <stdexcept>

namespace CLI {
class App;
}

namespace demos {

/// What the exit status says.
constexpr int exitDone = 0;
constexpr int exitFailed = 1;          ///< file, scene, display
constexpr int exitBadUsage = 2;        ///< unknown flags, values out of range
constexpr int exitAboveTolerance = 3;  ///< `solve` only

/// What the command line asks for cannot be meant: exitBadUsage, which only shows when the files
/// are looked at.
class BadUsage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What the parsed command line asks for; returns the exit status, throws std::exception when it
/// fails.
using Action = std::function<int()>;

void addScenesCommand(CLI::App& app, Action& chosen);
void addRunCommand(CLI::App& app, Action& chosen);
void addSolveCommand(CLI::App& app, Action& chosen);
void addDumpCommand(CLI::App& app, Action& chosen);
void addRenderCommand(CLI::App& app, Action& chosen);
void addReportCommand(CLI::App& app, Action& chosen);
void addAtlasCommand(CLI::App& app, Action& chosen);

}  // namespace demos
