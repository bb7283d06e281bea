#pragma once

#include <Eigen/Geometry>
#include <algorithm>

#include "BulletDynamics/Dynamics/btRigidBody.h"
#include "bullet_ext/group.h"

namespace delassus::bullet {

/// The share of one body in W_ii of a contact along `axis`. The linear factor is left out, as in
/// Bullet's solvers.
inline double responseOf(const Group& group, int body, const Vec3& arm, const Vec3& axis) {
  if (!group.movable(body)) return 0;
  const Vec3 turn = arm.cross(axis);
  if (const Articulation::Limb* limb = group.articulation.limbOf(body))
    return (axis.transpose() * limb->motion.topRows<3>() +
            turn.transpose() * limb->motion.bottomRows<3>())
        .squaredNorm();
  return group.bodySources[body].rigid->getInvMass() * axis.squaredNorm() +
         turn.dot(group.bodies[body].inverseInertia * turn);
}

/// The response along the contact's normal of the body that responds less. A body that does not
/// move does not count.
inline double lesserResponse(const Group& group, const Contact& c) {
  const Vec3 n = c.frame.col(0);
  const double a = responseOf(group, c.a, c.armA, n), b = responseOf(group, c.b, c.armB, n);
  return a > 0 && b > 0 ? std::min(a, b) : a + b;
}

}  // namespace delassus::bullet
