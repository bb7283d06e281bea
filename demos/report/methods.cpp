#include "demos/report/methods.h"

#include <algorithm>
#include <type_traits>

#include "bullet_ext/btDelassusConstraintSolver.h"
#include "demos/report/memory_peak.h"
#include "demos/scenes/judge.h"
#include "demos/scenes/statistics.h"
#include "demos/scenes/timed_solver.h"

namespace demos::report {

using delassus::Vec6;

namespace {

constexpr std::size_t pointLength = 10;

/// Visits the numbers of a run before its motion and memory, in the order in which they come from
/// the process apart.
template <class Run, class Visit>
void visitNumbers(Run& run, const Visit& visit) {
  visit(run.seconds);
  visit(run.secondsLow);
  visit(run.secondsHigh);
  visit(run.repeats);
  visit(run.residualMax);
  visit(run.residualRms);
  visit(run.fallbacks);
  visit(run.regions);
  visit(run.factorisations);
  visit(run.solveSeconds);
  visit(run.aroundSeconds);
  visit(run.peakBytes);
}

void append(std::vector<double>& numbers, const StepMemory& memory) {
  for (const PointMemory& point : memory) {
    numbers.insert(numbers.end(), {point.normal, point.lateral1, point.lateral2, point.mode});
    for (const btVector3& direction : {point.direction1, point.direction2})
      numbers.insert(numbers.end(), {direction[0], direction[1], direction[2]});
  }
}

std::vector<double> packed(const MethodRun& run) {
  std::vector<double> numbers;
  visitNumbers(run, [&](auto number) { numbers.push_back(double(number)); });
  for (const Vec6& velocity : run.motion)
    numbers.insert(numbers.end(), velocity.begin(), velocity.end());
  append(numbers, run.memory);
  return numbers;
}

MethodRun unpacked(const std::vector<double>& numbers, std::size_t bodies) {
  MethodRun run;
  run.ending = Ending::Done;
  auto at = numbers.begin();
  visitNumbers(run, [&](auto& number) { number = std::decay_t<decltype(number)>(*at++); });
  for (std::size_t i = 0; i < bodies; ++i, at += 6)
    run.motion.push_back(Eigen::Map<const Vec6>(&*at));
  for (; at + pointLength <= numbers.end(); at += pointLength) {
    const auto number = [at](int i) { return btScalar(at[i]); };
    run.memory.push_back({number(0),
                          number(1),
                          number(2),
                          number(3),
                          {number(4), number(5), number(6)},
                          {number(7), number(8), number(9)}});
  }
  return run;
}

/// Runs in the process apart.
MethodRun solveRepeatedly(const Method& method, const CapturedStep& step,
                          const StepProblem& problem, const StepMemory& memory,
                          const Timing& timing) {
  MethodRun run;
  NamedSolver named(method.name);
  btContactSolverInfo info = *step.info;
  named.configure(info);
  writeMemory(step, memory);
  const SavedState start(step);

  TimedSolver timed(named.solver());
  MemoryPeak peak(timed);
  JudgedSolver judged(peak, btScalar(problem.cfm()));
  step.solve(judged, info);
  const double firstSeconds = timed.takeSeconds();
  const StepResidual first = judged.takeResidual();
  run.residualMax = first.max;
  run.residualRms = first.rms();
  run.motion = problem.currentMotion();
  run.memory = readMemory(step);
  run.fallbacks = named.fallbacks();

  // Steps are not announced to the solver (prepareSolve). So ours keeps nothing beside the points;
  // otherwise a repeat would begin from the answer of the run before. The first run warms caches
  // and workspaces; it counts only if there is no time for another.
  std::vector<double> seconds;
  double spent = firstSeconds;
  const auto another = [&] {
    const int count = int(seconds.size());
    return count < timing.mostRepeats &&
           (count < timing.leastRepeats ? spent + firstSeconds < timing.secondsLimit
                                        : spent < timing.seconds);
  };
  while (another()) {
    start.restore();
    step.solve(timed, info);
    seconds.push_back(timed.takeSeconds());
    spent += seconds.back();
  }
  const double runs = 1 + double(seconds.size());
  if (seconds.empty()) seconds.push_back(firstSeconds);

  delassus::StepReport all;
  if (named.delassus() != nullptr) all = named.delassus()->report();
  run.seconds = median(seconds);
  run.secondsLow = quantile(seconds, 0.25);
  run.secondsHigh = quantile(seconds, 0.75);
  run.repeats = int(seconds.size());
  run.regions = all.regions / runs;
  run.factorisations = all.factorisations / runs;
  run.solveSeconds = (all.secondsPlan + all.secondsSolve + all.secondsPush) / runs;
  run.aroundSeconds = (all.secondsGather + all.secondsWriteBack) / runs;
  run.peakBytes = peak.bytes();
  return run;
}

}  // namespace

Method methodNamed(const std::string& name) {
  Method method{name, parseSolverName(name).family};
  NamedSolver{name};  // throws UnknownSolver now rather than in an hour
  return method;
}

std::vector<Method> methodsNamed(const std::vector<std::string>& names) {
  std::vector<Method> methods;
  for (const std::string& name : names) methods.push_back(methodNamed(name));
  return methods;
}

MethodRun runMethod(const Method& method, const CapturedStep& step, const StepProblem& problem,
                    const StepMemory& memory, const Timing& timing) {
  // The judge takes time beside the method's own.
  const Limits limits{2 * timing.secondsLimit + 1};
  const ApartResult apart = runApart(
      [&] { return packed(solveRepeatedly(method, step, problem, memory, timing)); }, limits);
  MethodRun run;
  run.ending = apart.ending;
  run.seconds = apart.seconds;
  if (apart.ending == Ending::Done) run = unpacked(apart.numbers, std::size_t(problem.bodies()));
  if (run.seconds > timing.secondsLimit && run.ending == Ending::Done)
    run.ending = Ending::TimeLimit;
  return run;
}

}  // namespace demos::report
