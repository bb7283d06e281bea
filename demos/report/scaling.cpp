#include <cmath>
#include <set>

#include "demos/process/interrupt.h"
#include "demos/report/figure.h"
#include "demos/report/markdown.h"
#include "demos/report/part.h"
#include "demos/scenes/builders.h"
#include "demos/table.h"

namespace demos::report {

namespace {

constexpr const char* folderName = "scaling";

/// A scene of any size, made for about a given number of contacts.
struct Growing {
  std::string name, what;
  std::function<std::unique_ptr<World>(double contacts)> build;
  int stepsBefore;  ///< steps on si:10 before the problem is taken
};

std::vector<Growing> growingScenes() {
  return {{"pyramid", "flat pyramid of boxes, started",
           [](double contacts) {
             return buildPyramid(std::max(1, int(std::lround(std::sqrt(contacts / 4)))));
           },
           3},
          {"wall", "brick wall twice as wide as high in bricks, started",
           [](double contacts) {
             constexpr double perBrick = 7.4;
             const double bricks = contacts / perBrick;
             const int rows = std::max(1, int(std::lround(std::sqrt(bricks / 2))));
             return buildWall(std::max(1, int(std::lround(bricks / rows))), rows);
           },
           3},
          {"pile", "spheres poured into a bin for a second",
           [](double contacts) {
             constexpr double perSphere = 3;
             return buildSpheresBin(std::max(1, int(std::lround(std::cbrt(contacts / perSphere)))));
           },
           60}};
}

/// The step after the start of a world, solved by all methods still in the race.
class SizeRun {
 public:
  SizeRun(const Plan& plan, std::set<std::string>& outOfRace, CsvTable& table)
      : plan_(plan), outOfRace_(outOfRace), table_(table) {}

  void run(const Growing& growing, double contacts, const Progress& progress) {
    const std::unique_ptr<World> world = growing.build(contacts);
    NamedSolver usual("si:10");
    const double cfm = world->dynamics().getSolverInfo().m_globalCfm;
    usual.configure(world->dynamics().getSolverInfo());
    world->setSolver(usual.solver());
    for (int i = 0; i < growing.stepsBefore; ++i) {
      InterruptWatch::throwIfAsked();
      world->step(1.0 / 60);
    }
    StepCapture capture(usual.solver());
    capture.beforeSolve = [&](const CapturedStep& step) {
      measure(step, StepProblem(step, cfm), progress);
    };
    world->setSolver(capture);
    world->step(1.0 / 60);
    world->setSolver(usual.solver());
  }

 private:
  void measure(const CapturedStep& step, const StepProblem& problem, const Progress& progress) {
    const StepMemory nothing(readMemory(step).size());
    for (std::size_t i = 0; i < plan_.scalingMethods.size(); ++i) {
      const Method& method = plan_.scalingMethods[i];
      if (outOfRace_.count(method.name) == 0) {
        const MethodRun run = runMethod(method, step, problem, nothing, plan_.scalingTiming);
        // Larger problems would take even longer.
        if (run.ending != Ending::Done) outOfRace_.insert(method.name);
        table_.add(
            {std::to_string(problem.contacts()), std::to_string(problem.bodies()), method.name,
             method.family,
             run.fallbacks > 0 && run.ending == Ending::Done ? "gave up" : toString(run.ending),
             csvNumber(run.seconds), csvNumber(run.secondsLow), csvNumber(run.secondsHigh),
             std::to_string(run.repeats), csvNumber(run.residualMax), csvNumber(run.peakBytes)});
      }
      progress(double(i + 1) / double(plan_.scalingMethods.size()));
    }
  }

  const Plan& plan_;
  std::set<std::string>& outOfRace_;
  CsvTable& table_;
};

CsvTable measureScaling(const Growing& growing, const Plan& plan, const Progress& progress) {
  CsvTable table({"contacts", "bodies", "method", "family", "ending", "seconds", "seconds_low",
                  "seconds_high", "repeats", "residual_max", "peak_bytes"});
  std::set<std::string> outOfRace;
  const double sizes = double(plan.contactCounts.size());
  for (std::size_t i = 0; i < plan.contactCounts.size(); ++i)
    SizeRun(plan, outOfRace, table).run(growing, plan.contactCounts[i], [&](double done) {
      progress((double(i) + done) / sizes);
    });
  return table;
}

/// The results of one method, by rising size.
struct Growth {
  std::vector<Place> cost;    ///< µs a contact over contacts
  std::vector<Place> memory;  ///< MB over contacts
  double lastContacts = 0, lastMs = 0, lastResidual = 0;
  std::string end;  ///< why it went no further
};

Growth growthOf(const CsvTable& table, const std::string& method) {
  Growth growth;
  for (int row = 0; row < table.rows(); ++row) {
    if (table.text(row, "method") != method) continue;
    const double contacts = table.number(row, "contacts");
    const std::string& ending = table.text(row, "ending");
    if (ending != "done") {
      growth.end = ending + " at " + table.text(row, "contacts");
      if (ending != "gave up") break;
      continue;
    }
    const auto perContact = [&](const char* column) {
      return 1e6 * table.number(row, column) / contacts;
    };
    growth.cost.push_back({contacts, perContact("seconds"), contacts, contacts});
    const double bytes = table.number(row, "peak_bytes");
    // The first run of any code adds its own pages, and tables that Bullet makes once.
    constexpr double megabyte = 1e6, leastTold = 2 * megabyte;
    if (bytes > leastTold) growth.memory.push_back({contacts, bytes / megabyte});
    growth.lastContacts = contacts;
    growth.lastMs = 1e3 * table.number(row, "seconds");
    growth.lastResidual = table.number(row, "residual_max");
  }
  return growth;
}

Panel panelOf(const CsvTable& table, const Plan& plan, bool memory, const std::string& title) {
  Panel panel;
  panel.title = title;
  panel.xLabel = "contacts";
  panel.yLabel = memory ? "memory at its highest, MB" : "time, µs a contact";
  for (const Method& method : plan.scalingMethods) {
    const Growth growth = growthOf(table, method.name);
    Curve curve;
    curve.label = method.name;
    curve.colour = familyColour(method.family);
    curve.width = method.name == "delassus" ? 3 : 1.5;
    curve.line = memory ? growth.memory : growth.cost;
    panel.curves.push_back(curve);
  }
  return panel;
}

Words writeScaling(const Plan& plan, const std::filesystem::path& report) {
  const std::filesystem::path folder = report / folderName;
  Words words;
  std::string trouble;
  for (const Growing& growing : growingScenes()) {
    if (!std::filesystem::exists(folder / (growing.name + ".csv"))) continue;
    const CsvTable data = CsvTable::read(folder / (growing.name + ".csv"));
    Figure figure;
    figure.title = growing.name + ", one step from cold: cost against size";
    figure.panels = {panelOf(data, plan, false, "time"), panelOf(data, plan, true, "memory")};
    addFault(trouble, draw(figure, folder, growing.name));
    MarkdownTable table(
        {"solver", "largest done, contacts", "its time, ms", "its residual, m/s", "then"});
    for (const Method& method : plan.scalingMethods) {
      const Growth growth = growthOf(data, method.name);
      table.add({code(method.name), shortNumber(growth.lastContacts, 6), shortMs(growth.lastMs),
                 shortNumber(growth.lastResidual, 2), growth.end});
    }
    words.body += "### " + growing.name + ": " + growing.what + "\n\n" +
                  picture(folderName, growing.name, "cost against size, " + growing.name) +
                  table.text();
  }
  if (words.body.empty()) return {};
  words.body = "## Scaling\n\nOne step from cold, with a limit of " +
               shortNumber(plan.scalingTiming.secondsLimit) +
               " s a method and problem; beyond it a method is not asked again. Memory is the "
               "resident memory that the\n"
               "first solve came to need; less than 2 MB is not told apart. Where an MLCP solver "
               "gave up, its time is not shown.\n\n" +
               words.body + trouble;
  return words;
}

}  // namespace

Part scalingPart(const Plan& plan) {
  Part part;
  part.name = folderName;
  for (const Growing& growing : growingScenes())
    part.units.push_back({growing.name, [&plan, growing](const Progress& progress) {
                            return measureScaling(growing, plan, progress);
                          }});
  part.write = [&plan](const std::filesystem::path& report) { return writeScaling(plan, report); };
  return part;
}

}  // namespace demos::report
