#include "demos/report/stability/trial.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>

#include "bullet_ext/btDelassusConstraintSolver.h"
#include "demos/process/apart.h"
#include "demos/report/captured_step.h"
#include "demos/report/step_problem.h"
#include "demos/scenes/measures.h"
#include "demos/scenes/solver_in_world.h"
#include "demos/scenes/statistics.h"
#include "demos/scenes/step_judge.h"

namespace demos::report::stability {

namespace {

/// Of this process alone: a busy machine must not shorten a trial.
double processorSeconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

/// The names of a trial's numbers, in their order.
const std::vector<std::string> measured{
    "steps",         "worst_error",    "residual_max", "first_error", "first_certified",
    "last_error",    "last_certified", "energy_gain",  "ms",          "solved",
    "out_of_budget", "incompatible",   "non_finite",   "left_out",    "fallbacks"};
enum Column {
  Steps,
  WorstError,
  Residual,
  FirstError,
  FirstCertified,
  LastError,
  LastCertified,
  EnergyGain,
  Ms,
  Solved,
  OutOfBudget,
  Incompatible,
  NonFinite,
  LeftOut,
  Fallbacks
};

/// Islands of more unknowns are not refined, since that takes seconds.
constexpr int mostRefined = 200;

/// The motion that takes place in the first step of a trial, found in a process apart; unknown if
/// that fails.
Certified certifyFirstStep(const Sweep& sweep, double value, double secondsLimit) {
  const auto work = [&] {
    Trial trial = sweep.build(value);
    NamedSolver named("delassus");
    const double cfm = trial.world->dynamics().getSolverInfo().m_globalCfm;
    StepCapture capture(named.solver());
    std::vector<double> numbers;
    capture.beforeSolve = [&](const CapturedStep& step) {
      if (!numbers.empty()) return;  // of the first substep
      const Certified truth = certify(StepProblem(step, cfm), secondsLimit, mostRefined);
      if (!truth.known()) return;
      numbers = {truth.size, double(truth.refined), truth.agreement};
      for (const delassus::Vec6& velocity : truth.motion)
        numbers.insert(numbers.end(), velocity.begin(), velocity.end());
    };
    trial.world->setSolver(capture);
    trial.world->step(trial.timeStep);
    trial.world->setSolver(named.solver());
    return numbers;
  };
  const ApartResult apart = runApart(work, Limits{3 * secondsLimit + 2});
  Certified truth;
  truth.ending = apart.ending;
  if (apart.numbers.empty()) return truth;
  truth.size = apart.numbers[0];
  truth.refined = apart.numbers[1] != 0;
  truth.agreement = apart.numbers[2];
  for (std::size_t at = 3; at + 6 <= apart.numbers.size(); at += 6)
    truth.motion.push_back(Eigen::Map<const delassus::Vec6>(&apart.numbers[at]));
  return truth;
}

/// The error of `inner` in the next step, judged by what `truth` knows of its problem.
struct StepError {
  double error = std::nan("");  ///< |v − v*|_M / |v_f − v*|_M
  bool certified = false;       ///< v* is the motion that takes place, to all digits of a double
};
StepError stepError(Trial& trial, btConstraintSolver& inner, double cfm,
                    const std::function<Certified(const StepProblem&)>& truth) {
  StepError out;
  std::optional<StepProblem> problem;  // of the first substep
  Certified right;
  int solves = 0;
  StepCapture capture(inner);
  capture.beforeSolve = [&](const CapturedStep& step) {
    if (solves++ > 0) return;
    problem.emplace(step, cfm);
    right = truth(*problem);
  };
  capture.afterSolve = [&](const CapturedStep&) {
    if (solves > 1 || !right.known()) return;
    // Reactions of no more than rounding count as none.
    const double momentum = problem->distance(problem->freeMotion(), problem->atRest());
    if (right.size <= 100 * std::numeric_limits<btScalar>::epsilon() * momentum) return;
    constexpr double same = 1e-12;  // two refined answers agree better than that, or not at all
    out.error = problem->distance(problem->currentMotion(), right.motion) / right.size;
    out.certified = right.refined && right.agreement <= same;
  };
  trial.world->setSolver(capture);
  trial.world->step(trial.timeStep);
  trial.world->setSolver(inner);
  return out;
}

/// Runs the method alone with the world, in the process apart.
std::vector<double> live(const Sweep& sweep, double value, const Method& method,
                         double secondsLimit, const MapPlan& plan, const Certified& truth) {
  const double start = processorSeconds();
  Trial trial = sweep.build(value);
  World& world = *trial.world;
  NamedSolver named(method.name);
  SolverInWorld solving(world, named);
  StepJudge judge(solving.timed(), named, solving.sceneCfm());
  world.setSolver(judge.solver());
  const auto gained = energyGainedFrom(world, 1);

  std::vector<double> numbers(measured.size(), 0), milliseconds;
  named.setGeometricStiffness(trial.geometricStiffness);
  for (int step = 0; step < trial.steps; ++step) {
    if (step == 0) {
      const StepError first = stepError(trial, judge.solver(), solving.sceneCfm(),
                                        [&truth](const StepProblem&) { return truth; });
      numbers[FirstError] = first.error;
      numbers[FirstCertified] = first.certified;
    } else {
      world.step(trial.timeStep);
    }
    milliseconds.push_back(1e3 * solving.timed().takeSeconds());

    numbers[Steps] += 1;
    const double error = trial.error((step + 1) * trial.timeStep);
    // An error that is not a number counts as infinite. So does that of a world with bodies that
    // are nowhere.
    const bool lost = std::isnan(error) || !isFinite(world);
    numbers[WorstError] = std::max(numbers[WorstError], lost ? INFINITY : error);
    numbers[EnergyGain] = largerOf(numbers[EnergyGain], gained(0));
    numbers[Residual] = largerOf(numbers[Residual], judge.takeResidual().max);
    if (named.delassus() != nullptr) {
      const delassus::StepReport& report = named.delassus()->report();
      // Counts steps, not islands: it is the share of time in which something was reported.
      const bool said = report.outOfBudget + report.incompatible + report.nonFinite > 0;
      numbers[Solved] += !said;
      numbers[OutOfBudget] += report.outOfBudget > 0;
      numbers[Incompatible] += report.incompatible > 0;
      numbers[NonFinite] += report.nonFinite > 0;
      numbers[LeftOut] += report.leftOut > 0;
    }
    if (lost) numbers[Residual] = std::nan("");
    // A lost world does not come back, and its steps may take very long.
    if (!(numbers[WorstError] <= 10 * sweep.allowed) || processorSeconds() - start > secondsLimit)
      break;
  }
  numbers[Fallbacks] = named.fallbacks();
  StepError last;
  // The problem of a stiffened step is not that of its bodies.
  if (plan.lastCertificateLimit > 0 && !trial.geometricStiffness &&
      processorSeconds() - start <= secondsLimit)
    last =
        stepError(trial, judge.solver(), solving.sceneCfm(), [&plan](const StepProblem& problem) {
          return 3 * problem.contacts() + problem.rows() <= mostRefined
                     ? certify(problem, plan.lastCertificateLimit, mostRefined)
                     : Certified();
        });
  numbers[LastError] = last.error;
  numbers[LastCertified] = last.certified;
  numbers[Ms] = median(milliseconds);
  return numbers;
}

Verdict judge(const Sweep& sweep, int stepsWanted, const ApartResult& run) {
  if (run.ending == Ending::Crashed) return Verdict::Crashes;
  if (run.ending == Ending::TimeLimit) return Verdict::TooSlow;
  const std::vector<double>& n = run.numbers;
  const bool said = n[OutOfBudget] + n[Incompatible] + n[NonFinite] + n[LeftOut] + n[Fallbacks] > 0;
  if (!(n[WorstError] <= sweep.allowed)) return said ? Verdict::FailsAndSays : Verdict::Fails;
  if (n[Steps] < stepsWanted) return Verdict::TooSlow;
  return said ? Verdict::HoldsAndSays : Verdict::Holds;
}

const std::vector<std::pair<Verdict, std::string>> verdictWords{
    {Verdict::Holds, "holds"},
    {Verdict::HoldsAndSays, "holds and says so"},
    {Verdict::FailsAndSays, "fails and says so"},
    {Verdict::Fails, "fails"},
    {Verdict::TooSlow, "too slow"},
    {Verdict::Crashes, "crashes"}};

}  // namespace

std::string toString(Verdict verdict) {
  for (const auto& [known, word] : verdictWords)
    if (known == verdict) return word;
  return "";
}

Verdict verdictOf(const std::string& word) {
  for (const auto& [verdict, known] : verdictWords)
    if (known == word) return verdict;
  throw std::runtime_error("there is no verdict '" + word + "'");
}

bool holds(Verdict verdict) {
  return verdict == Verdict::Holds || verdict == Verdict::HoldsAndSays;
}

MapPlan planFor(const SweepGroup& group, MapPlan plan) {
  if (group.second.empty()) return plan;
  plan.methods = plan.pairMethods;
  plan.certificateLimit = plan.lastCertificateLimit = 0;
  return plan;
}

std::vector<double> valuesOf(const Sweep& sweep, const MapPlan& plan) {
  if (!plan.quick) return sweep.values;
  std::vector<double> values;
  for (std::size_t i = 0; i < sweep.values.size(); i += 3) values.push_back(sweep.values[i]);
  return values;
}

CsvTable measureSweep(const Sweep& sweep, const MapPlan& plan, const Progress& progress) {
  std::vector<std::string> columns{"value", "method", "verdict", "allowed", "steps_wanted"};
  columns.insert(columns.end(), measured.begin(), measured.end());
  CsvTable table(columns);
  const std::vector<double> values = valuesOf(sweep, plan);
  const double limit = plan.secondsLimit * (plan.quick ? 1 : sweep.patience);
  std::set<std::string> givenUp;  // methods
  double done = 0;
  for (const double value : values) {
    const Certified truth = plan.certificateLimit > 0
                                ? certifyFirstStep(sweep, value, plan.certificateLimit)
                                : Certified();
    const int stepsWanted = sweep.build(value).steps;
    for (const Method& method : plan.methods) {
      ApartResult run;
      run.ending = Ending::TimeLimit;
      // A run ends itself at its limit; only a step that never ends is ended from outside.
      if (givenUp.count(method.name) == 0)
        run = runApart([&] { return live(sweep, value, method, limit, plan, truth); },
                       Limits{5 * limit + 2});
      const Verdict verdict = judge(sweep, stepsWanted, run);
      if (sweep.lengthens && verdict == Verdict::TooSlow) givenUp.insert(method.name);
      run.numbers.resize(measured.size(), std::nan(""));
      std::vector<std::string> row{csvNumber(value), method.name, toString(verdict),
                                   csvNumber(sweep.allowed), std::to_string(stepsWanted)};
      for (const double number : run.numbers) row.push_back(csvNumber(number));
      table.add(row);
      progress(++done / double(values.size() * plan.methods.size()));
    }
  }
  return table;
}

}  // namespace demos::report::stability
