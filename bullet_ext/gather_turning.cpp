#include <algorithm>

#include "BulletCollision/NarrowPhaseCollision/btPersistentManifold.h"
#include "bullet_ext/contact_frame.h"
#include "bullet_ext/gather.h"
#include "delassus/turning_friction.h"

namespace delassus::bullet {
namespace {

// Users write "infinite" coefficients.
constexpr double largestCoefficient = 1e3;

// Below this a body does not resist turning about an axis, as in Bullet.
constexpr double leastLength = 1e-3;

// The load of each point, N·s, up to which Bullet's own solver counts it: |τ| ≤ κ min(r_n, 1 N·s).
// It is a bound per step, not per second.
constexpr double stockMostLoad = 1;

double coefficient(btScalar value) {
  return value > 0 ? std::min<double>(value, largestCoefficient) : 0;
}

/// Whether the body can turn at all.
bool canTurn(const Group& group, int body) {
  return group.movable(body) && group.bodies[body].inverseInertia.any();
}

TurningFriction turningFrictionOf(const PointSource& source, bool asStock) {
  const btPersistentManifold& manifold = *source.manifold;
  const btManifoldPoint& point = manifold.getContactPoint(source.point);
  TurningFriction friction;
  friction.spinning = coefficient(point.m_combinedSpinningFriction);
  friction.rolling = coefficient(point.m_combinedRollingFriction);
  if (friction.rolling > 0) {
    friction.axes =
        rollingAxes(point, rollingAnisotropyOf(*manifold.getBody0(), *manifold.getBody1()));
    if (friction.axes.norm() < leastLength) friction.rolling = 0;
  }
  if (asStock) {
    friction.mostLoad = stockMostLoad;
    if (!(point.m_combinedRollingFriction > 0)) friction.spinning = 0;
  }
  return friction;
}

}  // namespace

void gatherTurningFriction(Group& group, bool asStock) {
  if (group.turning == 0) return;
  const std::size_t others = group.rows.size();
  for (std::size_t i = 0; i < group.contacts.size(); ++i) {
    const Contact& contact = group.contacts[i];
    if (!canTurn(group, contact.a) && !canTurn(group, contact.b)) continue;
    const bool rigid = !group.isLimb(contact.a) && !group.isLimb(contact.b);
    addRows(turningFrictionOf(group.contactSources[i], asStock && rigid), contact,
            static_cast<int>(i), group.rows);
  }
  group.turningRows = static_cast<int>(group.rows.size() - others);
}

}  // namespace delassus::bullet
