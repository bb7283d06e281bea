/// Contacts with what joints hold: they ask for nothing, unless something drives it there.

#include <BulletDynamics/ConstraintSolver/btFixedConstraint.h>
#include <BulletDynamics/ConstraintSolver/btGeneric6DofSpring2Constraint.h>
#include <BulletDynamics/ConstraintSolver/btSliderConstraint.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

/// A door of 20 kg, 1 m by 2 m, that hangs on one or two hinges and is `overlap` deep in the floor.
struct Door {
  DelassusWorld world;
  btRigidBody* leaf;
  btHingeConstraint* hinge;
  btJointFeedback feedback;

  Door(double overlap, int hinges) {
    world.addGround();
    leaf = &world.addBox({0.5, 1, btScalar(0.05)}, {0.5, btScalar(1 - overlap), 0}, 20);
    for (int k = 0; k < hinges; ++k)
      hinge = &world.addJoint<btHingeConstraint>(*leaf, btVector3(-0.5, btScalar(0.8 - 1.6 * k), 0),
                                                 btVector3(0, 1, 0));
    hinge->setJointFeedback(&feedback);
  }
  /// Pushed for a second with 5 N at its far edge.
  double angleAfterPush() {
    for (int step = 0; step < 60; ++step) {
      leaf->applyForce({0, 0, 5}, {0.5, 0, 0});
      world.advance();
      EXPECT_EQ(world.report().incompatible + world.report().outOfBudget, 0) << step;
      EXPECT_EQ(world.report().pushUnsolved, 0) << step;
      for (const btManifoldPoint* point : world.points())
        EXPECT_LT(point->getAppliedImpulse(), 0.1 * 20 * g * h);
    }
    return hinge->getHingeAngle();
  }
};

TEST(HeldContacts, ADoorThatGrazesTheFloorSwingsAsIfItDidNot) {
  for (const int hinges : {1, 2}) {
    const double free = Door(-0.1, hinges).angleAfterPush();
    ASSERT_GT(std::abs(free), 0.2);
    for (const double overlap : {1e-4, 1e-3, 0.02, 0.1}) {
      SCOPED_TRACE(testing::Message() << hinges << " hinges, " << overlap << " m");
      EXPECT_NEAR(Door(overlap, hinges).angleAfterPush(), free, tolerance(1e-5, 1e-4));
    }
  }
}

/// How far, rad, a double door opens in a second that is pushed at the middle. Its leaves of 1 m
/// by 6 cm overlap each other by `overlap`. Pushed with 20 N.
double openedDoubleDoor(double overlap) {
  DelassusWorld world;
  std::vector<btRigidBody*> leaves;
  std::vector<btHingeConstraint*> hinges;
  for (const int side : {-1, 1}) {
    const double x = 0.5 * side * (1 - overlap);
    leaves.push_back(&world.addBox({0.5, btScalar(0.6), btScalar(0.03)}, {btScalar(x), 2, 0}, 10));
    leaves.back()->setDamping(0, 0);
    hinges.push_back(&world.addJoint<btHingeConstraint>(
        *leaves.back(), btVector3(btScalar(0.5 * side), 0, 0), btVector3(0, 1, 0)));
  }
  for (int step = 0; step < 60; ++step) {
    for (const int k : {0, 1})
      leaves[k]->applyForce({0, 0, 20}, {btScalar(k == 0 ? 0.5 : -0.5), 0, 0});
    world.advance();
  }
  return std::min(std::abs(hinges[0]->getHingeAngle()), std::abs(hinges[1]->getHingeAngle()));
}

// Rigid corners would lock it.
TEST(HeldContacts, ADoorThatFitsExactlyOpens) {
  const double free = openedDoubleDoor(-0.05);
  ASSERT_GT(free, 1);
  for (const double overlap : {-2e-4, 0.0, 1e-3}) {
    SCOPED_TRACE(overlap);
    EXPECT_NEAR(openedDoubleDoor(overlap), free, 0.2 * free);
  }
}

// A stop close behind the hinge blocks one way, and carries what presses against it.
TEST(HeldContacts, AStopNearTheHingeHolds) {
  DelassusWorld world;
  btRigidBody& leaf = world.addBox({0.5, 1, btScalar(0.05)}, {0.5, 1, 0}, 20);
  auto& hinge = world.addJoint<btHingeConstraint>(leaf, btVector3(-0.5, 0, 0), btVector3(0, 1, 0));
  world.addBox({btScalar(0.01), 0.5, 0.1}, {btScalar(0.05), 1, btScalar(0.15)}, 0);
  for (int step = 0; step < 60; ++step) {
    leaf.applyForce({0, 0, 20}, {0.5, 0, 0});
    world.advance();
  }
  EXPECT_LT(std::abs(hinge.getHingeAngle()), 0.02);
}

// Nor does a slope of few degrees let go: a slider runs up to it, and a little into it.
TEST(HeldContacts, AShallowRampStopsASlider) {
  for (const double degrees : {isDouble ? 1.0 : 2.0, 3.9, 8.0}) {  // in float, 1 degree is held
    SCOPED_TRACE(degrees);
    DelassusWorld world;
    world->setGravity({0, 0, 0});
    btRigidBody& slider = world.addBox({0.25, 0.25, 0.25}, {0, 0, 0}, 1);
    world.addJoint<btSliderConstraint>(slider, DelassusWorld::at({0, 0, 0}), true);
    const btQuaternion tilt(btVector3(0, 0, 1), btScalar(degrees * M_PI / 180));
    btRigidBody& ramp = world.addBody(
        std::make_unique<btBoxShape>(btVector3(2, 0.5, 1)),
        btTransform(tilt, btVector3(0, 0, 0) + quatRotate(tilt, {2, btScalar(-0.5), 0}) +
                              btVector3(0.5, btScalar(-0.25), 0)),
        0);
    ramp.setFriction(0);
    for (int step = 0; step < 120; ++step) {
      slider.applyCentralForce({40, 0, 0});
      world.advance();
    }
    const double slope = std::tan(degrees * M_PI / 180), play = 2.5e-3 * 0.36;
    EXPECT_LT(slider.getWorldTransform().getOrigin().x(), 0.25 + 2 * play / slope + 0.03);
    EXPECT_LT(slider.getLinearVelocity().length(), 0.05);
  }
}

// A prop is light and free to turn; what it bears is heavy, and has no other hold.
TEST(HeldContacts, PropsBearAGate) {
  DelassusWorld world;
  btRigidBody& gate = world.addBox({1, btScalar(0.1), 0.5}, {0, 2, 0}, 200);
  world.addJoint<btSliderConstraint>(
      gate, btTransform(btQuaternion(btVector3(0, 0, 1), btScalar(M_PI / 2)), {0, 0, 0}), true);
  for (const double x : {-0.5, 0.5}) {
    btRigidBody& prop = world.addBox({btScalar(0.05), btScalar(0.45), btScalar(0.05)},
                                     {btScalar(x), btScalar(1.45), 0}, 1);
    world.addJoint<btHingeConstraint>(prop, btVector3(0, btScalar(-0.45), 0), btVector3(0, 0, 1));
  }
  world.advance(120);
  EXPECT_NEAR(gate.getWorldTransform().getOrigin().y(), 2, 0.001);
}

// A wheel on an axle of the world, a millimetre deep in the floor.
TEST(HeldContacts, AWheelThatGrazesTheFloorTurns) {
  DelassusWorld world;
  world.addGround();
  btRigidBody& wheel = world.addBody(std::make_unique<btCylinderShapeZ>(btVector3(0.5, 0.5, 0.1)),
                                     world.at({0, btScalar(0.499), 0}), 10);
  btHingeConstraint& axle =
      world.addJoint<btHingeConstraint>(wheel, btVector3(0, 0, 0), btVector3(0, 0, 1));
  axle.enableAngularMotor(true, 3, 1);
  for (int step = 0; step < 60; ++step) {
    world.advance();
    ASSERT_EQ(world.report().incompatible + world.report().outOfBudget, 0) << step;
    EXPECT_EQ(world.report().held, world.report().contacts) << step;
  }
  EXPECT_NEAR(wheel.getAngularVelocity().length(), 3, tolerance(1e-6, 1e-3));
}

// A car in space: its fender, welded to it, overlaps the wheel.
TEST(HeldContacts, AWheelTurnsInTheFenderOfItsCar) {
  for (const double overlap : {1e-4, 5e-3, 0.03}) {
    SCOPED_TRACE(overlap);
    DelassusWorld world;
    world->setGravity({0, 0, 0});
    btRigidBody& car = world.addBox({1, btScalar(0.1), 0.2}, {0, 0, 0}, 10);
    btRigidBody& wheel = world.addBody(std::make_unique<btCylinderShapeZ>(btVector3(0.4, 0.4, 0.1)),
                                       world.at({0, 0, 0.5}), 5);
    btRigidBody& fender =
        world.addBox({btScalar(0.3), btScalar(0.05), 0.2}, {0, btScalar(0.45 - overlap), 0.5}, 1);
    const btVector3 axis(0, 0, 1);
    auto& axle = world.addJoint<btHingeConstraint>(car, wheel, btVector3(0, 0, 0.5),
                                                   btVector3(0, 0, 0), axis, axis);
    world.addJoint<btFixedConstraint>(car, fender, fender.getWorldTransform(),
                                      btTransform::getIdentity());
    axle.enableAngularMotor(true, 3, 1);
    for (int step = 0; step < 60; ++step) {
      world.advance();
      ASSERT_EQ(world.report().incompatible + world.report().outOfBudget, 0) << step;
    }
    const btVector3 turn = wheel.getAngularVelocity() - car.getAngularVelocity();
    EXPECT_NEAR(turn.length(), 3, tolerance(1e-4, 1e-3));
    EXPECT_FALSE(world.points().empty());
    world.clear();
  }
}

// It carries what stands on it, and no more.
TEST(HeldContacts, WhatIsBoltedIntoTheGroundPullsAtNoBolt) {
  for (const double overlap : {1e-3, 0.05}) {
    SCOPED_TRACE(overlap);
    DelassusWorld world;
    world.addGround();
    btRigidBody& base = world.addCube({0, btScalar(0.5 - overlap), 0}, 10);
    btFixedConstraint& bolt =
        world.addJoint<btFixedConstraint>(base, btTypedConstraint::getFixedBody(),
                                          btTransform::getIdentity(), base.getWorldTransform());
    btJointFeedback feedback;
    bolt.setJointFeedback(&feedback);
    world.addCube({0, btScalar(1.5 - overlap), 0}, 5);
    for (int step = 0; step < 60; ++step) {
      world.advance();
      ASSERT_EQ(world.report().incompatible + world.report().outOfBudget, 0) << step;
      ASSERT_NEAR(feedback.m_appliedForceBodyA.length(), 15 * g, 15 * g * 0.02) << step;
    }
    EXPECT_NEAR(base.getWorldTransform().getOrigin().y(), 0.5 - overlap, tolerance(1e-6, 1e-4));
    world.clear();
  }
}

/// A plank of 2 m and 4 kg on a hinge of the world at its left end, level, its right end on a post
/// that it overlaps by `overlap`.
struct Plank {
  DelassusWorld world;
  btRigidBody* plank;
  btHingeConstraint* hinge;

  explicit Plank(double overlap) {
    plank = &world.addBox({1, btScalar(0.05), 0.2}, {1, 0, 0}, 4);
    hinge = &world.addJoint<btHingeConstraint>(*plank, btVector3(-1, 0, 0), btVector3(0, 0, 1));
    world.addBox({btScalar(0.1), 1, 1}, {btScalar(1.9), btScalar(-1.05 + overlap), 0}, 0);
  }
  /// All of the last step, N.
  double carried() {
    double sum = 0;
    for (const btManifoldPoint* point : world.points()) sum += point->getAppliedImpulse() / h;
    return sum;
  }
};

// The hinge leaves it free to rise: what overlaps is mended, and what it rests on carries its part.
TEST(HeldContacts, WhatAJointLeavesFreeIsExact) {
  Plank in(0.002);
  for (int step = 0; step < 180; ++step) {
    in.world.advance();
    ASSERT_EQ(in.world.report().solved, 1) << step;
    ASSERT_EQ(in.world.report().held, 0) << step;
  }
  for (const btManifoldPoint* point : in.world.points())
    EXPECT_GT(point->getDistance(), -tolerance(1e-6, 1e-4));
  // Half its weight acts at the post's near edge or its own end, 1.8 or 2 m from the hinge.
  EXPECT_GT(in.carried(), 4 * g / 2 * 0.999);
  EXPECT_LT(in.carried(), 4 * g / 1.8 * 1.01);
}

// A stop that lets it not rise holds one way: it is pressed no deeper, and does not fall.
TEST(HeldContacts, AgainstAStopItRestsWhereItIs) {
  Plank in(0.002);
  in.hinge->setLimit(-1, 0);  // counted upwards
  double most = 0;
  for (int step = 0; step < 300; ++step) {
    in.world.advance();
    ASSERT_EQ(in.world.report().incompatible + in.world.report().outOfBudget, 0) << step;
    most = std::max(most, in.carried());
  }
  EXPECT_LT(most, 100 * 4 * g);
  EXPECT_GT(in.carried(), 4 * g / 2 * 0.999);
  EXPECT_LT(std::abs(in.hinge->getHingeAngle()), 2e-3);
  in.plank->applyCentralForce({0, 100, 0});
  in.world.advance();
  EXPECT_LT(in.plank->getLinearVelocity().y(), 1e-3) << "the stop lets it not rise";
}

// A servo that presses its arm on a table is stopped there: who drives must not pass.
TEST(HeldContacts, AServoDoesNotPassThroughATable) {
  for (const double hertz : {60.0, 240.0})
    for (const double speed : {0.3, 0.02, 0.005})
      for (const bool isMotor : {false, true}) {
        SCOPED_TRACE(testing::Message() << hertz << " Hz, " << speed << " rad/s");
        Plank in(0);
        if (isMotor)
          in.hinge->enableAngularMotor(true, btScalar(-speed), BT_LARGE_FLOAT);
        else
          in.hinge->setLimit(0, 0);
        const int steps = static_cast<int>(hertz * std::min(0.6 / speed, 10.0));
        for (int step = 0; step < steps; ++step) {
          const auto wanted = btScalar(-speed * step / hertz);
          if (!isMotor) in.hinge->setLimit(wanted, wanted);
          in.world->stepSimulation(btScalar(1 / hertz), 0);
        }
        EXPECT_GT(in.plank->getWorldTransform().getOrigin().y(), -0.02);
      }
}

// A plate on the floor whose joint lets it rise and sink by 5 m, and whose motor presses it down.
// Bullet makes rows for both limits of such an axis, however far they are.
TEST(HeldContacts, ALimitThatIsFarAwayHoldsNothing) {
  for (const double force : {500.0, 5e4, 1e7}) {
    SCOPED_TRACE(testing::Message() << force << " N");
    DelassusWorld world;
    world.addGround();
    btRigidBody& plate = world.addBox({1, btScalar(0.1), 1}, {0, btScalar(0.1), 0}, 5);
    auto& joint = world.addJoint<btGeneric6DofSpring2Constraint>(plate, btTransform::getIdentity());
    for (int axis = 0; axis < 6; ++axis) joint.setLimit(axis, 0, 0);
    joint.setLimit(1, -5, 5);
    joint.enableMotor(1, true);
    joint.setTargetVelocity(1, btScalar(0.5));  // of the world against the plate
    joint.setMaxMotorForce(1, btScalar(force));
    for (int step = 0; step < 120; ++step) world.advance();
    double pressed = 0;
    for (const btManifoldPoint* point : world.points()) pressed += point->getAppliedImpulse() / h;
    EXPECT_NEAR(plate.getWorldTransform().getOrigin().y(), 0.1, 1e-4);
    EXPECT_NEAR(pressed, force + 5 * g, 1e-3 * force);
  }
}

// A post on the floor that is also welded to the world rests on the floor: the weld, which would
// break under a third of its weight, carries no more than its share.
TEST(HeldContacts, WhatIsWeldedStillRestsOnTheFloor) {
  for (const double load : {0.0, 100.0}) {
    SCOPED_TRACE(testing::Message() << load << " kg");
    DelassusWorld world;
    world.addGround();
    btRigidBody& post = world.addBox({btScalar(0.1), 0.5, btScalar(0.1)}, {0, 0.5, 0}, 2);
    auto& weld =
        world.addJoint<btFixedConstraint>(post, btTypedConstraint::getFixedBody(),
                                          btTransform::getIdentity(), post.getWorldTransform());
    weld.setBreakingImpulseThreshold(btScalar((2 + load) * g * h / 3));
    if (load > 0)
      world.addBox({btScalar(0.1), btScalar(0.1), btScalar(0.1)}, {0, btScalar(1.1), 0},
                   btScalar(load));
    for (int step = 0; step < 60; ++step) {
      world.advance();
      ASSERT_TRUE(weld.isEnabled()) << step;
    }
  }
}

// What a kinematic press drives against a weld still breaks it.
TEST(HeldContacts, AWeldBreaksUnderAPress) {
  DelassusWorld world;
  btRigidBody& box = world.addBox({0.2, 0.2, 0.2}, {0, 1, 0});
  auto& weld = world.addJoint<btFixedConstraint>(
      box, btTypedConstraint::getFixedBody(), btTransform::getIdentity(), box.getWorldTransform());
  weld.setBreakingImpulseThreshold(50);
  btRigidBody& press = world.addBox({0.3, 0.5, 0.5}, {btScalar(-0.55), 1, 0}, 0);
  press.setCollisionFlags(press.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
  for (int step = 1; step <= 60; ++step) {
    press.setWorldTransform(world.at({btScalar(-0.55 + 0.5 * step / 60), 1, 0}));
    world.advance();
  }
  EXPECT_FALSE(weld.isEnabled());
}

}  // namespace
}  // namespace delassus::test
