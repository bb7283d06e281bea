/// Robots of rigid bodies: links that overlap, motors that hold them.

#include <BulletDynamics/ConstraintSolver/btFixedConstraint.h>
#include <BulletDynamics/ConstraintSolver/btGeneric6DofSpring2Constraint.h>
#include <BulletDynamics/ConstraintSolver/btHingeConstraint.h>
#include <BulletDynamics/ConstraintSolver/btSliderConstraint.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

/// The most kinetic energy, J, of links that only their contacts could move.
double mostEnergyOf(DelassusWorld& world, int steps) {
  double most = 0;
  for (int step = 0; step < steps; ++step) {
    world.advance();
    double sum = 0;
    for (int i = 0; i < world->getNumCollisionObjects(); ++i) {
      const btRigidBody& body = *btRigidBody::upcast(world->getCollisionObjectArray()[i]);
      const btVector3 turn = body.getAngularVelocity();
      sum += 0.5 * body.getLinearVelocity().length2() / body.getInvMass() +
             0.5 * turn.dot(body.getInvInertiaTensorWorld().inverse() * turn);
    }
    most = std::max(most, sum);
  }
  return most;
}

// Each link of a robot is welded to the next one, and overlaps the one after that. The longer one
// has more rows than those that are taken together.
TEST(Robots, WeldedLinksOfALongChainRest) {
  for (const int links : {30, 60}) {
    SCOPED_TRACE(testing::Message() << links << " links");
    DelassusWorld world;
    world->setGravity({0, 0, 0});
    btRigidBody* last = nullptr;
    for (int i = 0; i < links; ++i) {
      btRigidBody& link =
          world.addBox({btScalar(0.11), btScalar(0.05), btScalar(0.05)}, {btScalar(0.1 * i), 0, 0});
      if (last) {
        world.addJoint<btFixedConstraint>(*last, link, DelassusWorld::at({btScalar(0.1), 0, 0}),
                                          btTransform::getIdentity());
        link.setIgnoreCollisionCheck(last, true);
      }
      last = &link;
    }
    EXPECT_LT(mostEnergyOf(world, 60), tolerance(1e-12, 1e-8));
    EXPECT_EQ(world.report().incompatible + world.report().outOfBudget, 0);
    EXPECT_GT(world.report().held, 0);
  }
}

// A motor that may push with 10 kN m holds its link as a weld does.
TEST(Robots, AStrongMotorIsNoDrive) {
  DelassusWorld world;
  world->setGravity({0, 0, 0});
  btRigidBody& base = world.addBox({0.5, btScalar(0.1), 0.5}, {0, 0, 0}, 5);
  btRigidBody& post = world.addBox({btScalar(0.1), 0.5, btScalar(0.1)}, {btScalar(-0.4), 0.6, 0});
  btRigidBody& flap = world.addBox({btScalar(0.21), btScalar(0.05), btScalar(0.1)},
                                   {btScalar(-0.1), btScalar(0.9), 0});
  world.addJoint<btFixedConstraint>(base, post, DelassusWorld::at({btScalar(-0.4), 0.6, 0}),
                                    btTransform::getIdentity());
  auto& hinge = world.addJoint<btHingeConstraint>(
      base, flap, btVector3(btScalar(0.1), btScalar(0.9), 0), btVector3(btScalar(0.2), 0, 0),
      btVector3(0, 0, 1), btVector3(0, 0, 1));
  hinge.enableAngularMotor(true, 0, btScalar(1e4 * h));
  EXPECT_LT(mostEnergyOf(world, 60), tolerance(1e-12, 1e-6));
  EXPECT_EQ(world.report().incompatible + world.report().outOfBudget, 0);
  EXPECT_GT(world.report().held, 0);
}

// The motor of an axis could move its light carriage far in a step, but not bear what it carries:
// the floor does, and its overlap is mended.
TEST(Robots, AMotorThatCannotBearItsLoadHoldsNothing) {
  for (const double force : {100.0, 4000.0}) {
    SCOPED_TRACE(testing::Message() << force << " N");
    DelassusWorld world;
    world.addGround();
    btRigidBody& rail =
        world.addBox({btScalar(0.02), 0.5, btScalar(0.02)}, {0, btScalar(1.2), 0.5}, 0);
    const btScalar small = btScalar(0.05), half = btScalar(0.1);
    btRigidBody& carriage = world.addBox({small, small, small}, {0, btScalar(0.4), 0}, 0.5);
    btRigidBody& load =
        world.addBox({half, half, half}, {0, btScalar(0.2), 0}, btScalar(force / 4));
    btTransform onRail(btQuaternion(btVector3(0, 0, 1), SIMD_HALF_PI), {0, btScalar(-0.8), -0.5});
    const btTransform onCarriage(onRail.getRotation());
    auto& axis = world.addJoint<btSliderConstraint>(rail, carriage, onRail, onCarriage, true);
    axis.setLowerLinLimit(-2);
    axis.setUpperLinLimit(2);
    axis.setLowerAngLimit(0);
    axis.setUpperAngLimit(0);
    axis.setPoweredLinMotor(true);
    axis.setMaxLinMotorForce(btScalar(force));
    world.addJoint<btFixedConstraint>(carriage, load, DelassusWorld::at({0, -half, 0}),
                                      DelassusWorld::at({0, half, 0}));
    world.advance(240);
    EXPECT_NEAR(load.getWorldTransform().getOrigin().y(), half, 1e-3);
  }
}

/// A plate that floats, with a post, and a box beside the post that overlaps it by 1 cm when it
/// stands where its joint holds it.
struct Claw {
  DelassusWorld world;
  btRigidBody *plate, *post, *finger;

  /// The finger is `pulled` out of its joint, away from the post, m.
  explicit Claw(double pulled = 0) {
    world->setGravity({0, 0, 0});
    plate = &world.addBox({0.5, btScalar(0.1), 0.5}, {0, 0, 0}, 5);
    post = &world.addBox({btScalar(0.1), 0.5, btScalar(0.1)}, {btScalar(-0.4), 0.6, 0});
    finger = &world.addBox({btScalar(0.21), btScalar(0.05), btScalar(0.1)},
                           {btScalar(-0.1 + pulled), btScalar(0.9), 0});
    world.addJoint<btFixedConstraint>(*plate, *post, DelassusWorld::at({btScalar(-0.4), 0.6, 0}),
                                      btTransform::getIdentity());
  }
  static btTransform place() { return DelassusWorld::at({btScalar(-0.1), btScalar(0.9), 0}); }
  double fromPlace() const {
    const btTransform onPlate = plate->getWorldTransform().inverse() * finger->getWorldTransform();
    return onPlate.getOrigin().x() - place().getOrigin().x();
  }
};

// After a blow a weld is a millimetre apart. It mends that, though its link then overlaps another.
TEST(Robots, AWeldMendsItsErrorAgainstALinkThatItOverlaps) {
  Claw claw(1e-3);
  claw.world.addJoint<btFixedConstraint>(*claw.plate, *claw.finger, Claw::place(),
                                         btTransform::getIdentity());
  for (int step = 0; step < 60; ++step) {
    claw.world.advance();
    EXPECT_EQ(claw.world.report().incompatible + claw.world.report().outOfBudget, 0);
    EXPECT_GT(claw.world.report().held, 0);
  }
  EXPECT_NEAR(claw.fromPlace(), 0, 1e-5);
}

// The motor of a claw, as strong as a weld, presses its finger on the post, which stops it. If it
// has no bound the finger sinks in, but resists.
TEST(Robots, AClawStopsAtWhatItPresses) {
  for (const bool isBounded : {true, false}) {
    Claw claw(0.05);
    auto& axis = claw.world.addJoint<btSliderConstraint>(*claw.plate, *claw.finger, Claw::place(),
                                                         btTransform::getIdentity(), true);
    axis.setLowerLinLimit(-1);
    axis.setUpperLinLimit(1);
    axis.setLowerAngLimit(0);
    axis.setUpperAngLimit(0);
    axis.setPoweredLinMotor(true);
    axis.setMaxLinMotorForce(isBounded ? btScalar(1e4) : BT_LARGE_FLOAT);
    axis.setTargetLinMotorVelocity(btScalar(-0.1));
    claw.world.advance(12);
    EXPECT_NEAR(claw.fromPlace(), 0.03, 1e-3) << "it moves";
    claw.world.advance(90);
    if (isBounded)
      EXPECT_NEAR(claw.fromPlace(), 0.01, 2e-3);
    else
      EXPECT_GT(claw.fromPlace(), -0.05);  // and not -0.12
  }
}

// The motor of a light link holds with 10 kN m while its limit, which is passed, mends that. It
// takes up what the limit does: nothing is thrown.
TEST(Robots, ALimitIsMendedAgainstAStrongMotor) {
  for (const double passed : {1e-4, 1e-2, 0.3}) {
    SCOPED_TRACE(testing::Message() << passed << " rad");
    DelassusWorld world;
    world->setGravity({0, 0, 0});
    btRigidBody& body = world.addBox({0.5, btScalar(0.1), 0.5}, {0, 0, 0}, 5);
    const btScalar half = btScalar(0.02);
    btRigidBody& hand = world.addBox({half, half, half}, {0, 0.5, 0}, btScalar(0.1));
    auto& joint = world.addJoint<btGeneric6DofSpring2Constraint>(
        body, hand, DelassusWorld::at({0, 0.5, 0}), btTransform::getIdentity());
    for (int axis = 0; axis < 6; ++axis) joint.setLimit(axis, 0, 0);
    joint.setLimit(3, btScalar(passed), 1);
    joint.enableMotor(3, true);
    joint.setMaxMotorForce(3, 1e4);
    for (int step = 0; step < 60; ++step) {
      world.advance();
      EXPECT_EQ(world.report().incompatible + world.report().softened, 0);
    }
    joint.calculateTransforms();
    EXPECT_NEAR(joint.getAngle(0), passed, tolerance(2.5e-5, 2e-4));
  }
}

/// A robot of two arms whose links overlap, as Bullet's importer makes it of
/// TwoJointRobot_w_fixedJoints.urdf, falls 2 m; turned by `turn` rad at first.
class FallingRobot {
 public:
  explicit FallingRobot(double turn) : turned_(btVector3(1, 2, 3).normalized(), btScalar(turn)) {
    world_->setGravity({0, 0, -10});
    world_.addBox({20, 20, 1}, {0, 0, btScalar(-2.5)}, 0);
    const double places[][2] = {{0, 0.025}, {0, 0.075},   {0.5, 0.075}, {1, 0.075},
                                {1, 0.125}, {1.5, 0.125}, {2, 0.125}};
    for (const auto& [x, z] : places) {
      const bool isArm = x == 0.5 || x == 1.5;
      links_.push_back(isArm ? &addArm(at(x, z)) : &addAxle(at(x, z)));
    }
    const double joints[][2] = {{0, 0.075}, {0, 0.075}, {1, 0.075},
                                {1, 0.125}, {1, 0.125}, {2, 0.125}};
    for (int i = 0; i < 6; ++i) join(i, at(joints[i][0], joints[i][1]), i == 0 || i == 3);
  }
  double energy() {
    double sum = 0;
    for (const btRigidBody* link : links_) {
      const double mass = 1 / link->getInvMass();
      const btVector3 turn = link->getAngularVelocity();
      sum += 0.5 * mass * link->getLinearVelocity().length2() +
             0.5 * turn.dot(link->getInvInertiaTensorWorld().inverse() * turn) +
             10 * mass * link->getWorldTransform().getOrigin().z();
    }
    return sum;
  }
  void advance() { world_->stepSimulation(btScalar(1) / 240, 0); }
  const StepReport& report() { return world_.report(); }

 private:
  btTransform at(double x, double z) const {
    return btTransform(turned_, quatRotate(turned_, {btScalar(x), 0, btScalar(z)}));
  }
  btRigidBody& addArm(const btTransform& pose) {
    return world_.addBody(
        std::make_unique<btBoxShape>(btVector3(0.5, btScalar(0.05), btScalar(0.025))), pose, 0.5);
  }
  /// A cylinder with 32 sides.
  btRigidBody& addAxle(const btTransform& pose) {
    constexpr int sides = 32;
    auto shape = std::make_unique<btConvexHullShape>();
    for (int i = 0; i < sides; ++i)
      for (const double z : {0.025, -0.025}) {
        const double angle = 2 * SIMD_PI * i / sides;
        shape->addPoint(
            {btScalar(0.075 * std::sin(angle)), btScalar(0.075 * std::cos(angle)), btScalar(z)});
      }
    shape->setMargin(btScalar(0.001));
    return world_.addBody(std::move(shape), pose, btScalar(0.2));
  }
  void join(int i, const btTransform& pose, bool isHinge) {
    btRigidBody &a = *links_[i], &b = *links_[i + 1];
    auto& joint = world_.addJoint<btGeneric6DofSpring2Constraint>(
        a, b, a.getWorldTransform().inverse() * pose, b.getWorldTransform().inverse() * pose);
    for (int axis = 0; axis < 6; ++axis) joint.setLimit(axis, 0, 0);
    a.setIgnoreCollisionCheck(&b, true);
    if (!isHinge) return;
    joint.setLimit(5, -3, 3);
    joint.enableMotor(5, true);
    joint.setMaxMotorForce(5, 1e4);
  }
  DelassusWorld world_;
  btQuaternion turned_;
  std::vector<btRigidBody*> links_;
};

// Links that are held wholly do not squeeze each other, a blow leaves no quarrel, and rounding, as
// they fall, is none.
TEST(Robots, AFallIsNoSourceOfEnergy) {
  for (const double turn : {0.15, 0.2, 0.25}) {
    SCOPED_TRACE(testing::Message() << turn << " rad");
    FallingRobot robot(turn);
    double last = robot.energy(), gained = 0;
    for (int step = 0; step < 360; ++step) {
      robot.advance();
      EXPECT_EQ(robot.report().incompatible + robot.report().outOfBudget, 0) << step;
      const double now = robot.energy();
      gained += std::max(now - last, 0.0);
      last = now;
    }
    EXPECT_LT(gained, 0.5);  // of 30 J
  }
}

}  // namespace
}  // namespace delassus::test
