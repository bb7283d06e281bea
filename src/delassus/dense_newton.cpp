#include "delassus/dense_newton.h"

#include <algorithm>

namespace delassus {

bool fitsDenseNewton(const Problem& problem, const NaturalMap& map) {
  constexpr int mostUnknowns = 90;
  return problem.size() <= mostUnknowns && problem.disks.empty() && !problem.W.inBodySpace() &&
         map.diagonal().minCoeff() > 0;
}

template <int Most>
void DenseNewton<Most>::start(const Problem& problem, const NaturalMap& map, Start from,
                              const Solution& best) {
  const int n = problem.size();
  steps_.resize(n);
  if (problem.W.isFull()) {
    steps_.W.leftCols(n) =
        Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
            problem.W.entries().valuePtr(), n, n);
  } else {
    steps_.W.leftCols(n) = problem.W.entries();
  }
  map.meanDiagonal(candidate_.u);
  steps_.rho = candidate_.u;
  if (from == Start::Best) {
    steps_.r = best.r;
    steps_.u = best.u;
  } else {
    steps_.r.setZero(n);
    steps_.u = problem.q;
  }
}

/// Whether the reactions of the steps keep the law, moved back into the cones that rounding may
/// have left by a last digit.
template <int Most>
bool DenseNewton<Most>::judge(const Problem& problem, const NaturalMap& map, double tolerance,
                              Solution& best) {
  candidate_.r = steps_.r;
  makeFeasible(problem, candidate_.r);
  allowed_ = candidate_.r;
  steps_.multiply(allowed_, felt_);
  candidate_.u = problem.q + felt_;
  const VelocityResidual residual = map.error(candidate_.r, candidate_.u);
  if (!(residual.max <= tolerance)) return false;
  best.r = candidate_.r;
  best.u = candidate_.u;
  best.setResidual(residual);
  return true;
}

template <int Most>
bool DenseNewton<Most>::solve(const Problem& problem, const NaturalMap& map, double tolerance,
                              int budget, Start from, Solution& best) {
  constexpr int mostSteps = 20;
  constexpr double near = 10;
  const auto bounds = ReactionBounds::of(problem);
  start(problem, map, from, best);
  double error = steps_.error(bounds);
  for (int k = 0; k < std::min(mostSteps, budget); ++k) {
    ++best.regions;
    ++best.factorisations;
    steps_.forgetFactor();
    if (!steps_.step(bounds, error)) return false;
    // These are two measures of the same distance: only reactions near by this one can be there by
    // the other.
    if (error <= near * tolerance && judge(problem, map, tolerance, best)) return true;
  }
  return false;
}

template class DenseNewton<fewUnknowns>;
template class DenseNewton<Eigen::Dynamic>;

}  // namespace delassus
