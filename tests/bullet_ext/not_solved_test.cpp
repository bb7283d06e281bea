/// Islands that end above their tolerance: the report and the listener name the contacts that are to blame.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/bullet_world.h"

namespace delassus::testing {
namespace {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
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
  world.delassus().setContactListener([&](const ContactEvent& event) { events.push_back(event); });
  world.advance();
  const StepReport& report = world.report();
  ASSERT_EQ(report.outOfBudget, 1);
  EXPECT_THAT(report.messages, ElementsAre(AllOf(StartsWith("contact "), HasSubstr("budget"))));
  int told = 0;
  for (const ContactEvent& event : events) told += event.trouble == Trouble::OutOfBudget;
  EXPECT_EQ(told, 1);
}

TEST(NotSolved, IncompatibleContactsAreToldToTheListenerInEveryStep) {
  DelassusWorld world;
  btRigidBody& left = world.addBox({1, 1, 1}, {btScalar(-1.5), 0, 0}, 1);
  btRigidBody& right = world.addBox({1, 1, 1}, {btScalar(1.5), 0, 0}, 1);
  world.addSphere(btScalar(0.5), {0, 0, 0}).setFriction(0);
  world.advance();
  for (btRigidBody* wall : {&left, &right})
    wall->setCollisionFlags(wall->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
  for (int step = 1; step <= 3; ++step) {
    int told = 0;
    world.delassus().setContactListener(
        [&](const ContactEvent& event) { told += event.trouble == Trouble::Incompatible; });
    // The walls of a press close on the ball.
    left.setWorldTransform(BulletWorld::at({btScalar(-1.5) + btScalar(0.01) * step, 0, 0}));
    right.setWorldTransform(BulletWorld::at({btScalar(1.5) - btScalar(0.01) * step, 0, 0}));
    world.advance();
    EXPECT_EQ(world.report().incompatible, 1);
    EXPECT_GT(told, 0);
    EXPECT_THAT(world.report().messages, Each(HasSubstr("no motion meets its demand")));
  }
}

}  // namespace
}  // namespace delassus::testing
