#include "delassus/dense_newton.h"

#include <algorithm>

#include "delassus/cone.h"

namespace delassus {

bool DenseNewton::fits(const Problem& problem, const NaturalMap& map) {
  constexpr int mostUnknowns = 90;
  return problem.size() <= mostUnknowns && problem.disks.empty() && !problem.W.inBodySpace() &&
         map.diagonal().minCoeff() > 0;
}

void DenseNewton::start(const Problem& problem, const NaturalMap& map, const Solution& best) {
  W_ = problem.W.entries();
  K_.resize(problem.size(), problem.size());
  error_.resize(problem.size());
  map.meanDiagonal(rho_);
  r_ = best.r;
  u_ = best.u;
}

double DenseNewton::evaluate(const Problem& problem, const VectorXd& r, const VectorXd& u,
                             bool differentiate) {
  const int n = problem.contacts();
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const int at = 3 * i;
    const Vec3 z = r.segment<3>(at) - u.segment<3>(at) / rho_[at];
    Mat3 P;
    const Vec3 f =
        reactionTo(z, problem.friction[i], differentiate ? &P : nullptr) - r.segment<3>(at);
    error_.segment<3>(at) = f;
    sum += (rho_[at] * f).squaredNorm();
    if (!differentiate) continue;
    K_.middleRows<3>(at).noalias() = (P / rho_[at]) * W_.middleRows<3>(at);
    K_.block<3, 3>(at, at) += Mat3::Identity() - P;
  }
  for (int i = 0; i < problem.rows(); ++i) {
    const int at = 3 * n + i;
    const double z = r[at] - u[at] / rho_[at];
    error_[at] = std::clamp(z, problem.lower[i], problem.upper[i]) - r[at];
    sum += rho_[at] * error_[at] * rho_[at] * error_[at];
    if (!differentiate) continue;
    if (z > problem.lower[i] && z < problem.upper[i]) {
      K_.row(at) = W_.row(at) / rho_[at];
    } else {
      K_.row(at).setZero();
      K_(at, at) = 1;
    }
  }
  return sum;
}

bool DenseNewton::isSingular() const {
  constexpr double negligible = 1e-10;
  const auto pivots = lu_.matrixLU().diagonal().cwiseAbs();
  return !(pivots.minCoeff() > negligible * pivots.maxCoeff());
}

bool DenseNewton::solve(const Problem& problem, const NaturalMap& map, double tolerance, int budget,
                        Solution& best) {
  constexpr int mostSteps = 20, mostHalvings = 5;
  start(problem, map, best);
  for (int k = 0; k < std::min(mostSteps, budget); ++k) {
    const double error = evaluate(problem, r_, u_, true);
    lu_.compute(K_);
    ++best.regions;
    ++best.factorisations;
    if (isSingular()) return false;
    const VectorXd step = lu_.solve(error_);
    if (!step.allFinite()) return false;
    // A step that gains nothing is taken all the same, a short one: behind the wall there may be a better region.
    double t = 1;
    for (int h = 0; h <= mostHalvings; ++h, t *= 0.5) {
      trialR_ = r_ + t * step;
      trialU_ = problem.q;
      trialU_.noalias() += W_ * trialR_;
      if (evaluate(problem, trialR_, trialU_, false) < error) break;
    }
    r_.swap(trialR_);
    u_.swap(trialU_);
    if (!(map.residual(r_, u_).max <= tolerance)) continue;
    // Rounding may have left a cone by its last digit.
    trialR_ = r_;
    makeFeasible(problem, trialR_);
    trialU_ = problem.q;
    trialU_.noalias() += W_ * trialR_;
    const NaturalResidual residual = map.residual(trialR_, trialU_);
    if (!(residual.max <= tolerance)) continue;
    best.r = trialR_;
    best.u = trialU_;
    best.residual = residual.max;
    best.residualRms = residual.rms;
    return true;
  }
  return false;
}

}  // namespace delassus
