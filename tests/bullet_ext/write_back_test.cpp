/// What Bullet and its users read after a step: impulses, directions, contact modes.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "bullet_ext/saturating_sum.h"
#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

double sumOfNormalImpulses(BulletWorld& world) {
  double sum = 0;
  for (const btManifoldPoint* point : world.points()) sum += point->m_appliedImpulse;
  return sum;
}

TEST(Parity, Row26NormalImpulsesCarryTheWeightWithAndWithoutWarmStart) {
  for (bool warm : {true, false}) {
    DelassusWorld world;
    if (!warm) world.info().m_solverMode &= ~SOLVER_USE_WARMSTARTING;
    world.addGround();
    world.addCube({0, btScalar(0.5), 0}, 3);
    for (int i = 0; i < 60; ++i) world.advance();
    EXPECT_EQ(world.points().size(), 4u);
    EXPECT_NEAR(sumOfNormalImpulses(world) / h, 3 * g, tolerance(1e-9, 1e-2)) << warm;
  }
}

TEST(Parity, Row27LateralImpulsesTimesDirectionsAreTheFriction) {
  DelassusWorld world;
  world.addGround();
  btRigidBody& box = world.addCube({0, btScalar(0.5), 0});
  const btVector3 pull(2, 0, btScalar(-1.5));
  for (int i = 0; i < 30; ++i) {
    box.applyCentralForce(pull);
    world.advance();
  }
  btVector3 friction(0, 0, 0);
  for (const btManifoldPoint* point : world.points()) {
    EXPECT_NEAR(point->m_lateralFrictionDir1.length(), 1, 10 * precision);
    EXPECT_NEAR(point->m_lateralFrictionDir1.dot(point->m_normalWorldOnB), 0, 10 * precision);
    EXPECT_NEAR(point->m_lateralFrictionDir2.dot(point->m_normalWorldOnB), 0, 10 * precision);
    EXPECT_NEAR(point->m_lateralFrictionDir1.dot(point->m_lateralFrictionDir2), 0, 10 * precision);
    const btVector3 reaction = point->m_appliedImpulseLateral1 * point->m_lateralFrictionDir1 +
                               point->m_appliedImpulseLateral2 * point->m_lateralFrictionDir2;
    // Body 0 of the only manifold is the ground or the box, as the broadphase decides.
    friction += reaction;
  }
  const bool groundFirst = world.dispatcher().getManifoldByIndexInternal(0)->getBody1() == &box;
  const btVector3 onBox = (groundFirst ? -1 : 1) * friction / BulletWorld::step;
  for (int k : {0, 2}) EXPECT_NEAR(onBox[k], -pull[k], tolerance(1e-8, 1e-3));
}

TEST(Parity, Row41SpeculativeRestitutionReadsTheImpulse) {
  const auto shoot = [](BulletWorld& world) {
    world->setGravity({0, 0, 0});
    world->setApplySpeculativeContactRestitution(true);
    btRigidBody& wall = world.addBox({btScalar(0.05), 5, 5}, {5, 0, 0}, 0);
    wall.setRestitution(1);
    btRigidBody& bullet = world.addSphere(btScalar(0.1), {0, 0, 0});
    bullet.setRestitution(btScalar(0.5));
    bullet.setCcdMotionThreshold(btScalar(0.1));
    bullet.setCcdSweptSphereRadius(btScalar(0.05));
    bullet.setLinearVelocity({100, 0, 0});
    world.advance(20);
    return bullet.getLinearVelocity().x();
  };
  DelassusWorld ours;
  StockWorld stock;
  const double bounced = shoot(ours);
  EXPECT_LT(bounced, -1) << "came back from the wall";
  EXPECT_NEAR(bounced, shoot(stock), tolerance(1e-7, 1e-2));
}

TEST(ContactListener, TellsTouchSlideStopAndRelease) {
  DelassusWorld world;
  world.addGround();
  btRigidBody& ball = world.addSphere(btScalar(0.5), {0, btScalar(0.51), 0});
  ball.setAngularFactor(0);
  std::vector<ContactEvent> events;
  world.delassus().setContactListener([&](const ContactEvent& event) { events.push_back(event); });

  const auto expectOne = [&](Mode from, Mode to, const char* when) {
    ASSERT_EQ(events.size(), 1u) << when;
    EXPECT_EQ(events[0].from, from) << when;
    EXPECT_EQ(events[0].to, to) << when;
    EXPECT_EQ(world.report().modeChanges, 1) << when;
    events.clear();
  };
  const auto advanceUntilTold = [&] {
    for (int i = 0; i < 120 && events.empty(); ++i) world.advance();
  };

  advanceUntilTold();
  EXPECT_NEAR(events.front().reaction.length(), world.points()[0]->m_appliedImpulse,
              10 * precision);
  expectOne(Mode::Open, Mode::Stick, "landing");
  // Slower than 0.02 m a step: beyond that Bullet makes a new point, which has no memory.
  ball.setLinearVelocity({1, 0, 0});
  advanceUntilTold();
  EXPECT_NEAR(std::hypot(events.front().reaction.x(), events.front().reaction.z()),
              0.5 * std::abs(events.front().reaction.y()), tolerance(1e-10, 1e-6))
      << "on the cone";
  expectOne(Mode::Stick, Mode::Slide, "kick");
  advanceUntilTold();
  expectOne(Mode::Slide, Mode::Stick, "stop");
  ball.setLinearVelocity({0, btScalar(0.1), 0});
  world->setGravity({0, 0, 0});
  ball.setGravity({0, 0, 0});
  advanceUntilTold();
  expectOne(Mode::Stick, Mode::Open, "lift");

  world.delassus().setContactListener(nullptr);
  ball.setLinearVelocity({0, -1, 0});
  world.advance(10);
  EXPECT_TRUE(events.empty());
}

TEST(StepReport, CountsModesAndParts) {
  DelassusWorld world;
  world.addGround();
  world.addCube({0, btScalar(0.5), 0});
  btRigidBody& ice = world.addCube({5, btScalar(0.5), 0});
  ice.setFriction(0);
  world.advance(10);
  const StepReport& report = world.report();
  EXPECT_EQ(report.islands, 2);
  EXPECT_EQ(report.contacts, 8);
  EXPECT_EQ(report.open + report.stick + report.slide, 8);
  EXPECT_GE(report.slide, 1) << "a contact without friction slides as long as it persists";
  EXPECT_EQ(report.solved, 2);
  EXPECT_LT(report.residualMax, 1e-9);
  EXPECT_LE(report.residualRms, report.residualMax);
  EXPECT_GT(report.workspaceBytes, 0u);
  EXPECT_TRUE(report.messages.empty());
}

TEST(StepReport, CountsStayAtTheLargestNumber) {
  constexpr int most = std::numeric_limits<int>::max();
  int sum = most - 1;
  addTo(sum, 1);
  EXPECT_EQ(sum, most);
  addTo(sum, 2);
  EXPECT_EQ(sum, most);

  Plan plan;
  plan.rows = most / 2 + 1;
  plan.add(Plan(plan));
  EXPECT_EQ(plan.rows, most);
}

TEST(StepReport, StaysWhereItIsAfterReset) {
  DelassusWorld world;
  world.addGround();
  world.addCube({0, btScalar(0.5), 0});
  const StepReport& report = world.report();
  world.advance(2);
  EXPECT_EQ(report.contacts, 4);
  world.delassus().reset();
  EXPECT_EQ(&report, &world.report());
  EXPECT_EQ(report.contacts, 0);
  world.advance();
  EXPECT_EQ(report.contacts, 4);
}

}  // namespace
}  // namespace delassus::test
