#include "delassus/forced_hold.h"

#include <algorithm>
#include <cmath>

#include "delassus/cone.h"
#include "delassus/length.h"
#include "delassus/options.h"

namespace delassus {
namespace {

// A larger alpha would need more steps per digit. A smaller one would lose digits to rounding,
// which 1/alpha magnifies.
constexpr double alpha = 3e-8;
// The ease of friction relative to normal reactions. Piles at rest hardly need friction, and the
// taller the pile, the smaller this should be: a pyramid of 50 rows takes half the steps with the
// first. But towers with wedged corners need some once they have moved.
constexpr double tangentShareAtFirst = 0.003, tangentShareLater = 0.015;
// A reaction outside its cone is moved beyond the wall of a narrower cone that begins a little
// above the tip. So all reactions lie inside after finitely many steps.
constexpr double innerShare = 0.6, beyond = 1.6, marginShare = 0.15;

/// The move of a reaction outside its cone: towards the nearest point of the cone that begins at
/// `margin` and has `innerShare` of the friction, and beyond that point. Nearest in the norm in
/// which tangents move with the ease `tangentShare`.
Vec3 moveInside(const Vec3& r, double mu, double margin, double tangentShare) {
  const double root = std::sqrt(tangentShare);
  const Vec3 z(r[0] - margin, r[1] / root, r[2] / root);
  const Vec3 move = beyond * (projectOnCone(z, innerShare * mu / root) - z);
  return {move[0], root * move[1], root * move[2]};
}

double moveInside(double r, double lower, double upper, double margin) {
  const double inside = std::min(margin, 0.25 * (upper - lower));
  return beyond * (std::clamp(r, lower + inside, upper - inside) - r);
}

bool isInside(const Vec3& r, double mu) { return r[0] >= 0 && lengthOf(r[1], r[2]) <= mu * r[0]; }

bool isHeld(const ActiveSet& set, int unknown) {
  const int scalar = unknown - 3 * static_cast<int>(set.contacts.size());
  return scalar < 0 ? set.contacts[unknown / 3] != Mode::Open : set.rows[scalar] == RowState::Free;
}

}  // namespace

/// Sets the weights, zero for parts that are not held, and G for the Newton matrix. Sets change_ to
/// the reactions that those parts have to lose.
template <class Motion>
void ForcedHold<Motion>::setHold(const ActiveSet& set) {
  const int n = problem().contacts();
  space_.setWeights(alpha);
  change_.setZero(r_.size());
  for (int i = 0; i < n; ++i) {
    auto l = l_.segment<3>(3 * i);
    l.tail<2>() *= problem().friction[i] > 0 ? tangentShare_ : 0;
    if (!isHeld(set, 3 * i)) {
      l.setZero();
      change_.segment<3>(3 * i) = -r_.segment<3>(3 * i);
    }
    G_.contacts[i] = l.asDiagonal();
  }
  for (int at = 3 * n; at < problem().size(); ++at)
    if (!isHeld(set, at)) l_[at] = 0;
  G_.rows = l_.tail(problem().rows());
  for (std::size_t k = 0; k < problem().disks.size(); ++k) {
    const Disk& disk = problem().disks[k];
    const bool held = isHeld(set, disk.governor);
    if (!held) {
      l_.segment(disk.first, disk.unknowns).setZero();
      disk.put(-disk.of(r_), change_);
    }
    space_.answerOfDisk(disk, static_cast<int>(k), held ? Mode::Stick : Mode::Open, Vec2::Zero(), 0,
                        false, G_);
  }
}

/// Sets change_ to the moves of all r_ that lie outside their cones, bounds and disks. Returns the
/// square of its size, (m/s)².
template <class Motion>
double ForcedHold<Motion>::moveAllInside(double demand) {
  const int n = problem().contacts(), rows = problem().rows();
  double outside = 0;
  for (int i = 0; i < n; ++i) {
    const int at = 3 * i;
    const double mu = problem().friction[i];
    auto change = change_.segment<3>(at);
    if (isInside(r_.segment<3>(at), mu)) {
      change.setZero();
      continue;
    }
    change = moveInside(r_.segment<3>(at), mu, marginShare * demand / scale_[at], tangentShare_);
    outside += change.cwiseProduct(scale_.segment<3>(at)).squaredNorm();
  }
  change_.tail(rows).setZero();
  for (int i = 0; i < rows; ++i) {
    const int at = 3 * n + i;
    const double lower = problem().lower[i], upper = problem().upper[i];
    if (r_[at] < lower || r_[at] > upper)
      change_[at] = moveInside(r_[at], lower, upper, marginShare * demand / scale_[at]);
  }
  for (const Disk& disk : problem().disks) {
    const Vec2 r = disk.of(r_);
    const double length = r.norm(), radius = disk.radiusAt(r_);
    if (length > radius) disk.put(beyond * (innerShare * radius / length - 1) * r, change_);
  }
  return outside + change_.tail(rows).cwiseProduct(scale_.tail(rows)).squaredNorm();
}

/// r_ ← r' − L u with r' = r_ + change_, where u is the relative velocity with the new r_; updates
/// u_. Leaves change_ undefined.
template <class Motion>
void ForcedHold<Motion>::holdOnce() {
  // In large piles each pass over the unknowns counts: as few as possible.
  const Eigen::Index size = r_.size();
  for (Eigen::Index i = 0; i < size; ++i) {
    r_[i] += change_[i];
    u_[i] += compliance_[i] * change_[i];
    change_[i] -= l_[i] * u_[i];
  }
  space_.motion().impulse(change_, felt_);
  space_.motion().solve(felt_);
  space_.motion().relativeVelocity(felt_, measuredU_);
  for (Eigen::Index i = 0; i < size; ++i) {
    const double u = u_[i] + measuredU_[i], back = l_[i] * u;
    r_[i] -= back;
    u_[i] = u - compliance_[i] * back;
  }
}

/// Makes steps from r_, u_ and change_ until all r_ lie inside, and some more for the last digits.
template <class Motion>
bool ForcedHold<Motion>::holdOn(double tolerance, int budget, Solution& best) {
  // If something has to give way, the part outside stays as large as it is, or grows.
  constexpr int mostIdle = 10, mostStuck = 4;
  constexpr double halved = 0.5, unchanged = 0.8;
  constexpr double unknown = infinity;
  const double demand = problem().demand();
  double mark = unknown, outside = unknown, residual = unknown;
  for (int k = 0, idle = 0, stuck = 0; k < budget && idle < mostIdle && stuck < mostStuck; ++k) {
    holdOnce();
    ++best.sweeps;
    const double before = outside;
    outside = moveAllInside(demand);
    if (outside > 0) {
      stuck = outside > unchanged * before ? stuck + 1 : 0;
      ++idle;
      if (outside < halved * mark) mark = outside, idle = 0;
      continue;
    }
    const double residualBefore = residual;
    const VelocityResidual measured = space_.measure(r_, measuredU_);
    residual = measured.max;
    u_.swap(measuredU_);
    best.takeIfBetter(r_, u_, measured);
    if (residual <= polishedShare * tolerance || residual > 0.1 * residualBefore) break;
  }
  return best.residual <= tolerance;
}

template <class Motion>
ForcedHold<Motion>::ForcedHold(ProximalSpace<Motion>& space)
    : space_(space),
      scale_(space.scale),
      compliance_(space.compliance),
      l_(space.l),
      felt_(space.felt),
      G_(space.G),
      r_(space.ofUnknowns[0]),
      u_(space.ofUnknowns[1]),
      change_(space.ofUnknowns[2]),
      measuredU_(space.ofUnknowns[3]) {}

template <class Motion>
bool ForcedHold<Motion>::hold(double tolerance, int budget, Solution& best) {
  r_ = best.r;
  u_ = best.u;
  const bool startsFromNothing = !r_.any();
  tangentShare_ = startsFromNothing ? tangentShareAtFirst : tangentShareLater;
  setHold(best.activeSet);
  ++best.regions;
  if (!space_.factorise(best)) return false;
  const int end = best.sweeps + budget;
  if (holdOn(tolerance, budget, best)) return true;
  if (startsFromNothing) return false;
  r_.setZero(problem().size());
  u_ = problem().q;
  change_ = r_;
  return holdOn(tolerance, end - best.sweeps, best);
}

template class ForcedHold<BodyMotion>;
template class ForcedHold<FactoredMotion>;

}  // namespace delassus
