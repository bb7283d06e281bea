/// What joints mend is no drive, and what drives is told from it: in contacts that joints hold, and
/// where a contact moves a body against a motor.
#include <BulletDynamics/ConstraintSolver/btFixedConstraint.h>
#include <BulletDynamics/ConstraintSolver/btGeneric6DofSpring2Constraint.h>
#include <BulletDynamics/ConstraintSolver/btHingeConstraint.h>
#include <BulletDynamics/ConstraintSolver/btPoint2PointConstraint.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "tests/support/bullet_world.h"
#include "tests/support/welds.h"

namespace delassus::test {
namespace {

/// The deepest overlap of any point, m.
double deepestOf(DelassusWorld& world) {
  double deepest = 0;
  for (const btManifoldPoint* point : world.points())
    deepest = std::max<double>(deepest, -point->getDistance());
  return deepest;
}

int notSolved(DelassusWorld& world) {
  const StepReport& report = world.report();
  return report.incompatible + report.outOfBudget + report.softened;
}

// A door that is deep in the floor, and leans a little from its normal: as it turns, its hinge
// mends errors that have a part along the normal. (They were taken for a servo's, and locked it.)
TEST(DrivesAndErrors, ADoorThatLeansTurns) {
  for (const double lean : {0.0, 0.05, 0.2})  // degrees
    for (const double deep : {0.01, 0.06, 0.2}) {
      SCOPED_TRACE(testing::Message() << lean << " degrees, " << deep << " m");
      constexpr double speed = 3;  // rad/s
      DelassusWorld world;
      world.addBox({50, 1, 50}, {0, -1, 0}, 0);
      const btQuaternion turned(btVector3(1, 0, 0), btScalar(lean * SIMD_PI / 180));
      btRigidBody& door = world.addBox({0.5, 1, btScalar(0.05)}, {0, 0, 0}, 10);
      door.setWorldTransform(btTransform(turned, quatRotate(turned, {0, btScalar(1 - deep), 0})));
      world.addJoint<btHingeConstraint>(door, btVector3(-0.5, 0, 0), btVector3(0, 1, 0));
      door.setAngularVelocity(quatRotate(turned, {0, btScalar(speed), 0}));
      door.setLinearVelocity(quatRotate(turned, {0, 0, btScalar(-0.5 * speed)}));
      int bad = 0;
      for (int step = 0; step < 60; ++step) {
        world.advance();
        bad += notSolved(world);
      }
      EXPECT_EQ(bad, 0);
      EXPECT_GT(door.getAngularVelocity().length(), 0.9 * speed);
    }
}

// A turret that stands free: the brake of its boom could turn it by a radian in a step, but not
// bear the load on it. What the boom lies on does. (It sank by a centimetre in three seconds.)
TEST(DrivesAndErrors, ABrakeThatIsTooWeakLeavesTheLoadToTheContact) {
  for (const double load : {10.0, 100.0})
    for (const double torque : {50.0, 500.0}) {
      SCOPED_TRACE(testing::Message() << load << " kg, " << torque << " N m");
      DelassusWorld world;
      world.addGround();
      btRigidBody& base = world.addBox({1, btScalar(0.1), 1}, {0, btScalar(0.1), 0}, 200);
      btRigidBody& post =
          world.addBox({btScalar(0.05), btScalar(0.05), btScalar(0.05)}, {0, btScalar(0.27), 0});
      btRigidBody& boom = world.addBox({btScalar(0.4), btScalar(0.03), btScalar(0.1)},
                                       {btScalar(0.5), btScalar(0.23), 0});
      const btVector3 up(0, 1, 0), across(0, 0, 1);
      world.addJoint<btHingeConstraint>(base, post, btVector3(0, btScalar(0.17), 0),
                                        btVector3(0, 0, 0), up, up);
      world
          .addJoint<btHingeConstraint>(post, boom, btVector3(0, btScalar(-0.04), 0),
                                       btVector3(btScalar(-0.5), 0, 0), across, across)
          .enableAngularMotor(true, 0, btScalar(torque * h));
      post.setIgnoreCollisionCheck(&base, true);
      post.setIgnoreCollisionCheck(&boom, true);
      world.advance(30);
      world.addBox({btScalar(0.1), btScalar(0.1), btScalar(0.08)},
                   {btScalar(0.7), btScalar(0.36), 0}, load);
      world.advance(90);
      EXPECT_LT(deepestOf(world), 1e-4);
      EXPECT_GT(world.report().held, 0);
    }
}

// The fingers of a gripper that stands free close slowly, on each other.
TEST(DrivesAndErrors, SlowFingersStopEachOther) {
  DelassusWorld world;
  world.addGround();
  btRigidBody& base = world.addBox({0.5, btScalar(0.1), btScalar(0.3)}, {0, btScalar(0.1), 0}, 20);
  for (const int side : {-1, 1}) {
    const auto x = btScalar(0.0505 * side);
    btRigidBody& finger =
        world.addBox({btScalar(0.05), btScalar(0.3), btScalar(0.05)}, {x, btScalar(0.55), 0});
    world
        .addJoint<btHingeConstraint>(base, finger, btVector3(x, btScalar(0.15), 0),
                                     btVector3(0, btScalar(-0.3), 0), btVector3(0, 0, 1),
                                     btVector3(0, 0, 1))
        .enableAngularMotor(true, btScalar(-0.002 * side), btScalar(300 * h));
    finger.setIgnoreCollisionCheck(&base, true);
  }
  world.advance(600);
  EXPECT_LT(deepestOf(world), 3e-3);  // without a stop 2.3 cm
}

// An arm lies deep in a table, and a motor holds it down. The contact lifts it against the motor,
// which takes up what the contact does: nothing is thrown. (It was taken for a throw, and the
// overlap stayed for ever.)
TEST(DrivesAndErrors, AnOverlapIsMendedAgainstAMotor) {
  for (const double torque : {20.0, 500.0})
    for (const double speed : {0.0, 2.0}) {  // a brake; a drive
      SCOPED_TRACE(testing::Message() << torque << " N m, " << speed << " rad/s");
      DelassusWorld world;
      world.addBox({btScalar(0.3), 0.5, btScalar(0.3)}, {1, -0.5, 0}, 0);
      btRigidBody& arm =
          world.addBox({0.5, btScalar(0.05), btScalar(0.05)}, {0.5, btScalar(0.05 - 0.01), 0});
      auto& hinge =
          world.addJoint<btHingeConstraint>(arm, btVector3(-0.5, 0, 0), btVector3(0, 0, 1));
      hinge.enableAngularMotor(true, btScalar(speed), btScalar(torque * h));
      int bad = 0;
      for (int step = 0; step < 60; ++step) {
        world.advance();
        bad += notSolved(world);
      }
      EXPECT_EQ(bad, 0);
      EXPECT_LT(deepestOf(world), 1e-4);
    }
}

/// A machine on the ground: a base with a block on it, and an arm above the block, on a post.
struct Machine {
  DelassusWorld world;
  btRigidBody *base, *block, *arm;
  const btTransform onBase = DelassusWorld::at({btScalar(-0.4), btScalar(0.75), 0}),
                    onArm = DelassusWorld::at({-0.5, 0, 0});
  static constexpr double blockTop = 0.6;

  Machine() {
    world.addGround();
    base = &world.addBox({btScalar(0.6), btScalar(0.1), btScalar(0.3)}, {0, btScalar(0.1), 0}, 50);
    block = &world.addBox({btScalar(0.1), btScalar(0.2), btScalar(0.2)},
                          {btScalar(0.4), btScalar(0.4), 0}, 5);
    arm =
        &world.addBox({0.5, btScalar(0.05), btScalar(0.1)}, {btScalar(0.1), btScalar(0.85), 0}, 3);
    addBolt(world, *base);
    addWeld(world, *base, *block);
  }
  double tip() const { return (arm->getWorldTransform() * btVector3(btScalar(0.45), 0, 0)).y(); }
};

// A motor with a force that Bullet takes for boundless drives, and mends nothing.
TEST(DrivesAndErrors, ABoundlessMotorIsADrive) {
  for (const double force : {1e3, 1e20, 1e30}) {
    SCOPED_TRACE(force);
    Machine in;
    auto& joint =
        in.world.addJoint<btGeneric6DofSpring2Constraint>(*in.base, *in.arm, in.onBase, in.onArm);
    for (int axis = 0; axis < 6; ++axis) joint.setLimit(axis, 0, 0);
    joint.setLimit(5, 1, -1);
    joint.enableMotor(5, true);
    joint.setMaxMotorForce(5, btScalar(force));
    joint.setTargetVelocity(5, 1);
    for (int step = 0; step < 90; ++step) {
      in.world.advance();
      ASSERT_GT(in.tip(), Machine::blockTop - 0.05) << step;
    }
  }
}

// A hand that is moved draws the arm on to the block, and a little further, and then stays.
TEST(DrivesAndErrors, WhatAHandHasDrawnTogetherStaysApart) {
  Machine in;
  const btVector3 axis(0, 0, 1);
  in.world.addJoint<btHingeConstraint>(*in.base, *in.arm, in.onBase.getOrigin(),
                                       in.onArm.getOrigin(), axis, axis);
  const auto handAt = [](double turn) {
    return DelassusWorld::at(
        {btScalar(-0.4 + 0.95 * std::cos(turn)), btScalar(0.85 - 0.95 * std::sin(turn)), 0});
  };
  btRigidBody& hand =
      in.world.addBody(std::make_unique<btSphereShape>(btScalar(0.01)), handAt(0), 0);
  hand.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT |
                         btCollisionObject::CF_NO_CONTACT_RESPONSE);
  in.world.addJoint<btPoint2PointConstraint>(*in.arm, hand, btVector3(btScalar(0.45), 0, 0),
                                             btVector3(0, 0, 0));
  for (int step = 0; step < 180; ++step) {
    hand.setWorldTransform(handAt(0.6 * std::min(step, 120) / 120));
    in.world.advance();
    ASSERT_GT(in.tip(), Machine::blockTop - 0.05) << step;
  }
}

}  // namespace
}  // namespace delassus::test
