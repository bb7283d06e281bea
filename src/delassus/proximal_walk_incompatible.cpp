/// What the walk does where demands are incompatible.
#include <algorithm>
#include <cmath>
#include <limits>

#include "delassus/proximal_walk.h"

namespace delassus {

/// Whether reactions grow in vain. Incompatible demands let them grow without end, by the same d
/// each time, along which no body moves: J̃ᵀ d = 0. The motion is then the compromise that is
/// nearest to the demands in least squares, weighted by the W_aa. Contacts with friction and disks
/// have no part in it: a squeezed body may slip out, since u_n = −μ |u_t| is no demand at all.
///
/// Farkas' bound proves it: a motion that meets all demands has an energy norm of at least
/// −d·u/√(d·W d), and this is beyond any norm that the demands could ask for. The proof is needed,
/// as a nearly singular W with compatible demands lets reactions grow long, too.
template <class Motion>
bool ProximalWalk<Motion>::growsInVain(double tolerance, double residual) {
  // Shares of the residual, and of the largest part of d.
  constexpr double hardlyOpen = 0.1, nothing = 1e-6;
  VectorXd &d = change_, &open = step_, &moved = trialError_;  // in storage that is free now
  d = r_ - center_;
  const int frictional = 3 * problem().contacts(), plainRows = problem().disksBegin() - frictional;
  open = d.cwiseQuotient(l_);
  auto demands = open.segment(frictional, plainRows);
  if (plainRows == 0 || demands.cwiseAbs().maxCoeff() < hardlyOpen * residual) return false;
  demands.setZero();
  if (open.cwiseAbs().maxCoeff() > nothing * residual) return false;
  // A motor grows no further than its bound, and then gives way.
  const double least = nothing * d.cwiseAbs().maxCoeff();
  for (int i = 0; i < plainRows; ++i) {
    const double grows = d[frictional + i];
    if (std::isfinite(grows > 0 ? problem().upper[i] : problem().lower[i]) &&
        std::abs(grows) > least)
      return false;
  }
  space_.motion().impulse(d, felt_);
  space_.motion().relativeVelocity(felt_, moved);
  // Nothing is proven by a tolerance beside which the residual is small, nor by the rounding of
  // large reactions.
  const double still = std::min(tolerance, space_.map().roundOff(r_));
  if (moved.cwiseAbs().maxCoeff() > std::max(still, nothing * residual)) return false;

  constexpr double impossible = 1e3, rounding = 64 * std::numeric_limits<double>::epsilon();
  const double energy =
      std::abs(d.dot(moved)) + rounding * d.cwiseAbs2().dot(scale_);  // W is known no finer
  const double asked = problem().q.cwiseAbs().cwiseQuotient(scale_.cwiseSqrt()).maxCoeff();
  return -d.dot(trialU_) > impossible * asked * std::sqrt(energy);
}

/// Removes the part along d = r − center from the reactions, and names the parts whose demands made
/// it grow.
template <class Motion>
void ProximalWalk<Motion>::compromise(Solution& best) {
  // A share of a radius; and a share of the largest part of d, above which a part is named.
  constexpr double boundRounding = 1e-9, named = 0.1;
  VectorXd &d = change_, &open = step_, &shares = trialError_;  // in storage that is free now
  d = r_ - center_;
  open = scale_.cwiseProduct(d);
  best.r = center_ - d * (open.dot(center_) / open.dot(d));
  // Where a bound or a disk needs a share of d, the reactions stay as large as they have grown.
  const auto rows = best.r.tail(problem().rows()).array();
  const auto narrow = [&](const Disk& disk) {
    return disk.of(best.r).norm() > (1 + boundRounding) * disk.radiusAt(best.r);
  };
  if ((rows < problem().lower.array()).any() || (rows > problem().upper.array()).any() ||
      std::any_of(problem().disks.begin(), problem().disks.end(), narrow))
    best.r = r_;
  best.setResidual(space_.measure(best.r, best.u));
  // Compared in √J: the units of a row must not decide whether it is named.
  shares = scale_.cwiseSqrt().cwiseProduct(d);
  const double largest = shares.cwiseAbs().maxCoeff();
  best.blamed.clear();
  for (int i = 0; i < problem().contacts(); ++i)
    if (shares.segment<3>(3 * i).norm() > named * largest) best.blamed.push_back(3 * i);
  for (int at = 3 * problem().contacts(); at < problem().size(); ++at)
    if (std::abs(shares[at]) > named * largest) best.blamed.push_back(at);
}

template <class Motion>
bool ProximalWalk<Motion>::answerCompliant(double tolerance, double alpha, const VectorXd& start,
                                           int& regionBudget, Solution& best) {
  center_.setZero(problem().size());
  u_ = problem().q;
  r_ = center_;
  setTolerance(tolerance);
  setWeights(alpha);
  startFromReactions(start);
  if (solveProximal(regionBudget, best) == Inner::Failed) return false;
  best.residual = infinity;
  moveTo(measure(), best);
  return true;
}

template bool ProximalWalk<BodyMotion>::growsInVain(double, double);
template bool ProximalWalk<FactoredMotion>::growsInVain(double, double);
template void ProximalWalk<BodyMotion>::compromise(Solution&);
template void ProximalWalk<FactoredMotion>::compromise(Solution&);
template bool ProximalWalk<BodyMotion>::answerCompliant(double, double, const VectorXd&, int&,
                                                        Solution&);
template bool ProximalWalk<FactoredMotion>::answerCompliant(double, double, const VectorXd&, int&,
                                                            Solution&);

}  // namespace delassus
