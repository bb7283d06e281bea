#pragma once

#include <cmath>

#include "demos/report/stability/sweep.h"
#include "demos/scenes/solvers.h"

namespace demos::report::stability {

/// The largest error of a trial that `delassus` steps. It looks once in `every` steps and at the
/// end.
inline double worstError(Trial trial, int every = 1) {
  NamedSolver named("delassus");
  named.configure(trial.world->dynamics().getSolverInfo());
  named.setGeometricStiffness(trial.geometricStiffness);
  trial.world->setSolver(named.solver());
  double worst = 0;
  for (int step = 1; step <= trial.steps; ++step) {
    trial.world->step(trial.timeStep);
    if (step % every != 0 && step != trial.steps) continue;
    const double error = trial.error(step * trial.timeStep);
    worst = std::isnan(error) ? INFINITY : std::max(worst, error);
  }
  trial.world.reset();  // before its solver
  return worst;
}

}  // namespace demos::report::stability
