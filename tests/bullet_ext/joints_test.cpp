/// Joints of every Bullet type against stock run to convergence; motors, springs, feedback,
/// breaking, user constraints.

#include <gtest/gtest.h>

#include <BulletDynamics/ConstraintSolver/btFixedConstraint.h>

#include <cmath>
#include <functional>
#include <string>

#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

using AddJoint = std::function<void(BulletWorld&, btRigidBody&, btRigidBody&)>;

struct JointCase {
  std::string name;
  AddJoint add;
};

btTransform frameAt(const btVector3& position) {
  // Turned, so that no axis of the joint is one of the world.
  return btTransform(btQuaternion(btVector3(1, 2, 1).normalized(), btScalar(0.4)), position);
}
const btVector3 inA(btScalar(0.6), 0, 0), inB(btScalar(-0.6), 0, 0);

std::vector<JointCase> jointCases() {
  const btTransform frameA = frameAt(inA), frameB = frameAt(inB);
  return {
      {"point2point", [](BulletWorld& w, btRigidBody& a,
                         btRigidBody& b) { w.addJoint<btPoint2PointConstraint>(a, b, inA, inB); }},
      {"hinge",
       [=](BulletWorld& w, btRigidBody& a, btRigidBody& b) {
         w.addJoint<btHingeConstraint>(a, b, frameA, frameB)
             .setLimit(btScalar(-0.05), btScalar(0.05));
       }},
      {"slider",
       [=](BulletWorld& w, btRigidBody& a, btRigidBody& b) {
         auto& slider = w.addJoint<btSliderConstraint>(a, b, frameA, frameB, true);
         slider.setLowerLinLimit(btScalar(-0.02));
         slider.setUpperLinLimit(btScalar(0.02));
         // Bullet drops a locked angle's row in steps where the angle is zero to the last bit.
         slider.setLowerAngLimit(btScalar(-0.1));
         slider.setUpperAngLimit(btScalar(0.1));
       }},
      {"six_dof",
       [=](BulletWorld& w, btRigidBody& a, btRigidBody& b) {
         auto& joint = w.addJoint<btGeneric6DofConstraint>(a, b, frameA, frameB, true);
         joint.setAngularLowerLimit({btScalar(-0.1), 0, 0});
         joint.setAngularUpperLimit({btScalar(0.1), 0, 0});
       }},
      {"six_dof_spring",
       [=](BulletWorld& w, btRigidBody& a, btRigidBody& b) {
         auto& joint = w.addJoint<btGeneric6DofSpringConstraint>(a, b, frameA, frameB, true);
         joint.setLinearLowerLimit({-1, 0, 0});
         joint.setLinearUpperLimit({1, 0, 0});
         joint.enableSpring(0, true);
         joint.setStiffness(0, 50);
         joint.setEquilibriumPoint();
       }},
      {"six_dof_spring_2",
       [=](BulletWorld& w, btRigidBody& a, btRigidBody& b) {
         auto& joint = w.addJoint<btGeneric6DofSpring2Constraint>(a, b, frameA, frameB);
         joint.setLinearLowerLimit({-1, 0, 0});
         joint.setLinearUpperLimit({1, 0, 0});
         joint.enableSpring(0, true);
         joint.setStiffness(0, 50);
         joint.setDamping(0, 1);
         joint.setEquilibriumPoint();
       }},
      {"cone_twist",
       [=](BulletWorld& w, btRigidBody& a, btRigidBody& b) {
         w.addJoint<btConeTwistConstraint>(a, b, frameA, frameB)
             .setLimit(btScalar(0.1), btScalar(0.1), btScalar(0.05));
       }},
      {"fixed", [=](BulletWorld& w, btRigidBody& a,
                    btRigidBody& b) { w.addJoint<btFixedConstraint>(a, b, frameA, frameB); }},
      {"gear",
       [](BulletWorld& w, btRigidBody& a, btRigidBody& b) {
         w.addJoint<btPoint2PointConstraint>(b, b.getWorldTransform().getOrigin() * 0);
         w.addJoint<btGearConstraint>(a, b, btVector3(0, 0, 1), btVector3(0, 0, 1), btScalar(2));
       }},
      {"universal",
       [](BulletWorld& w, btRigidBody& a, btRigidBody& b) {
         btVector3 anchor(btScalar(0.6), 0, 0), axis1(0, 1, 0), axis2(0, 0, 1);
         w.addJoint<btUniversalConstraint>(a, b, anchor, axis1, axis2);
       }},
      {"hinge_2",
       [](BulletWorld& w, btRigidBody& a, btRigidBody& b) {
         btVector3 anchor(btScalar(0.6), 0, 0), axis1(0, 1, 0), axis2(0, 0, 1);
         w.addJoint<btHinge2Constraint>(a, b, anchor, axis1, axis2);
       }},
  };
}

/// Two boxes: a hangs on the world by a corner, b on a by the joint; both turning.
struct Pendulum {
  btRigidBody& a;
  btRigidBody& b;
};

Pendulum addPendulum(BulletWorld& world, const AddJoint& add) {
  btRigidBody& a = world.addBox({0.5, 0.2, 0.2}, {0, 0, 0}, 2);
  btRigidBody& b = world.addBox({0.5, 0.2, 0.3}, {btScalar(1.2), 0, 0}, 1);
  a.setIgnoreCollisionCheck(&b, true);
  b.setIgnoreCollisionCheck(&a, true);
  world.addJoint<btPoint2PointConstraint>(a, btVector3(btScalar(-0.5), 0, 0));
  add(world, a, b);
  a.setAngularVelocity({btScalar(0.2), btScalar(-0.1), btScalar(0.3)});
  b.setAngularVelocity({btScalar(0.5), btScalar(0.4), btScalar(-0.6)});
  return {a, b};
}

TEST(Parity, Row28EveryJointType) {
  for (const JointCase& joint : jointCases()) {
    SCOPED_TRACE(joint.name);
    DelassusWorld ours;
    StockWorld stock(5000);
    ours.info().m_numIterations = stock.info().m_numIterations;  // spring joints read it
    const Pendulum p = addPendulum(ours, joint.add), s = addPendulum(stock, joint.add);
    for (int i = 0; i < 40; ++i) {
      ours.advance();
      stock.advance();
      ASSERT_EQ(ours.report().solved, ours.report().islands) << i;
    }
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(p.b.getLinearVelocity()[k], s.b.getLinearVelocity()[k], tolerance(1e-6, 2e-2));
      EXPECT_NEAR(p.b.getAngularVelocity()[k], s.b.getAngularVelocity()[k], tolerance(1e-6, 4e-2));
      EXPECT_NEAR(p.a.getAngularVelocity()[k], s.a.getAngularVelocity()[k], tolerance(1e-6, 4e-2));
    }
  }
}

TEST(Parity, Row28JointSoftnessIsRelative) {
  // The sag of a loaded point joint: ERP closes what softness gives way, χ W m g h = erp d/h with W
  // = 1/m.
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
  EXPECT_NEAR(feedback.m_appliedForceBodyA.y(), 3 * g, tolerance(1e-9, 1e-3));
  EXPECT_NEAR(feedback.m_appliedForceBodyB.y(), -3 * g, tolerance(1e-9, 1e-3));
  hanging.joint.setEnabled(false);
  hanging.world.advance();
  EXPECT_EQ(feedback.m_appliedForceBodyA.y(), 0) << "cleared when the joint is disabled";
}

TEST(Parity, Row30BreaksAboveItsThreshold) {
  for (double factor : {0.99, 1.01}) {
    Hanging hanging;
    hanging.joint.setBreakingImpulseThreshold(btScalar(factor * 3 * g * h));
    hanging.world.advance(60);
    EXPECT_EQ(hanging.joint.isEnabled(), factor > 1);
  }
}

/// Stock's 0 ≥ 0.
TEST(Parity, Row30JointThatBearsNothingBreaksAtOnce) {
  Hanging hanging;
  hanging.joint.setBreakingImpulseThreshold(0);
  hanging.world.advance();
  EXPECT_FALSE(hanging.joint.isEnabled());
  EXPECT_NEAR(hanging.ball.getLinearVelocity().y(), -g * h, 100 * precision);
}

TEST(Parity, Row31DisabledJointIsSkipped) {
  DelassusWorld world;
  btRigidBody& near = world.addCube({0, 5, 0});
  btRigidBody& far = world.addCube({50, 5, 0});
  auto& disabled =
      world.addJoint<btPoint2PointConstraint>(near, far, btVector3(25, 0, 0), btVector3(-25, 0, 0));
  disabled.setEnabled(false);
  world.addJoint<btPoint2PointConstraint>(near, btVector3(0, 0, 0));
  world.advance(30);
  EXPECT_NEAR(near.getWorldTransform().getOrigin().y(), 5, tolerance(1e-9, 1e-4));
  EXPECT_NEAR(far.getLinearVelocity().y(), -g * 30 * h, 1e3 * precision) << "falls";
  EXPECT_EQ(disabled.getAppliedImpulse(), 0);
}

/// Keeps a body from falling faster than a speed, in solveConstraintObsolete alone.
class FallBrake : public btTypedConstraint {
 public:
  FallBrake(btRigidBody& body, btScalar speed)
      : btTypedConstraint(MAX_CONSTRAINT_TYPE, body), speed_(speed) {}
  void getInfo1(btConstraintInfo1* info) override { info->m_numConstraintRows = info->nub = 0; }
  void getInfo2(btConstraintInfo2*) override {
    FAIL() << "a constraint without rows is not asked for them";
  }
  void setParam(int, btScalar, int) override {}
  btScalar getParam(int, int) const override { return 0; }
  void solveConstraintObsolete(btSolverBody& body, btSolverBody&, btScalar) override {
    ++calls;
    const btVector3 velocity =
        body.m_linearVelocity + body.m_externalForceImpulse + body.getDeltaLinearVelocity();
    const btScalar missing = -speed_ - velocity.y();
    if (missing > 0)
      body.internalApplyImpulse(btVector3(0, 1, 0) * body.internalGetInvMass(), {0, 0, 0},
                                missing / body.internalGetInvMass().y());
  }
  int calls = 0;

 private:
  btScalar speed_;
};

TEST(Parity, Row32ConstraintsWithoutRowsSolveThemselves) {
  DelassusWorld ours;
  StockWorld stock;
  ours.info().m_numIterations = stock.info().m_numIterations;  // sweeps of the user's own method
  const auto run = [](BulletWorld& world) -> btRigidBody& {
    btRigidBody& lower = world.addCube({0, 10, 0});
    btRigidBody& upper = world.addCube({0, btScalar(11), 0});
    world.addJoint<FallBrake>(lower, btScalar(1));
    world.advance(60);
    EXPECT_NEAR(lower.getLinearVelocity().y(), -1, tolerance(1e-6, 1e-3))
        << "with another body on top";
    return upper;
  };
  const btRigidBody &a = run(ours), &b = run(stock);
  EXPECT_NEAR(a.getLinearVelocity().y(), b.getLinearVelocity().y(), tolerance(1e-6, 1e-3));
  EXPECT_EQ(ours.report().obsoleteConstraints, 1);
}

// The rest of the group keeps its bits, whoever else is in it.
TEST(Joints, AConstraintWithoutRowsLeavesOtherIslandsAlone) {
  const auto run = [](bool brakes) {
    DelassusWorld world;
    world.addGround();
    std::vector<const btRigidBody*> tower;
    for (int i = 0; i < 4; ++i)
      tower.push_back(&world.addCube({btScalar(0.1) * i, btScalar(0.52) + i, 0}));
    btRigidBody& falling = world.addCube({20, 50, 0});
    if (brakes) world.addJoint<FallBrake>(falling, btScalar(1));
    std::vector<btVector3> motion;
    for (int step = 0; step < 60; ++step) {
      world.advance();
      for (const btRigidBody* body : tower) {
        motion.push_back(body->getLinearVelocity());
        motion.push_back(body->getAngularVelocity());
      }
    }
    EXPECT_EQ(falling.getLinearVelocity().y() > -2, brakes);
    return motion;
  };
  EXPECT_EQ(run(true), run(false));
}

/// Looks at its second body, in solveConstraintObsolete.
class Watcher : public btTypedConstraint {
 public:
  Watcher(btRigidBody& a, btRigidBody& b) : btTypedConstraint(MAX_CONSTRAINT_TYPE, a, b) {}
  void getInfo1(btConstraintInfo1* info) override { info->m_numConstraintRows = info->nub = 0; }
  void getInfo2(btConstraintInfo2*) override {}
  void setParam(int, btScalar, int) override {}
  btScalar getParam(int, int) const override { return 0; }
  void solveConstraintObsolete(btSolverBody&, btSolverBody& body, btScalar) override {
    seen = body.m_originalBody;
    speed = body.m_linearVelocity.x();
  }
  const btRigidBody* seen = nullptr;
  btScalar speed = 0;
};

TEST(Joints, AConstraintWithoutRowsSeesAKinematicPartnerThatNothingTouches) {
  const auto run = [](BulletWorld& world) {
    btRigidBody& falling = world.addCube({0, 10, 0});
    btRigidBody& platform = world.addCube({0, 0, 0}, 0);
    platform.setCollisionFlags(platform.getCollisionFlags() |
                               btCollisionObject::CF_KINEMATIC_OBJECT);
    Watcher& watcher = world.addJoint<Watcher>(falling, platform);
    platform.setWorldTransform(BulletWorld::at({btScalar(h), 0, 0}));
    world.advance();
    EXPECT_EQ(watcher.seen, &platform);
    return watcher.speed;
  };
  DelassusWorld ours;
  StockWorld stock;
  const btScalar speed = run(ours);
  EXPECT_NEAR(speed, 1, 100 * precision);
  EXPECT_EQ(speed, run(stock));
}

TEST(Joints, ARowThatMakesNoSenseIsLeftOut) {
  Hanging hanging;
  hanging.joint.setBreakingImpulseThreshold(-1);  // bounds cross
  hanging.world.advance();
  EXPECT_NEAR(hanging.ball.getLinearVelocity().y(), -g * h, 100 * precision);
  ASSERT_EQ(hanging.world.report().messages.size(), 3u);
  EXPECT_NE(hanging.world.report().messages[0].find("lower bound is above"), std::string::npos);
}

}  // namespace
}  // namespace delassus::test
