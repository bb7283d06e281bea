/// What links are made of: restitution, and softness of friction.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/multibody_world.h"

namespace delassus::test {
namespace {

constexpr btScalar radius = btScalar(0.5);

/// A ball of 1 kg that is the base of a tree without links.
btMultiBody& addBall(MultiBodyWorld& world, const btVector3& position, btScalar restitution) {
  const btScalar inertia = btScalar(0.4) * radius * radius;
  btMultiBody& ball = world.addTree(0, 1, btVector3(inertia, inertia, inertia), false, position);
  world.addCollider(ball, -1, std::make_unique<btSphereShape>(radius)).setRestitution(restitution);
  world.finish(ball);
  return ball;
}

// ---- Restitution
// -------------------------------------------------------------------------------------------------

/// The speed at which a link of a falling tree and a falling ball part after meeting at 1 m/s.
double partingSpeed(MultiBodyWorld& world, bool linkAbove, double restitution) {
  btMultiBody& link = addBall(world, {0, 0, 0}, btScalar(restitution));
  const btScalar side = linkAbove ? -1 : 1;
  btRigidBody& ball = world.addSphere(radius, {0, side * 2 * radius, 0});
  ball.setRestitution(1);
  ball.setLinearVelocity({0, -side, 0});
  world.advance();
  return side * (ball.getLinearVelocity().y() - link.getBaseVel().y());
}

// Bullet's velocities of links include gravity from the start of the step. Those of rigid bodies
// must not be compared without it.
TEST(MultiBodyRestitution, FallingTogetherAddsNothing) {
  for (const bool linkAbove : {false, true})
    for (const double restitution : {1.0, 0.5}) {
      DelassusMultiBodyWorld ours;
      StockMultiBodyWorld stock;
      const double speed = partingSpeed(ours, linkAbove, restitution);
      EXPECT_NEAR(speed, restitution, tolerance(1e-10, 1e-5)) << linkAbove;
      EXPECT_NEAR(speed, partingSpeed(stock, linkAbove, restitution), tolerance(1e-10, 1e-5));
    }
}

// A force drives the two together within the step, so they part faster, as in stock.
TEST(MultiBodyRestitution, WhatAForceAddsBouncesToo) {
  const auto parting = [](MultiBodyWorld& world) {
    world->setGravity({0, 0, 0});
    btMultiBody& link = addBall(world, {0, 0, 0}, 1);
    btRigidBody& ball = world.addSphere(radius, {0, 2 * radius, 0});
    ball.setRestitution(1);
    ball.setLinearVelocity({0, -1, 0});
    ball.applyCentralForce({0, -6, 0});
    world.advance();
    return ball.getLinearVelocity().y() - link.getBaseVel().y();
  };
  DelassusMultiBodyWorld ours;
  StockMultiBodyWorld stock;
  const double speed = parting(ours);
  EXPECT_NEAR(speed, 1 + 6 * h, tolerance(1e-10, 1e-5));
  EXPECT_NEAR(speed, parting(stock), tolerance(1e-10, 1e-5));
}

// At 30 Hz the speed that gravity adds in one step is above the threshold.
TEST(MultiBodyRestitution, ALinkThatRestsOnABoxDoesNotHop) {
  DelassusMultiBodyWorld world;
  world.addGround();
  const btScalar half = btScalar(0.5);
  btRigidBody& box = world.addBox({1, half, 1}, {0, half, 0}, 10);
  box.setRestitution(1);
  const btMultiBody& link = addBall(world, {0, 2 * half + radius, 0}, 1);
  for (int i = 0; i < 60; ++i) {
    world->stepSimulation(btScalar(1) / 30, 0);
    ASSERT_LE(link.getBaseVel().length(), tolerance(1e-9, 1e-4)) << i;
    ASSERT_LE(box.getLinearVelocity().length(), tolerance(1e-9, 1e-4)) << i;
  }
}

// ---- Softness of friction
// ------------------------------------------------------------------------------------------

/// A foot of 1 kg on the ground that cannot turn. It slides up and down, and along x, where it is
/// pulled. Returns its speed at the end.
double pulledFoot(MultiBodyWorld& world, double softness, double pull) {
  world.info().m_frictionCFM = btScalar(softness);
  btRigidBody& ground = world.addGround();
  ground.setCollisionFlags(ground.getCollisionFlags() |
                           btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
  const btVector3 zero(0, 0, 0), inertia(1, 1, 1);
  const btQuaternion straight = btQuaternion::getIdentity();
  btMultiBody& tree = world.addTree(2, 0, zero, true, {0, radius, 0});
  tree.setupPrismatic(0, btScalar(0.5), inertia, -1, straight, {0, 1, 0}, zero, zero, true);
  tree.setupPrismatic(1, btScalar(0.5), inertia, 0, straight, {1, 0, 0}, zero, zero, true);
  world.addCollider(tree, 1, std::make_unique<btSphereShape>(radius));
  world.finish(tree);
  for (int i = 0; i < 60; ++i) {
    tree.addJointTorque(1, btScalar(pull));
    world.advance();
  }
  return tree.getJointVel(1);
}

// u = (cfm/h) r with r = h F.
TEST(MultiBodyFriction, SlipsInProportionToItsForceAndSoftness) {
  for (const double softness : {0.0, 0.01, 0.02})
    for (const double pull : {1.0, 2.0}) {
      DelassusMultiBodyWorld ours;
      StockMultiBodyWorld stock;
      const double speed = pulledFoot(ours, softness, pull);
      EXPECT_NEAR(speed, softness * pull, tolerance(1e-9, 1e-5)) << softness << " " << pull;
      EXPECT_NEAR(speed, pulledFoot(stock, softness, pull), tolerance(1e-9, 1e-5));
    }
}

/// Gives each new point directions of its own, along x and z, and a softness.
bool giveSoftDirections(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                        const btCollisionObjectWrapper*, int, int) {
  point.m_contactPointFlags |= BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED;
  point.m_lateralFrictionDir1 = {1, 0, 0};
  point.m_lateralFrictionDir2 = {0, 0, 1};
  point.m_frictionCFM = btScalar(0.4);
  return true;
}

// As soft as with rigid bodies, u = χ W r, by the mean of both W: 2/kg along x, 0 across the rail.
TEST(MultiBodyFriction, OfDirectionsIsAsSoftAsTheirPointSays) {
  DelassusMultiBodyWorld world;
  world.info().m_solverMode |=
      SOLVER_ENABLE_FRICTION_DIRECTION_CACHING | SOLVER_USE_2_FRICTION_DIRECTIONS;
  gContactAddedCallback = giveSoftDirections;
  const double pull = 2, speed = pulledFoot(world, 0, pull);
  gContactAddedCallback = nullptr;
  EXPECT_NEAR(speed, 0.4 * (0.5 * 2) * pull * h, tolerance(1e-9, 1e-5));
}

// As in stock, only the softness of their point softens the friction of rigid bodies.
TEST(MultiBodyFriction, OfRigidBodiesIsNotSoftened) {
  DelassusMultiBodyWorld world;
  world.info().m_frictionCFM = btScalar(0.02);
  world.addGround();
  btRigidBody& box = world.addCube({0, radius, 0});
  for (int i = 0; i < 60; ++i) {
    box.applyCentralForce({2, 0, 0});
    world.advance();
    ASSERT_LE(box.getLinearVelocity().length(), tolerance(1e-9, 1e-5)) << i;
  }
}

}  // namespace
}  // namespace delassus::test
