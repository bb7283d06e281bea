#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "demos/command.h"
#include "demos/number_checks.h"
#include "demos/report/part.h"
#include "demos/report/stability/map.h"
#include "demos/subject.h"

namespace demos {

namespace {

/// Tells which options change nothing, since no chosen part uses them.
void tellWhatIsIdle(const report::ReportArguments& arguments) {
  const auto isAskedFor = [&](std::initializer_list<const char*> parts) {
    return arguments.parts.empty() ||
           std::any_of(arguments.parts.begin(), arguments.parts.end(), [&](const auto& name) {
             return std::find(parts.begin(), parts.end(), name) != parts.end();
           });
  };
  const auto tell = [](const char* option, const char* parts) {
    std::fprintf(stderr, "%s is for %s alone, and changes nothing: add one to --parts\n", option,
                 parts);
  };
  if (arguments.stability) return;
  if (!arguments.scenes.empty() &&
      !isAskedFor({"same_problem", "persisting", "own_trajectory", "ablation"}))
    tell("--scenes", "same_problem, persisting, own_trajectory and ablation");
  if (!arguments.solvers.empty() &&
      !isAskedFor({"same_problem", "persisting", "own_trajectory", "time_step", "scaling"}))
    tell("--solvers", "same_problem, persisting, own_trajectory, time_step and scaling");
}

/// Each name once, in the order in which they were first named.
void keepOnce(std::vector<std::string>& names) {
  std::vector<std::string> once;
  for (const std::string& name : names)
    if (std::find(once.begin(), once.end(), name) == once.end()) once.push_back(name);
  names = std::move(once);
}

int writeReport(report::ReportArguments arguments) {
  for (std::vector<std::string>* names : {&arguments.parts, &arguments.scenes, &arguments.solvers})
    keepOnce(*names);
  tellWhatIsIdle(arguments);
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
      command
          ->add_option("--scenes", arguments->scenes, "scene names (default: those in the report)")
          ->delimiter(',')
          ->allow_extra_args(false)
          ->type_name("NAME,...");
  command->add_option("--solvers", arguments->solvers, "solver names, as in 'run'")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NAME,...");
  command
      ->add_option(
          "--parts", arguments->parts,
          "some of same_problem, persisting (measures same_problem too), own_trajectory, "
          "time_step, scaling, ablation; with --stability: masses, units, stiffness, friction, "
          "redundancy, "
          "angles, speeds, long_runs, stack_pair, chain_pair, soft_ground_pair, wedge_pair")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NAME,...");
  command->add_option("--out", arguments->out, "folder for the report")
      ->type_name("DIR")
      ->check(notEmpty)
      ->capture_default_str();
  CLI::Option* stability = command->add_flag(
      "--stability", arguments->stability,
      "makes the stability map instead, which shows up to which hardness each solver holds, in "
      "both precisions: 20 minutes");
  command
      ->add_flag("--one-precision", arguments->onePrecision,
                 "for the map: only measure, and only in the precision of this executable")
      ->needs(stability);
  scenes->excludes(stability);  // which has its own worlds
  command->add_flag("--quick", arguments->quick, "fewer scenes and settings: under three minutes");
  command->add_flag("--resume", arguments->resume, "continues a report that was interrupted");
  command->callback(
      [&chosen, arguments] { chosen = [arguments] { return writeReport(*arguments); }; });
}

}  // namespace demos
