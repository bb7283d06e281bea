/// Locked axes: no demand along them takes part, and all others are met (Bullet's linear and
/// angular factors).

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

using ::testing::IsEmpty;

// ---- Joints
// -------------------------------------------------------------------------------------------------

// No impulse fits a row that moves nothing. The least demand of such a row would take all the
// impulse there is, and break the joint.
TEST(LockedAxes, AHingeWhoseAxisLeansOnABodyThatCannotTurn) {
  DelassusWorld world;
  btRigidBody& body = world.addCube({0, 0, 0}, 3);
  body.setAngularFactor(0);
  auto& hinge = world.addJoint<btHingeConstraint>(body, btVector3(0, 1, 0), btVector3(0, 0, 1));
  hinge.getAFrame().getBasis() *= btMatrix3x3(btQuaternion({1, 0, 0}, btScalar(1e-3)));
  hinge.setBreakingImpulseThreshold(100);
  btJointFeedback feedback;
  hinge.setJointFeedback(&feedback);
  for (int i = 0; i < 60; ++i) {
    world.advance();
    ASSERT_TRUE(hinge.isEnabled()) << i;
    ASSERT_EQ(hinge.getAppliedImpulse(), 0) << i;
    ASSERT_NEAR(feedback.m_appliedForceBodyA.y(), 3 * g, tolerance(1e-7, 1e-3)) << i;
    ASSERT_NEAR(feedback.m_appliedTorqueBodyB.length(), 0, tolerance(1e-7, 1e-3)) << i;
  }
  EXPECT_NEAR(body.getWorldTransform().getOrigin().length(), 0, tolerance(1e-9, 1e-5));
  EXPECT_THAT(world.report().messages, IsEmpty());
}

/// Where a point of the body is now; `local` is its place in the body's own frame.
btVector3 pivotOf(const btRigidBody& body, const btVector3& local) {
  return body.getWorldTransform()(local);
}

// Two bodies of a flat world, 10 cm apart in the direction across the plane.
TEST(LockedAxes, APointToPointBetweenFlatBodiesHoldsInTheirPlane) {
  DelassusWorld world;
  const btVector3 inA(1, 0, 0), inB(-1, 0, 0);
  btRigidBody& a = world.addCube({0, 0, 0});
  btRigidBody& b = world.addCube({2, 0, btScalar(0.1)});
  for (btRigidBody* body : {&a, &b}) {
    body->setLinearFactor({1, 1, 0});
    body->setAngularFactor({0, 0, 1});
  }
  auto& joint = world.addJoint<btPoint2PointConstraint>(a, b, inA, inB);
  joint.setBreakingImpulseThreshold(1000);
  b.setLinearVelocity({0, 2, 0});

  world.advance();
  const btVector3 slip = a.getVelocityInLocalPoint(inA) - b.getVelocityInLocalPoint(inB);
  EXPECT_NEAR(std::hypot(slip.x(), slip.y()), 0, tolerance(1e-9, 1e-6));
  EXPECT_NEAR(a.getLinearVelocity().y() + b.getLinearVelocity().y(), 2 - 2 * g * h,
              tolerance(1e-12, 1e-6));
  for (int i = 0; i < 60; ++i) {
    world.advance();
    ASSERT_TRUE(joint.isEnabled()) << i;
    ASSERT_EQ(joint.getAppliedImpulse(), 0) << "that of its last row, across the plane";
  }
  const btVector3 apart = pivotOf(a, inA) - pivotOf(b, inB);
  EXPECT_NEAR(std::hypot(apart.x(), apart.y()), 0, 1e-2);
  EXPECT_NEAR(apart.z(), -0.1, 10 * precision);
  EXPECT_EQ(world.report().solved, world.report().islands);
}

// A lean of less than 1e-4 rad counts as a locked axis. Met exactly, such a hinge would ask for
// thousands of N·s.
TEST(LockedAxes, AHingeBetweenFlatBodiesMayLeanALittle) {
  for (const double lean : {1e-7, 1e-6, 1e-5, 5e-5}) {
    SCOPED_TRACE(lean);
    DelassusWorld world;
    btRigidBody& a = world.addCube({0, 0, 0});
    btRigidBody& b = world.addCube({2, 0, 0});
    for (btRigidBody* body : {&a, &b}) {
      body->setLinearFactor({1, 1, 0});
      body->setAngularFactor({0, 0, 1});
    }
    auto& hinge = world.addJoint<btHingeConstraint>(a, b, btVector3(1, 0, 0), btVector3(-1, 0, 0),
                                                    btVector3(0, 0, 1), btVector3(0, 0, 1));
    hinge.getAFrame().getBasis() *=
        btMatrix3x3(btQuaternion(btVector3(btScalar(0.8), btScalar(0.6), 0), btScalar(lean)));
    hinge.setBreakingImpulseThreshold(100);
    a.setAngularVelocity({0, 0, 1});
    world.advance(20);
    EXPECT_TRUE(hinge.isEnabled());
    EXPECT_NEAR(b.getAngularVelocity().z() + a.getAngularVelocity().z(), 1, 0.9) << "it is free";
    EXPECT_THAT(world.report().messages, IsEmpty());
  }
}

// The axes of the rail are rounded, and all its rows that hold angles act in vain.
TEST(LockedAxes, ALiftOnARailThatCannotTurn) {
  constexpr double mass = 20;
  DelassusWorld world;
  btRigidBody& lift =
      world.addBody(std::make_unique<btBoxShape>(btVector3(1, btScalar(0.1), 1)),
                    btTransform(btQuaternion({0, 1, 0}, btScalar(0.7)), {3, 4, 5}), btScalar(mass));
  lift.setAngularFactor(0);
  const btTransform upright(btQuaternion({0, 0, 1}, SIMD_HALF_PI));
  auto& rail = world.addJoint<btSliderConstraint>(lift, upright, true);
  rail.setLowerLinLimit(-10);
  rail.setUpperLinLimit(10);
  rail.setLowerAngLimit(0);
  rail.setUpperAngLimit(0);
  rail.setPoweredLinMotor(true);
  rail.setTargetLinMotorVelocity(1);
  rail.setMaxLinMotorForce(1000);
  rail.setBreakingImpulseThreshold(1000);
  btJointFeedback feedback;
  rail.setJointFeedback(&feedback);
  for (int i = 0; i < 60; ++i) {
    world.advance();
    ASSERT_TRUE(rail.isEnabled()) << i;
  }
  EXPECT_NEAR(std::abs(lift.getLinearVelocity().y()), 1, tolerance(1e-9, 1e-5));
  EXPECT_NEAR(feedback.m_appliedForceBodyB.y(), mass * g, tolerance(1e-6, 1e-2)) << "the lift";
  EXPECT_EQ(world.report().solved, world.report().islands);
}

// Point masses cannot be turned, whatever their factors say.
TEST(LockedAxes, AFixedJointOfBodiesWithoutInertiaHoldsTheirPlaces) {
  DelassusWorld world;
  btRigidBody& a = world.addCube({0, 0, 0});
  btRigidBody& b = world.addCube({2, 0, 0});
  for (btRigidBody* body : {&a, &b}) {
    body->setMassProps(1, {0, 0, 0});
    body->updateInertiaTensor();
  }
  const btTransform inA = BulletWorld::at({1, 0, 0});
  const btTransform inB(btQuaternion({0, 0, 1}, btScalar(0.1)), {-1, 0, 0});  // 0.1 rad off
  world.addJoint<btFixedConstraint>(a, b, inA, inB);
  b.setLinearVelocity({0, 2, 0});
  world.advance();
  for (const btRigidBody* body : {&a, &b})
    EXPECT_NEAR(body->getLinearVelocity().y(), 1 - g * h, tolerance(1e-9, 1e-6));
  EXPECT_EQ(world.report().solved, world.report().islands);
  EXPECT_THAT(world.report().messages, IsEmpty());
}

// ---- Contacts
// -------------------------------------------------------------------------------------------------

/// A ball that keeps its place and spins about z; its lowest point is 1 cm below y = 0.
struct PinnedBall {
  static constexpr double radius = 0.5, mass = 2, spin = 10, depth = 0.01;
  static constexpr double inertia = 0.4 * mass * radius * radius;

  explicit PinnedBall(BulletWorld& world)
      : ball(world.addSphere(btScalar(radius), {0, btScalar(radius - depth), 0}, mass)) {
    ball.setLinearFactor({0, 0, 0});
    ball.setAngularVelocity({0, 0, spin});
    ball.setDamping(0, 0);
  }
  btRigidBody& ball;
};

TEST(LockedAxes, APinnedBallSpinsOnInWhatStands) {
  DelassusWorld world;
  world.addGround();
  const PinnedBall pinned(world);
  world.advance(10);
  EXPECT_EQ(pinned.ball.getAngularVelocity(), btVector3(0, 0, PinnedBall::spin));
  EXPECT_EQ(world.report().contacts, 0);
  ASSERT_EQ(world.points().size(), 1u);
  EXPECT_EQ(world.points()[0]->m_appliedImpulse, 0);
}

TEST(LockedAxes, APinnedBallRubsAgainstWhatMoves) {
  DelassusWorld world;
  world->setGravity({0, 0, 0});
  const PinnedBall pinned(world);
  // The free ball is below the pinned one, so that the two overlap as much.
  btRigidBody& free = world.addSphere(0.5, {0, btScalar(-0.5), 0});
  world.advance();
  const double recovery = 0.2 * PinnedBall::depth / h, rub = friction * friction * recovery;
  EXPECT_NEAR(free.getLinearVelocity().y(), -recovery, tolerance(1e-9, 1e-4));
  EXPECT_NEAR(free.getLinearVelocity().x(), rub, tolerance(1e-9, 1e-4)) << "it is driven";
  EXPECT_NEAR(pinned.ball.getAngularVelocity().z(),
              PinnedBall::spin - rub * PinnedBall::radius / PinnedBall::inertia,
              tolerance(1e-9, 1e-4));
  EXPECT_EQ(pinned.ball.getLinearVelocity(), btVector3(0, 0, 0));
}

// A world seen from above: a body that lies in the ground cannot come out, and must not be held.
TEST(LockedAxes, ABoxThatCannotRiseSlidesOverWhatItOverlaps) {
  for (const btVector3& turns : {btVector3(0, 0, 0), btVector3(0, 1, 0)}) {
    DelassusWorld world;
    world.addGround();
    btRigidBody& box = world.addCube({0, btScalar(0.49), 0});
    box.setLinearFactor({1, 0, 1});
    box.setAngularFactor(turns);
    box.setLinearVelocity({1, 0, 2});
    btRigidBody& other = world.addCube({btScalar(1.1), btScalar(0.49), btScalar(0.2)}, 0);
    other.setFriction(0);
    world.advance(5);
    EXPECT_EQ(box.getLinearVelocity(), btVector3(1, 0, 2));
    EXPECT_EQ(world.report().contacts, 0) << "those with the ground";
    world.advance(10);
    EXPECT_LT(box.getLinearVelocity().x(), 1) << "what stands beside it stops it";
    EXPECT_THAT(world.report().messages, IsEmpty());
  }
}

// The normal of the ball's point is rounded.
TEST(LockedAxes, ABallThatCannotRiseSlidesOverWhatItOverlaps) {
  for (const double depth : {1e-2, 1e-4, 0.0}) {
    DelassusWorld world;
    world.addGround();
    btRigidBody& ball = world.addSphere(0.5, btVector3(0, btScalar(0.5 - depth), 0));
    ball.setLinearFactor({1, 0, 1});
    ball.setLinearVelocity({1, 0, 0});
    world.advance(10);
    EXPECT_EQ(ball.getLinearVelocity(), btVector3(1, 0, 0)) << depth;
  }
}

// ---- Torque
// -------------------------------------------------------------------------------------------------

// applyTorque applies the factor already, so it counts once.
// A body that keeps its place is at rest only if it does not turn.
TEST(LockedAxes, WhatCannotGoTurnsOn) {
  const btVector3 axis(0, 1, 0);
  constexpr double torque = 0.5, mass = 10;
  for (const bool isDriven : {false, true}) {
    SCOPED_TRACE(isDriven ? "a motor at its largest impulse" : "a motor that holds its speed");
    DelassusWorld world;
    btRigidBody& wheel =
        world.addBox({btScalar(0.3), btScalar(0.1), btScalar(0.3)}, {0, 0, 0}, mass);
    wheel.setLinearFactor({0, 0, 0});
    wheel.setDamping(0, 0);
    const double inertia = 1 / wheel.getInvInertiaTensorWorld()[1][1];
    auto& hinge = world.addJoint<btHingeConstraint>(wheel, btVector3(0, 0, 0), axis);
    constexpr double most = 0.01, target = 3;  // N·m·s, rad/s
    hinge.enableAngularMotor(true, btScalar(target), btScalar(isDriven ? most : 100));
    for (int step = 1; step <= 30; ++step) {
      if (!isDriven) wheel.applyTorque(axis * -btScalar(torque));
      world.advance();
      const double expected = isDriven ? std::min(step * most / inertia, target) : target;
      ASSERT_NEAR(wheel.getAngularVelocity().y(), expected, tolerance(1e-9, 1e-5)) << step;
    }
  }
}

TEST(LockedAxes, AFractionalAngularFactorTakesItsPartOfATorque) {
  for (const double factor : {0.5, 0.25, 2.0}) {
    const auto gain = [&](BulletWorld& world) {
      btRigidBody& body = world.addCube({0, 0, 0});
      body.setAngularFactor(btScalar(factor));
      body.applyTorque({0, 1, 0});
      world.advance();
      return body.getAngularVelocity().y();
    };
    DelassusWorld ours;
    StockWorld stock;
    const double omega = gain(ours), inertia = 1.0 / 6;
    EXPECT_NEAR(omega, h * factor / inertia, tolerance(1e-14, 1e-6));
    EXPECT_NEAR(omega, gain(stock), tolerance(1e-14, 1e-6));
  }
}

TEST(LockedAxes, TorqueAndGyroscopicTermsTurnNothingAboutThem) {
  for (int flag :
       {0, int(BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT), int(BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD),
        int(BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY)}) {
    DelassusWorld world;
    btRigidBody& body =
        world.addBody(std::make_unique<btSphereShape>(btScalar(1)),
                      btTransform(btQuaternion(btVector3(1, 2, 3).normalized(), 1), {0, 0, 0}), 1);
    body.setMassProps(1, {1, 2, 3});
    body.updateInertiaTensor();
    body.setFlags(flag);
    body.setAngularFactor({btScalar(0.5), 0, 1});
    body.setAngularVelocity({1, 0, 2});
    for (int i = 0; i < 60; ++i) {
      body.applyTorque({1, 1, 1});
      world.advance();
      ASSERT_EQ(body.getAngularVelocity().y(), 0) << flag << " " << i;
    }
    EXPECT_GT(std::abs(body.getAngularVelocity().x() - 1), 0.01) << "the others turn";
  }
}

}  // namespace
}  // namespace delassus::test
