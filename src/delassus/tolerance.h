#pragma once

#include <algorithm>

#include "delassus/options.h"
#include "delassus/problem.h"

namespace delassus {

/// The natural residual that an answer may leave, m/s, where friction is at most μ:
///
///     max(toleranceFor(μ) largest demand, rounding of q)
inline double toleranceOf(const Options& options, double friction, double demand, double roundOff) {
  return std::max(options.toleranceFor(friction) * demand, roundOff);
}

/// The same for a problem.
inline double toleranceOf(const Options& options, const Problem& problem) {
  const double widest = problem.contacts() > 0 ? problem.friction.maxCoeff() : 0;
  return toleranceOf(options, widest, problem.demand(), problem.roundOff);
}

}  // namespace delassus
