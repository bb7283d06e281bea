#pragma once

#include <Eigen/Geometry>
#include <algorithm>

#include "BulletDynamics/Dynamics/btRigidBody.h"
#include "bullet_ext/group.h"

namespace delassus::bullet {

/// How a coordinate of its tree moves a point of a limb along `axis`. turn: arm × axis.
inline double motionAlong(const Articulation::Limb& limb, Eigen::Index coordinate, const Vec3& axis,
                          const Vec3& turn) {
  const auto motion = limb.motion.col(coordinate);
  return axis.dot(motion.head<3>()) + turn.dot(motion.tail<3>());
}

/// The share of one body in W_ii of a contact along `axis`. The linear factor is left out, as in
/// Bullet's solvers.
inline double responseOf(const Group& group, int body, const Vec3& arm, const Vec3& axis) {
  if (!group.movable(body)) return 0;
  const Vec3 turn = arm.cross(axis);
  if (const Articulation::Limb* limb = group.articulation.limbOf(body)) {
    double sum = 0;
    for (Eigen::Index k = 0; k < limb->motion.cols(); ++k) {
      const double motion = motionAlong(*limb, k, axis, turn);
      sum += motion * motion;
    }
    return sum;
  }
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
