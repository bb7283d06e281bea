#include "delassus/newton_steps.h"

#include <algorithm>

#include "delassus/cone.h"
#include "delassus/row_product.h"

namespace delassus {

namespace {

void resizeTo(int unknowns, KeptMatrix& matrix) { matrix.resize(unknowns, unknowns); }
/// Matrices of fixed width are zero behind the last unknown.
template <class Matrix>
void resizeTo(int unknowns, Matrix& matrix) {
  matrix.setZero(unknowns, matrix.cols());
}

}  // namespace

template <int Most>
void NewtonSteps<Most>::resize(int unknowns) {
  resizeTo(unknowns, W);
  W.setZero();
  forgetFactor();
  error_.resize(unknowns);
  felt_.resize(unknowns);
}

template <int Most>
void NewtonSteps<Most>::multiply(const Vector& x, Vector& product) const {
  product.resize(x.size());
  if constexpr (Most == Eigen::Dynamic) {
    product.noalias() = W * x;
  } else {
    // For so few unknowns, the set-up of the library's product takes longer than to multiply.
    const int n = static_cast<int>(x.size());
    int at = 0;
    for (; at + 2 < n; at += 3)
      product.template segment<3>(at) = timesRows(&W(at, 0), W.cols(), x.data(), n);
    for (; at < n; ++at) product[at] = W.row(at).head(n).dot(x);
  }
}

template <int Most>
double NewtonSteps<Most>::evaluate(const ReactionBounds& bounds, const Vector& at,
                                   const Vector& velocity) {
  return reactionError(
      bounds, at, velocity, [this](int k) { return rho[k]; }, error_);
}

/// A sliding disk is on the rim, which r_n moves, and turns as a contact does:
///
///     dP = (R/‖z‖) (1 − t tᵀ) dz + κ t dr_n,   t = z/‖z‖
template <int Most>
void NewtonSteps<Most>::findActiveDisk(const Disk& disk) {
  const Vec2 z = disk.of(r) - disk.of(u) / rho[disk.first];
  const double load = r[disk.governor] + error_[disk.governor];
  const double radius = disk.radiusUnder(load), length = z.norm();
  if (!(radius > 0)) return;
  active_.push_back({disk.first, disk.unknowns, length > radius});
  Active& own = active_.back();
  if (own.slides) {
    const Vec2 t = z / length;
    own.P.template topLeftCorner<2, 2>() = radius / length * (Mat2::Identity() - t * t.transpose());
    const auto at = std::find(unknowns_.begin(), unknowns_.end(), disk.governor);
    if (load < disk.mostLoad && at != unknowns_.end()) {
      own.governor = static_cast<int>(at - unknowns_.begin());
      own.P.col(2).template head<2>() = disk.radius * t;
    }
  }
  for (int j = 0; j < disk.unknowns; ++j) unknowns_.push_back(disk.first + j);
}

/// Finds the active parts in the region of r and u.
template <int Most>
void NewtonSteps<Most>::findActive(const ReactionBounds& bounds) {
  const int n = bounds.contacts();
  active_.clear();
  unknowns_.clear();
  for (int i = 0; i < n; ++i) {
    const int k = 3 * i;
    const Vec3 z = r.template segment<3>(k) - u.template segment<3>(k) / rho[k];
    if (z[0] <= 0) continue;
    const double zt = lengthOf(z[1], z[2]);
    active_.push_back({k, 3, zt > bounds.friction[i] * z[0]});
    Active& contact = active_.back();
    if (contact.slides) slidingReaction(z, zt, bounds.friction[i], &contact.P);
    for (int j = 0; j < 3; ++j) unknowns_.push_back(k + j);
  }
  for (int i = 0; i < bounds.rows(); ++i) {
    const int k = 3 * n + i;
    const double z = r[k] - u[k] / rho[k];
    if (!(z > bounds.lower[i] && z < bounds.upper[i])) continue;
    active_.push_back({k, 1, false});
    unknowns_.push_back(k);
  }
  for (const Disk& disk : bounds.disks) findActiveDisk(disk);
}

/// Sets K_ to −dF/dr of the active parts.
template <int Most>
void NewtonSteps<Most>::fillMatrix() {
  const auto m = static_cast<int>(unknowns_.size());
  resizeTo(m, K_);
  int row = 0;
  for (const Active& a : active_) {
    const double scale = 1 / rho[a.first];
    for (int j = 0; j < a.unknowns; ++j)
      for (int c = 0; c < m; ++c) K_(row + j, c) = scale * W(a.first + j, unknowns_[c]);
    if (a.slides && a.unknowns == 3) {
      auto rows = K_.template middleRows<3>(row);
      for (int c = 0; c < m; ++c) rows.col(c) = (a.P * rows.col(c)).eval();
      K_.template block<3, 3>(row, row) += Mat3::Identity() - a.P;
    } else if (a.slides) {
      for (int c = 0; c < m; ++c) {
        Vec2 column(K_(row, c), a.unknowns == 2 ? K_(row + 1, c) : 0);
        column = (a.P.template topLeftCorner<2, 2>() * column).eval();
        for (int j = 0; j < a.unknowns; ++j) K_(row + j, c) = column[j];
      }
      for (int j = 0; j < a.unknowns; ++j) {
        for (int l = 0; l < a.unknowns; ++l) K_(row + j, row + l) += (j == l) - a.P(j, l);
        if (a.governor >= 0) K_(row + j, a.governor) -= a.P(j, 2);
      }
    }
    row += a.unknowns;
  }
}

/// Whether the last factor is of this region, and sliding contacts have hardly turned since.
template <int Most>
bool NewtonSteps<Most>::isFactored() const {
  constexpr double hardly = 1e-3;
  const auto isSame = [](const Active& now, const Active& then) {
    return now.first == then.first && now.slides == then.slides && now.governor == then.governor &&
           (now.P - then.P).cwiseAbs().maxCoeff() <= hardly;
  };
  return hasFactor_ &&
         std::equal(active_.begin(), active_.end(), factored_.begin(), factored_.end(), isSame);
}

/// Finds step_ from error_, and felt_ = W step_. Parts that are open or at a bound go where they
/// must, whatever the others do, and have no place in K_. False if K_ is singular.
template <int Most>
bool NewtonSteps<Most>::findStep(const ReactionBounds& bounds) {
  findActive(bounds);
  const auto m = static_cast<int>(unknowns_.size());
  step_ = error_;
  for (const int at : unknowns_) step_[at] = 0;
  if (step_.any())
    multiply(step_, felt_);
  else
    felt_.setZero(step_.size());
  right_.resize(m);
  int row = 0;
  for (const Active& a : active_) {
    if (a.unknowns == 3) {
      Vec3 felt = felt_.template segment<3>(a.first) / rho[a.first];
      if (a.slides) felt = (a.P * felt).eval();
      right_.template segment<3>(row) = error_.template segment<3>(a.first) - felt;
    } else {
      Vec3 felt = Vec3::Zero();
      for (int j = 0; j < a.unknowns; ++j) felt[j] = felt_[a.first + j] / rho[a.first];
      // P(z_n) changes by Δr_n − F_n.
      if (a.governor >= 0) felt[2] = error_[unknowns_[a.governor]];
      if (a.slides) felt = (a.P * felt).eval();
      for (int j = 0; j < a.unknowns; ++j) right_[row + j] = error_[a.first + j] - felt[j];
    }
    row += a.unknowns;
  }
  if constexpr (Most == Eigen::Dynamic) {
    if (!isFactored()) {
      fillMatrix();
      factored_.assign(active_.begin(), active_.end());
      hasFactor_ = elimination_.factorise(K_);
      if (!hasFactor_) return false;
    }
    elimination_.solve(right_);
  } else {
    fillMatrix();
    if (m > 0 && !elimination_.solve(K_, right_)) return false;
  }
  for (int c = 0; c < m; ++c) step_[unknowns_[c]] = right_[c];
  if (!step_.allFinite()) return false;
  multiply(step_, felt_);
  return true;
}

template <int Most>
void NewtonSteps<Most>::tryStep(const ReactionBounds& bounds, double share, double& error) {
  trialR_ = r + share * step_;
  trialU_ = u + share * felt_;
  error = evaluate(bounds, trialR_, trialU_);
}

template <int Most>
bool NewtonSteps<Most>::step(const ReactionBounds& bounds, double& error) {
  constexpr int mostHalvings = 5;
  const double before = error;
  if (!findStep(bounds)) return false;
  double share = 1;
  tryStep(bounds, share, error);
  for (int h = 0; h < mostHalvings && !(error < before); ++h) tryStep(bounds, share *= 0.5, error);
  r.swap(trialR_);
  u.swap(trialU_);
  return true;
}

template <int Most>
bool NewtonSteps<Most>::fullStep(const ReactionBounds& bounds, double& error) {
  if (!findStep(bounds)) return false;
  tryStep(bounds, 1, error);
  r.swap(trialR_);
  u.swap(trialU_);
  return true;
}

template <int Most>
void NewtonSteps<Most>::keepLast() {
  keptR_.swap(trialR_);
  keptU_.swap(trialU_);
}

template <int Most>
void NewtonSteps<Most>::goBack() {
  r.swap(keptR_);
  u.swap(keptU_);
}

template class NewtonSteps<fewUnknowns>;
template class NewtonSteps<Eigen::Dynamic>;

}  // namespace delassus
