/// Robots of rigid bodies: links that overlap, motors that hold them.

#include <BulletDynamics/ConstraintSolver/btFixedConstraint.h>
#include <gtest/gtest.h>

#include <algorithm>

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

// Each link of a robot is welded to the next one, and overlaps the one after that.
TEST(Robots, WeldedLinksOfALongChainRest) {
  constexpr int links = 30;
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

}  // namespace
}  // namespace delassus::test
