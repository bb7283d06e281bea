#include "delassus/proximal_point.h"

#include <cmath>

namespace delassus {
namespace {

/// Relative to the unit diagonal. A step leaves alpha/(alpha + σ) of the error in a mode of
/// eigenvalue σ, and ε/alpha of round-off in the null space. alpha is large enough for the latter,
/// and is reduced when the former is slow.
constexpr double firstAlpha = 1e-6, lastAlpha = 1e-12, alphaFactor = 1e-2;
constexpr double largestAlpha = 1e-2;  ///< where round-off in W makes it indefinite

constexpr int stepBudget = 40;
constexpr double slowContraction = 0.1;

/// A direction d of reactions is null if |W d| is below this part of |d| (unit diagonal).
constexpr double nullVelocity = 1e-12;

/// Entries of a direction below this part of its largest are zero.
constexpr double negligible = 1e-6;

/// Whether d proves that no motion meets all demands: admissible for ever, W d = 0, d·q < 0
/// (algorithms 5.5).
bool provesIncompatible(const BoundedRows& problem, const VectorXd& d, double residual) {
  const double size = d.cwiseAbs().maxCoeff();
  if (!problem.symmetric || !(size > 0)) return false;
  for (int i = 0; i < problem.size(); ++i) {
    if (d[i] > negligible * size && !std::isinf(problem.upper[i])) return false;
    if (d[i] < -negligible * size && !std::isinf(problem.lower[i])) return false;
  }
  if ((problem.W * d).cwiseAbs().maxCoeff() > nullVelocity * size) return false;
  // d·q / ‖d‖² · d is the shift of the compromise. A residual that it does not explain is only slow
  // convergence.
  return d.dot(problem.q) * size < -0.5 * residual * d.squaredNorm();
}

}  // namespace

void RowAnswer::offer(const BoundedRows& problem, const RegionWalk& walk) {
  const VectorXd clamped = problem.clamp(walk.r());
  const double itsResidual = problem.naturalResidual(clamped);
  if (itsResidual < residual) *this = {clamped, walk.states(), itsResidual};
}

ProximalAnswer proximalPoint(const BoundedRows& problem, RegionWalk& walk, double goodEnough,
                             int regionBudget) {
  ProximalAnswer answer;
  answer.shift = VectorXd::Zero(problem.size());
  VectorXd anchor = VectorXd::Zero(problem.size());
  double alpha = firstAlpha, previous = infinity;
  for (int step = 0; step < stepBudget; ++step) {
    const RegionWalk::End end = walk.settle(anchor, alpha, regionBudget);
    if (end == RegionWalk::End::Singular) {
      alpha /= alphaFactor;
      if (alpha > largestAlpha) break;
      continue;
    }
    const VectorXd r = problem.clamp(walk.r());
    const double residual = problem.naturalResidual(r);
    answer.best.offer(problem, walk);
    if (end == RegionWalk::End::OutOfBudget || residual <= problem.roundOff(r) / 8) break;

    const VectorXd direction = r - anchor;
    if (provesIncompatible(problem, direction, residual)) {
      // On the rows that push for ever u tends to −alpha d. The part of q along d is the same,
      // without the rounding of large reactions.
      answer.shift = -direction.dot(problem.q) / direction.squaredNorm() * direction;
      const double size = direction.cwiseAbs().maxCoeff();
      for (int i = 0; i < problem.size(); ++i)
        if (std::abs(direction[i]) > negligible * size) answer.blamed.push_back(i);
      break;
    }
    if (residual > slowContraction * previous) {
      if (residual <= goodEnough) break;
      if (alpha > 2 * lastAlpha) {
        alpha *= alphaFactor;
      } else if (residual > 0.5 * previous) {
        break;
      }
    }
    previous = residual;
    anchor = r;
  }
  return answer;
}

}  // namespace delassus
