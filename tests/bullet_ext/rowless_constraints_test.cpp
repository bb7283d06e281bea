/// Constraints without rows, which solve themselves (solveConstraintObsolete).

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/bullet_world.h"
#include "tests/support/rowless_constraint.h"

namespace delassus::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::StartsWith;

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

// A body that the constraint leaves alone is not solved again.
TEST(Joints, AConstraintWithoutRowsThatDoesNothingIsCalledOnce) {
  DelassusWorld world;
  world->setGravity({0, 0, 0});
  btRigidBody& body = world.addCube({0, 10, 0});
  const FallBrake& brake = world.addJoint<FallBrake>(body, btScalar(1));
  world.advance();
  EXPECT_EQ(brake.calls, 1);
  EXPECT_EQ(world.report().obsoleteConstraints, 0);
}

// The rest of the group keeps its motion, bit for bit, whoever else is in the group.
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

/// Pushes its body once, in solveConstraintObsolete, and takes itself out.
class Starter : public RowlessConstraint {
 public:
  using RowlessConstraint::RowlessConstraint;
  void solveConstraintObsolete(btSolverBody& body, btSolverBody&, btScalar) override {
    ++calls;
    body.internalApplyImpulse(btVector3(1, 0, 0) * body.internalGetInvMass(), {0, 0, 0}, 1);
    setEnabled(false);
  }
  int calls = 0;
};

TEST(Joints, AConstraintWithoutRowsThatDisablesItselfIsCalledOnce) {
  const auto run = [](BulletWorld& world) {
    btRigidBody& body = world.addCube({0, 10, 0});
    Starter& starter = world.addJoint<Starter>(body);
    world.addJoint<FallBrake>(body, btScalar(0.1));  // goes on for all sweeps
    world.advance(3);
    EXPECT_EQ(starter.calls, 1);
    return body.getLinearVelocity();
  };
  DelassusWorld ours;
  StockWorld stock(10);
  const btVector3 velocity = run(ours);
  EXPECT_NEAR((velocity - btVector3(1, btScalar(-0.1), 0)).length(), 0, 100 * precision);
  EXPECT_NEAR((velocity - run(stock)).length(), 0, 100 * precision);
}

// Without a budget the four points are trouble, until the constraint lifts the body off them.
TEST(Joints, TroubleThatAConstraintWithoutRowsEndsIsNotTold) {
  Options options;
  options.newtonBudget = options.sweepBudget = 0;
  OwningWorld<btDiscreteDynamicsWorld, btDelassusConstraintSolver> world(
      std::make_unique<btDelassusConstraintSolver>(options));
  world.addGround();
  btRigidBody& box = world.addCube({0, btScalar(0.5), 0});
  int troubles = 0;
  world.solver().setTroubleListener([&](const ContactEvent&) { ++troubles; });
  for (const bool lifts : {false, true}) {
    if (lifts) world.addJoint<FallBrake>(box, btScalar(-1));
    world.advance();
    EXPECT_EQ(world.solver().report().outOfBudget, lifts ? 0 : 1);
    EXPECT_EQ(troubles > 0, !lifts);
    troubles = 0;
  }
}

/// Looks at its second body, in solveConstraintObsolete.
class Watcher : public RowlessConstraint {
 public:
  using RowlessConstraint::RowlessConstraint;
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

/// Sets velocities that are NaN, in solveConstraintObsolete.
class BrokenMover : public RowlessConstraint {
 public:
  using RowlessConstraint::RowlessConstraint;
  void solveConstraintObsolete(btSolverBody& body, btSolverBody&, btScalar) override {
    body.internalApplyImpulse({1, 0, 0}, {0, 0, 0}, notANumber);
  }
};

/// Pushes its body in every sweep, without end.
class Mover : public BrokenMover {
 public:
  using BrokenMover::BrokenMover;
  void solveConstraintObsolete(btSolverBody& body, btSolverBody&, btScalar) override {
    body.internalApplyImpulse({1, 0, 0}, {0, 0, 0}, btScalar(0.1));
  }
};

TEST(LeftOut, AConstraintThatSolvesItselfToNoNumberIsAskedOnce) {
  DelassusWorld world;
  world.addJoint<BrokenMover>(world.addCube({0, 0, 0}));
  world.addJoint<Mover>(world.addCube({5, 0, 0}));
  world.advance();
  EXPECT_EQ(world.report().leftOut, 1);
}

TEST(LeftOut, AConstraintThatSolvesItselfToNoNumber) {
  DelassusWorld world;
  world.addGround();
  btRigidBody& box = world.addCube({0, btScalar(0.5), 0});
  world.addJoint<BrokenMover>(box);
  world.advance(2);
  EXPECT_THAT(world.report().messages,
              ElementsAre(AllOf(StartsWith("a joint of body 1 and the world "),
                                EndsWith("the velocities that it sets are not finite"))));
  EXPECT_NEAR(box.getLinearVelocity().length(), 0, tolerance(1e-9, 1e-5));
}

}  // namespace
}  // namespace delassus::test
