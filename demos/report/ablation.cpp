#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "bullet_ext/btDelassusConstraintSolver.h"
#include "demos/process/interrupt.h"
#include "demos/report/markdown.h"
#include "demos/report/part.h"
#include "demos/report/step_problem.h"
#include "demos/scenes/catalogue.h"
#include "demos/scenes/statistics.h"
#include "demos/scenes/step_totals.h"
#include "demos/scenes/timed_solver.h"
#include "demos/table.h"

namespace demos::report {

namespace {

using delassus::Economies;

constexpr const char* folderName = "ablation";

struct Economy {
  const char* name;
  bool Economies::*member;
  const char* without;  ///< what is done if it is off
};

const std::vector<Economy> economies{
    {"tangents", &Economies::tangents, "three unknowns for contacts without friction too"},
    {"free", &Economies::freeIslands, "W also where no contact approaches"},
    {"kept", &Economies::keptIslands,
     "islands that still keep the law are solved again, from nothing"},
    {"formula", &Economies::closedForms, "single contacts and rows are walked"},
    {"one region", &Economies::oneRegion, "sweeps also where there is only one region"},
    {"joints", &Economies::joints, "sweeps over joints, and their share in all regions"},
    {"factors", &Economies::factors, "a factorisation also where region and W stand"},
    {"welds", &Economies::weldedContacts, "contacts between bodies that welds make one"},
    {"pushes", &Economies::pushes, "a push problem also without deep penetrations"},
    {"events", &Economies::events, "contact events though nobody listens"},
    {"storage", &Economies::storage, "memory is let go after each step"}};

/// Our solver without one economy, or with all of them, and the times it took.
class Variant {
 public:
  explicit Variant(const Economy* without)
      : solver_(without ? without->name : "all", optionsWithout(without)),
        timed_(solver_.solver()) {}

  /// Solves the step as it is, timed. Joints get back the impulses that this solver left in them,
  /// by which it recognises them.
  void solve(const CapturedStep& step) {
    forEachJoint(step, [this](btTypedConstraint& joint) {
      const auto left = impulses_.find(&joint);
      if (left != impulses_.end()) joint.internalSetAppliedImpulse(left->second);
    });
    timed_.prepareSolve(0, 0);
    step.solve(timed_, *step.info);
    forEachJoint(step, [this](btTypedConstraint& joint) {
      impulses_[&joint] = joint.internalGetAppliedImpulse();
    });
    milliseconds_.push_back(1e3 * timed_.takeSeconds());
    totals_.add(solver_.delassus()->report());
  }
  void noteDifference(double difference) { difference_ = largerOf(difference_, difference); }

  /// Of each step, ms.
  const std::vector<double>& milliseconds() const { return milliseconds_; }
  double difference() const { return difference_; }
  const StepTotals& totals() const { return totals_; }

 private:
  template <class Visit>
  static void forEachJoint(const CapturedStep& step, Visit visit) {
    for (const CapturedStep::Group& group : step.groups)
      for (btTypedConstraint* joint : group.constraints) visit(*joint);
  }
  static delassus::Options optionsWithout(const Economy* economy) {
    delassus::Options options;
    if (economy) options.economies.*(economy->member) = false;
    return options;
  }

  NamedSolver solver_;
  TimedSolver timed_;
  std::map<const btTypedConstraint*, btScalar> impulses_;
  std::vector<double> milliseconds_;
  double difference_ = 0;
  StepTotals totals_;
};

/// The trajectory is that of the solver with all economies. All variants solve each of its steps in
/// turn, from the same stored impulses; the order begins with another variant in each step.
class Race {
 public:
  explicit Race(double cfm) : cfm_(cfm) {
    variants_.push_back(std::make_unique<Variant>(nullptr));
    for (const Economy& economy : economies)
      variants_.push_back(std::make_unique<Variant>(&economy));
  }

  void solve(const CapturedStep& step) {
    const StepProblem problem(step, cfm_);
    const SavedState start(step);
    if (busy_.empty()) {
      // The first solver to run would pay for everything the machine has not met yet.
      Variant(nullptr).solve(step);
      start.restore();
    }
    const int matricesBefore = all().totals().sum.matrices;
    std::vector<Motion> motions(variants_.size());
    for (std::size_t k = 0; k < variants_.size(); ++k) {
      const std::size_t i = (k + busy_.size()) % variants_.size();
      variants_[i]->solve(step);
      motions[i] = problem.currentMotion();
      start.restore();
    }
    busy_.push_back(all().totals().sum.matrices > matricesBefore);
    const double size = problem.distance(problem.freeMotion(), motions[0]);
    if (!(size > 0)) return;
    for (std::size_t i = 0; i < variants_.size(); ++i)
      variants_[i]->noteDifference(problem.distance(motions[i], motions[0]) / size);
  }

  CsvTable table() const {
    CsvTable table({"without", "calm_steps", "calm_ms", "calm_ratio", "busy_steps", "busy_ms",
                    "busy_ratio", "difference", "unknowns", "matrices", "sweeps", "factorisations",
                    "push_islands", "events"});
    for (std::size_t i = 0; i < variants_.size(); ++i)
      add(i == 0 ? "nothing" : economies[i - 1].name, *variants_[i], table);
    return table;
  }

 private:
  const Variant& all() const { return *variants_[0]; }

  void add(const std::string& name, const Variant& variant, CsvTable& table) const {
    std::vector<double> numbers;
    for (const bool busy : {false, true}) {
      std::vector<double> times, ratios;
      for (std::size_t k = 0; k < busy_.size(); ++k) {
        if (busy_[k] != busy) continue;
        times.push_back(variant.milliseconds()[k]);
        ratios.push_back(times.back() / all().milliseconds()[k]);
      }
      numbers.insert(numbers.end(), {double(times.size()), median(times), median(ratios)});
    }
    const StepTotals& totals = variant.totals();
    numbers.insert(numbers.end(),
                   {variant.difference(), totals.aStep(totals.sum.plan.unknowns),
                    totals.aStep(totals.sum.matrices), totals.aStep(totals.sum.sweeps),
                    totals.aStep(totals.sum.factorisations), totals.aStep(totals.sum.pushIslands),
                    totals.aStep(totals.sum.events)});
    std::vector<std::string> row{name};
    for (const double number : numbers) row.push_back(csvNumber(number));
    table.add(row);
  }

  double cfm_;
  std::vector<std::unique_ptr<Variant>> variants_;  ///< the first has all economies
  std::vector<bool> busy_;                          ///< of each step: whether the first built any W
};

CsvTable measureScene(const SceneDescription& scene, const Plan& plan, const Progress& progress) {
  using Clock = std::chrono::steady_clock;
  const std::unique_ptr<World> world = scene.build();
  NamedSolver usual("delassus");
  Race race(world->dynamics().getSolverInfo().m_globalCfm);
  StepCapture capture(usual.solver());
  capture.beforeSolve = [&race](const CapturedStep& step) { race.solve(step); };
  world->setSolver(capture);
  const int steps = std::max(1, int(std::min(scene.seconds, plan.ablationSeconds) * scene.hz));
  const auto start = Clock::now();
  for (int i = 0; i < steps; ++i) {
    InterruptWatch::throwIfAsked();
    world->step(1 / scene.hz);
    progress(double(i + 1) / steps);
    if (std::chrono::duration<double>(Clock::now() - start).count() > plan.ablationLimit) break;
  }
  world->setSolver(usual.solver());
  return race.table();
}

std::vector<std::string> headingOf(const char* first) {
  std::vector<std::string> heading{"scene", first};
  for (const Economy& economy : economies) heading.emplace_back(economy.name);
  return heading;
}

/// "1.4", and bold if it is beyond the difference between two runs of the same solver.
std::string ratioCell(double ratio) {
  constexpr double noise = 1.05;
  if (!std::isfinite(ratio)) return "";
  const std::string word = ratio < 10 ? shortNumber(ratio, 3) : std::to_string(std::lround(ratio));
  return ratio > noise ? "**" + word + "**" : word;
}

/// One line of a table: the time with all economies, then the ratios without each.
std::vector<std::string> lineOf(const std::string& scene, const CsvTable& table,
                                const std::string& prefix) {
  std::vector<std::string> line{scene};
  for (int row = 0; row < table.rows(); ++row)
    line.push_back(row == 0 ? shortMs(table.number(row, prefix + "ms"))
                            : ratioCell(table.number(row, prefix + "ratio")));
  return line;
}

Words writeAblation(const Plan& plan, const std::filesystem::path& report) {
  const std::filesystem::path folder = report / folderName;
  constexpr int fewest = 5;  // fewest steps whose median means something
  MarkdownTable calm(headingOf("ms a calm step")), busy(headingOf("ms a busy step"));
  double difference = -1;
  std::string where;
  for (const std::string& scene : plan.ablationScenes) {
    if (!std::filesystem::exists(folder / (scene + ".csv"))) continue;
    const CsvTable table = CsvTable::read(folder / (scene + ".csv"));
    if (table.number(0, "calm_steps") >= fewest) calm.add(lineOf(scene, table, "calm_"));
    if (table.number(0, "busy_steps") >= fewest) busy.add(lineOf(scene, table, "busy_"));
    for (int row = 0; row < table.rows(); ++row) {
      if (!(table.number(row, "difference") > difference)) continue;
      difference = table.number(row, "difference");
      where = scene + ", without *" + table.text(row, "without") + "*";
    }
  }
  if (where.empty()) return {};
  Words words;
  words.body =
      "## What is left out where a scene does not need it\n\n"
      "Each economy of `delassus` switched off in turn, the others on. The steps are those of the "
      "trajectory with all economies;\n"
      "each is given to all variants in turn in one process, from the same stored impulses. Told "
      "is the median over the steps of\n"
      "the time without the economy over that with all of them; bold where it is more than 5 % "
      "longer. The largest difference of\n"
      "the motion, |v − v°|_M / |v_f − v°|_M with v° that of all economies, is " +
      shortNumber(difference, 2) + " (" + where + ").\n\n";
  for (const Economy& economy : economies)
    words.body += std::string("* *") + economy.name + "* off: " + economy.without + "\n";
  words.body += "\nCalm steps, in which all islands are free or still keep the law:\n\n" +
                calm.text() + "Busy steps, in which at least one island is solved:\n\n" +
                busy.text();
  return words;
}

}  // namespace

Part ablationPart(const Plan& plan) {
  Part part;
  part.name = folderName;
  for (const std::string& scene : plan.ablationScenes)
    part.units.push_back({scene, [&plan, scene](const Progress& progress) {
                            return measureScene(findScene(scene), plan, progress);
                          }});
  part.write = [&plan](const std::filesystem::path& report) { return writeAblation(plan, report); };
  return part;
}

}  // namespace demos::report
