/// Limits of joints: what leans on them, how they give, and what leaves them.

#include <gtest/gtest.h>

#include <functional>
#include <utility>

#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

/// A limb whose joint lets it fall against a limit.
struct Leaning {
  DelassusWorld world;
  btRigidBody& limb = world.addBox({0.5, btScalar(0.1), btScalar(0.1)}, {0.5, 0, 0});
  const btTransform atJoint = DelassusWorld::at({btScalar(-0.5), 0, 0});
};

// Soft limits give as their law says, however little: χ W m g l h = erp bias s/h, where a limb
// leans on one with its weight at l, and passes it by s.
TEST(Joints, SoftLimitsGiveHoweverLittle) {
  Leaning leaning;
  auto& hinge = leaning.world.addJoint<btHingeConstraint>(leaning.limb, leaning.atJoint.getOrigin(),
                                                          btVector3(0, 0, 1));
  const double softness = 4e-5, erp = 0.2, bias = 0.3, arm = 0.5;
  hinge.setUseFrameOffset(false);
  hinge.setLimit(0, 1, btScalar(0.9), btScalar(bias));
  hinge.setParam(BT_CONSTRAINT_STOP_CFM, btScalar(softness));
  hinge.setParam(BT_CONSTRAINT_STOP_ERP, btScalar(erp));
  leaning.world.advance(600);
  const double passing = softness * leaning.limb.getInvInertiaDiagLocal().z() * g * arm * h * h;
  EXPECT_NEAR(-hinge.getHingeAngle() * erp * bias, passing, tolerance(1e-3, 0.1) * passing);
}

// Bullet asks for the row of a limit only while the limit is passed. Were it mended to the last
// digit, the row would be gone now and then, and the limb would fall.
TEST(Joints, WhatLeansOnALimitStaysThere) {
  const auto hinged = [](Leaning& l) {
    auto& hinge =
        l.world.addJoint<btHingeConstraint>(l.limb, l.atJoint.getOrigin(), btVector3(0, 0, 1));
    // With it, a hinge on the world that is at its limit lets weights turn nothing.
    hinge.setUseFrameOffset(false);
    hinge.setLimit(btScalar(-0.3), btScalar(0.3));
  };
  const auto inACone = [](Leaning& l) {
    l.world.addJoint<btConeTwistConstraint>(l.limb, l.atJoint)
        .setLimit(btScalar(0.3), btScalar(0.3), btScalar(0.2));
  };
  const auto onASlider = [](Leaning& l) {
    const btTransform upright(btQuaternion(btVector3(0, 0, 1), SIMD_HALF_PI));
    auto& slider = l.world.addJoint<btSliderConstraint>(l.limb, upright, true);
    slider.setLowerLinLimit(btScalar(-0.3));
    slider.setUpperLinLimit(btScalar(0.3));
  };
  const auto inSixDof = [](auto& joint) {
    joint.setLinearLowerLimit({0, btScalar(-0.1), 0});
    joint.setLinearUpperLimit({0, btScalar(0.1), 0});
    joint.setAngularLowerLimit({0, 0, btScalar(-0.3)});
    joint.setAngularUpperLimit({0, 0, btScalar(0.3)});
  };
  const auto inSixDof1 = [&](Leaning& l) {
    inSixDof(l.world.addJoint<btGeneric6DofConstraint>(l.limb, l.atJoint, true));
  };
  const auto inSixDof2 = [&](Leaning& l) {
    inSixDof(l.world.addJoint<btGeneric6DofSpring2Constraint>(l.limb, l.atJoint));
  };
  const std::pair<const char*, std::function<void(Leaning&)>> joints[] = {
      {"hinge", hinged},
      {"cone twist", inACone},
      {"slider", onASlider},
      {"six-dof", inSixDof1},
      {"six-dof spring 2", inSixDof2}};
  for (const auto& [name, join] : joints) {
    SCOPED_TRACE(name);
    Leaning leaning;
    join(leaning);
    leaning.world.advance(300);
    const int rows = leaning.world.report().rows;
    const btVector3 place = leaning.limb.getWorldTransform().getOrigin();
    EXPECT_LT(place.y(), -0.05) << "it has fallen against the limit";
    double fastest = 0;
    for (int i = 0; i < 600; ++i) {
      leaning.world.advance();
      ASSERT_EQ(leaning.world.report().rows, rows) << "after " << i << " steps";
      fastest = std::max<double>(fastest, leaning.limb.getLinearVelocity().length());
    }
    EXPECT_LT(fastest, tolerance(1e-9, 1e-5));
    EXPECT_LT((leaning.limb.getWorldTransform().getOrigin() - place).length(),
              tolerance(1e-8, 1e-5));
  }
}

// Bullet adds the speed of a motor to what the limit of a turn asks for. However slow it is, it
// turns the joint away from the limit, and no further into it.
TEST(Joints, AMotorLeavesItsLimitHoweverSlowly) {
  for (const auto& [hertz, speed] : {std::pair(60.0, 1e-4), {60.0, 1e-3}, {1000.0, 2e-3}}) {
    SCOPED_TRACE(testing::Message() << hertz << " Hz, " << speed << " rad/s");
    const double seconds = 2, frequency = hertz, asked = speed * seconds;
    const auto turned = [&, rate = speed](BulletWorld& world, bool away) {
      world->setGravity({0, 0, 0});
      btRigidBody& hand = world.addBox({btScalar(0.05), 0.5, btScalar(0.05)}, {0, 0, 0});
      auto& hinge = world.addJoint<btHingeConstraint>(hand, btTransform::getIdentity(), true);
      const auto passed = btScalar(1e-7), range = btScalar(1.5);
      away ? hinge.setLimit(passed, range) : hinge.setLimit(-range, -passed);
      hinge.enableAngularMotor(true, btScalar(rate), 10);
      const double before = hinge.getHingeAngle();
      for (int i = 0; i < seconds * frequency; ++i)
        world->stepSimulation(btScalar(1 / frequency), 0);
      return hinge.getHingeAngle() - before;
    };
    DelassusWorld ours, blocked;
    StockWorld stock(50);
    const double inStock = turned(stock, true);
    EXPECT_GT(inStock, 0.95 * asked);
    EXPECT_NEAR(turned(ours, true), inStock, tolerance(1e-6, 0.03) * asked);
    // It passes the limit until what the limit recovers in a step balances the motor.
    EXPECT_LT(turned(blocked, false), 10 * speed / hertz);
  }
}

}  // namespace
}  // namespace delassus::test
