#include "delassus/proximal_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "delassus/options.h"
#include "delassus/proximal_weight.h"
#include "delassus/residual.h"
#include "delassus/wall.h"

namespace delassus {
namespace {

constexpr int endless = std::numeric_limits<int>::max();  ///< patience

}  // namespace

template <class Motion>
ProximalWalk<Motion>::ProximalWalk(ProximalSpace<Motion>& space)
    : space_(space),
      scale_(space.scale),
      l_(space.l),
      felt_(space.felt),
      G_(space.G),
      center_(space.ofUnknowns[0]),
      u_(space.ofUnknowns[1]),
      r_(space.ofUnknowns[2]),
      delta_(space.ofMotion[0]),
      change_(space.ofUnknowns[3]),
      error_(space.ofMotion[1]),
      step_(space.ofMotion[2]),
      trialDelta_(space.ofMotion[3]),
      trialError_(space.ofMotion[4]),
      trialU_(space.ofUnknowns[4]),
      fromU_(space.ofUnknowns[space.seldomUsed[0]]),
      alongU_(space.ofUnknowns[space.seldomUsed[1]]) {}

template <class Motion>
void ProximalWalk<Motion>::setWeights(double alpha) {
  constexpr double finest = 1e-7, coarsest = 1e-2;
  space_.setWeights(alpha);
  enough_ = std::clamp(alpha, finest, coarsest);
}

/// Sets the inner accuracy that answers within this tolerance need.
template <class Motion>
void ProximalWalk<Motion>::setTolerance(double tolerance) {
  // An error of the motion (in energy norm) that is too small beside the tolerance for any contact.
  fine_ = 0.1 * tolerance / std::sqrt(scale_.maxCoeff());
}

/// The motion of the bodies that r_ causes beyond the center, J̃ᵀ (r − r_k).
template <class Motion>
const VectorXd& ProximalWalk<Motion>::felt() {
  space_.motion().impulse(change_, felt_);
  return felt_;
}

/// The norm of the error after this share of the step.
template <class Motion>
double ProximalWalk<Motion>::tryStep(double share) {
  trialDelta_ = delta_ + share * step_;
  space_.motion().relativeVelocity(trialDelta_, trialU_);
  trialU_ += u_;
  respond(trialU_, nullptr);
  trialError_ = trialDelta_ - felt();
  return trialError_.norm();
}

/// Takes as much of the step as lets the energy norm `error` of the error fall. Near a solution
/// that is the whole step. Elsewhere the step is halved until the error falls. Along the step the
/// error falls as far as some wall of the regions, and rises behind it; halves alone come ever
/// nearer to that wall and never through it. So the step goes on from wall to wall as long as the
/// error falls, and ends a hair's breadth behind the last wall: the next step then knows the region
/// there. False if the error does not fall.
template <class Motion>
bool ProximalWalk<Motion>::stepAlong(double& error) {
  constexpr int mostHalvings = 10, mostWalls = 4;
  constexpr double leastDecrease = 1e-4;  // of the error, beside what the whole step promises
  constexpr double hair = 1e-6;
  double share = 1, least = tryStep(share);
  for (int h = 1; !(least <= (1 - leastDecrease * share) * error); ++h) {
    if (h == mostHalvings) return false;
    share *= 0.5;
    least = tryStep(share);
  }
  if (share < 1) {
    const double tooLong = 2 * share;
    space_.motion().relativeVelocity(delta_, fromU_);
    fromU_ += u_;
    space_.motion().relativeVelocity(step_, alongU_);
    double tried = share;
    for (int k = 0; k < mostWalls; ++k) {
      const double wall = nextWallAlong(tried);
      if (!(wall < tooLong)) break;
      tried = (1 + hair) * wall;
      const double now = tryStep(tried);
      if (!(now < least)) break;
      least = now;
      share = tried;
    }
    if (tried != share) tryStep(share);
  }
  error = least;
  return true;
}

/// The first wall after this share of the step.
template <class Motion>
double ProximalWalk<Motion>::nextWallAlong(double after) const {
  double first = infinity;
  const int n = problem().contacts();
  for (int i = 0; i < n; ++i) {
    const int at = 3 * i;
    const Vec3 l = l_.segment<3>(at);
    const Vec3 z = center_.segment<3>(at) - l.cwiseProduct(fromU_.segment<3>(at));
    const Vec3 d = -l.cwiseProduct(alongU_.segment<3>(at));
    first = std::min(first, nextWall(z, d, problem().friction[i], after));
  }
  const auto z = [this](int at) { return center_[at] - l_[at] * fromU_[at]; };
  const auto d = [this](int at) { return -l_[at] * alongU_[at]; };
  for (int i = 0; i < problem().rows(); ++i) {
    const int at = 3 * n + i;
    first = std::min(first, nextWall(z(at), d(at), problem().lower[i], problem().upper[i], after));
  }
  for (const Disk& disk : problem().disks) {
    const Vec2 own = disk.of(center_) - l_[disk.first] * disk.of(fromU_);
    const Vec2 along = -l_[disk.first] * disk.of(alongU_);
    const Vec3 from(z(disk.governor), own[0], own[1]), way(d(disk.governor), along[0], along[1]);
    first = std::min(first, nextWall(from, way, disk.radius, after));
  }
  return first;
}

template <class Motion>
void ProximalWalk<Motion>::startFromCenter() {
  delta_.setZero(space_.motion().size());
  trialU_ = u_;
}

template <class Motion>
void ProximalWalk<Motion>::startFromReactions(const VectorXd& r) {
  change_ = r - center_;
  space_.motion().impulse(change_, delta_);
  space_.motion().relativeVelocity(delta_, trialU_);
  trialU_ += u_;
}

/// False if the region leads nowhere.
template <class Motion>
bool ProximalWalk<Motion>::startFromRegion(const Solution& region, int& budget, WorkDone& count) {
  startFromCenter();
  if (budget-- <= 0) return false;
  ++count.regions;
  respondInRegion(region);
  if (!space_.factorise(count)) return false;
  change_ = r_ - center_;
  delta_ = felt();
  space_.motion().solve(delta_);
  if (!delta_.allFinite()) return false;
  space_.motion().relativeVelocity(delta_, trialU_);
  trialU_ += u_;
  return true;
}

/// Solves the inner problem, from δ and the u that belongs to it.
template <class Motion>
typename ProximalWalk<Motion>::Inner ProximalWalk<Motion>::solveProximal(int& budget,
                                                                         WorkDone& count) {
  // An inner answer only has to be better than what the outer step corrects anyway; at round-off
  // the line search stalls.
  constexpr double stalled = 1e-2;
  constexpr int mostSteps = 40;
  respond(trialU_, &G_);
  error_ = delta_ - felt();
  double error = error_.norm();
  for (int k = 0; k < mostSteps; ++k) {
    const double size = std::max(delta_.norm(), felt_.norm());
    if (error <= std::max(enough_ * size, fine_)) return Inner::Converged;
    if (budget-- <= 0) return Inner::Failed;
    ++count.regions;
    if (k > 0) respond(trialU_, &G_);
    if (!space_.factorise(count)) return Inner::Failed;
    step_ = -error_;
    space_.motion().solve(step_);
    if (!step_.allFinite()) return Inner::Failed;

    if (!stepAlong(error)) return error <= stalled * size ? Inner::Converged : Inner::Failed;
    delta_.swap(trialDelta_);
    error_.swap(trialError_);
  }
  return Inner::Failed;
}

template <class Motion>
Outcome ProximalWalk<Motion>::walk(double tolerance, double alpha, int regionBudget,
                                   Solution& best) {
  return walkFrom(best, tolerance, alpha, regionBudget, best);
}

template <class Motion>
Outcome ProximalWalk<Motion>::walkOn(double tolerance, double alpha, int patience, int regionBudget,
                                     Solution& best) {
  center_ = best.r;
  u_ = best.u;
  return converge(tolerance, alpha, patience, regionBudget, false, best.residual, best);
}

template <class Motion>
Outcome ProximalWalk<Motion>::walkFrom(const Solution& start, double tolerance, double alpha,
                                       int regionBudget, Solution& best) {
  center_ = start.r;
  u_ = start.u;
  return converge(tolerance, alpha, endless, regionBudget, false, start.residual, best);
}

template <class Motion>
Outcome ProximalWalk<Motion>::walkFromRegion(double tolerance, double alpha, int regionBudget,
                                             Solution& best) {
  center_.setZero(problem().size());
  u_ = problem().q;
  constexpr double unknown = infinity;
  return converge(tolerance, alpha, endless, regionBudget, true, unknown, best);
}

/// Makes r_ the next center, and the best answer if its residual is the smallest.
template <class Motion>
void ProximalWalk<Motion>::moveTo(const VelocityResidual& residual, Solution& best) {
  center_ = r_;
  u_.swap(trialU_);
  best.takeIfBetter(center_, u_, residual);
}

template <class Motion>
void ProximalWalk<Motion>::polish(double tolerance, double alpha, int regionBudget,
                                  Solution& best) {
  center_ = best.r;
  u_ = best.u;
  r_ = center_;
  setTolerance(tolerance);
  setWeights(alpha);
  startFromCenter();
  if (solveProximal(regionBudget, best) == Inner::Failed) return;
  moveTo(measure(), best);
}

/// Makes outer steps from the reactions center_, whose natural residual is `residual`.
template <class Motion>
Outcome ProximalWalk<Motion>::converge(double tolerance, double firstWeight, int patience,
                                       int regionBudget, bool fromRegion, double residual,
                                       Solution& best) {
  constexpr double smallest = 1e-12, largest = 10, hardly = 1e-7;
  // Shares of the residual that a step leaves. Above `slow` a smaller weight is needed; above
  // `tooSlow` no more digits come by themselves; above `atItsEnd`, with the smallest weight,
  // nothing more will come; above `stuck` reactions may grow in vain.
  constexpr double slow = 1e-2, tooSlow = 0.3, atItsEnd = 0.1, stuck = 0.5;
  constexpr int easyRegions = 6;  // an outer step with no more regions was an easy one
  constexpr int mostIdle = 1000;  // outer steps without regions; no budget ends these
  setTolerance(tolerance);
  r_ = center_;
  ProximalWeight alpha(firstWeight, smallest, largest);
  double toHalve = infinity;  // root mean square of the residual, m/s
  int halvedAt = regionBudget, idle = 0;
  for (int outer = 0; idle < mostIdle && halvedAt - regionBudget < patience; ++outer) {
    setWeights(alpha.value());
    const int regionsBefore = regionBudget;
    bool hasStart = true;
    if (fromRegion && outer == 0)
      hasStart = startFromRegion(best, regionBudget, best);
    else
      startFromCenter();
    if (!hasStart || solveProximal(regionBudget, best) == Inner::Failed) {
      // Where the budget ends, a half-done step may be better than none.
      if (regionBudget <= 0) moveTo(measure(), best);
      if (best.residual <= tolerance) return Outcome::Reached;
      if (fromRegion || regionBudget <= 0 || alpha.isMost()) return Outcome::Lost;
      alpha.grow();
      continue;
    }
    alpha.learn(regionsBefore - regionBudget <= easyRegions);
    if (regionsBefore == regionBudget) ++idle;
    const VelocityResidual measured = measure();
    const double now = measured.max;
    if (now > std::max(stuck * residual, tolerance) && alpha.value() <= hardly &&
        growsInVain(tolerance, now)) {
      compromise(best);
      return Outcome::Incompatible;
    }
    moveTo(measured, best);
    if (measured.rms <= 0.5 * toHalve) {
      toHalve = measured.rms;
      halvedAt = regionBudget;
    }
    // Take some more digits if they come by themselves: the next step may then keep these
    // reactions.
    const double aim = now > tooSlow * residual ? tolerance : polishedShare * tolerance;
    if (now <= std::max(aim, space_.map().roundOff(center_))) return Outcome::Reached;
    // A known region needs a small weight to finish; one that still changes needs a larger weight.
    if (now > atItsEnd * residual && alpha.isLeast()) break;
    if (now > slow * residual) alpha.shrink();
    residual = now;
  }
  return best.residual <= tolerance ? Outcome::Reached : Outcome::Lost;
}

template class ProximalWalk<BodyMotion>;
template class ProximalWalk<FactoredMotion>;

}  // namespace delassus
