#pragma once

#include <string>

#include "demos/report/csv.h"
#include "demos/report/methods.h"
#include "demos/report/settings.h"
#include "demos/report/stability/sweep.h"

namespace demos::report::stability {

/// How a solver fared in one trial.
enum class Verdict {
  Holds,         ///< the law holds, and the solver reported nothing
  HoldsAndSays,  ///< the law holds; some steps ended above the tolerance, and that was reported
  FailsAndSays,  ///< the law is broken, and some steps were reported
  /// The law is broken in silence: by the solver, or by the time stepping and the narrow phase.
  Fails,
  TooSlow,  ///< held until its time was up, or did not come back from a step
  Crashes,  ///< or asks for more memory than there is
};
std::string toString(Verdict verdict);
Verdict verdictOf(const std::string& word);
bool holds(Verdict verdict);

/// How much is measured.
struct MapPlan {
  std::vector<Method> methods;
  std::vector<Method> pairMethods;  ///< of two things at once
  double secondsLimit;  ///< of a trial, of the processor, times the patience of its sweep
  /// Limits of one solve, s; 0: none. The first is for the motion that takes place in the first
  /// step. The second is for that in the step after a trial, which differs from solver to solver.
  double certificateLimit, lastCertificateLimit;
  bool quick = false;
};

/// Pairs take less work: the motions of their single steps are not compared with anything.
MapPlan planFor(const SweepGroup& group, MapPlan plan);

/// All methods at all values of a sweep, each trial in a process of its own.
CsvTable measureSweep(const Sweep& sweep, const MapPlan& plan, const Progress& progress);

/// The values that are tried: all, or in a quick map every third one.
std::vector<double> valuesOf(const Sweep& sweep, const MapPlan& plan);

}  // namespace demos::report::stability
