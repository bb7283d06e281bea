#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include "bullet_ext/btDelassusConstraintSolver.h"
#include "demos/process/interrupt.h"
#include "demos/report/part.h"
#include "demos/report/same_problem.h"
#include "demos/scenes/catalogue.h"
#include "demos/scenes/measures.h"

namespace demos::report {

namespace {

/// Steps of a scene by the name of what happens in them.
using Samples = std::map<int, std::string>;

/// One step of the scouting run.
struct Seen {
  double change;  ///< |v_f − v|_M: the effect of the reactions
  int modeChanges;
};

/// A scene on our solver with an observer. Every sample is taken from such a run.
class ReferenceRun {
 public:
  explicit ReferenceRun(const SceneDescription& scene)
      : scene_(scene), world_(scene.build()), solver_("delassus"), capture_(solver_.solver()) {
    cfm_ = world_->dynamics().getSolverInfo().m_globalCfm;
    world_->setSolver(capture_);
  }
  ~ReferenceRun() { world_->setSolver(solver_.solver()); }
  ReferenceRun(const ReferenceRun&) = delete;
  ReferenceRun& operator=(const ReferenceRun&) = delete;

  StepCapture& capture() { return capture_; }
  double cfm() const { return cfm_; }
  int modeChanges() const { return solver_.delassus()->report().modeChanges; }
  void step() {
    InterruptWatch::throwIfAsked();
    world_->step(1 / scene_.hz);
  }

 private:
  const SceneDescription& scene_;
  std::unique_ptr<World> world_;
  NamedSolver solver_;
  StepCapture capture_;
  double cfm_;
};

std::vector<Seen> scout(const SceneDescription& scene, const Plan& plan, const Progress& progress) {
  using Clock = std::chrono::steady_clock;
  ReferenceRun run(scene);
  std::vector<Seen> seen;
  std::unique_ptr<StepProblem> problem;
  run.capture().beforeSolve = [&](const CapturedStep& step) {
    problem = std::make_unique<StepProblem>(step, run.cfm());
  };
  run.capture().afterSolve = [&](const CapturedStep&) {
    seen.push_back(
        {problem->distance(problem->freeMotion(), problem->currentMotion()), run.modeChanges()});
  };
  const int steps = int(std::min(scene.seconds, plan.trajectorySeconds) * scene.hz);
  const auto start = Clock::now();
  for (int i = 0; i < steps; ++i) {
    run.step();
    progress(double(i) / steps);
    if (std::chrono::duration<double>(Clock::now() - start).count() > plan.scoutLimit) break;
  }
  return seen;
}

/// Cold: the first step with reactions. Impact: the later one in which reactions do most. Settling:
/// the step after the impact in which most contacts change their mode, or halfway to the end if
/// none does. Resting: the last one.
Samples chooseSamples(const std::vector<Seen>& seen) {
  Samples samples;
  const int steps = int(seen.size());
  int cold = 0;
  while (cold < steps && !(seen[std::size_t(cold)].change > 1e-9)) ++cold;
  if (cold == steps) return samples;

  const auto byChange = [](const Seen& a, const Seen& b) { return a.change < b.change; };
  const auto byModes = [](const Seen& a, const Seen& b) { return a.modeChanges < b.modeChanges; };
  // If two samples fall on one step, the first keeps it.
  samples.emplace(cold, "cold");
  const int last = steps - 1;
  if (last > cold) {
    const auto impact = std::max_element(seen.begin() + cold + 1, seen.end(), byChange);
    const auto after = impact + 1;
    const auto busiest = std::max_element(after, seen.end(), byModes);
    const bool busy = busiest != seen.end() && busiest->modeChanges > 0;
    const int settling =
        busy ? int(busiest - seen.begin()) : (int(impact - seen.begin()) + last) / 2;
    samples.emplace(int(impact - seen.begin()), "impact");
    samples.emplace(settling, "settling");
    samples.emplace(last, "resting");
  }
  return samples;
}

/// All methods on the samples of one scene.
class Comparison {
 public:
  Comparison(const SceneDescription& scene, const Plan& plan, Samples samples)
      : scene_(scene), plan_(plan), samples_(std::move(samples)), memories_(plan.methods.size()) {}

  CsvTable run(const Progress& progress) {
    ReferenceRun run(scene_);
    run.capture().beforeSolve = [&](const CapturedStep& step) {
      const StepProblem problem(step, run.cfm());
      look(step, problem, progress);
    };
    const int last = samples_.rbegin()->first;
    for (step_ = 0; step_ <= last; ++step_) run.step();
    return std::move(table_);
  }

 private:
  /// The methods make warm starts of their own in the steps before a sample.
  bool remembersIn(int step) const {
    const auto next = samples_.lower_bound(step);
    return next != samples_.end() && next->first - step <= plan_.memorySteps;
  }

  void look(const CapturedStep& step, const StepProblem& problem, const Progress& progress) {
    const std::vector<int> earlier = earlierNumbers(step);
    const auto sample = samples_.find(step_);
    if (sample != samples_.end())
      compare(sample->second, step, problem, earlier, progress);
    else if (remembersIn(step_))
      remember(step, problem, earlier);
    else
      for (StepMemory& memory : memories_) memory.clear();
    numberPoints(step);
  }

  void remember(const CapturedStep& step, const StepProblem& problem,
                const std::vector<int>& earlier) {
    const Timing once{plan_.timing.secondsLimit, 0, 0, 0};
    for (std::size_t i = 0; i < plan_.methods.size(); ++i) {
      if (givenUp_.count(i) != 0) continue;
      MethodRun run =
          runMethod(plan_.methods[i], step, problem, carried(memories_[i], earlier), once);
      if (run.ending != Ending::Done) givenUp_[i] = run.ending;
      memories_[i] = std::move(run.memory);
    }
  }

  void compare(const std::string& phase, const CapturedStep& step, const StepProblem& problem,
               const std::vector<int>& earlier, const Progress& progress) {
    const Certified truth = certify(problem, plan_.certificateLimit);
    const StepMemory nothing(earlier.size());
    for (std::size_t i = 0; i < plan_.methods.size(); ++i) {
      for (const char* view : {"cold", "warm"}) {
        const bool cold = view == std::string("cold");
        MethodRun run;
        if (givenUp_.count(i) != 0)
          run.ending = givenUp_[i];
        else
          run = runMethod(plan_.methods[i], step, problem,
                          cold ? nothing : carried(memories_[i], earlier), plan_.timing);
        if (run.ending != Ending::Done) givenUp_[i] = run.ending;
        addRow(phase, view, plan_.methods[i], problem, truth, run);
        if (!cold) memories_[i] = std::move(run.memory);
      }
      progress((done_ + double(i + 1) / double(plan_.methods.size())) / double(samples_.size()));
    }
    ++done_;
  }

  void addRow(const std::string& phase, const std::string& view, const Method& method,
              const StepProblem& problem, const Certified& truth, const MethodRun& run) {
    double error = std::nan(""), wrong = std::nan("");
    if (run.ending == Ending::Done && truth.known()) {
      error = problem.distance(run.motion, truth.motion) / truth.size;
      const auto right = problem.modes(truth.motion), read = problem.modes(run.motion);
      int differ = 0;
      for (std::size_t i = 0; i < right.size(); ++i) differ += right[i] != read[i];
      wrong = right.empty() ? 0 : double(differ) / double(right.size());
    }
    const std::string ending =
        run.ending == Ending::Done && run.fallbacks > 0 ? "gave up" : toString(run.ending);
    table_.add({phase,
                std::to_string(step_),
                std::to_string(problem.contacts()),
                std::to_string(problem.rows()),
                view,
                method.name,
                method.family,
                ending,
                csvNumber(run.seconds),
                csvNumber(run.secondsLow),
                csvNumber(run.secondsHigh),
                std::to_string(run.repeats),
                csvNumber(error),
                csvNumber(run.residualMax),
                csvNumber(run.residualRms),
                csvNumber(wrong),
                csvNumber(run.regions),
                csvNumber(run.factorisations),
                csvNumber(run.solveSeconds),
                csvNumber(run.aroundSeconds),
                toString(truth.ending),
                csvNumber(truth.residual),
                csvNumber(truth.agreement),
                csvNumber(truth.unsolved),
                csvNumber(truth.size)});
  }

  const SceneDescription& scene_;
  const Plan& plan_;
  Samples samples_;
  std::vector<StepMemory> memories_;
  /// Methods that took too long or crashed; they are not asked again.
  std::map<std::size_t, Ending> givenUp_;
  CsvTable table_ = sameProblemTable();
  int step_ = 0, done_ = 0;
};

}  // namespace

CsvTable sameProblemTable() {
  return CsvTable({"phase",
                   "step",
                   "contacts",
                   "rows",
                   "view",
                   "method",
                   "family",
                   "ending",
                   "seconds",
                   "seconds_low",
                   "seconds_high",
                   "repeats",
                   "error",
                   "residual_max",
                   "residual_rms",
                   "wrong_modes",
                   "regions",
                   "factorisations",
                   "solve_seconds",
                   "around_seconds",
                   "certificate_ending",
                   "certificate_residual",
                   "certificate_agreement",
                   "certificate_unsolved",
                   "free_distance"});
}

CsvTable measureSameProblem(const SceneDescription& scene, const Plan& plan,
                            const Progress& progress) {
  constexpr double scoutShare = 0.2;
  const Samples samples =
      chooseSamples(scout(scene, plan, [&](double done) { progress(scoutShare * done); }));
  if (samples.empty()) return sameProblemTable();
  return Comparison(scene, plan, samples).run([&](double done) {
    progress(scoutShare + (1 - scoutShare) * done);
  });
}

}  // namespace demos::report
