#include "delassus/region_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delassus {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// How many block changes of state may fail to reach a new smallest number of objections before
/// single changes begin.
constexpr int blockPatience = 10;

}  // namespace

bool BoundedRows::bilateral(int i) const { return std::isinf(lower[i]) && std::isinf(upper[i]); }

double BoundedRows::naturalResidual(const VectorXd& r) const {
  if (size() == 0) return 0;
  return (r - clamp(r - (W * r + q))).cwiseAbs().maxCoeff();
}

double BoundedRows::roundOff(const VectorXd& r) const {
  return size() == 0 ? 0 : 64 * epsilon * q.cwiseAbs().maxCoeff() + 16 * epsilon * r.norm();
}

RowState BoundedRows::possible(int i, RowState wished) const {
  if (constant(i)) return RowState::AtLower;
  const bool atInfinity = (wished == RowState::AtLower && std::isinf(lower[i])) ||
                          (wished == RowState::AtUpper && std::isinf(upper[i]));
  return atInfinity ? RowState::Free : wished;
}

std::vector<RowState> BoundedRows::firstStates() const {
  const VectorXd rest = clamp(VectorXd::Zero(size()));
  std::vector<RowState> states(size(), RowState::Free);
  for (int i = 0; i < size(); ++i) {
    if (rest[i] == lower[i] && q[i] >= 0) states[i] = RowState::AtLower;
    if (rest[i] == upper[i] && q[i] <= 0) states[i] = RowState::AtUpper;
    states[i] = possible(i, states[i]);
  }
  return states;
}

RegionWalk::RegionWalk(const BoundedRows& problem, std::vector<RowState> start)
    : problem_(problem),
      states_(std::move(start)),
      r_(problem.clamp(VectorXd::Zero(problem.size()))) {
  for (int i = 0; i < problem_.size(); ++i) states_[i] = problem_.possible(i, states_[i]);
}

int RegionWalk::factorisations() const {
  return factorisations_ + (cholesky_ ? cholesky_->factorisations() : 0);
}

RegionWalk::End RegionWalk::settle(const VectorXd& anchor, double alpha, int regionBudget) {
  size_t fewest = problem_.size() + 1;
  int patience = blockPatience;
  for (; regions_ < regionBudget; ++regions_) {
    if (!solveRegion(anchor, alpha)) return End::Singular;
    std::vector<int> objecting = objections();
    if (objecting.empty()) {
      ++regions_;
      return End::Settled;
    }
    if (objecting.size() < fewest) {
      fewest = objecting.size();
      patience = blockPatience;
    } else if (patience > 0) {
      --patience;
    } else if (problem_.symmetric) {
      return descend(anchor, alpha, regionBudget);
    } else {
      objecting = {objecting.back()};  // Murty: a fixed order cannot cycle
    }
    for (const int row : objecting) changeState(row);
  }
  return End::OutOfBudget;
}

bool RegionWalk::redundantTies() {
  if (!problem_.symmetric || !cholesky_) return false;
  const double velocity = problem_.roundOff(r_);
  bool redundant = false;
  for (int i = 0; i < problem_.size(); ++i) {
    const bool tie = states_[i] != RowState::Free && std::abs(u_[i]) <= velocity;
    if (tie && !problem_.constant(i)) redundant = !cholesky_->append(i) || redundant;
  }
  alpha_ = -1;  // the factor has more rows now than its region
  return redundant;
}

/// Primal active-set descent: r stays within its bounds and the cost falls with every region.
RegionWalk::End RegionWalk::descend(const VectorXd& anchor, double alpha, int regionBudget) {
  VectorXd r = problem_.clamp(anchor);
  holdAtBounds(r);
  for (; regions_ < regionBudget; ++regions_) {
    if (!solveRegion(anchor, alpha)) return End::Singular;
    const std::vector<int> objecting = objections();
    if (objecting.empty()) {
      ++regions_;
      return End::Settled;
    }
    const auto freeObjects = [this](int i) { return states_[i] == RowState::Free; };
    if (std::any_of(objecting.begin(), objecting.end(), freeObjects)) {
      stepToFirstBound(r);
    } else {
      // This is the lowest point of the face: leave it where the cost falls fastest.
      r = problem_.clamp(r_);
      const auto less = [this](int i, int j) { return std::abs(u_[i]) < std::abs(u_[j]); };
      changeState(*std::max_element(objecting.begin(), objecting.end(), less));
    }
  }
  return End::OutOfBudget;
}

/// Rows of r that lie at a bound stay there.
void RegionWalk::holdAtBounds(const VectorXd& r) {
  for (int i = 0; i < problem_.size(); ++i) {
    states_[i] = r[i] == problem_.lower[i]   ? RowState::AtLower
                 : r[i] == problem_.upper[i] ? RowState::AtUpper
                                             : RowState::Free;
  }
}

/// Moves r towards the lowest point r_ of its face until the first rows meet their bounds; these
/// are then held.
void RegionWalk::stepToFirstBound(VectorXd& r) {
  const VectorXd reachable = problem_.clamp(r_);
  const auto fraction = [&](int i) {
    return reachable[i] == r_[i] ? 1.0 : (reachable[i] - r[i]) / (r_[i] - r[i]);
  };
  double step = 1;
  for (const int i : free_) step = std::min(step, fraction(i));
  for (const int i : free_) {
    if (reachable[i] != r_[i] && fraction(i) <= step) {
      changeState(i);
      r[i] = reachable[i];
    } else {
      r[i] += step * (r_[i] - r[i]);
    }
  }
}

/// False if the free rows are dependent. `anew` forbids edits of the last factor.
bool RegionWalk::factorFreeRows(double alpha, bool anew) {
  // Bilateral rows never leave, so they come first and edits happen behind them.
  std::vector<int> free;
  for (int i = 0; i < problem_.size(); ++i)
    if (states_[i] == RowState::Free && problem_.bilateral(i)) free.push_back(i);
  for (int i = 0; i < problem_.size(); ++i)
    if (states_[i] == RowState::Free && !problem_.bilateral(i)) free.push_back(i);

  if (!problem_.symmetric) {
    if (alpha == alpha_ && free == free_) return true;
    free_ = free;
    alpha_ = alpha;
    if (free_.empty()) return true;
    ++factorisations_;
    MatrixXd block = problem_.W(free_, free_);
    block.diagonal().array() += alpha;
    lu_.compute(block);
    const auto pivots = lu_.matrixLU().diagonal().cwiseAbs();
    const double smallest = alpha > 0 ? epsilon * epsilon : dependentPivot;
    if (pivots.minCoeff() > smallest * block.cwiseAbs().maxCoeff()) return true;
    alpha_ = -1;
    return false;
  }

  if (!cholesky_ || alpha != alpha_) {
    if (cholesky_) factorisations_ += cholesky_->factorisations();
    // With a shift every pivot is at least the shift. If rounding exceeds it, the factor is
    // useless.
    const double redundant = alpha > 0 ? epsilon : dependentPivot;
    cholesky_ = std::make_unique<PrincipalCholesky>(problem_.W, alpha, redundant);
    alpha_ = alpha;
    anew = true;
  }
  const bool independent = anew ? cholesky_->factor(free) : cholesky_->retarget(free);
  free_ = cholesky_->rows();
  return independent;
}

VectorXd RegionWalk::solveFreeRows(const VectorXd& b) const {
  if (free_.empty()) return b;
  return problem_.symmetric ? cholesky_->solve(b) : VectorXd(lu_.solve(b));
}

bool RegionWalk::solveRegion(const VectorXd& anchor, double alpha) {
  if (!factorFreeRows(alpha, false)) return false;
  if (answerRegion(anchor, alpha)) return true;
  // Edits have cost digits (algorithms 4.2).
  if (problem_.symmetric && cholesky_->edited()) {
    if (!factorFreeRows(alpha, true)) return false;
    answerRegion(anchor, alpha);
  }
  return true;
}

/// r_F = anchor_F − (W_FF + alpha I)⁻¹ (W r + q)_F with the other rows at their bounds. In this
/// form a proximal step also refines the residual of W itself. False if the residual is larger than
/// rounding explains.
bool RegionWalk::answerRegion(const VectorXd& anchor, double alpha) {
  r_ = anchor;
  for (int i = 0; i < problem_.size(); ++i) {
    if (states_[i] == RowState::AtLower) r_[i] = problem_.lower[i];
    if (states_[i] == RowState::AtUpper) r_[i] = problem_.upper[i];
  }
  u_ = problem_.W * r_ + problem_.q + alpha * (r_ - anchor);
  double missed = 0;  // by rows that are free
  for (int refinement = 0; refinement < 2; ++refinement) {
    const VectorXd correction = solveFreeRows(u_(free_));
    r_(free_) -= correction;
    u_ = problem_.W * r_ + problem_.q + alpha * (r_ - anchor);
    missed = free_.empty() ? 0 : u_(free_).cwiseAbs().maxCoeff();
    if (missed <= problem_.roundOff(r_) / 8) break;
  }
  return missed <= 8 * problem_.roundOff(r_);
}

/// Rows whose reaction or velocity has a sign that their state forbids, by more than round-off.
std::vector<int> RegionWalk::objections() const {
  const double reaction = problem_.size() ? 64 * epsilon * r_.cwiseAbs().maxCoeff() : 0;
  const double velocity = problem_.roundOff(r_);
  std::vector<int> rows;
  for (int i = 0; i < problem_.size(); ++i) {
    if (problem_.constant(i)) continue;
    const bool objects = states_[i] == RowState::Free ? r_[i] < problem_.lower[i] - reaction ||
                                                            r_[i] > problem_.upper[i] + reaction
                         : states_[i] == RowState::AtLower ? u_[i] < -velocity
                                                           : u_[i] > velocity;
    if (objects) rows.push_back(i);
  }
  return rows;
}

/// A row goes from one bound to the other only by way of Free.
void RegionWalk::changeState(int row) {
  if (states_[row] != RowState::Free) {
    states_[row] = RowState::Free;
  } else {
    states_[row] = r_[row] < problem_.lower[row] ? RowState::AtLower : RowState::AtUpper;
  }
}

}  // namespace delassus
