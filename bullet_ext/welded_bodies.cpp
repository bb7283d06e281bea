#include "bullet_ext/welded_bodies.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "BulletDynamics/ConstraintSolver/btTypedConstraint.h"
#include "bullet_ext/convert.h"
#include "bullet_ext/group.h"
#include "delassus/bytes.h"

namespace delassus::bullet {
namespace {

/// Whether the body has the same mass along all axes, and inertia about each.
bool hasFullMass(const Body& body) {
  constexpr double leastRatio = 1e-9;
  const Vec3& m = body.inverseMass;
  const double mean = body.inverseInertia.trace() / 3;
  return m[0] > 0 && m[0] == m[1] && m[0] == m[2] &&
         body.inverseInertia.determinant() > leastRatio * mean * mean * mean;
}

Vec3 centreOf(const Group& group, int body) {
  return toCore(group.bodySources[body].rigid->getCenterOfMassPosition());
}

/// The velocity of what goes along with a body, at this way from its centre.
Vec6 goingAlong(const Vec6& velocity, const Vec3& way) {
  Vec6 along = velocity;
  along.head<3>() += velocity.tail<3>().cross(way);
  return along;
}

}  // namespace

std::size_t WeldedBodies::bytes() const {
  return bytesOf(parts_, partOf_, rootOf_, moverOf_, leastThreshold_, fromCentre_, ofErrors_,
                 ofMovers_, welds_, bolts_, weldsFrom_, firstFrom_, found_);
}

void WeldedBodies::reset(const Group& group) {
  const auto count = static_cast<int>(group.bodies.size());
  parts_ = group.bodies;
  partOf_.resize(count);
  rootOf_.assign(count, none);
  leastThreshold_.assign(count, infinity);
  fromCentre_.assign(count, Vec3::Zero());
  moverOf_.assign(count, none);
  ofErrors_.assign(count, Vec6::Zero());
  ofMovers_.assign(count, Vec6::Zero());
  for (int i = 0; i < count; ++i) {
    partOf_[i] = group.isRigid(i) ? i : none;
    if (partOf_[i] != none) continue;
    moverOf_[i] = i;
    ofMovers_[i] = group.bodies[i].velocity;
  }
  welds_.clear();
  bolts_.clear();
}

void WeldedBodies::weld(const Group& group, const JointSource& joint) {
  const Row& first = group.rows[joint.firstRow];
  const int a = first.a, b = first.b;
  const bool hasA = partOf(a) != none, hasB = partOf(b) != none;
  if ((hasA && !hasFullMass(group.bodies[a])) || (hasB && !hasFullMass(group.bodies[b]))) return;
  // Of the body that goes along, and of the other one.
  const bool isBNext = hasB;
  Mat6 onNext, onOther;
  Vec6 target;
  for (int k = 0; k < 6; ++k) {
    const Row& row = group.rows[joint.firstRow + k];
    if (row.a != a || row.b != b) return;
    onNext.row(k) = isBNext ? row.jacobianB : row.jacobianA;
    onOther.row(k) = isBNext ? row.jacobianA : row.jacobianB;
    target[k] = row.target;
  }
  const Eigen::PartialPivLU<Mat6> factor(onNext);
  constexpr double leastRatio = 1e-9;
  if (!(std::abs(factor.determinant()) > leastRatio * onNext.rowwise().norm().prod())) return;
  const double threshold = toCoreBound(joint.constraint->getBreakingImpulseThreshold());
  const int next = isBNext ? b : a, other = isBNext ? a : b;
  if (hasA && hasB) {
    // Where the welded places have come apart, the rows differ from those of a rigid body, and what
    // they ask for depends on how the bodies turn.
    const Vec6& v = group.bodies[other].velocity;
    const Vec6 along = goingAlong(v, centreOf(group, next) - centreOf(group, other));
    const Vec6 asked = factor.solve(target - onOther * v) - along;
    welds_.push_back({other, next, threshold, asked});
    const Vec3 back = centreOf(group, other) - centreOf(group, next);
    welds_.push_back({next, other, threshold, -goingAlong(asked, back)});
  } else {
    Vec6 moved = Vec6::Zero();
    if (other >= 0) moved = factor.solve(-onOther * ofMovers_[other]);
    bolts_.push_back({next, moverOf(other), threshold, factor.solve(target), moved});
  }
}

/// Finds the bodies that hang on this one, and what their welds ask of them.
void WeldedBodies::spread(const Group& group, int root) {
  rootOf_[root] = root;
  found_.assign(1, root);
  for (std::size_t next = 0; next < found_.size(); ++next) {
    const int at = found_[next];
    for (int k = firstFrom_[at]; k < firstFrom_[at + 1]; ++k) {
      const Weld& weld = welds_[weldsFrom_[k]];
      if (rootOf_[weld.to] != none) continue;
      rootOf_[weld.to] = root;
      partOf_[weld.to] = partOf_[root];
      const Vec3 way = centreOf(group, weld.to) - centreOf(group, at);
      moverOf_[weld.to] = moverOf_[root];
      ofErrors_[weld.to] = goingAlong(ofErrors_[at], way) + weld.target;
      ofMovers_[weld.to] = goingAlong(ofMovers_[at], way);
      found_.push_back(weld.to);
    }
  }
}

/// Makes one body of those that have been found.
void WeldedBodies::unite(const Group& group, int root) {
  double mass = 0;
  Vec3 centre = Vec3::Zero();
  for (const int body : found_) {
    const double m = 1 / group.bodies[body].inverseMass[0];
    mass += m;
    centre += m * centreOf(group, body);
  }
  centre /= mass;
  Mat3 inertia = Mat3::Zero();
  for (const int body : found_) {
    const Vec3 r = centreOf(group, body) - centre;
    fromCentre_[body] = r;
    inertia += group.bodies[body].inverseInertia.inverse() +
               (r.squaredNorm() * Mat3::Identity() - r * r.transpose()) /
                   group.bodies[body].inverseMass[0];
  }
  parts_[root].inverseMass.setConstant(1 / mass);
  parts_[root].inverseInertia = inertia.inverse();
}

void WeldedBodies::close(const Group& group) {
  const auto count = static_cast<int>(welds_.size());
  firstFrom_.assign(group.bodies.size() + 1, 0);
  for (const Weld& weld : welds_) ++firstFrom_[weld.from];
  std::partial_sum(firstFrom_.begin(), firstFrom_.end(), firstFrom_.begin());
  weldsFrom_.resize(count);
  for (int k = count; k-- > 0;) weldsFrom_[--firstFrom_[welds_[k].from]] = k;

  for (const Bolt& bolt : bolts_) {
    if (rootOf_[bolt.body] != none) continue;
    partOf_[bolt.body] = none;
    moverOf_[bolt.body] = bolt.mover;
    ofErrors_[bolt.body] = bolt.ofErrors;
    ofMovers_[bolt.body] = bolt.ofMovers;
    spread(group, bolt.body);
  }
  for (const Weld& weld : welds_) {
    if (rootOf_[weld.from] != none) continue;
    spread(group, weld.from);
    unite(group, weld.from);
  }
  const auto note = [&](int body, double threshold) {
    double& least = leastThreshold_[rootOf_[body]];
    least = std::min(least, threshold);
  };
  for (const Bolt& bolt : bolts_) note(bolt.body, bolt.threshold);
  for (const Weld& weld : welds_) note(weld.from, weld.threshold);
}

bool WeldedBodies::moveAsOne(const Group& group, int a, int b) const {
  if (a == b) return true;
  if (a < 0 || b < 0 || group.isLimb(a) || group.isLimb(b)) return false;
  const Vec3 placeA = centreOf(group, a), placeB = centreOf(group, b), way = placeB - placeA;
  const Vec6 apart = ofMovers_[b] - goingAlong(ofMovers_[a], way);
  constexpr double rounding = 8 * static_cast<double>(std::numeric_limits<btScalar>::epsilon());
  const double turn = ofMovers_[a].tail<3>().norm(), h = group.h;
  // Bullet takes the angle of a turn from its cosine. Where that rounds too much, they count as
  // two: what they press together must not pass.
  const double ofTurn = turn > 0 ? rounding / (turn * h * h) : 0;
  if (ofTurn > 0.25 * turn || apart.tail<3>().norm() > ofTurn) return false;
  const double chord = turn * turn * h * way.norm();
  return apart.head<3>().norm() <=
         chord + ofTurn * way.norm() + rounding * (placeA.norm() + placeB.norm()) / h;
}

bool WeldedBodies::areOfOneWeld(int a, int b) const {
  if (!areWelded(a, b)) return false;
  return std::any_of(weldsFrom_.begin() + firstFrom_[a], weldsFrom_.begin() + firstFrom_[a + 1],
                     [&](int weld) { return welds_[weld].to == b; });
}

Vec6 WeldedBodies::onPart(int body, const Vec6& impulse) const {
  Vec6 on = impulse;
  on.tail<3>() += fromCentre_[body].cross(impulse.head<3>());
  return on;
}

}  // namespace delassus::bullet
