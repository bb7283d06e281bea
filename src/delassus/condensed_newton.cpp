#include "delassus/condensed_newton.h"

#include <algorithm>
#include <cmath>

namespace delassus {
namespace {

/// The steps for `descend`.
struct StepsWithin {
  ReactionBounds bounds;
  NewtonSteps<Eigen::Dynamic>& steps;

  double error() { return steps.error(bounds); }
  bool step(double& error) { return steps.fullStep(bounds, error); }
  void keepLast() { steps.keepLast(); }
  void goBack() { steps.goBack(); }
};

}  // namespace

/// Divides the unknowns. E has the rows without bounds, or also those whose r is within their
/// bounds, but none of disks or that govern disks.
void CondensedNewton::divide(const Problem& problem, const VectorXd& r, bool withinBounds) {
  const int contactsEnd = 3 * problem.contacts();
  const auto governs = [&](int at) {
    return std::any_of(problem.disks.begin(), problem.disks.end(),
                       [at](const Disk& disk) { return disk.governor == at; });
  };
  left_.clear();
  held_.clear();
  left_.reserve(problem.size());
  held_.reserve(problem.rows());
  for (int at = 0; at < problem.size(); ++at) {
    const int row = at - contactsEnd;
    const bool isHeld =
        row >= 0 && at < problem.disksBegin() &&
        ((std::isinf(problem.lower[row]) && std::isinf(problem.upper[row])) ||
         (withinBounds && r[at] > problem.lower[row] && r[at] < problem.upper[row])) &&
        !governs(at);
    (isHeld ? held_ : left_).push_back(at);
  }
  const auto placeOf = [this](int at) {
    return static_cast<int>(std::lower_bound(left_.begin(), left_.end(), at) - left_.begin());
  };
  disks_ = problem.disks;
  for (Disk& disk : disks_) {
    disk.first = placeOf(disk.first);
    disk.governor = placeOf(disk.governor);
  }
}

bool CondensedNewton::setProblem(const Problem& problem, const NaturalMap& map, const VectorXd& r,
                                 int most) {
  const int ofDisks = problem.size() - problem.disksBegin();
  if (!problem.W.inBodySpace() || 3 * problem.contacts() + ofDisks > most) return false;
  problem_ = &problem;
  map_ = &map;
  divide(problem, r, false);
  if (left_.empty()) return false;
  const bool areFew = static_cast<int>(left_.size()) <= most;
  if (areFew && !held_.empty()) return true;
  divide(problem, r, true);
  // A motor that gives all it has may seem to be within its bounds, by rounding.
  if (areFew && !left_.empty()) divide(problem, r, false);
  return static_cast<int>(left_.size()) <= most;
}

/// Eliminates E. False if K cannot be factored.
bool CondensedNewton::condense(WorkDone& count) {
  const Problem& problem = *problem_;
  constexpr double alpha = 1e-5;
  const int contactsEnd = 3 * problem.contacts();
  const VectorXd& compliance = problem.W.bodySpace().compliance;
  map_->meanDiagonal(mean_);
  motion_.setProblem(problem);
  G_.reset(problem);
  for (const int at : held_) G_.rows[at - contactsEnd] = 1 / (compliance[at] + alpha * mean_[at]);
  const auto n = static_cast<int>(left_.size());
  lower_.resize(n - contactsEnd);
  upper_.resize(n - contactsEnd);
  for (int i = contactsEnd; i < n; ++i) {
    lower_[i - contactsEnd] = problem.lower[left_[i] - contactsEnd];
    upper_[i - contactsEnd] = problem.upper[left_[i] - contactsEnd];
  }
  ++count.regions;
  ++count.factorisations;
  if (!motion_.factorise(G_)) return false;
  weight_ = 0;
  steps_.resize(n);
  if (!motion_.condense(left_, steps_.W)) return false;
  diagonal_ = steps_.W.diagonal();
  for (int i = 0; i < n; ++i) diagonal_[i] += compliance[left_[i]];
  return true;
}

/// Sets α of C.
void CondensedNewton::setWeight(double alpha) {
  if (alpha == weight_) return;
  weight_ = alpha;
  const auto n = static_cast<int>(left_.size());
  steps_.rho.resize(n);
  for (int i = 0; i < n; ++i)
    steps_.rho[i] = steps_.W(i, i) = diagonal_[i] + alpha * mean_[left_[i]];
  for (int i = 0; i < problem_->contacts(); ++i)
    steps_.rho.segment<3>(3 * i).setConstant(steps_.rho.segment<3>(3 * i).mean());
  for (const Disk& disk : disks_) {
    auto own = steps_.rho.segment(disk.first, disk.unknowns);
    own.setConstant(own.mean());
  }
  steps_.forgetFactor();
}

/// Lets E respond, around reactions with these u, to C's part of change_: finds E's part of it, δ
/// and J̃ δ.
void CondensedNewton::letHeldAnswer(const VectorXd& u) {
  const int contactsEnd = 3 * problem_->contacts();
  for (const int at : held_) change_[at] = -G_.rows[at - contactsEnd] * u[at];
  motion_.impulse(change_, delta_);
  motion_.solve(delta_);
  motion_.relativeVelocity(delta_, felt_);
  for (const int at : held_) change_[at] -= G_.rows[at - contactsEnd] * felt_[at];
}

Descent CondensedNewton::moveOn(const Solution& center, double alpha, double enough, int budget,
                                Solution& next) {
  const auto n = static_cast<int>(left_.size());
  setWeight(alpha);
  change_.setZero(problem_->size());
  letHeldAnswer(center.u);
  steps_.r.resize(n);
  steps_.u.resize(n);
  for (int i = 0; i < n; ++i) {
    steps_.r[i] = center.r[left_[i]];
    steps_.u[i] = center.u[left_[i]] + felt_[left_[i]];
  }
  StepsWithin steps{{problem_->friction, lower_, upper_, disks_}, steps_};
  const Descent descent = descend(steps, enough, budget);
  for (int i = 0; i < n; ++i) change_[left_[i]] = steps_.r[i] - center.r[left_[i]];
  letHeldAnswer(center.u);
  next.r = center.r + change_;
  makeFeasible(*problem_, next.r);
  next.setResidual(map_->measure(next.r, delta_, next.u));
  return descent;
}

bool CondensedNewton::solve(double tolerance, int budget, Solution& best) {
  return condense(best) && goOn(tolerance, budget, best);
}

bool CondensedNewton::goOn(double tolerance, int budget, Solution& best) {
  const auto move = [this](const Solution& center, double alpha, double enough, int steps,
                           Solution& next) { return moveOn(center, alpha, enough, steps, next); };
  const Descent descent =
      moveCenters(move, *map_, tolerance, std::min(budget, mostSteps), next_, best);
  best.sweeps += descent.steps;
  return descent.isFound;
}

}  // namespace delassus
