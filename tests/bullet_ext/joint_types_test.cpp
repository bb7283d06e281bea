/// Joints of every Bullet type, in all their settings, against stock run to convergence.

#include <gtest/gtest.h>

#include <BulletDynamics/ConstraintSolver/btFixedConstraint.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

#include "bullet_ext/softness.h"
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

/// Motors, servos, springs, and joints with softness and damping of their own.
std::vector<JointCase> drivenCases() {
  const btTransform frameA = frameAt(inA), frameB = frameAt(inB);
  const auto slider = [=](BulletWorld& w, btRigidBody& a, btRigidBody& b) -> btSliderConstraint& {
    auto& joint = w.addJoint<btSliderConstraint>(a, b, frameA, frameB, true);
    joint.setLowerLinLimit(-1);
    joint.setUpperLinLimit(1);
    joint.setLowerAngLimit(-1);
    joint.setUpperAngLimit(1);
    return joint;
  };
  using SixDof2 = btGeneric6DofSpring2Constraint;
  const auto sixDof2 = [=](BulletWorld& w, btRigidBody& a, btRigidBody& b) -> SixDof2& {
    auto& joint = w.addJoint<SixDof2>(a, b, frameA, frameB);
    joint.setAngularLowerLimit({0, 0, 0});
    joint.setAngularUpperLimit({0, 0, 0});
    return joint;
  };
  return {
      {"slider_motor_along",
       [=](BulletWorld& w, btRigidBody& a, btRigidBody& b) {
         auto& joint = slider(w, a, b);
         joint.setPoweredLinMotor(true);
         joint.setTargetLinMotorVelocity(btScalar(0.5));
         joint.setMaxLinMotorForce(30);
       }},
      {"slider_motor_about",
       [=](BulletWorld& w, btRigidBody& a, btRigidBody& b) {
         auto& joint = slider(w, a, b);
         joint.setPoweredAngMotor(true);
         joint.setTargetAngMotorVelocity(1);
         joint.setMaxAngMotorForce(3);
       }},
      {"slider_damped",
       [=](BulletWorld& w, btRigidBody& a, btRigidBody& b) {
         auto& joint = slider(w, a, b);
         joint.setDampingDirLin(btScalar(0.5));
         joint.setDampingDirAng(btScalar(0.3));
         joint.setDampingOrthoLin(btScalar(0.8));
       }},
      {"six_dof_motor_along",
       [=](BulletWorld& w, btRigidBody& a, btRigidBody& b) {
         auto& joint = w.addJoint<btGeneric6DofConstraint>(a, b, frameA, frameB, true);
         joint.setLinearLowerLimit({1, 0, 0});  // above the upper one: free
         joint.setLinearUpperLimit({-1, 0, 0});
         btTranslationalLimitMotor& motor = *joint.getTranslationalLimitMotor();
         motor.m_enableMotor[0] = true;
         motor.m_targetVelocity[0] = btScalar(0.4);
         motor.m_maxMotorForce[0] = 20;
       }},
      {"six_dof_motor_about",
       [=](BulletWorld& w, btRigidBody& a, btRigidBody& b) {
         auto& joint = w.addJoint<btGeneric6DofConstraint>(a, b, frameA, frameB, true);
         joint.setAngularLowerLimit({1, 0, 0});
         joint.setAngularUpperLimit({-1, 0, 0});
         btRotationalLimitMotor& motor = *joint.getRotationalLimitMotor(0);
         motor.m_enableMotor = true;
         motor.m_targetVelocity = 1;
         motor.m_maxMotorForce = 5;
       }},
      {"six_dof_spring_about",
       [=](BulletWorld& w, btRigidBody& a, btRigidBody& b) {
         auto& joint = w.addJoint<btGeneric6DofSpringConstraint>(a, b, frameA, frameB, true);
         joint.setAngularLowerLimit({-1, 0, 0});
         joint.setAngularUpperLimit({1, 0, 0});
         joint.enableSpring(3, true);
         joint.setStiffness(3, 5);
         joint.setDamping(3, btScalar(0.5));
         joint.setEquilibriumPoint(3, btScalar(0.2));
       }},
      {"six_dof_spring_2_servo",
       [=](BulletWorld& w, btRigidBody& a, btRigidBody& b) {
         auto& joint = sixDof2(w, a, b);
         joint.setLinearLowerLimit({1, 0, 0});
         joint.setLinearUpperLimit({-1, 0, 0});
         joint.enableMotor(0, true);
         joint.setServo(0, true);
         joint.setServoTarget(0, btScalar(0.3));
         joint.setTargetVelocity(0, 1);
         joint.setMaxMotorForce(0, 40);
       }},
      {"six_dof_spring_2_motor",
       [=](BulletWorld& w, btRigidBody& a, btRigidBody& b) {
         auto& joint = sixDof2(w, a, b);
         joint.setAngularLowerLimit({0, 0, 1});
         joint.setAngularUpperLimit({0, 0, -1});
         joint.enableMotor(5, true);
         joint.setTargetVelocity(5, btScalar(-0.7));
         joint.setMaxMotorForce(5, 2);
       }},
      {"six_dof_spring_2_spring_about",
       [=](BulletWorld& w, btRigidBody& a, btRigidBody& b) {
         auto& joint = sixDof2(w, a, b);
         joint.setAngularLowerLimit({1, 0, 0});
         joint.setAngularUpperLimit({-1, 0, 0});
         joint.enableSpring(3, true);
         joint.setStiffness(3, 5);
         joint.setDamping(3, btScalar(0.1));
         joint.setEquilibriumPoint(3, btScalar(0.5));
       }},
      {"hinge_motor_soft",
       [=](BulletWorld& w, btRigidBody& a, btRigidBody& b) {
         auto& joint = w.addJoint<btHingeConstraint>(a, b, frameA, frameB, true);
         joint.setParam(BT_CONSTRAINT_CFM, btScalar(0.1));
         joint.setParam(BT_CONSTRAINT_ERP, btScalar(0.4));
         joint.setLimit(btScalar(-0.02), btScalar(0.02), btScalar(0.9), btScalar(0.3),
                        btScalar(0.8));
         joint.enableAngularMotor(true, 2, btScalar(0.05));
       }},
      {"hinge_that_counts_turns",
       [=](BulletWorld& w, btRigidBody& a, btRigidBody& b) {
         w.addJoint<btHingeAccumulatedAngleConstraint>(a, b, frameA, frameB, true)
             .setLimit(btScalar(-0.05), btScalar(0.05));
       }},
      {"hinge_that_breaks_at_its_limit",
       [=](BulletWorld& w, btRigidBody& a, btRigidBody& b) {
         auto& joint = w.addJoint<btHingeConstraint>(a, b, frameA, frameB, true);
         joint.setLimit(btScalar(-0.02), btScalar(0.02));
         joint.setBreakingImpulseThreshold(btScalar(0.1));
       }},
      {"point2point_damped_and_clamped",
       [](BulletWorld& w, btRigidBody& a, btRigidBody& b) {
         auto& joint =
             w.addJoint<btPoint2PointConstraint>(a, b, inA + btVector3(0, btScalar(0.01), 0), inB);
         joint.m_setting.m_damping = btScalar(0.5);
         joint.m_setting.m_tau = btScalar(0.3);
         joint.m_setting.m_impulseClamp = btScalar(0.02);
       }},
      {"cone_twist_soft",
       [=](BulletWorld& w, btRigidBody& a, btRigidBody& b) {
         auto& joint = w.addJoint<btConeTwistConstraint>(a, b, frameA, frameB);
         joint.setLimit(btScalar(0.02), btScalar(0.03), btScalar(0.01), btScalar(0.8),
                        btScalar(0.4), btScalar(0.9));
         joint.setDamping(btScalar(0.02));
         joint.setParam(BT_CONSTRAINT_STOP_CFM, btScalar(0.1));
         joint.setParam(BT_CONSTRAINT_CFM, btScalar(0.05));
       }},
  };
}

/// Two boxes: a hangs on the world by a corner, b hangs on a by the joint; both turn.
struct Pendulum {
  btRigidBody& a;
  btRigidBody& b;
  bool closesLoop;  ///< the joint brings further joints, so that some motions are held twice

  /// How near two solvers must be in double precision, if joints that close no loop must be as near
  /// as `ofOthers`. Joints that close one give by loopSoftness of what they carry, some `unit`.
  double accuracy(double ofOthers, double unit = 1) const {
    return closesLoop ? std::max(ofOthers, bullet::loopSoftness * unit) : ofOthers;
  }
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
  return {a, b, world->getNumConstraints() > 2};
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
      EXPECT_NEAR(p.b.getLinearVelocity()[k], s.b.getLinearVelocity()[k],
                  tolerance(p.accuracy(1e-6), 2e-2));
      for (auto [body, stockBody] : {std::pair(&p.a, &s.a), std::pair(&p.b, &s.b)})
        EXPECT_NEAR(body->getAngularVelocity()[k], stockBody->getAngularVelocity()[k],
                    tolerance(p.accuracy(1e-6), 4e-2));
    }
  }
}

/// What the joint under test did to its bodies in one step: velocities, and the forces users read.
struct Deed {
  Deed(const Pendulum& pendulum, const btTypedConstraint& joint)
      : velocities{pendulum.a.getLinearVelocity(), pendulum.a.getAngularVelocity(),
                   pendulum.b.getLinearVelocity(), pendulum.b.getAngularVelocity()} {
    const btJointFeedback& feedback = *joint.getJointFeedback();
    forces = {feedback.m_appliedForceBodyA, feedback.m_appliedTorqueBodyA,
              feedback.m_appliedForceBodyB, feedback.m_appliedTorqueBodyB,
              btVector3(joint.getAppliedImpulse() / h, 0, 0)};
  }
  std::vector<btVector3> velocities, forces;
};

double largestDifference(const std::vector<btVector3>& a, const std::vector<btVector3>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max<double>(largest, (a[i] - b[i]).length());
  return largest;
}

/// Both worlds begin every step in the same state, so that nothing but the step can differ.
void expectSameDeeds(const JointCase& joint, double damping, double softness) {
  DelassusWorld ours;
  StockWorld stock(5000);
  for (BulletWorld* world : {static_cast<BulletWorld*>(&ours), static_cast<BulletWorld*>(&stock)}) {
    world->info().m_numIterations = stock.info().m_numIterations;
    world->info().m_damping = btScalar(damping);
    world->info().m_globalCfm = btScalar(softness);
  }
  const Pendulum p = addPendulum(ours, joint.add), s = addPendulum(stock, joint.add);
  const auto last = [](BulletWorld& world) {
    return world->getConstraint(world->getNumConstraints() - 1);
  };
  btTypedConstraint &ourJoint = *last(ours), &stockJoint = *last(stock);
  btJointFeedback ourFeedback, stockFeedback;
  ourJoint.setJointFeedback(&ourFeedback);
  stockJoint.setJointFeedback(&stockFeedback);
  for (int step = 0; step < 12; ++step) {
    ours.advance();
    stock.advance();
    const Deed a(p, ourJoint), b(s, stockJoint);
    ASSERT_LE(largestDifference(a.velocities, b.velocities), tolerance(p.accuracy(1e-8), 2e-5))
        << step;
    ASSERT_LE(largestDifference(a.forces, b.forces), tolerance(p.accuracy(1e-7, 1 / h), 5e-3))
        << step;
    ASSERT_EQ(ourJoint.isEnabled(), stockJoint.isEnabled()) << step;
    ASSERT_EQ(ours.report().solved, ours.report().islands) << step;
    for (auto [from, to] : {std::pair(&p.a, &s.a), std::pair(&p.b, &s.b)}) {
      to->setCenterOfMassTransform(from->getCenterOfMassTransform());
      to->setLinearVelocity(from->getLinearVelocity());
      to->setAngularVelocity(from->getAngularVelocity());
    }
  }
}

TEST(Parity, Row28EveryJointTypeUnderDampingAndSoftnessOfTheWorld) {
  for (const auto& cases : {jointCases(), drivenCases()})
    for (const JointCase& joint : cases)
      for (const double damping : {1.0, 0.7})
        for (const double softness : {0.0, 0.05}) {
          SCOPED_TRACE(joint.name + ", damping " + std::to_string(damping) + ", softness " +
                       std::to_string(softness));
          expectSameDeeds(joint, damping, softness);
        }
}

/// Pushes a body along x with all that its bounds allow, in one direction or the other.
class Ram : public btTypedConstraint {
 public:
  Ram(btRigidBody& body, btScalar error)
      : btTypedConstraint(MAX_CONSTRAINT_TYPE, body), error_(error) {}
  void getInfo1(btConstraintInfo1* info) override { info->m_numConstraintRows = info->nub = 1; }
  void getInfo2(btConstraintInfo2* info) override {
    info->m_J1linearAxis[0] = 1;
    info->m_constraintError[0] = error_;
    info->m_lowerLimit[0] = -2;
    info->m_upperLimit[0] = 3;
  }
  void setParam(int, btScalar, int) override {}
  btScalar getParam(int, int) const override { return 0; }

 private:
  btScalar error_;
};

// An infinite error asks for the largest push in its direction.
TEST(Joints, ARowMayPushAsHardAsItMayEitherWay) {
  for (const btScalar error : {SIMD_INFINITY, -SIMD_INFINITY}) {
    DelassusWorld world;
    btRigidBody& body = world.addCube({0, 0, 0}, 4);
    world.addJoint<Ram>(body, error);
    world.advance();
    EXPECT_NEAR(body.getLinearVelocity().x(), (error > 0 ? 3 : -2) / 4.0, 10 * precision);
    EXPECT_TRUE(world.report().messages.empty());
  }
}

}  // namespace
}  // namespace delassus::test
