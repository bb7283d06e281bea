#include <CLI/CLI.hpp>
#include <cstdio>

#include "demos/command.h"
#include "demos/report/part.h"
#include "demos/report/stability/map.h"
#include "demos/subject.h"

namespace demos {

namespace {

int writeReport(const report::ReportArguments& arguments) {
  const bool complete =
      arguments.stability ? report::stability::makeMap(arguments) : report::makeReport(arguments);
  const std::string made = arguments.onePrecision ? std::string("stability/") + precisionName()
                           : arguments.stability  ? "stability.md"
                                                  : "report.md";
  std::printf("%s/%s\n", arguments.out.c_str(), made.c_str());
  if (complete) return exitDone;
  std::fprintf(stderr, "delassus: interrupted; '%s --resume' goes on\n",
               arguments.command().c_str());
  return exitFailed;
}

}  // namespace

void addReportCommand(CLI::App& app, Action& chosen) {
  auto arguments = std::make_shared<report::ReportArguments>();
  CLI::App* command =
      app.add_subcommand("report", "error against run time: CSV, plots, a summary in Markdown");
  CLI::Option* scenes =
      command->add_option("--scenes", arguments->scenes, "which (default: those the report names)")
          ->delimiter(',')
          ->type_name("NAME,...");
  command->add_option("--solvers", arguments->solvers, "which, as in 'run'")
      ->delimiter(',')
      ->type_name("NAME,...");
  command
      ->add_option(
          "--parts", arguments->parts,
          "which of same_problem, persisting (measures same_problem too), own_trajectory, "
          "time_step, scaling, ablation; with --stability: masses, units, stiffness, friction, "
          "redundancy, "
          "angles, speeds, long_runs, stack_pair, chain_pair, soft_ground_pair, wedge_pair")
      ->delimiter(',')
      ->type_name("NAME,...");
  command->add_option("--out", arguments->out, "folder for what is made")
      ->type_name("DIR")
      ->capture_default_str();
  CLI::Option* stability = command->add_flag(
      "--stability", arguments->stability,
      "instead, the map of what holds up to which hardness, in both precisions: 20 minutes");
  command
      ->add_flag("--one-precision", arguments->onePrecision,
                 "of the map: only measure, and only in the precision of this executable")
      ->needs(stability);
  scenes->excludes(stability);  // whose worlds are its own
  command->add_flag("--quick", arguments->quick, "fewer scenes and settings: under three minutes");
  command->add_flag("--resume", arguments->resume, "go on with a report that was interrupted");
  command->callback(
      [&chosen, arguments] { chosen = [arguments] { return writeReport(*arguments); }; });
}

}  // namespace demos
