#include "delassus/dense_newton.h"

#include <algorithm>

#include "delassus/cone.h"
#include "delassus/row_product.h"

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
  if constexpr (Most == Eigen::Dynamic) {
    W_ = problem.W.entries();
  } else {
    W_.setZero(n, W_.cols());
    if (problem.W.isFull()) {
      W_.leftCols(n) =
          Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
              problem.W.entries().valuePtr(), n, n);
    } else {
      W_.leftCols(n) = problem.W.entries();
    }
  }
  K_.resize(n, W_.cols());
  error_.resize(n);
  map.meanDiagonal(candidate_.u);
  rho_ = candidate_.u;
  if (from == Start::Best) {
    r_ = best.r;
    u_ = best.u;
  } else {
    r_.setZero(n);
    u_ = problem.q;
  }
}

template <int Most>
void DenseNewton<Most>::feel(const Problem& problem, const Vector& r, Vector& u) const {
  u = problem.q;
  if constexpr (Most == Eigen::Dynamic) {
    u.noalias() += W_ * r;
  } else {
    // For so few, what the library's product sets up takes longer than to multiply.
    const int n = static_cast<int>(r.size()), frictional = 3 * problem.contacts();
    for (int at = 0; at < frictional; at += 3)
      u.template segment<3>(at) += timesRows(&W_(at, 0), W_.cols(), r.data(), n);
    for (int at = frictional; at < n; ++at) u[at] += W_.row(at).head(n).dot(r);
  }
}

template <int Most>
double DenseNewton<Most>::evaluate(const Problem& problem, const Vector& r, const Vector& u,
                                   bool differentiate) {
  const int n = problem.contacts();
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const int at = 3 * i;
    const Vec3 z = r.template segment<3>(at) - u.template segment<3>(at) / rho_[at];
    Mat3 P;
    const Vec3 f = reactionTo(z, problem.friction[i], differentiate ? &P : nullptr) -
                   r.template segment<3>(at);
    error_.template segment<3>(at) = f;
    sum += (rho_[at] * f).squaredNorm();
    if (!differentiate) continue;
    K_.template middleRows<3>(at).noalias() = (P / rho_[at]) * W_.template middleRows<3>(at);
    K_.template block<3, 3>(at, at) += Mat3::Identity() - P;
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
  return std::sqrt(sum);
}

/// Whether r_ keeps the law; rounding may have left a cone by its last digit.
template <int Most>
bool DenseNewton<Most>::judge(const Problem& problem, const NaturalMap& map, double tolerance,
                              Solution& best) {
  candidate_.r = r_;
  makeFeasible(problem, candidate_.r);
  trialR_ = candidate_.r;
  feel(problem, trialR_, trialU_);
  candidate_.u = trialU_;
  const VelocityResidual residual = map.residual(candidate_.r, candidate_.u);
  if (!(residual.max <= tolerance)) return false;
  best.r = candidate_.r;
  best.u = candidate_.u;
  best.residual = residual.max;
  best.residualRms = residual.rms;
  return true;
}

template <int Most>
bool DenseNewton<Most>::solve(const Problem& problem, const NaturalMap& map, double tolerance,
                              int budget, Start from, Solution& best) {
  constexpr int mostSteps = 20, mostHalvings = 5;
  constexpr double near = 10;
  start(problem, map, from, best);
  for (int k = 0; k < std::min(mostSteps, budget); ++k) {
    const double before = evaluate(problem, r_, u_, true);
    step_ = error_;
    ++best.regions;
    ++best.factorisations;
    if (!elimination_.solve(K_, step_) || !step_.allFinite()) return false;
    // A step that gains nothing is taken all the same, a short one: behind the wall there may be a better region.
    double share = 1, error = before;
    for (int h = 0; h <= mostHalvings; ++h, share *= 0.5) {
      trialR_ = r_ + share * step_;
      feel(problem, trialR_, trialU_);
      error = evaluate(problem, trialR_, trialU_, false);
      if (error < before) break;
    }
    r_.swap(trialR_);
    u_.swap(trialU_);
    // Two measures of the same distance: only what is near by this one may be there by the other.
    if (error <= near * tolerance && judge(problem, map, tolerance, best)) return true;
  }
  return false;
}

template class DenseNewton<fewUnknowns>;
template class DenseNewton<Eigen::Dynamic>;

}  // namespace delassus
