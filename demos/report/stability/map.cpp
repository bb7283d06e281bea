#include "demos/report/stability/map.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "demos/command.h"
#include "demos/process/interrupt.h"
#include "demos/process/other_command.h"
#include "demos/progress_bar.h"
#include "demos/report/part.h"
#include "demos/report/stability/page.h"
#include "demos/subject.h"

namespace demos::report::stability {

namespace {

namespace fs = std::filesystem;

MapPlan planOf(const ReportArguments& arguments) {
  MapPlan plan;
  const auto chosen = [&arguments](const std::vector<std::string>& usual) {
    return methodsNamed(arguments.solvers.empty() ? usual : arguments.solvers);
  };
  plan.methods = chosen({"delassus", "si:10", "si:1000", "dantzig:1e-6"});
  plan.pairMethods = chosen({"delassus", "si:10", "dantzig:1e-6"});
  plan.quick = arguments.quick;
  plan.secondsLimit = arguments.quick ? 0.5 : 3;
  plan.certificateLimit = arguments.quick ? 0.2 : 0.5;
  plan.lastCertificateLimit = 0.1;
  return plan;
}

/// All sweeps, in the order of the page.
std::vector<SweepGroup> allSweeps() {
  return {massSweeps(),       unitSweeps(),  stiffnessSweeps(), frictionSweeps(),
          redundancySweeps(), angleSweeps(), speedSweeps(),     longRunSweeps(),
          stackPair(),        chainPair(),   softGroundPair(),  wedgePair()};
}

std::vector<SweepGroup> chosenGroups(const std::vector<std::string>& names) {
  std::vector<SweepGroup> all = allSweeps();
  if (names.empty()) return all;
  std::vector<SweepGroup> chosen;
  std::string existing;
  for (const SweepGroup& group : all) existing += (existing.empty() ? "" : ", ") + group.name;
  for (const std::string& name : names) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const SweepGroup& group) { return group.name == name; });
    if (found == all.end())
      throw BadUsage("the stability map has no part '" + name + "'; there are " + existing);
    chosen.push_back(*found);
  }
  return chosen;
}

std::vector<Part> partsOf(const std::vector<SweepGroup>& groups, const MapPlan& plan) {
  std::vector<Part> parts;
  for (const SweepGroup& group : groups) {
    Part part;
    part.name = group.name;
    for (const Sweep& sweep : group.sweeps)
      part.units.push_back(
          {sweep.name, [&sweep, own = planFor(group, plan)](const Progress& progress) {
             return measureSweep(sweep, own, progress);
           }});
    parts.push_back(part);
  }
  return parts;
}

/// The executable for Bullet's other precision, beside this one. If it is not there, says so and
/// returns nothing.
fs::path otherPrecision() {
  const fs::path here = fs::read_symlink("/proc/self/exe").parent_path();
  const fs::path other =
      here / (sizeof(btScalar) == sizeof(double) ? "delassus-float32" : "delassus");
  if (fs::exists(other)) return other;
  std::fprintf(stderr,
               "delassus: there is no %s: only %s precision is measured; "
               "'cmake --build --preset release' makes both\n",
               other.c_str(), precisionName());
  return {};
}

std::vector<std::string> commandOf(const fs::path& executable, const ReportArguments& arguments) {
  std::vector<std::string> words{executable.string(), "report", "--stability",
                                 "--one-precision",   "--out",  arguments.out};
  const auto add = [&](const char* flag, const std::vector<std::string>& names) {
    if (names.empty()) return;
    words.emplace_back(flag);
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ",") + name;
    words.push_back(list);
  };
  add("--solvers", arguments.solvers);
  add("--parts", arguments.parts);
  if (arguments.quick) words.emplace_back("--quick");
  if (arguments.resume) words.emplace_back("--resume");
  return words;
}

/// The number of sweeps without measures, in each precision that has a folder.
int missingIn(const fs::path& folder, const std::vector<SweepGroup>& groups) {
  int missing = 0;
  for (const char* precision : precisions)
    if (fs::exists(folder / precision))
      for (const SweepGroup& group : groups)
        for (const Sweep& sweep : group.sweeps)
          missing += !fs::exists(folder / precision / group.name / (sweep.name + ".csv"));
  return missing;
}

}  // namespace

bool makeMap(const ReportArguments& arguments) {
  const MapPlan plan = planOf(arguments);
  const std::vector<SweepGroup> groups = chosenGroups(arguments.parts);
  const std::vector<Part> parts = partsOf(groups, plan);
  const fs::path folder = fs::path(arguments.out) / "stability", own = folder / precisionName();
  stamp(own, arguments.commandAnywhere(), arguments.resume, parts);
  // Removes the measures of both precisions. If the other executable is missing, nothing replaces
  // its measures.
  if (!arguments.onePrecision && !arguments.resume)
    for (const char* precision : precisions) removeMeasures(folder / precision, parts);
  std::optional<CommandBeside> other;
  if (!arguments.onePrecision)
    if (const fs::path executable = otherPrecision(); !executable.empty())
      other.emplace(commandOf(executable, arguments));
  const bool stopped = measure(parts, own) > 0;
  if (other && !stopped) {
    const InterruptWatch watch;
    other->wait();
  }
  other.reset();
  if (arguments.onePrecision) return !stopped;  // the other executable writes the page

  const int missing = missingIn(folder, groups);
  writeMapPage(arguments.out, arguments.command(), groups, plan, missing);
  return missing == 0;
}

}  // namespace demos::report::stability
