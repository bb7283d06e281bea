#pragma once

#include <Eigen/Geometry>

#include "BulletDynamics/Dynamics/btRigidBody.h"
#include "bullet_ext/group.h"

namespace delassus::bullet {

/// What one body adds to W_ii of a contact along `axis`. The linear factor is left out, as in
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

}  // namespace delassus::bullet
