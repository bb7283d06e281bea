#include "demos/report/methods.h"

#include <algorithm>
#include <chrono>

#include "bullet_ext/btDelassusConstraintSolver.h"
#include "demos/report/memory_peak.h"
#include "demos/scenes/judge.h"
#include "demos/scenes/statistics.h"
#include "demos/scenes/timed_solver.h"

namespace demos::report {

using delassus::Vec6;

namespace {

/// The numbers of a MethodRun before the motion and the memory begin.
constexpr std::size_t headLength = 12;
constexpr std::size_t pointLength = 10;

void append(std::vector<double>& numbers, const StepMemory& memory) {
  for (const PointMemory& point : memory) {
    numbers.insert(numbers.end(), {point.normal, point.lateral1, point.lateral2, point.mode});
    for (const btVector3& direction : {point.direction1, point.direction2})
      numbers.insert(numbers.end(), {direction[0], direction[1], direction[2]});
  }
}

MethodRun unpacked(const std::vector<double>& numbers, std::size_t bodies) {
  MethodRun run;
  run.ending = Ending::Done;
  auto at = numbers.begin();
  for (double* field : {&run.seconds, &run.secondsLow, &run.secondsHigh}) *field = *at++;
  run.repeats = int(*at++);
  for (double* field : {&run.residualMax, &run.residualRms}) *field = *at++;
  run.fallbacks = int(*at++);
  for (double* field :
       {&run.regions, &run.factorisations, &run.solveSeconds, &run.aroundSeconds, &run.peakBytes})
    *field = *at++;
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

/// Work of the process apart.
std::vector<double> solveRepeatedly(const Method& method, const CapturedStep& step,
                                    const StepProblem& problem, const StepMemory& memory,
                                    const Timing& timing) {
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
  const Verdict verdict = judged.takeVerdict();
  const Motion motion = problem.currentMotion();
  const StepMemory written = readMemory(step);
  const int fallbacks = named.fallbacks();

  // Steps are not announced to the solver (prepareSolve): so ours keeps nothing beside the points, or a repeat would begin from
  // the answer of the run before. The first run warms caches and workspaces; it counts only where there is no time for another.
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
  std::vector<double> numbers{median(seconds),
                              quantile(seconds, 0.25),
                              quantile(seconds, 0.75),
                              double(seconds.size()),
                              verdict.max,
                              verdict.rms(),
                              double(fallbacks),
                              all.regions / runs,
                              all.factorisations / runs,
                              (all.secondsPlan + all.secondsSolve + all.secondsPush) / runs,
                              (all.secondsGather + all.secondsWriteBack) / runs,
                              peak.bytes()};
  for (const Vec6& velocity : motion)
    numbers.insert(numbers.end(), velocity.begin(), velocity.end());
  append(numbers, written);
  return numbers;
}

}  // namespace

Method methodNamed(const std::string& name) {
  Method method{name, name.substr(0, name.find_first_of(":/"))};
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
  static_assert(headLength == 12);
  // The judge takes its time too, outside the method's own.
  const Limits limits{2 * timing.secondsLimit + 1};
  const ApartResult apart =
      runApart([&] { return solveRepeatedly(method, step, problem, memory, timing); }, limits);
  MethodRun run;
  run.ending = apart.ending;
  run.seconds = apart.seconds;
  if (apart.ending == Ending::Done) run = unpacked(apart.numbers, std::size_t(problem.bodies()));
  if (run.seconds > timing.secondsLimit && run.ending == Ending::Done)
    run.ending = Ending::TimeLimit;
  return run;
}

}  // namespace demos::report
