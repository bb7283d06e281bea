#include <algorithm>
#include <chrono>
#include <cmath>

#include "demos/process/apart.h"
#include "demos/report/figure.h"
#include "demos/report/markdown.h"
#include "demos/report/part.h"
#include "demos/scenes/catalogue.h"
#include "demos/scenes/measures.h"
#include "demos/scenes/solver_in_world.h"
#include "demos/scenes/statistics.h"
#include "demos/table.h"

namespace demos::report {

namespace {

constexpr const char* folderName = "own_trajectory";

/// A scene that should stand counts as fallen beyond this, m.
constexpr double fallen = 0.1;

bool shouldStand(const SceneDescription& scene) {
  const std::string& law = scene.expectation;
  return law.rfind("stands", 0) == 0 || law.rfind("stays", 0) == 0;
}

const std::vector<std::string> measured{"steps",          "ms",          "ms_p95",      "drift",
                                        "overlap",        "energy_gain", "joint_error", "reaction",
                                        "reaction_noise", "fallbacks"};

double meanOf(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? 0 : sum / double(values.size());
}

/// Root mean square of the changes from step to step: it shows shaking, not swinging.
double noiseOf(const std::vector<double>& values) {
  double squares = 0;
  for (std::size_t i = 1; i < values.size(); ++i)
    squares += (values[i] - values[i - 1]) * (values[i] - values[i - 1]);
  return values.size() > 1 ? std::sqrt(squares / double(values.size() - 1)) : 0;
}

/// Runs the method alone with the scene; returns numbers in the order of `measured`.
std::vector<double> live(const SceneDescription& scene, const Method& method, int steps,
                         double secondsLimit) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  NamedSolver named(method.name);
  const std::unique_ptr<World> world = scene.build();
  SolverInWorld solving(*world, named);
  const Drift drift(*world);
  const double energy = totalEnergy(*world);

  double drifted = 0, overlap = 0, gain = 0, joints = 0;
  std::vector<double> milliseconds, reactions;
  for (int i = 0; i < steps; ++i) {
    world->step(1 / scene.hz);
    milliseconds.push_back(1e3 * solving.timed().takeSeconds());
    drifted = largerOf(drifted, drift.largest());
    overlap = largerOf(overlap, deepestPenetration(world->dynamics()));
    joints = largerOf(joints, largestJointError(world->dynamics()));
    gain = largerOf(gain, totalEnergy(*world) - energy);
    // Measures of a lost world mean nothing.
    if (!isFinite(*world)) drifted = overlap = joints = gain = std::nan("");
    // Only the second half, since the first may have an impact.
    if (2 * i >= steps) reactions.push_back(reactionOverWeight(*world, 1 / scene.hz));
    if (std::chrono::duration<double>(Clock::now() - start).count() > secondsLimit) break;
  }
  return {double(milliseconds.size()),
          median(milliseconds),
          quantile(milliseconds, 0.95),
          drifted,
          overlap,
          gain,
          joints,
          meanOf(reactions),
          noiseOf(reactions),
          double(named.fallbacks())};
}

CsvTable measureScene(const SceneDescription& scene, const Plan& plan, const Progress& progress) {
  std::vector<std::string> columns{"method", "family", "ending", "steps_wanted"};
  columns.insert(columns.end(), measured.begin(), measured.end());
  CsvTable table(columns);
  const int steps = std::max(1, int(std::min(scene.seconds, plan.trajectorySeconds) * scene.hz));
  for (std::size_t i = 0; i < plan.trajectoryMethods.size(); ++i) {
    const Method& method = plan.trajectoryMethods[i];
    // A run ends itself at its limit; only a step that never ends is ended from outside.
    ApartResult run = runApart([&] { return live(scene, method, steps, plan.trajectoryLimit); },
                               Limits{2 * plan.trajectoryLimit + 1});
    run.numbers.resize(measured.size(), std::nan(""));
    std::vector<std::string> row{method.name, method.family, toString(run.ending),
                                 std::to_string(steps)};
    for (const double value : run.numbers) row.push_back(csvNumber(value));
    table.add(row);
    progress(double(i + 1) / double(plan.trajectoryMethods.size()));
  }
  return table;
}

/// Whether the time limit ended the run: the worst may have been still to come.
bool isCut(const CsvTable& table, int row) {
  return table.number(row, "steps") < table.number(row, "steps_wanted");
}

constexpr double least = 1e-12;  ///< as good as zero

/// Marks with names: `column` against time. Of a run that was cut, zero tells nothing.
Panel panelOf(const CsvTable& table, const std::string& title, const std::string& column) {
  Panel panel;
  panel.title = title;
  panel.xLabel = "ms a step";
  panel.yLabel = title;
  for (int row = 0; row < table.rows(); ++row) {
    const double value = table.number(row, column);
    if (!std::isfinite(value) || (value <= least && isCut(table, row))) continue;
    if (value <= least) panel.yLabel = title + " (lowest: none)";
    Curve mark;
    mark.colour = familyColour(table.text(row, "family"));
    mark.marks = {{table.number(row, "ms"), std::max(value, least)}};
    mark.markLabels = {table.text(row, "method") + (isCut(table, row) ? " (cut)" : "")};
    panel.curves.push_back(mark);
  }
  return panel;
}

bool anyAbove(const CsvTable& table, const std::string& column, double value) {
  for (int row = 0; row < table.rows(); ++row)
    if (table.number(row, column) > value) return true;
  return false;
}

Figure figureOf(const SceneDescription& scene, const CsvTable& table) {
  Figure figure;
  figure.title = scene.name + ", each solver on its own: lower left is better";
  figure.columns = 3;
  figure.panelWidth = 400;
  if (shouldStand(scene))
    figure.panels.push_back(panelOf(table, "furthest drift of a body, m", "drift"));
  else if (!scene.driven && anyAbove(table, "energy_gain", least))
    figure.panels.push_back(panelOf(table, "energy gained, J", "energy_gain"));
  figure.panels.push_back(panelOf(table, "deepest overlap, m", "overlap"));
  figure.panels.push_back(
      anyAbove(table, "joint_error", 0)
          ? panelOf(table, "joints pulled apart, m", "joint_error")
          : panelOf(table, "noise of ground reaction / weight", "reaction_noise"));
  return figure;
}

std::string stands(const SceneDescription& scene, const CsvTable& table, int row) {
  const double drift = table.number(row, "drift");
  if (std::isnan(drift)) return "**lost: not a number**";
  if (!shouldStand(scene)) return "";
  return drift < fallen ? "stands" : "**falls**";
}

std::string tableOf(const SceneDescription& scene, const CsvTable& table) {
  MarkdownTable page({"solver", "ms a step", "p95", "drift m", "overlap m", "energy gained J",
                      "joints m", "reaction/weight", "its noise", "gave up", "steps", ""});
  for (int row = 0; row < table.rows(); ++row) {
    const std::string name = code(table.text(row, "method"));
    if (table.text(row, "ending") != "done") {
      page.add({name, table.text(row, "ending"), "", "", "", "", "", "", "", "", "", ""});
      continue;
    }
    const auto value = [&](const char* column) {
      return shortNumber(table.number(row, column), 2);
    };
    page.add({name, shortMs(table.number(row, "ms")), shortMs(table.number(row, "ms_p95")),
              value("drift"), value("overlap"), value("energy_gain"), value("joint_error"),
              shortNumber(table.number(row, "reaction"), 4), value("reaction_noise"),
              std::to_string(int(table.number(row, "fallbacks"))),
              table.text(row, "steps") + (isCut(table, row) ? " (time limit)" : ""),
              stands(scene, table, row)});
  }
  return page.text();
}

Words writeOwnTrajectory(const Plan& plan, const std::filesystem::path& report) {
  const std::filesystem::path folder = report / folderName;
  Words words;
  std::string trouble;
  for (const std::string& name : plan.scenes) {
    if (!std::filesystem::exists(folder / (name + ".csv"))) continue;
    const SceneDescription& scene = findScene(name);
    const CsvTable table = CsvTable::read(folder / (name + ".csv"));
    addFault(trouble, draw(figureOf(scene, table), folder, name));
    words.body += "### " + name + ", own trajectory\n\nWhat it should do: " + scene.expectation +
                  ".\n\n" + picture(folderName, name, "own trajectory, " + name) +
                  tableOf(scene, table);
  }
  if (words.body.empty()) return {};
  words.body =
      "## Own trajectory\n\n"
      "Each method runs the scene by itself. Time is of `solveGroup`, median of the steps; drift, "
      "overlap, joint error and energy\n"
      "gained are the worst of the run. Reaction over weight is the mean of the second half (at "
      "rest: 1), its noise the root\n"
      "mean square of its changes from step to step. A scene that should stand has fallen where a "
      "body drifts 0.1 m.\nWhere a plot says cut, the time limit of " +
      shortNumber(plan.trajectoryLimit) +
      " s ended the run, whose worst may have been yet to come.\n\n" + words.body + trouble;
  return words;
}

}  // namespace

Part ownTrajectoryPart(const Plan& plan) {
  Part part;
  part.name = folderName;
  for (const std::string& scene : plan.scenes)
    part.units.push_back({scene, [&plan, scene](const Progress& progress) {
                            return measureScene(findScene(scene), plan, progress);
                          }});
  part.write = [&plan](const std::filesystem::path& report) {
    return writeOwnTrajectory(plan, report);
  };
  return part;
}

}  // namespace demos::report
