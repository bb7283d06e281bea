#include "delassus/condensed_newton.h"

#include <algorithm>
#include <cmath>

#include "delassus/options.h"

namespace delassus {
namespace {

bool isHeld(const Problem& problem, int row) {
  return std::isinf(problem.lower[row]) && std::isinf(problem.upper[row]);
}

}  // namespace

bool CondensedNewton::fits(const Problem& problem) {
  constexpr int mostUnknowns = 60;
  if (!problem.W.inBodySpace() || !problem.disks.empty()) return false;
  int unknowns = 3 * problem.contacts();
  for (int i = 0; i < problem.rows(); ++i) unknowns += isHeld(problem, i) ? 0 : 1;
  return unknowns > 0 && unknowns <= mostUnknowns && unknowns < problem.size();
}

/// False if K cannot be factored.
bool CondensedNewton::condense(const Problem& problem, const NaturalMap& map, Solution& count) {
  constexpr double alpha = 1e-5;
  const int contactsEnd = 3 * problem.contacts();
  const VectorXd& compliance = problem.W.bodySpace().compliance;
  map.meanDiagonal(mean_);
  motion_.setProblem(problem);
  G_.reset(problem);
  left_.clear();
  held_.clear();
  for (int at = 0; at < problem.size(); ++at) {
    const int row = at - contactsEnd;
    if (row >= 0 && isHeld(problem, row)) {
      held_.push_back(at);
      G_.rows[row] = 1 / (compliance[at] + alpha * mean_[at]);
    } else {
      left_.push_back(at);
    }
  }
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
  steps_.resize(n);
  motion_.condense(left_, steps_.W);
  diagonal_ = steps_.W.diagonal();
  for (int i = 0; i < n; ++i) diagonal_[i] += compliance[left_[i]];
  return true;
}

/// α of C.
void CondensedNewton::setWeight(const Problem& problem, double alpha) {
  const auto n = static_cast<int>(left_.size());
  steps_.rho.resize(n);
  for (int i = 0; i < n; ++i)
    steps_.rho[i] = steps_.W(i, i) = diagonal_[i] + alpha * mean_[left_[i]];
  for (int i = 0; i < problem.contacts(); ++i)
    steps_.rho.segment<3>(3 * i).setConstant(steps_.rho.segment<3>(3 * i).mean());
  steps_.forgetFactor();
}

/// What E does about the velocities u_ once C has changed by change_, of which only its own part is not read.
void CondensedNewton::letHeldAnswer() {
  const auto contactsEnd = static_cast<int>(u_.size() - G_.rows.size());
  for (const int at : held_) change_[at] = -G_.rows[at - contactsEnd] * u_[at];
  motion_.impulse(change_, delta_);
  motion_.solve(delta_);
  motion_.relativeVelocity(delta_, felt_);
  for (const int at : held_) change_[at] -= G_.rows[at - contactsEnd] * felt_[at];
}

/// The reactions of C to within ‖ρ F‖ ≤ enough (m/s). False if they are not found.
bool CondensedNewton::solveLeft(const Problem& problem, double enough, int budget,
                                Solution& count) {
  const ReactionBounds bounds{problem.friction, lower_, upper_};
  double error = steps_.error(bounds);
  for (int k = 0; k < budget && error > enough; ++k) {
    ++count.sweeps;
    if (!steps_.step(bounds, error)) return false;
  }
  return error <= enough;
}

bool CondensedNewton::solve(const Problem& problem, const NaturalMap& map, double tolerance,
                            int budget, Solution& best) {
  constexpr int mostOuters = 20;
  constexpr int mostSteps = 20;  // what takes more is found sooner by a walk
  constexpr double unknownRegion = 1e-3, knownRegion = 1e-5, largest = 1e-2, growth = 10;
  constexpr double fine = 1e-2;
  if (!condense(problem, map, best)) return false;
  const auto n = static_cast<int>(left_.size());
  const int most = best.sweeps + std::min(budget, mostSteps);
  center_ = best.r;
  u_ = best.u;
  steps_.r.resize(n);
  steps_.u.resize(n);
  double residual = best.residual, alpha = unknownRegion, weight = 0, shrink = 1e-2;
  for (int outer = 0; outer < mostOuters; ++outer) {
    if (weight != alpha) setWeight(problem, weight = alpha);
    change_.setZero(problem.size());
    letHeldAnswer();
    for (int i = 0; i < n; ++i) {
      steps_.r[i] = center_[left_[i]];
      steps_.u[i] = u_[left_[i]] + felt_[left_[i]];
    }
    const double enough = std::max(fine * std::max(alpha * residual, polishedShare * tolerance),
                                   map.roundOff(center_));
    const bool isFound = solveLeft(problem, enough, most - best.sweeps, best);
    if (!isFound && alpha < largest && best.sweeps < most) {
      alpha *= growth;
      shrink = std::sqrt(shrink);
      continue;
    }
    for (int i = 0; i < n; ++i) change_[left_[i]] = steps_.r[i] - center_[left_[i]];
    letHeldAnswer();
    center_ += change_;
    makeFeasible(problem, center_);
    problem.W.multiply(center_, delta_, u_);
    u_ += problem.q;
    const VelocityResidual now = map.residual(center_, u_);
    if (now.max < best.residual) {
      best.r = center_;
      best.u = u_;
      best.residual = now.max;
      best.residualRms = now.rms;
    }
    // As in ProximalNewton::converge.
    const double aim = now.max > 0.3 * residual ? tolerance : polishedShare * tolerance;
    if (now.max <= std::max(aim, map.roundOff(center_))) return true;
    if (!isFound || !(now.max <= 0.3 * residual)) break;
    if (now.max > 0.01 * residual) alpha = std::max(knownRegion, shrink * alpha);
    residual = now.max;
  }
  return best.residual <= tolerance;
}

}  // namespace delassus
