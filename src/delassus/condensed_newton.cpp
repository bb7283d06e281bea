#include "delassus/condensed_newton.h"

#include <algorithm>
#include <cmath>

#include "delassus/options.h"

namespace delassus {

/// Divides the unknowns, with the rows of E those without bounds, or also those that r has within their bounds.
void CondensedNewton::divide(const Problem& problem, const VectorXd& r, bool withinBounds) {
  const int contactsEnd = 3 * problem.contacts();
  left_.clear();
  held_.clear();
  for (int at = 0; at < problem.size(); ++at) {
    const int row = at - contactsEnd;
    const bool isHeld =
        row >= 0 && ((std::isinf(problem.lower[row]) && std::isinf(problem.upper[row])) ||
                     (withinBounds && r[at] > problem.lower[row] && r[at] < problem.upper[row]));
    (isHeld ? held_ : left_).push_back(at);
  }
}

bool CondensedNewton::setProblem(const Problem& problem, const NaturalMap& map, const VectorXd& r,
                                 int most) {
  if (!problem.W.inBodySpace() || !problem.disks.empty() || 3 * problem.contacts() > most)
    return false;
  problem_ = &problem;
  map_ = &map;
  const auto isFit = [&] { return !left_.empty() && static_cast<int>(left_.size()) <= most; };
  divide(problem, r, false);
  if (isFit()) return true;
  divide(problem, r, true);
  return isFit();
}

/// False if K cannot be factored.
bool CondensedNewton::condense(Solution& count) {
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
  motion_.condense(left_, steps_.W);
  diagonal_ = steps_.W.diagonal();
  for (int i = 0; i < n; ++i) diagonal_[i] += compliance[left_[i]];
  return true;
}

/// α of C.
void CondensedNewton::setWeight(double alpha) {
  if (alpha == weight_) return;
  weight_ = alpha;
  const auto n = static_cast<int>(left_.size());
  steps_.rho.resize(n);
  for (int i = 0; i < n; ++i)
    steps_.rho[i] = steps_.W(i, i) = diagonal_[i] + alpha * mean_[left_[i]];
  for (int i = 0; i < problem_->contacts(); ++i)
    steps_.rho.segment<3>(3 * i).setConstant(steps_.rho.segment<3>(3 * i).mean());
  steps_.forgetFactor();
}

/// What E does once C has changed by its part of change_: E's part of it, δ and J̃ δ.
void CondensedNewton::letHeldAnswer() {
  const int contactsEnd = 3 * problem_->contacts();
  const VectorXd& u = center_.u;
  for (const int at : held_) change_[at] = -G_.rows[at - contactsEnd] * u[at];
  motion_.impulse(change_, delta_);
  motion_.solve(delta_);
  motion_.relativeVelocity(delta_, felt_);
  for (const int at : held_) change_[at] -= G_.rows[at - contactsEnd] * felt_[at];
}

/// The reactions of C to within ‖ρ F‖ ≤ enough (m/s). False if they are not found.
bool CondensedNewton::solveLeft(double enough, int budget, Solution& count) {
  const ReactionBounds bounds{problem_->friction, lower_, upper_};
  double error = steps_.error(bounds);
  for (int k = 0; k < budget && error > enough; ++k) {
    ++count.sweeps;
    if (!steps_.step(bounds, error)) return false;
  }
  return error <= enough;
}

/// r_k ← r. False if r is not found; then it is what the steps have come to.
bool CondensedNewton::moveCenter(double enough, int budget, Solution& count) {
  const auto n = static_cast<int>(left_.size());
  change_.setZero(problem_->size());
  letHeldAnswer();
  steps_.r.resize(n);
  steps_.u.resize(n);
  for (int i = 0; i < n; ++i) {
    steps_.r[i] = center_.r[left_[i]];
    steps_.u[i] = center_.u[left_[i]] + felt_[left_[i]];
  }
  const bool isFound = solveLeft(enough, budget, count);
  for (int i = 0; i < n; ++i) change_[left_[i]] = steps_.r[i] - center_.r[left_[i]];
  letHeldAnswer();
  center_.r += change_;
  makeFeasible(*problem_, center_.r);
  problem_->W.multiply(center_.r, delta_, center_.u);
  center_.u += problem_->q;
  const VelocityResidual residual = map_->residual(center_.r, center_.u);
  center_.residual = residual.max;
  center_.residualRms = residual.rms;
  return isFound;
}

bool CondensedNewton::solve(double tolerance, int budget, Solution& best) {
  constexpr int mostSteps = 20;  // what takes more is found sooner by a walk
  constexpr double unknownRegion = 1e-3, knownRegion = 1e-5;
  constexpr double fine = 1e-2, slow = 1e-2, tooSlow = 0.3;  // shares of the residual
  if (!condense(best)) return false;
  const int most = best.sweeps + std::min(budget, mostSteps);
  center_.takeReactions(best);
  for (double alpha = unknownRegion;;) {
    const double before = center_.residual;
    const double enough = std::max(fine * std::max(alpha * before, polishedShare * tolerance),
                                   map_->roundOff(center_.r));
    setWeight(alpha);
    const bool isFound = moveCenter(enough, most - best.sweeps, best);
    const double now = center_.residual;
    if (now < best.residual) best.takeReactions(center_);
    // Some digits more if they come by themselves.
    const double aim = now > tooSlow * before ? tolerance : polishedShare * tolerance;
    if (now <= std::max(aim, map_->roundOff(center_.r))) return true;
    if (!isFound || !(now <= tooSlow * before)) return best.residual <= tolerance;
    if (now > slow * before) alpha = knownRegion;
  }
}

}  // namespace delassus
