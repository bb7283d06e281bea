/// What joints do and report: softness, limits, motors, springs, feedback, breaking, constraints of
/// users.

#include <BulletDynamics/ConstraintSolver/btFixedConstraint.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

TEST(Parity, Row28JointSoftnessIsRelative) {
  // The sag of a loaded point joint. ERP closes what softness gives:
  // χ W m g h = erp d/h with W = 1/m.
  DelassusWorld world;
  btRigidBody& ball = world.addSphere(btScalar(0.2), {0, 0, 0}, 3);
  auto& joint = world.addJoint<btPoint2PointConstraint>(ball, btVector3(0, 0, 0));
  const double softness = 0.5, erp = 0.2;
  joint.setParam(BT_CONSTRAINT_CFM, btScalar(softness));
  joint.setParam(BT_CONSTRAINT_ERP, btScalar(erp));
  world.advance(600);
  const btScalar sag = -ball.getWorldTransform().getOrigin().y();
  EXPECT_NEAR(sag, softness * g * h * h / erp, tolerance(1e-9, 1e-4));
}

TEST(Parity, Row29HingeMotorPushesWithItsMaximumImpulse) {
  DelassusWorld world;
  world->setGravity({0, 0, 0});
  btRigidBody& wheel = world.addBox({0.5, 0.5, 0.1}, {0, 0, 0}, 2);
  auto& hinge = world.addJoint<btHingeConstraint>(wheel, btVector3(0, 0, 0), btVector3(0, 0, 1));
  const btScalar impulse = btScalar(0.01);
  hinge.enableAngularMotor(true, 100, impulse);
  wheel.setDamping(0, 0);
  constexpr int steps = 30;
  world.advance(steps);
  const double inverseInertia = wheel.getInvInertiaDiagLocal().z();
  EXPECT_NEAR(std::abs(wheel.getAngularVelocity().z()), steps * impulse * inverseInertia,
              1e4 * precision);
}

TEST(Parity, Row29HingeLimitPushesOneWay) {
  DelassusWorld ours;
  StockWorld stock;
  const auto swing = [](BulletWorld& world) -> const btRigidBody& {
    world->setGravity({0, 0, 0});
    btRigidBody& wheel = world.addBox({0.5, 0.5, 0.1}, {0, 0, 0});
    world.addJoint<btHingeConstraint>(wheel, btVector3(0, 0, 0), btVector3(0, 0, 1))
        .setLimit(btScalar(-0.5), btScalar(0.5));
    wheel.setAngularVelocity({0, 0, 2});
    return wheel;
  };
  const btRigidBody &a = swing(ours), &b = swing(stock);
  for (int i = 0; i < 60; ++i) {
    ours.advance();
    stock.advance();
    ASSERT_NEAR(a.getAngularVelocity().z(), b.getAngularVelocity().z(), tolerance(1e-9, 1e-3)) << i;
  }
  EXPECT_LT(a.getAngularVelocity().z(), 0) << "came back";
}

TEST(Parity, Row29SpringFrequencyWhateverTheIterations) {
  for (int iterations : {10, 50}) {
    DelassusWorld world;
    world->setGravity({0, 0, 0});
    world.info().m_numIterations = iterations;
    btRigidBody& body = world.addCube({0, 0, 0}, 2);
    const btTransform identity = btTransform::getIdentity();
    auto& joint = world.addJoint<btGeneric6DofSpringConstraint>(body, identity, true);
    joint.setLinearLowerLimit({-10, 0, 0});
    joint.setLinearUpperLimit({10, 0, 0});
    const double stiffness = 20;
    joint.enableSpring(0, true);
    joint.setStiffness(0, btScalar(stiffness));
    joint.setEquilibriumPoint(0, 0);
    body.translate({1, 0, 0});

    // The first crossing of the middle is a quarter period after the release.
    int steps = 0;
    while (body.getWorldTransform().getOrigin().x() > 0 && steps < 200) world.advance(), ++steps;
    const double quarter = SIMD_HALF_PI / std::sqrt(stiffness / 2);
    EXPECT_NEAR(steps * h, quarter, 3 * h) << iterations;
  }
}

/// A ball of 3 kg that hangs on the world.
struct Hanging {
  DelassusWorld world;
  btRigidBody& ball = world.addSphere(btScalar(0.2), {0, -1, 0}, 3);
  btPoint2PointConstraint& joint =
      world.addJoint<btPoint2PointConstraint>(ball, btVector3(0, 1, 0));
};

TEST(Parity, Row30FeedbackIsTheWeight) {
  Hanging hanging;
  btJointFeedback feedback;
  hanging.joint.setJointFeedback(&feedback);
  hanging.world.advance(60);
  EXPECT_NEAR(feedback.m_appliedForceBodyA.y(), 3 * g, tolerance(1e-8, 1e-3));
  EXPECT_NEAR(feedback.m_appliedForceBodyB.y(), -3 * g, tolerance(1e-8, 1e-3));
  hanging.joint.setEnabled(false);
  hanging.world.advance();
  EXPECT_EQ(feedback.m_appliedForceBodyA.y(), 0) << "cleared when the joint is disabled";
}

// A beam that sticks out of a wall bears about its own centre only what the torque on it asks for;
// the wall, whose origin is that of the world, bears the moment of its weight, too.
TEST(Parity, Row30FeedbackHasTheMomentsAboutTheBodies) {
  DelassusWorld world;
  constexpr double mass = 3, torque = 4;
  const btScalar reach = 2;
  btRigidBody& beam = world.addBox({1, btScalar(0.1), btScalar(0.1)}, {reach, 0, 0}, mass);
  btRigidBody& wall = world.addCube({0, 0, 0}, 0);
  beam.setIgnoreCollisionCheck(&wall, true);
  auto& joint = world.addJoint<btFixedConstraint>(beam, wall, BulletWorld::at({-1, 0, 0}),
                                                  BulletWorld::at({reach - 1, 0, 0}));
  btJointFeedback feedback;
  joint.setJointFeedback(&feedback);
  for (int i = 0; i < 60; ++i) {
    beam.applyTorque({0, 0, torque});
    world.advance();
  }
  const btVector3 force(0, btScalar(mass * g), 0), moment(0, 0, btScalar(-torque));
  const btVector3 onWall = -btVector3(reach, 0, 0).cross(force) - moment;
  constexpr double near = tolerance(1e-6, 1e-2);
  EXPECT_NEAR((feedback.m_appliedForceBodyA - force).length(), 0, near);
  EXPECT_NEAR((feedback.m_appliedForceBodyB + force).length(), 0, near);
  EXPECT_NEAR((feedback.m_appliedTorqueBodyA - moment).length(), 0, near);
  EXPECT_NEAR((feedback.m_appliedTorqueBodyB - onWall).length(), 0, near);
}

// Feedback leaves out the axes along which a body is locked.
TEST(Parity, Row30FeedbackHasTheFactorsOfTheBodies) {
  const auto run = [](BulletWorld& world) {
    btRigidBody& a = world.addCube({0, 0, 0}, 3);
    btRigidBody& b = world.addCube({2, 0, 0}, 3);
    for (btRigidBody* body : {&a, &b}) {
      body->setLinearFactor({1, 0, 0});
      body->setAngularFactor({0, 0, body == &a ? btScalar(1) : btScalar(0.5)});
    }
    auto& joint = world.addJoint<btPoint2PointConstraint>(a, b, btVector3(1, 0, 0),
                                                          btVector3(-1, btScalar(0.2), 0));
    btJointFeedback feedback;
    joint.setJointFeedback(&feedback);
    a.setAngularVelocity({0, 0, 1});
    b.setLinearVelocity({1, 0, 0});
    world.advance();
    return feedback;
  };
  DelassusWorld ours;
  StockWorld stock;
  const btJointFeedback a = run(ours), b = run(stock);
  EXPECT_GT(a.m_appliedTorqueBodyB.length(), 1);
  const double near = tolerance(1e-6, 1e-3) * a.m_appliedTorqueBodyB.length();
  EXPECT_NEAR((a.m_appliedForceBodyA - b.m_appliedForceBodyA).length(), 0, near);
  EXPECT_NEAR((a.m_appliedForceBodyB - b.m_appliedForceBodyB).length(), 0, near);
  EXPECT_NEAR((a.m_appliedTorqueBodyA - b.m_appliedTorqueBodyA).length(), 0, near);
  EXPECT_NEAR((a.m_appliedTorqueBodyB - b.m_appliedTorqueBodyB).length(), 0, near);
}

TEST(Parity, Row30BreaksAboveItsThreshold) {
  for (double factor : {0.99, 1.01}) {
    Hanging hanging;
    hanging.joint.setBreakingImpulseThreshold(btScalar(factor * 3 * g * h));
    hanging.world.advance(60);
    EXPECT_EQ(hanging.joint.isEnabled(), factor > 1);
  }
}

// A reaction that has reached its bound may be a last digit below it, and is kept from then on.
TEST(Parity, Row30BreaksUnderALoadThatGrows) {
  constexpr double rate = 40, settled = 0.5, step = 1.0 / 240;  // N/s, s
  for (const double threshold : {0.05, 0.1, 0.15, 0.2, 0.25, 0.3})
    for (const double offset : {0.0, 0.02}) {
      SCOPED_TRACE(testing::Message() << threshold << " N·s, " << offset);
      DelassusWorld world;
      world->setGravity({0, -10, 0});
      const btVector3 half(btScalar(0.1), btScalar(0.1), btScalar(0.1));
      btRigidBody& upper = world.addBox(half, {0, 1, 0}, 1);
      btRigidBody& lower = world.addBox(half, {0, btScalar(0.7), 0}, 1);
      auto& weld = world.addJoint<btFixedConstraint>(upper, lower,
                                                     DelassusWorld::at({0, btScalar(-0.15), 0}),
                                                     DelassusWorld::at({0, btScalar(0.15), 0}));
      weld.setBreakingImpulseThreshold(btScalar(threshold));
      world.addJoint<btPoint2PointConstraint>(upper, btVector3(0, 0, 0));
      const double due = settled + (threshold / step - 10) / rate;
      for (int k = 0; k * step < due + 0.1; ++k) {
        const double pull = rate * std::max(k * step - settled, 0.0);
        lower.applyForce({0, btScalar(-pull), 0}, {btScalar(offset), 0, 0});
        world->stepSimulation(btScalar(step), 0);
      }
      EXPECT_FALSE(weld.isEnabled());
    }
}

/// Stock breaks a joint whose impulse reaches its threshold, here 0 ≥ 0.
TEST(Parity, Row30JointThatBearsNothingBreaksAtOnce) {
  Hanging hanging;
  hanging.joint.setBreakingImpulseThreshold(0);
  hanging.world.advance();
  EXPECT_FALSE(hanging.joint.isEnabled());
  EXPECT_NEAR(hanging.ball.getLinearVelocity().y(), -g * h, 100 * precision);
}

/// Drives a body along x with an impulse of at most `strength` a step. Its last row keeps the body
/// from falling.
class Drive : public btTypedConstraint {
 public:
  Drive(btRigidBody& body, btScalar strength)
      : btTypedConstraint(MAX_CONSTRAINT_TYPE, body), strength_(strength) {}
  void getInfo1(btConstraintInfo1* info) override {
    info->m_numConstraintRows = 2;
    info->nub = 4;
  }
  void getInfo2(btConstraintInfo2* info) override {
    info->m_J1linearAxis[0] = 1;
    info->m_constraintError[0] = 2;
    info->m_lowerLimit[0] = -strength_;
    info->m_upperLimit[0] = strength_;
    info->m_J1linearAxis[info->rowskip + 1] = 1;
  }
  void setParam(int, btScalar, int) override {}
  btScalar getParam(int, int) const override { return 0; }

 private:
  btScalar strength_;
};

// The threshold at which a joint breaks bounds each of its rows.
TEST(Parity, Row30UserConstraintBreaksWhereItsMotorIsTooStrong) {
  constexpr double mass = 2, threshold = 0.5;
  for (const double strength : {0.49, 0.51, 10.0}) {
    SCOPED_TRACE(strength);
    const auto run = [&](BulletWorld& world) {
      btRigidBody& body = world.addCube({0, 0, 0}, mass);
      Drive& drive = world.addJoint<Drive>(body, btScalar(strength));
      drive.setBreakingImpulseThreshold(btScalar(threshold));
      world.advance();
      EXPECT_EQ(drive.isEnabled(), strength < threshold);
      EXPECT_NEAR(drive.getAppliedImpulse(), mass * g * h, tolerance(1e-7, 1e-6)) << "its last";
      return body.getLinearVelocity();
    };
    DelassusWorld ours;
    StockWorld stock;
    const btVector3 velocity = run(ours);
    EXPECT_NEAR(velocity.x(), std::min(strength, threshold) / mass, tolerance(1e-12, 1e-6));
    EXPECT_NEAR((velocity - run(stock)).length(), 0, tolerance(1e-7, 1e-6));
  }
}

// In small batches the group does not even hold the other body of the joint.
TEST(Parity, Row31DisabledJointIsSkipped) {
  for (const int batch : {0, 1, 128}) {
    SCOPED_TRACE(batch);
    DelassusWorld world;
    world.info().m_minimumSolverBatchSize = batch;
    btRigidBody& near = world.addCube({0, 5, 0});
    btRigidBody& far = world.addCube({50, 5, 0});
    auto& disabled = world.addJoint<btPoint2PointConstraint>(near, far, btVector3(25, 0, 0),
                                                             btVector3(-25, 0, 0));
    disabled.setEnabled(false);
    world.addJoint<btPoint2PointConstraint>(near, btVector3(0, 0, 0));
    world.advance(30);
    EXPECT_NEAR(near.getWorldTransform().getOrigin().y(), 5, tolerance(1e-9, 1e-4));
    EXPECT_NEAR(far.getLinearVelocity().y(), -g * 30 * h, 1e3 * precision) << "falls";
    EXPECT_EQ(disabled.getAppliedImpulse(), 0);
    EXPECT_EQ(world.report().leftOut, 0);
  }
}

/// Turns a body about x, by a row whose axis is this long, at this rate, rad/s.
class Crank : public btTypedConstraint {
 public:
  Crank(btRigidBody& body, btScalar length, btScalar rate)
      : btTypedConstraint(MAX_CONSTRAINT_TYPE, body), length_(length), rate_(rate) {}
  void getInfo1(btConstraintInfo1* info) override { info->m_numConstraintRows = info->nub = 1; }
  void getInfo2(btConstraintInfo2* info) override {
    info->m_J1angularAxis[0] = length_;
    info->m_constraintError[0] = length_ * rate_;
  }
  void setParam(int, btScalar, int) override {}
  btScalar getParam(int, int) const override { return 0; }

 private:
  btScalar length_, rate_;
};

// Cone-twist joints give such axes: rounding, at which their limit then asks for any rate.
TEST(Joints, AnAxisNoLongerThanRoundingTurnsNothing) {
  constexpr btScalar rate = 20;
  const double rounding = std::sqrt(precision);
  for (const double length : {0.1 * rounding, 0.01}) {
    DelassusWorld ours;
    StockWorld stock;
    for (BulletWorld* world :
         {static_cast<BulletWorld*>(&ours), static_cast<BulletWorld*>(&stock)}) {
      btRigidBody& body = world->addCube({0, 0, 0});
      world->addJoint<Crank>(body, btScalar(length), rate);
      world->advance();
      EXPECT_NEAR(body.getAngularVelocity().x(), length > rounding ? rate : 0, 1e-4) << length;
    }
  }
}

TEST(Joints, ARowThatMakesNoSenseIsLeftOut) {
  Hanging hanging;
  hanging.joint.setBreakingImpulseThreshold(-1);  // the bounds cross
  hanging.world.advance();
  EXPECT_NEAR(hanging.ball.getLinearVelocity().y(), -g * h, 100 * precision);
  ASSERT_EQ(hanging.world.report().messages.size(), 3u);
  EXPECT_NE(hanging.world.report().messages[0].find("lower bound is above"), std::string::npos);
}

}  // namespace
}  // namespace delassus::test
