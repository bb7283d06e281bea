/// Islands that end above their tolerance: report and listener name the contacts that are to blame.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::StartsWith;

TEST(NotSolved, OutOfBudgetNamesTheContactThatIsFurthestFromItsLaw) {
  Options options;
  options.newtonBudget = options.sweepBudget = 1;
  BulletWorld world(std::make_unique<btDelassusConstraintSolver>(options));
  world.addGround();
  for (int i = 0; i < 6; ++i)
    world
        .addCube({btScalar(0.2) * (i % 2), btScalar(0.5) + i, btScalar(0.1) * (i % 3)},
                 std::pow(btScalar(10), btScalar(i)))
        .setLinearVelocity({1, btScalar(-1) - i, 2});
  std::vector<ContactEvent> events;
  world.delassus().setTroubleListener([&](const ContactEvent& event) { events.push_back(event); });
  world.advance();
  const StepReport& report = world.report();
  ASSERT_EQ(report.outOfBudget, 1);
  EXPECT_THAT(report.messages, ElementsAre(AllOf(StartsWith("contact "), HasSubstr("budget"))));
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].trouble, Trouble::OutOfBudget);
}

TEST(NotSolved, IncompatibleContactsAreToldInEveryStep) {
  // The walls of a press close on a ball.
  btSphereShape shape(1);
  btRigidBody ball(1, nullptr, &shape, btVector3(1, 1, 1));
  btRigidBody left(0, nullptr, &shape), right(0, nullptr, &shape);
  const auto touch = [&](btRigidBody& wall, btScalar side, btPersistentManifold& manifold) {
    wall.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
    wall.setWorldTransform(BulletWorld::at({2 * side, 0, 0}));
    wall.setLinearVelocity({-side, 0, 0});
    manifold.addManifoldPoint(btManifoldPoint({side, 0, 0}, {-side, 0, 0}, {-side, 0, 0}, 0));
    btManifoldPoint& point = manifold.getContactPoint(0);
    point.m_positionWorldOnA = point.m_positionWorldOnB = {side, 0, 0};
  };
  btPersistentManifold onLeft(&ball, &left, 0, btScalar(0.02), 1);
  btPersistentManifold onRight(&ball, &right, 0, btScalar(0.02), 1);
  touch(left, -1, onLeft);
  touch(right, 1, onRight);

  btDelassusConstraintSolver solver;
  std::vector<ContactEvent> troubles;
  solver.setTroubleListener([&](const ContactEvent& event) { troubles.push_back(event); });
  btCollisionObject* bodies[] = {&ball, &left, &right};
  btPersistentManifold* manifolds[] = {&onLeft, &onRight};
  for (int step = 1; step <= 3; ++step) {
    troubles.clear();
    solver.prepareSolve(3, 2);
    solver.solveGroup(bodies, 3, manifolds, 2, nullptr, 0, btContactSolverInfo(), nullptr, nullptr);
    EXPECT_EQ(solver.report().incompatible, 1);
    EXPECT_THAT(solver.report().messages,
                AllOf(SizeIs(1), Each(HasSubstr("solved as if contacts gave a little"))));
    ASSERT_EQ(troubles.size(), 2u);
    for (const ContactEvent& event : troubles) EXPECT_EQ(event.trouble, Trouble::Incompatible);
    EXPECT_NEAR(ball.getLinearVelocity().length(), 0, 1e-6) << "the compromise";
  }
}

// What two joints miss, since they hold a body to places that are apart, counts in the root mean
// square as in the largest residual.
TEST(NotSolved, WhatJointsMissCountsInTheMeanToo) {
  BulletWorld world(std::make_unique<btDelassusConstraintSolver>());
  btRigidBody& body = world.addCube({0, 0, 0});
  for (const double side : {-1.0, 1.0})
    world.addJoint<btPoint2PointConstraint>(body, btVector3(btScalar(side * 0.5), 0, 0))
        .setPivotB({btScalar(side * 0.6), 0, 0});
  world.advance();
  const StepReport& report = world.report();
  EXPECT_EQ(report.incompatible, 1);
  EXPECT_GT(report.residualMax, 0.1);
  EXPECT_LE(report.residualMax, 1.001 * std::sqrt(report.rows) * report.residualRms);
  EXPECT_LE(report.residualRms, report.residualMax);
}

// The same through Bullet's own narrow phase, with friction, on a row of boxes beside a bystander.
TEST(NotSolved, APressThatClosesOnBoxesSaysSoAndTheyStay) {
  BulletWorld world(std::make_unique<btDelassusConstraintSolver>());
  world.addGround();
  constexpr int count = 3;
  std::vector<btRigidBody*> boxes;
  for (int i = 0; i < count; ++i) boxes.push_back(&world.addCube({btScalar(i), btScalar(0.5), 0}));
  btRigidBody& bystander = world.addCube({1, btScalar(0.5), 5});
  btRigidBody* jaws[2];
  for (int k = 0; k < 2; ++k) {
    jaws[k] = &world.addCube({btScalar(k == 0 ? -1 : count), btScalar(0.5), 0}, 0);
    jaws[k]->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
    jaws[k]->setActivationState(DISABLE_DEACTIVATION);
  }
  constexpr double speed = 0.1;
  int said = 0;
  for (int step = 1; step <= 12; ++step) {
    for (int k = 0; k < 2; ++k) {
      const double way = speed * step * BulletWorld::step;
      const double x = k == 0 ? -1 + way : count - way;
      jaws[k]->setWorldTransform(BulletWorld::at({btScalar(x), btScalar(0.5), 0}));
    }
    world.advance();
    said += world.report().incompatible;
    EXPECT_EQ(world.report().outOfBudget, 0) << step;
    for (const btRigidBody* box : boxes) EXPECT_LT(box->getLinearVelocity().length(), 2 * speed);
    EXPECT_LT(bystander.getLinearVelocity().length(), 1e-6);
  }
  EXPECT_GE(said, 10);
}

// A box 1 cm deep in the ground cannot rise, and its other motions do not help all its corners.
// Where it cannot move along a normal no contact feels a push: some contact must be named all the
// same.
TEST(NotSolved, SomebodyIsNamedThoughNobodyCanYield) {
  int said = 0;
  for (const btVector3& linear : {btVector3(1, 0, 1), btVector3(1, 0, 0), btVector3(0, 0, 1)})
    for (const btVector3& angular : {btVector3(0, 0, 0), btVector3(0, 1, 0), btVector3(1, 1, 1)}) {
      DelassusWorld world;
      world.addGround();
      btRigidBody& box = world.addCube({0, btScalar(0.49), 0});
      box.setLinearFactor(linear);
      box.setAngularFactor(angular);
      box.setLinearVelocity(btScalar(0.3) * linear);
      std::vector<ContactEvent> told;
      world.delassus().setTroubleListener([&](const ContactEvent& event) {
        if (event.trouble == Trouble::Incompatible) told.push_back(event);
      });
      world.advance();
      const StepReport& report = world.report();
      said += report.incompatible;
      EXPECT_EQ(told.empty(), report.incompatible == 0);
      EXPECT_EQ(report.messages.empty(), report.incompatible == 0);
    }
  EXPECT_GT(said, 0);
}

// A box in a stack is made static a little too low, be it a millionth of a millimetre. The boxes
// below are squeezed, and hardly anything would lift them. That is reported at once, without a long
// search. By less than a micrometre the boxes give in, step by step.
TEST(NotSolved, ABodyThatIsFrozenInAStackCostsLittle) {
  for (const double depth : {1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-3}) {
    DelassusWorld world;
    world.addGround();
    std::vector<btRigidBody*> boxes;
    for (int i = 0; i < 5; ++i) boxes.push_back(&world.addCube({0, btScalar(0.5 + i), 0}));
    world.advance(30);
    btRigidBody& frozen = *boxes[2];
    world->removeRigidBody(&frozen);
    frozen.setMassProps(0, {0, 0, 0});
    frozen.setLinearVelocity({0, 0, 0});
    frozen.setAngularVelocity({0, 0, 0});
    frozen.setCenterOfMassTransform(world.at({0, btScalar(2.5 - depth), 0}));
    world->addRigidBody(&frozen);
    for (int step = 0; step < 10; ++step) {
      world.advance();
      const bool isSurelyTold =
          depth > 1e-4 || (sizeof(btScalar) == sizeof(double) && depth > 5e-7);
      if (isSurelyTold) {
        EXPECT_EQ(world.report().incompatible, 1) << depth << ", step " << step;
      }
      EXPECT_EQ(world.report().outOfBudget, 0) << depth << ", step " << step;
      EXPECT_LT(world.report().regions, 300) << depth << ", step " << step;
      EXPECT_LT(world.report().sweeps, 1000) << depth << ", step " << step;
    }
  }
}

}  // namespace
}  // namespace delassus::test
