#include <LinearMath/btScalar.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "demos/command.h"
#include "demos/scenes/solvers.h"
#include "demos/subject.h"

namespace demos {
namespace {

/// Returns `status`, or failure if output was lost, as on a full disk.
int afterOutput(int status) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  std::fprintf(stderr, "delassus: the output cannot be written\n");
  return exitFailed;
}

/// The fault of the first word; empty if it is a sub-command or an option. CLI11 would only say
/// that a sub-command is required.
std::string commandFault(const CLI::App& app, int argc, char** argv) {
  if (argc >= 2 && app.get_option_no_throw(argv[1]) != nullptr) return "";
  std::string existing;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (argc >= 2 && command->check_name(argv[1])) return "";
    existing += (existing.empty() ? "" : ", ") + command->get_name();
  }
  return (argc < 2            ? "a command is required"
          : argv[1][0] == '-' ? "before a command there is no option '" + std::string(argv[1]) +
                                    "' (there are --help and --version)"
                              : "there is no command '" + std::string(argv[1]) + "'") +
         "; the commands are " + existing;
}

/// The fault of an option of a sub-command; empty if all given options exist. CLI11 would only say
/// what is missing, or which word it did not expect.
std::string optionFault(const CLI::App& app) {
  for (const CLI::App* command : app.get_subcommands())
    for (const std::string& word : command->remaining()) {
      if (word.size() < 2 || word[0] != '-') continue;
      std::string existing;
      for (const CLI::Option* option : command->get_options())
        if (option->nonpositional())
          existing += (existing.empty() ? "" : ", ") + option->get_name();
      return command->get_name() + " has no option '" + word + "'; there are " + existing;
    }
  return "";
}

std::string versions() {
  return "delassus " DELASSUS_VERSION ", Bullet " + std::to_string(btGetVersion()) + " in " +
         precisionName() + " precision";
}

}  // namespace
}  // namespace demos

int main(int argc, char** argv) {
  using namespace demos;
  CLI::App app("Bullet worlds on Delassus' region selection, beside Bullet's own solvers",
               "delassus");
  app.require_subcommand(1);
  app.set_version_flag("--version", versions());
  Action chosen;
  addScenesCommand(app, chosen);
  addRunCommand(app, chosen);
  addRenderCommand(app, chosen);
  addSolveCommand(app, chosen);
  addDumpCommand(app, chosen);
  addReportCommand(app, chosen);
  addAtlasCommand(app, chosen);

  if (const std::string fault = commandFault(app, argc, argv); !fault.empty()) {
    std::fprintf(stderr, "delassus: %s\n", fault.c_str());
    return exitBadUsage;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (const std::string fault = optionFault(app); error.get_exit_code() != 0 && !fault.empty()) {
      std::fprintf(stderr, "delassus: %s\n", fault.c_str());
      return exitBadUsage;
    }
    return app.exit(error) == 0 ? afterOutput(exitDone) : exitBadUsage;
  }
  try {
    return afterOutput(chosen());
  } catch (const BadUsage& error) {
    std::fprintf(stderr, "delassus: %s\n", error.what());
    return exitBadUsage;
  } catch (const UnknownSolver& error) {
    std::fprintf(stderr, "delassus: %s\n", error.what());
    return exitBadUsage;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "delassus: %s\n", error.what());
    return exitFailed;
  }
}
