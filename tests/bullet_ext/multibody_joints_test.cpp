/// Constraints of articulated bodies: motors, limits, couplings.

#include <BulletDynamics/Featherstone/btMultiBodyFixedConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodyGearConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointLimitConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <BulletDynamics/Featherstone/btMultiBodyPoint2Point.h>
#include <BulletDynamics/Featherstone/btMultiBodySliderConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodySphericalJointLimit.h>
#include <BulletDynamics/Featherstone/btMultiBodySphericalJointMotor.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/support/multibody_chain.h"
#include "tests/support/multibody_world.h"

namespace delassus::test {
namespace {

/// Torques of a two-link chain: M a + bias, by Lagrange's equations.
Eigen::Vector2d inverseDynamics(const Eigen::Vector2d& q, const Eigen::Vector2d& v,
                                const Eigen::Vector2d& a) {
  const double m1 = Chain::mass(0), m2 = Chain::mass(1), I = Chain::inertia, c = 0.5;
  const double k = m2 * c * std::cos(q[1]), s = m2 * c * std::sin(q[1]);
  Eigen::Matrix2d M;
  M(0, 0) = 2 * I + m1 * c * c + m2 * (1 + c * c) + 2 * k;
  M(0, 1) = M(1, 0) = I + m2 * c * c + k;
  M(1, 1) = I + m2 * c * c;
  const double second = m2 * g * c * std::cos(q[0] + q[1]);
  return M * a + Eigen::Vector2d(
                     -s * v[1] * (2 * v[0] + v[1]) + (m1 * c + m2) * g * std::cos(q[0]) + second,
                     s * v[0] * v[0] + second);
}

TEST(MultiBodyJoints, MotorsReachTheirVelocityWithTheTorquesOfInverseDynamics) {
  DelassusMultiBodyWorld world;
  const Chain chain(world, 2);
  world.finish(*chain.tree);
  btMultiBodyJointMotor* motors[2];
  for (int i : {0, 1})
    motors[i] =
        &world.addConstraint<btMultiBodyJointMotor>(chain.tree, i, btScalar(0), btScalar(1000));
  for (int step = 0; step < 60; ++step) {
    const Eigen::Vector2d q(chain.tree->getJointPos(0), chain.tree->getJointPos(1));
    const Eigen::Vector2d v(chain.tree->getJointVel(0), chain.tree->getJointVel(1));
    const Eigen::Vector2d wanted(0.02 * step, 0.5 * std::sin(0.1 * step));
    for (int i : {0, 1}) motors[i]->setVelocityTarget(btScalar(wanted[i]));
    world.advance();
    const Eigen::Vector2d reached(chain.tree->getJointVel(0), chain.tree->getJointVel(1));
    EXPECT_LE((reached - wanted).norm(), tolerance(1e-9, 1e-5)) << step;
    const Eigen::Vector2d torque = inverseDynamics(q, v, (reached - v) / h);
    for (int i : {0, 1})
      EXPECT_NEAR(motors[i]->getAppliedImpulse(0) / h, torque[i],
                  torque.norm() * tolerance(1e-6, 1e-3))
          << step;
  }
}

// A ball on a spindle slides in a guide, and stands on the ground with the weight of all of them.
TEST(MultiBodyJoints, SpinningFrictionOfALinkIsFelt) {
  constexpr double kappa = 0.02;
  const double weight = 3 * g;
  const btScalar radius = btScalar(0.2), inertia = btScalar(0.05);
  const btVector3 up(0, 1, 0), none(0, 0, 0), inertias(inertia, inertia, inertia);
  DelassusMultiBodyWorld world;
  world.addGround();
  btMultiBody& tree = world.addTree(2, 1, inertias, true, {0, radius, 0});
  tree.setupPrismatic(0, 1, inertias, -1, btQuaternion::getIdentity(), up, none, none, true);
  tree.setupRevolute(1, 2, inertias, 0, btQuaternion::getIdentity(), up, none, none, true);
  world.addCollider(tree, 1, std::make_unique<btSphereShape>(radius))
      .setSpinningFriction(btScalar(kappa));
  world.finish(tree);
  tree.setJointVel(1, 20);
  for (int step = 1; step <= 10; ++step) {
    world.advance();
    EXPECT_NEAR(tree.getJointVel(1), 20 - step * kappa * weight / inertia * h,
                tolerance(1e-8, 1e-4));
    EXPECT_NEAR(tree.getLink(1).m_appliedConstraintTorque.y(), -kappa * weight,
                tolerance(1e-8, 1e-4));
  }
  EXPECT_EQ(world.report().plan.spinning, 1);
  EXPECT_EQ(world.report().rows, 0);
}

TEST(MultiBodyJoints, MotorAtItsLimitPushesWithAllItHas) {
  DelassusMultiBodyWorld world;
  world->setGravity(btVector3(0, 0, 0));
  const Chain chain(world, 1);
  world.finish(*chain.tree);
  const btScalar most = btScalar(0.05);
  auto& motor = world.addConstraint<btMultiBodyJointMotor>(chain.tree, 0, btScalar(5), most);
  const double inertia = Chain::inertia + Chain::mass(0) * 0.25;
  for (int step = 1; step <= 10; ++step) {
    world.advance();
    EXPECT_NEAR(chain.tree->getJointVel(0), step * most / inertia, tolerance(1e-9, 1e-5));
    EXPECT_NEAR(motor.getAppliedImpulse(0), most, 8 * precision * most);
  }
}

TEST(MultiBodyJoints, AMotorWhoseStrengthIsNoNumberIsLeftOut) {
  DelassusMultiBodyWorld world;
  world->setGravity(btVector3(0, 0, 0));
  const Chain chain(world, 2);
  world.finish(*chain.tree);
  world.addConstraint<btMultiBodyJointMotor>(chain.tree, 1, btScalar(1),
                                             std::numeric_limits<btScalar>::quiet_NaN());
  world.advance();
  EXPECT_EQ(chain.tree->getJointVel(1), 0);
  EXPECT_EQ(world.report().leftOut, 1);
  ASSERT_EQ(world.report().messages.size(), 1u);
  EXPECT_NE(world.report().messages[0].find("a bound is not a number"), std::string::npos)
      << world.report().messages[0];
}

// What it would act on does not show in the row of the next one, whichever Bullet takes that for.
TEST(MultiBodyJoints, WhatMayNotPushOrIsBrokenIsNone) {
  enum class Other { None, Weak, Broken };
  const auto velocities = [](Other other, bool isFirst) {
    DelassusMultiBodyWorld world;
    const Chain chain(world, 2);
    world.finish(*chain.tree);
    const auto addMotor = [&] {
      world.addConstraint<btMultiBodyJointMotor>(chain.tree, 1, btScalar(1), btScalar(100));
    };
    if (!isFirst) addMotor();
    if (other == Other::Weak)
      world
          .addConstraint<btMultiBodyPoint2Point>(chain.tree, 0, nullptr, btVector3(0.5, 0, 0),
                                                 btVector3(1, 0, 0))
          .setMaxAppliedImpulse(0);
    if (other == Other::Broken)
      world.addConstraint<btMultiBodyJointMotor>(chain.tree, 0, btScalar(3),
                                                 std::numeric_limits<btScalar>::quiet_NaN());
    if (isFirst) addMotor();
    world.advance();
    EXPECT_EQ(world.report().rows, 1);
    return std::vector<btScalar>{chain.tree->getJointVel(0), chain.tree->getJointVel(1)};
  };
  const std::vector<btScalar> alone = velocities(Other::None, false);
  for (const Other other : {Other::Weak, Other::Broken})
    for (const bool isFirst : {true, false}) EXPECT_EQ(velocities(other, isFirst), alone);
}

/// The largest number, or one that is large enough, is no bound.
TEST(MultiBodyJoints, AMotorOfUnlimitedStrengthHasNoBound) {
  for (const btScalar most : {btScalar(BT_LARGE_FLOAT), SIMD_INFINITY}) {
    DelassusMultiBodyWorld world;
    const Chain chain(world, 1);
    world.finish(*chain.tree);
    world.addConstraint<btMultiBodyJointMotor>(chain.tree, 0, btScalar(1), most);
    world.advance();
    EXPECT_NEAR(chain.tree->getJointVel(0), 1, tolerance(1e-9, 1e-5));
    EXPECT_EQ(world.report().plan.rows, 1);
    EXPECT_EQ(world.report().plan.boundedRows, 0);
  }
}

TEST(MultiBodyJoints, LimitStopsAFallingLink) {
  DelassusMultiBodyWorld world;
  const Chain chain(world, 1);
  world.finish(*chain.tree);
  auto& limit = world.addConstraint<btMultiBodyJointLimitConstraint>(chain.tree, 0, btScalar(-0.5),
                                                                     btScalar(0.5));
  world.advance(120);
  double impulse = 0;
  for (int step = 0; step < 60; ++step) {
    world.advance();
    impulse += limit.getAppliedImpulse(0);
    EXPECT_NEAR(chain.tree->getJointPos(0), -0.5, 0.01);
  }
  const double torque = Chain::mass(0) * g * 0.5 * std::cos(0.5);
  EXPECT_NEAR(impulse / (60 * h) / torque, 1, 0.05);

  // When the link is lifted off, the limit acts no more and says so.
  chain.tree->setJointPos(0, btScalar(0));
  chain.tree->setJointVel(0, 0);
  world.advance();
  EXPECT_EQ(limit.getAppliedImpulse(0), 0);
}

TEST(MultiBodyJoints, PointToPointClosesALoopWithTheWorld) {
  DelassusMultiBodyWorld world;
  const Chain chain(world, 4);
  world.finish(*chain.tree);
  world.addConstraint<btMultiBodyPoint2Point>(chain.tree, 3, nullptr, btVector3(0.5, 0, 0),
                                              btVector3(4, 0, 0));
  for (int step = 0; step < 120; ++step) {
    world.advance();
    EXPECT_LE((chain.endOf(3) - btVector3(4, 0, 0)).length(), 0.01) << step;
    EXPECT_LE(world.report().residualMax, tolerance(1e-6, 1e-5));
  }
}

/// Partners that do not move, or touch nothing, are not passed to the solver. They hold as a point
/// of the world does.
TEST(MultiBodyJoints, PartnersThatAreNotPassedHold) {
  enum Partner { World, Static, Kinematic };
  const auto motionWith = [](Partner partner) {
    DelassusMultiBodyWorld world;
    const Chain chain(world, 3);
    for (int i : {0, 1, 2}) chain.tree->setJointPos(i, btScalar(i == 0 ? 0.6 : -0.6));
    world.finish(*chain.tree);
    const btVector3 end = chain.endOf(2), centre(4, 3, 0);
    btRigidBody* body = nullptr;
    if (partner != World) {
      body = &world.addBox({btScalar(0.1), btScalar(0.1), btScalar(0.1)}, centre, 0);
      body->setWorldTransform(btTransform(btQuaternion(btVector3(0, 0, 1), btScalar(0.7)), centre));
    }
    if (partner == Kinematic) body->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
    world.addConstraint<btMultiBodyPoint2Point>(
        chain.tree, 2, body, btVector3(0.5, 0, 0),
        body ? body->getWorldTransform().inverse() * end : end);
    std::vector<double> motion;
    for (int step = 0; step < 30; ++step) {
      world.advance();
      for (int i : {0, 1, 2}) motion.push_back(chain.tree->getJointVel(i));
    }
    return motion;
  };
  const std::vector<double> wanted = motionWith(World);
  for (const Partner partner : {Static, Kinematic}) {
    const std::vector<double> motion = motionWith(partner);
    for (std::size_t i = 0; i < wanted.size(); ++i)
      EXPECT_NEAR(motion[i], wanted[i], tolerance(1e-8, 1e-3)) << i;
  }
}

/// For an unsplit group of joints Bullet passes their number as that of the multibody constraints,
/// and passes no such constraint.
TEST(MultiBodyJoints, AnUnsplitGroupOfJointsOnly) {
  DelassusMultiBodyWorld world;
  world->getSimulationIslandManager()->setSplitIslands(false);
  btRigidBody& door = world.addCube({1, 0, 0});
  world.addJoint<btHingeConstraint>(door, btVector3(-1, 0, 0), btVector3(0, 1, 0));
  world.advance(10);
  EXPECT_NEAR(door.getWorldTransform().getOrigin().y(), 0, tolerance(1e-6, 1e-4));
  EXPECT_EQ(world.report().plan.rows, 5);
}

/// Stock's constraints see rigid partners before gravity and let them sag; ours hold them.
TEST(MultiBodyJoints, RigidPartnersAreHeldAgainstGravity) {
  DelassusMultiBodyWorld world;
  const Chain chain(world, 2);
  world.finish(*chain.tree);
  for (int i : {0, 1})
    world.addConstraint<btMultiBodyJointMotor>(chain.tree, i, btScalar(0), btScalar(1000));
  btRigidBody& hanging = world.addBox({btScalar(0.1), btScalar(0.1), btScalar(0.1)}, {2, -1, 0}, 4);
  auto& knot = world.addConstraint<btMultiBodyPoint2Point>(
      chain.tree, 1, &hanging, btVector3(0.5, 0, 0), btVector3(0, 1, 0));
  world.advance(60);
  EXPECT_LE(hanging.getLinearVelocity().length(), tolerance(1e-8, 1e-4));
  EXPECT_NEAR(hanging.getWorldTransform().getOrigin().y(), -1, tolerance(1e-6, 1e-3));
  EXPECT_NEAR(std::abs(knot.getAppliedImpulse(1)) / h, 4 * g, 4 * g * tolerance(1e-6, 1e-3));
  EXPECT_EQ(hanging.getCompanionId(), -1);
  EXPECT_EQ(chain.tree->getCompanionId(), -1);
}

TEST(MultiBodyJoints, FixedConstraintMakesOneBodyOfTwo) {
  DelassusMultiBodyWorld world;
  const btVector3 half(btScalar(0.2), btScalar(0.2), btScalar(0.2));
  btMultiBody& tree = world.addTree(0, 1, btVector3(btScalar(0.03), btScalar(0.03), btScalar(0.03)),
                                    false, btVector3(0, 5, 0));
  world.addCollider(tree, -1, std::make_unique<btBoxShape>(half));
  world.finish(tree);
  btRigidBody& box = world.addBox(half, btVector3(btScalar(0.5), 5, 0), 3);
  const btMatrix3x3 straight = btMatrix3x3::getIdentity();
  world.addConstraint<btMultiBodyFixedConstraint>(&tree, -1, &box, btVector3(btScalar(0.25), 0, 0),
                                                  btVector3(btScalar(-0.25), 0, 0), straight,
                                                  straight);
  tree.setBaseOmega(btVector3(0, 1, 2));
  world.advance(1);
  for (int step = 0; step < 30; ++step) {
    world.advance();
    const btVector3 relative = box.getAngularVelocity() - tree.getBaseOmega();
    EXPECT_LE(relative.length(), 0.02) << step;
  }
  const btVector3 between = box.getWorldTransform().getOrigin() - tree.getBasePos();
  EXPECT_NEAR(between.length(), 0.5, 1e-3);
}

/// A box of 1 kg on a rail along x, which is part of the world or of a floating body of 3 kg: free
/// along the rail, held across.
TEST(MultiBodyJoints, SliderLeavesItsAxisFree) {
  const btVector3 half(btScalar(0.2), btScalar(0.2), btScalar(0.2)), axis(1, 0, 0);
  const btMatrix3x3 straight = btMatrix3x3::getIdentity();
  for (const bool ofWorld : {true, false}) {
    SCOPED_TRACE(ofWorld ? "rail of the world" : "rail of a body");
    DelassusMultiBodyWorld world;
    if (!ofWorld) world->setGravity(btVector3(0, 0, 0));
    const btScalar I = btScalar(0.03);
    btMultiBody& tree = world.addTree(0, 1, btVector3(I, I, I), false, btVector3(0, 5, 0));
    world.addCollider(tree, -1, std::make_unique<btBoxShape>(half));
    world.finish(tree);
    btRigidBody* rail = ofWorld ? nullptr : &world.addBox(half, btVector3(0, 6, 0), 3);
    world.addConstraint<btMultiBodySliderConstraint>(
        &tree, -1, rail, btVector3(0, 0, 0), ofWorld ? btVector3(0, 5, 0) : btVector3(0, -1, 0),
        straight, straight, axis);
    const double along = 1, across = 0.5;
    tree.setBaseVel(btVector3(along, across, 0));
    // Across, both go on with the momentum of the box; along, the box goes on alone.
    const double together = ofWorld ? 0 : across / 4;
    for (int step = 0; step < 60; ++step) {
      world.advance();
      EXPECT_NEAR(tree.getBaseVel().x(), along, tolerance(1e-9, 1e-4)) << step;
      EXPECT_NEAR(tree.getBaseVel().y(), together, tolerance(1e-9, 1e-4)) << step;
      EXPECT_LE(tree.getBaseOmega().length(), tolerance(1e-9, 1e-4)) << step;
      if (rail) {
        EXPECT_NEAR(rail->getLinearVelocity().x(), 0, tolerance(1e-9, 1e-4)) << step;
        EXPECT_NEAR(rail->getLinearVelocity().y(), together, tolerance(1e-9, 1e-4)) << step;
      }
    }
  }
}

/// A box that turns on its rail turns the body of the rail with it.
TEST(MultiBodyJoints, SliderHoldsAgainstTurning) {
  const btVector3 half(btScalar(0.2), btScalar(0.2), btScalar(0.2));
  const btMatrix3x3 straight = btMatrix3x3::getIdentity();
  DelassusMultiBodyWorld world;
  world->setGravity(btVector3(0, 0, 0));
  const btScalar I = btScalar(0.03);
  btMultiBody& tree = world.addTree(0, 1, btVector3(I, I, I), false, btVector3(0, 5, 0));
  world.addCollider(tree, -1, std::make_unique<btBoxShape>(half));
  world.finish(tree);
  btRigidBody& rail = world.addBox(half, btVector3(0, 6, 0), 3);
  world.addConstraint<btMultiBodySliderConstraint>(&tree, -1, &rail, btVector3(0, 0, 0),
                                                   btVector3(0, -1, 0), straight, straight,
                                                   btVector3(1, 0, 0));
  tree.setBaseOmega(btVector3(0, btScalar(0.5), 0));
  const double turning = 0.5 * I / (I + 1 / double(rail.getInvInertiaDiagLocal().y()));
  for (int step = 0; step < 10; ++step) {
    world.advance();
    EXPECT_NEAR(tree.getBaseOmega().y(), turning, 0.01 * turning) << step;
    EXPECT_NEAR(rail.getAngularVelocity().y(), turning, 0.01 * turning) << step;
  }
}

TEST(MultiBodyJoints, GearKeepsItsRatio) {
  DelassusMultiBodyWorld world;
  const btVector3 zero(0, 0, 0), inertia(1, 1, 1);
  btMultiBody& tree = world.addTree(2, 0, zero, true);
  for (int i : {0, 1})
    tree.setupRevolute(i, 1, inertia, -1, btQuaternion::getIdentity(), btVector3(0, 0, 1), zero,
                       zero, true);
  world.finish(tree);
  const btMatrix3x3 straight = btMatrix3x3::getIdentity();
  auto& gear = world.addConstraint<btMultiBodyGearConstraint>(&tree, 0, &tree, 1, zero, zero,
                                                              straight, straight);
  const double ratio = 3;
  gear.setGearRatio(btScalar(ratio));
  gear.setMaxAppliedImpulse(1000);
  for (int step = 0; step < 20; ++step) {
    tree.addJointTorque(0, 10);
    world.advance();
    // v_0 + 3 v_1 = 0: the torque turns an inertia of 1 + 1/9.
    EXPECT_NEAR(tree.getJointVel(0) + ratio * tree.getJointVel(1), 0, tolerance(1e-9, 1e-5));
  }
  EXPECT_NEAR(tree.getJointVel(0), 20 * 10 * h / (1 + 1 / (ratio * ratio)), tolerance(1e-8, 1e-4));
}

/// A ball joint at the origin whose link hangs to the side, along x.
btMultiBody& addBallJoint(MultiBodyWorld& world) {
  const btScalar I = btScalar(0.1);
  btMultiBody& tree = world.addTree(1, 0, btVector3(0, 0, 0), true);
  tree.setupSpherical(0, 2, btVector3(I, I, I), -1, btQuaternion::getIdentity(), btVector3(0, 0, 0),
                      btVector3(btScalar(0.5), 0, 0), true);
  world.finish(tree);
  return tree;
}

TEST(MultiBodyJoints, SphericalMotorHoldsItsLink) {
  DelassusMultiBodyWorld world;
  btMultiBody& tree = addBallJoint(world);
  auto& motor = world.addConstraint<btMultiBodySphericalJointMotor>(&tree, 0, btScalar(1000));
  motor.setPositionTarget(btQuaternion::getIdentity(), btScalar(0.2));
  motor.setVelocityTarget(btVector3(0, 0, 0), 1);
  world.advance(60);
  const btVector3 end = tree.localPosToWorld(0, btVector3(btScalar(0.5), 0, 0));
  EXPECT_LE((end - btVector3(1, 0, 0)).length(), 1e-3);
}

TEST(MultiBodyJoints, SphericalLimitStopsItsLink) {
  DelassusMultiBodyWorld world;
  btMultiBody& tree = addBallJoint(world);
  const btScalar range = btScalar(0.4);
  world.addConstraint<btMultiBodySphericalJointLimit>(&tree, 0, range, range, range,
                                                      btScalar(1000));
  for (int step = 0; step < 180; ++step) {
    world.advance();
    const btVector3 end = tree.localPosToWorld(0, btVector3(btScalar(0.5), 0, 0));
    EXPECT_LE(std::acos(std::min<double>(end.x() / end.length(), 1)), range + 0.1) << step;
  }
}

}  // namespace
}  // namespace delassus::test
