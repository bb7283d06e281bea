#pragma once

#include "tests/support/bullet_world.h"

namespace delassus::test {

constexpr double ballRadius = 0.25;
constexpr double inertiaOfUnit = 0.4 * ballRadius * ballRadius;  ///< of a ball of 1 kg

inline btVector3 vector(double x, double y, double z) {
  return {btScalar(x), btScalar(y), btScalar(z)};
}

/// A ball that touches y = 0.
inline btRigidBody& addBall(BulletWorld& world, double mass = 1, double x = 0) {
  return world.addSphere(btScalar(ballRadius), vector(x, ballRadius, 0), btScalar(mass));
}

}  // namespace delassus::test
