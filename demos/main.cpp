#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "demos/command.h"
#include "demos/scenes/solvers.h"

int main(int argc, char** argv) {
  using namespace demos;
  CLI::App app("Bullet worlds on Delassus' region selection, beside Bullet's own solvers",
               "delassus");
  app.require_subcommand(1);
  Action chosen;
  addScenesCommand(app, chosen);
  addRunCommand(app, chosen);
  addRenderCommand(app, chosen);
  addSolveCommand(app, chosen);
  addDumpCommand(app, chosen);
  addReportCommand(app, chosen);
  addAtlasCommand(app, chosen);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exitDone : exitBadUsage;
  }
  try {
    return chosen();
  } catch (const UnknownSolver& error) {
    std::fprintf(stderr, "delassus: %s\n", error.what());
    return exitBadUsage;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "delassus: %s\n", error.what());
    return exitFailed;
  }
}
