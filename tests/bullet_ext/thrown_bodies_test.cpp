/// What is pinched is not thrown, whatever the exact answer is; and what is not pinched keeps it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

/// A press comes down on a column of four balls or boxes, every other one off the line by `lean`,
/// m.
struct Press {
  static constexpr double speed = 1.2, half = 0.3;  // m/s, m
  static constexpr int height = 4;
  DelassusWorld world;
  std::vector<btRigidBody*> column;
  btRigidBody* plate;

  Press(bool areBalls, double lean, double mu) {
    world.addGround();
    for (const double side : {-1, 1}) {
      world.addBox({0.5, 6, 6}, {btScalar(2.5 * side), 4, 0}, 0);
      world.addBox({6, 6, 0.5}, {0, 4, btScalar(2.5 * side)}, 0);
    }
    const btScalar h(half);
    for (int i = 0; i < height; ++i) {
      const btVector3 place(btScalar((i % 2) * lean), btScalar(half * (2 * i + 1)), 0);
      column.push_back(areBalls ? &world.addSphere(h, place) : &world.addBox({h, h, h}, place));
      column.back()->setFriction(btScalar(mu));
    }
    plate = &world.addBox({2.2, 0.2, 2.2}, {0, btScalar(top(0)), 0}, 0);
    plate->setFriction(btScalar(mu));
    plate->setCollisionFlags(plate->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
  }
  static double top(int step) { return 2 * half * height + 0.3 - speed * step / 60; }

  /// The fastest that anything of the column is within `steps`, m/s.
  double fastest(int steps) {
    double most = 0;
    for (int step = 0; step < steps; ++step) {
      plate->setWorldTransform(world.at({0, btScalar(top(step)), 0}));
      world.advance();
      softened += world.report().softened;
      if (world.report().softened > 0) messages = world.report().messages;
      for (const btRigidBody* body : column)
        most = std::max(most, double(body->getLinearVelocity().length()));
    }
    return most;
  }
  int softened = 0;
  std::vector<std::string> messages;
};

// The exact answer throws them at km/s through the walls.
TEST(ThrownBodies, APressThrowsNothing) {
  int softened = 0;
  for (const bool areBalls : {true, false})
    for (const double lean : {0.0, 1e-3, 0.05})
      for (const double mu : {0.0, 0.5}) {
        SCOPED_TRACE(testing::Message() << (areBalls ? "balls " : "boxes ") << lean << " " << mu);
        Press press(areBalls, lean, mu);
        EXPECT_LT(press.fastest(80), 20 * Press::speed);
        softened += press.softened;
        if (press.softened > 0) {
          EXPECT_NE(press.messages.front().find("throws or wedges a body"), std::string::npos);
        }
        for (const btRigidBody* body : press.column) {
          const btVector3 place = body->getWorldTransform().getOrigin();
          EXPECT_LT(std::max(std::abs(place.x()), std::abs(place.z())), 3) << "through a wall";
        }
      }
  EXPECT_GT(softened, 0);
}

// A seesaw with arms of 1 : 5, and a bat that a motor turns: what is fast there is asked for.
TEST(ThrownBodies, LeversAndBatsAreExact) {
  DelassusWorld world;
  btRigidBody& board = world.addBox({3, btScalar(0.05), 0.5}, {2, 1, 0}, 1);
  btRigidBody& post = world.addBox({0.1, 0.1, 0.1}, {0, btScalar(0.5), 0}, 0);
  world.addJoint<btHingeConstraint>(board, post, btVector3(-2, 0, 0), btVector3(0, 0.5, 0),
                                    btVector3(0, 0, 1), btVector3(0, 0, 1));
  world.addSphere(0.2, {btScalar(4.8), btScalar(1.25), 0}, btScalar(0.1));
  world.addSphere(0.2, {btScalar(-0.9), btScalar(1.6), 0}, 200).setLinearVelocity({0, -5, 0});

  btRigidBody& bat = world.addBox({1, 0.1, 0.1}, {1, 5, 5}, 1);
  btRigidBody& axle = world.addBox({0.05, 0.05, 0.05}, {0, 5, 5}, 0);
  auto& motor = world.addJoint<btHingeConstraint>(
      bat, axle, btVector3(-1, 0, 0), btVector3(0, 0, 0), btVector3(0, 1, 0), btVector3(0, 1, 0));
  motor.enableAngularMotor(true, 20, 1e6);
  world.addSphere(0.1, {btScalar(1.9), 5, btScalar(5.2)}, 1);
  world.addSphere(0.1, {btScalar(1.9), 5, btScalar(4.8)}, 1);
  for (int step = 0; step < 60; ++step) {
    world.advance();
    EXPECT_EQ(world.report().softened, 0) << step;
  }
}

// A weight that falls on a beam beside its axle: the ends, one of which lay on a block, may be as
// fast as they like.
TEST(ThrownBodies, WhatIsNotPressedIsNotThrown) {
  constexpr double mass = 1000, arm = 0.2, speed = 5, inertia = 3;
  DelassusWorld world;
  world->setGravity({0, 0, 0});
  btRigidBody& beam = world.addBox({3, btScalar(0.05), btScalar(0.1)}, {0, 0, 0}, 1);
  beam.setMassProps(1, btVector3(1, 1, 1) * btScalar(inertia));
  beam.updateInertiaTensor();
  world.addJoint<btHingeConstraint>(beam, btVector3(0, 0, 0), btVector3(0, 0, 1));
  world.addBox({btScalar(0.1), 0.5, 1}, {btScalar(2.9), btScalar(-0.549), 0}, 0);
  btRigidBody& weight = world.addSphere(0.1, {btScalar(-arm), btScalar(0.15), 0}, btScalar(mass));
  weight.setFriction(0);
  weight.setLinearVelocity({0, -speed, 0});
  world.advance();
  const double expected = mass * speed * arm / (mass * arm * arm + inertia);
  EXPECT_EQ(world.report().softened, 0);
  EXPECT_GE(world.report().contacts, 2);
  EXPECT_NEAR(beam.getAngularVelocity().z(), expected, tolerance(1e-4, 1e-3) * expected);
}

/// A crane whose arm of 20 m a motor turns, with a load that hangs from its end.
TEST(ThrownBodies, WhatDrivesJointsMayDoAllThatItsBoundAllows) {
  constexpr double speed = 1;
  DelassusWorld world;
  btRigidBody& arm = world.addBox({10, btScalar(0.1), btScalar(0.1)}, {10, 0, 0}, 1);
  auto& motor = world.addJoint<btHingeConstraint>(arm, btVector3(-10, 0, 0), btVector3(0, 1, 0));
  motor.enableAngularMotor(true, speed, 1e6);
  btRigidBody& load = world.addSphere(0.2, {20, -1, 0}, 100);
  world.addJoint<btPoint2PointConstraint>(arm, load, btVector3(10, 0, 0), btVector3(0, 1, 0));
  for (int step = 0; step < 60; ++step) {
    world.advance();
    EXPECT_EQ(world.report().softened, 0) << step;
  }
  EXPECT_NEAR(std::abs(arm.getAngularVelocity().y()), speed, 1e-3);
}

// An arm of two links, each turned by a strong motor to angles that a sine gives.
TEST(ThrownBodies, AnArmMovesAsItsMotorsAsk) {
  DelassusWorld world;
  btRigidBody* last = &world.addBox({0.2, 0.2, 0.2}, {0, 4, 0}, 0);
  std::vector<btHingeConstraint*> motors;
  for (int i = 0; i < 2; ++i) {
    btRigidBody& link = world.addBox({btScalar(0.3), btScalar(0.1), btScalar(0.1)},
                                     {btScalar(0.35 + 0.7 * i), 4, 0}, 1);
    auto& motor = world.addJoint<btHingeConstraint>(
        *last, link, btVector3(i == 0 ? 0 : btScalar(0.35), 0, 0), btVector3(btScalar(-0.35), 0, 0),
        btVector3(0, 0, 1), btVector3(0, 0, 1));
    link.setCollisionFlags(link.getCollisionFlags() | btCollisionObject::CF_NO_CONTACT_RESPONSE);
    motor.setLimit(btScalar(-1.2), btScalar(1.2));
    motor.enableAngularMotor(true, 0, 1000);
    motors.push_back(&motor);
    last = &link;
  }
  for (int step = 0; step < 30; ++step) {
    for (int i = 0; i < 2; ++i)
      motors[i]->setMotorTarget(btScalar(0.6 * std::sin(0.03 * step + i)), btScalar(1.0 / 60));
    world.advance();
    EXPECT_EQ(world.report().softened, 0) << step;
    EXPECT_EQ(world.report().incompatible, 0) << step;
  }
}

// A box lies before the tip of a long arm, which is asked for a turn that is fast only there.
TEST(ThrownBodies, WhatALongArmPushesIsAskedFor) {
  constexpr double length = 12, speed = 1;
  DelassusWorld world;
  world.addGround();
  btRigidBody& arm = world.addBox({btScalar(length / 2), btScalar(0.2), btScalar(0.2)},
                                  {btScalar(length / 2), 0.25, 0}, 10);
  auto& motor = world.addJoint<btHingeConstraint>(arm, btVector3(btScalar(-length / 2), 0, 0),
                                                  btVector3(0, 1, 0));
  motor.enableAngularMotor(true, btScalar(speed), btScalar(1e5));
  world.addBox({0.25, 0.25, 0.25}, {btScalar(length - 0.3), 0.25, btScalar(-0.45)}, 1);
  for (int step = 0; step < 30; ++step) {
    world.advance();
    EXPECT_EQ(world.report().softened, 0) << step;
  }
}

// Faces that lean against each other close on a ball; a motor with hardly any torque asks for a
// turn that nothing can follow.
TEST(ThrownBodies, AMotorWithoutForceAsksForNothing) {
  constexpr double speed = 0.1, lean = 0.002;
  for (const double turn : {0.0, 100.0}) {
    DelassusWorld world;
    world->setGravity({0, 0, 0});
    world.addBox({0.5, 2, 2}, {btScalar(-0.75), 0, 0}, 0).setFriction(0);
    btRigidBody& face = world.addBox({0.5, 2, 2}, {btScalar(0.75), 0, 0}, 0);
    face.setFriction(0);
    face.setCollisionFlags(face.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    btRigidBody& ball = world.addSphere(btScalar(0.25), {0, 0, 0}, 1);
    ball.setFriction(0);
    btRigidBody& other = world.addBox({0.05, 0.05, 0.05}, {0, 0, 3}, btScalar(0.1));
    world
        .addJoint<btHingeConstraint>(ball, other, btVector3(0, 0, 1.5), btVector3(0, 0, -1.5),
                                     btVector3(0, 0, 1), btVector3(0, 0, 1))
        .enableAngularMotor(true, btScalar(turn), btScalar(1e-6));
    for (int step = 0; step < 12; ++step) {  // the deeper, the faster it may leave
      face.setWorldTransform(btTransform(btQuaternion({0, 0, 1}, btScalar(lean)),
                                         {btScalar(0.75 - speed * step / 60), 0, 0}));
      world.advance();
      ASSERT_LT(ball.getLinearVelocity().length(), 20 * speed) << turn << ", step " << step;
    }
  }
}

// Wheels that keep their places, each geared to the next, have no energy but that of their turn.
TEST(ThrownBodies, WheelsThatKeepTheirPlacesAreNotThrown) {
  DelassusWorld world;
  btRigidBody* last = nullptr;
  for (int i = 0; i < 3; ++i) {
    btRigidBody& wheel = world.addBox({btScalar(0.4), btScalar(0.2), btScalar(0.4)},
                                      {btScalar(2 * i), 2, 0}, btScalar(1 + i));
    wheel.setLinearFactor({0, 0, 0});
    world.addJoint<btHingeConstraint>(wheel, btVector3(0, 0, 0), btVector3(0, 1, 0));
    if (last)
      world.addJoint<btGearConstraint>(*last, wheel, btVector3(0, 1, 0), btVector3(0, 1, 0),
                                       btScalar(1 + 0.5 * i));
    else
      wheel.setAngularVelocity({0, 3, 0});
    last = &wheel;
  }
  for (int step = 0; step < 120; ++step) {
    world.advance();
    EXPECT_EQ(world.report().softened, 0) << step;
    EXPECT_EQ(world.report().incompatible, 0) << step;
  }
}

// Without gravity, and at rest, there is nothing that could be thrown.
TEST(ThrownBodies, RestIsNoThrow) {
  DelassusWorld world;
  world->setGravity({0, 0, 0});
  world.addGround();
  for (int i = 0; i < 5; ++i) world.addCube({0, btScalar(0.5 + i), 0});
  for (int step = 0; step < 20; ++step) {
    world.advance();
    EXPECT_EQ(world.report().softened, 0) << step;
  }
}

}  // namespace
}  // namespace delassus::test
