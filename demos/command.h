#pragma once
/// The sub-commands of `delassus`. Each has a file of its own, which adds its flags and does its
/// work.

#include <functional>
#include <stdexcept>

namespace CLI {
class App;
}

namespace demos {

/// Exit statuses.
constexpr int exitDone = 0;
constexpr int exitFailed = 1;          ///< file, scene, display
constexpr int exitBadUsage = 2;        ///< unknown flags, values out of range
constexpr int exitAboveTolerance = 3;  ///< `solve` only

/// The command line asks for something that makes no sense, which shows only once the files are
/// looked at: exitBadUsage.
class BadUsage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The work that the parsed command line asks for. Returns the exit status; throws std::exception
/// if the work fails.
using Action = std::function<int()>;

void addScenesCommand(CLI::App& app, Action& chosen);
void addRunCommand(CLI::App& app, Action& chosen);
void addSolveCommand(CLI::App& app, Action& chosen);
void addDumpCommand(CLI::App& app, Action& chosen);
void addRenderCommand(CLI::App& app, Action& chosen);
void addReportCommand(CLI::App& app, Action& chosen);
void addAtlasCommand(CLI::App& app, Action& chosen);

}  // namespace demos
