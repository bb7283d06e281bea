#pragma once

#include <optional>
#include <string>
#include <vector>

#include "demos/report/step_problem.h"
#include "demos/scenes/solvers.h"

namespace demos::report {

/// One way to solve a step: a solver with its settings. The methods of one family differ in how
/// much work they do.
struct Method {
  std::string name;    ///< as in `run`
  std::string family;  ///< that of its name
};

Method methodNamed(const std::string& name);
std::vector<Method> methodsNamed(const std::vector<std::string>& names);

/// The results of one method on one step.
struct MethodRun {
  Ending ending = Ending::Crashed;
  double seconds = 0;                      ///< of all groups, median over the repeats
  double secondsLow = 0, secondsHigh = 0;  ///< quartiles
  int repeats = 0;
  double residualMax = 0, residualRms = 0;  ///< natural residual, m/s
  int fallbacks = 0;                        ///< groups that the method gave up
  double regions = 0, factorisations = 0;   ///< ours only: means over the first run and the repeats
  double solveSeconds = 0, aroundSeconds = 0;  ///< the same: in the solve, before and after it
  double peakBytes = 0;  ///< resident memory that the first run added; NaN if not known
  Motion motion;
  StepMemory memory;
};

/// How often a method is timed.
struct Timing {
  double secondsLimit;  ///< for the first run; a slower method is given up
  int leastRepeats, mostRepeats;
  double seconds;  ///< repeats end early when they have taken that long altogether
};

/// Gives the step to the method in a process of its own, with `memory` as the impulses stored in
/// its contact points; the world stays as it is. The first run is judged, the repeats are timed,
/// each from the same start as the first. A solver's memories beside the points are missing: in
/// ours, joints and fresh points begin from nothing.
MethodRun runMethod(const Method& method, const CapturedStep& step, const StepProblem& problem,
                    const StepMemory& memory, const Timing& timing);

}  // namespace demos::report
