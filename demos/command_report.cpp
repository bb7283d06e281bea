#include <CLI/CLI.hpp>
#include <stdexcept>

#include "demos/command.h"

namespace demos {

namespace {

struct ReportArguments {
  std::vector<std::string> scenes;
  std::vector<std::string> solvers;
  std::string out = "report";
  bool quick = false;
};

int writeReport(const ReportArguments& arguments) {
  throw std::runtime_error("this build was made without the report: nothing written to '" +
                           arguments.out + "'");
}

}  // namespace

void addReportCommand(CLI::App& app, Action& chosen) {
  auto arguments = std::make_shared<ReportArguments>();
  CLI::App* command =
      app.add_subcommand("report", "error against run time: CSV, plots, a summary in Markdown");
  command->add_option("--scenes", arguments->scenes, "which (default: all)")
      ->delimiter(',')
      ->type_name("NAME,...");
  command->add_option("--solvers", arguments->solvers, "which, as in 'run'")
      ->delimiter(',')
      ->type_name("NAME,...");
  command->add_option("--out", arguments->out, "folder for what is made")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_flag("--quick", arguments->quick, "short runs, fewer scenes");
  command->callback(
      [&chosen, arguments] { chosen = [arguments] { return writeReport(*arguments); }; });
}

}  // namespace demos
