#pragma once

#include <BulletDynamics/ConstraintSolver/btFixedConstraint.h>

#include "tests/support/bullet_world.h"

namespace delassus::test {

/// A weld of bodies that do not collide.
inline btFixedConstraint& addWeld(BulletWorld& world, btRigidBody& a, btRigidBody& b) {
  a.setIgnoreCollisionCheck(&b, true);
  return world.addJoint<btFixedConstraint>(
      a, b, a.getWorldTransform().inverse() * b.getWorldTransform(), btTransform::getIdentity());
}
/// A weld to the world.
inline btFixedConstraint& addBolt(BulletWorld& world, btRigidBody& a) {
  return world.addJoint<btFixedConstraint>(a, btTypedConstraint::getFixedBody(),
                                           btTransform::getIdentity(), a.getWorldTransform());
}

/// How many islands of the last step were contradictory or not solved.
inline int notSolvedOf(DelassusWorld& world) {
  return world.report().incompatible + world.report().outOfBudget;
}

}  // namespace delassus::test
