/// Normal rows: gaps, restitution, penetration, slop, softness (Bullet's contract, contact normal
/// rows).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

constexpr double ballRadius = 0.5;

struct Approach {
  double gap = 0;          ///< between sphere and ground, m
  double approach = 0;     ///< m/s, downwards
  double restitution = 0;  ///< of the pair
};

/// One ball above the ground, without gravity.
btRigidBody& addTouching(BulletWorld& world, const Approach& touch) {
  world->setGravity({0, 0, 0});
  world.addGround().setRestitution(1);
  btRigidBody& ball = world.addSphere(ballRadius, {0, btScalar(ballRadius + touch.gap), 0});
  ball.setRestitution(btScalar(touch.restitution));
  ball.setLinearVelocity({0, btScalar(-touch.approach), 0});
  return ball;
}

double velocityAfterOneStep(const Approach& touch, bool split = true) {
  DelassusWorld world;
  world.info().m_splitImpulse = split;
  btRigidBody& ball = addTouching(world, touch);
  world.advance();
  return ball.getLinearVelocity().y();
}

constexpr double roundOff = tolerance(1e-12, 2e-5);

TEST(Parity, Row08SpeculativeGap) {
  EXPECT_NEAR(velocityAfterOneStep({0.015, 1, 1}), 1 - 0.015 / h, roundOff);
  EXPECT_NEAR(velocityAfterOneStep({0.015, 1, 0}), -0.015 / h, roundOff)
      << "closes the gap, no more";
  EXPECT_NEAR(velocityAfterOneStep({0.015, 0.5, 0}), -0.5, roundOff) << "does not get there";
}

// A body may set the distance beyond which a point does not count. Its earlier reaction is then
// gone.
TEST(Parity, Row08PointsBeyondTheProcessingThresholdAreIdle) {
  constexpr double threshold = 0.004;
  for (const double gap : {0.003, 0.005}) {
    DelassusWorld world;
    btRigidBody& ball = addTouching(world, {0, 1, 0});
    ball.setContactProcessingThreshold(btScalar(threshold));
    world.advance();
    ASSERT_EQ(world.points().size(), 1u);
    EXPECT_NEAR(world.points()[0]->m_appliedImpulse, 1, roundOff) << "stopped";

    ball.translate({0, btScalar(gap), 0});
    ball.setLinearVelocity({0, -1, 0});
    world.advance();
    ASSERT_EQ(world.points().size(), 1u);
    const bool idle = gap > threshold;
    const double speed = idle ? 1 : gap / h;
    EXPECT_NEAR(ball.getLinearVelocity().y(), -speed, roundOff);
    EXPECT_NEAR(world.points()[0]->m_appliedImpulse, 1 - speed, idle ? 0 : roundOff);
    EXPECT_EQ(world.report().contacts, idle ? 0 : 1);
  }
}

/// The upward velocity, m/s, of a ball after a step of gravity. The ball is let go, or thrown down
/// at `approach`, `gap` above the ground, 50 m from the origin.
double velocityFarOut(double gap, double approach) {
  DelassusWorld world;
  btRigidBody& ball = addTouching(world, {gap, approach, 0});
  ball.translate({50, 0, 0});
  world->setGravity({0, -BulletWorld::gravity, 0});
  world.advance();
  return ball.getLinearVelocity().y();
}

// There float rounds places to 4e-6 m. A gap or overlap that may be rounding alone is neither
// closed nor mended, unless something moves.
TEST(Contacts, WhatRoundingTellsOfADistanceIsNoGapAndNoOverlap) {
  constexpr double tiny = 1e-5, gap = 1e-3;
  constexpr bool rounds = sizeof(btScalar) < sizeof(double);
  EXPECT_NEAR(velocityFarOut(tiny, 0), rounds ? 0 : -tiny / h, roundOff);
  EXPECT_NEAR(velocityFarOut(-tiny, 0), rounds ? 0 : 0.2 * tiny / h, roundOff);
  EXPECT_NEAR(velocityFarOut(tiny, 0.1), -tiny / h, roundOff);
  EXPECT_NEAR(velocityFarOut(gap, 0), -gap / h, roundOff);
}

// Up to four roundings of both places, 50 m each, are no distance, nor is a fifty-thousandth of the
// distance at which Bullet drops a point; more than that is one.
TEST(Contacts, NegligibleDistancesAreNone) {
  const double dropped =
      btSphereShape(ballRadius).getContactBreakingThreshold(gContactBreakingThreshold);
  const double least = std::max(4 * 2 * 50 * precision, 2e-5 * dropped);
  for (const double distance : {0.75 * least, -0.75 * least})
    EXPECT_NEAR(velocityFarOut(distance, 0), 0, 0.01 * least / h);
  EXPECT_NEAR(velocityFarOut(1.5 * least, 0), -1.5 * least / h, 0.25 * least / h);
  EXPECT_NEAR(velocityFarOut(-1.5 * least, 0), 0.2 * 1.5 * least / h, 0.05 * least / h);
  EXPECT_NEAR(velocityFarOut(0.75 * least, 0.1), -0.75 * least / h, 0.25 * least / h) << "it moves";
}

// A step takes back a fifth of each overlap. If it did so for ever, no pile with overlaps would
// rest, and each step would take a search.
TEST(Contacts, BodiesThatOverlapComeToRest) {
  DelassusWorld world;
  world.addGround();
  std::vector<btRigidBody*> boxes;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row)
      boxes.push_back(
          &world.addCube({btScalar(0.9999 * column), btScalar(0.4999 + 0.9999 * row), 0}));
  world.advance(60);
  for (int step = 0; step < 10; ++step) {
    world.advance();
    EXPECT_EQ(world.report().regions, 0) << step;
    for (const btRigidBody* box : boxes) {
      EXPECT_TRUE(box->getLinearVelocity().isZero()) << step;
      EXPECT_TRUE(box->getAngularVelocity().isZero()) << step;
    }
  }
}

TEST(Parity, Row09RestitutionHasAThreshold) {
  EXPECT_NEAR(velocityAfterOneStep({0, 0.19, 0.5}), 0, roundOff);
  EXPECT_NEAR(velocityAfterOneStep({0, 0.21, 0.5}), 0.105, roundOff);
}

TEST(Parity, Row09RestitutionThresholdIsThatOfTheInfo) {
  for (const double threshold : {0.0, 1.0})
    for (const double approach : {0.05, 0.9, 1.1}) {
      DelassusWorld world;
      world.info().m_restitutionVelocityThreshold = btScalar(threshold);
      const btRigidBody& ball = addTouching(world, {0, approach, 0.5});
      world.advance();
      EXPECT_NEAR(ball.getLinearVelocity().y(), approach < threshold ? 0 : 0.5 * approach, roundOff)
          << threshold;
    }
}

TEST(Parity, Row09BouncingBallFollowsStock) {
  for (double e : {0.2, 0.5, 0.8, 1.0}) {
    SCOPED_TRACE(e);
    DelassusWorld ours;
    StockWorld stock;
    const auto drop = [e](BulletWorld& world) -> const btRigidBody& {
      btRigidBody& ball = addTouching(world, {1.5, 0, e});
      world->setGravity({0, -BulletWorld::gravity, 0});
      ball.setGravity({0, -BulletWorld::gravity, 0});
      return ball;
    };
    const btRigidBody &a = drop(ours), &b = drop(stock);
    for (int i = 0; i < 120; ++i) {
      ours.advance();
      stock.advance();
      ASSERT_NEAR(a.getWorldTransform().getOrigin().y(), b.getWorldTransform().getOrigin().y(),
                  tolerance(1e-10, 1e-3));
    }
  }
}

TEST(Parity, Row10ShallowPenetrationIsSolvedInVelocity) {
  EXPECT_NEAR(velocityAfterOneStep({-0.03}), 0.2 * 0.03 / h, roundOff);
}

TEST(Parity, Row11DeepPenetrationIsPushedAndLeavesNoVelocity) {
  DelassusWorld world;
  btRigidBody& ball = addTouching(world, {-0.05});
  world.advance();
  EXPECT_NEAR(ball.getLinearVelocity().y(), 0, roundOff);
  EXPECT_NEAR(ball.getWorldTransform().getOrigin().y(), ballRadius - 0.05 + 0.2 * 0.05, roundOff);
  EXPECT_EQ(world.report().pushIslands, 1);
  EXPECT_EQ(world.report().pushUnsolved, 0);
}

TEST(Parity, Row12SplitOffSolvesAllDepthsInVelocity) {
  for (double depth : {0.03, 0.05})
    EXPECT_NEAR(velocityAfterOneStep({-depth}, false), 0.2 * depth / h, roundOff);
}

TEST(Parity, Row11DepthFromWhichItIsPushedIsThatOfTheInfo) {
  for (const double threshold : {0.01, 0.1})
    for (const double depth : {0.009, 0.05, 0.11}) {
      DelassusWorld world;
      world.info().m_splitImpulsePenetrationThreshold = btScalar(-threshold);
      btRigidBody& ball = addTouching(world, {-depth});
      world.advance();
      const double recovery = 0.2 * depth;
      EXPECT_NEAR(ball.getLinearVelocity().y(), depth < threshold ? recovery / h : 0, roundOff);
      EXPECT_NEAR(ball.getWorldTransform().getOrigin().y(), ballRadius - depth + recovery,
                  roundOff);
    }
}

/// The depth at which a ball of 1 kg comes to rest.
template <class Prepare>
double restingDepth(const Prepare& prepare, int steps = 600) {
  DelassusWorld world;
  world.addGround();
  btRigidBody& ball = world.addSphere(ballRadius, {0, ballRadius, 0});
  prepare(world, ball);
  world.advance(steps);
  EXPECT_NEAR(ball.getLinearVelocity().y(), 0, tolerance(1e-8, 1e-4));
  return ballRadius - ball.getWorldTransform().getOrigin().y();
}

constexpr double resting = tolerance(1e-7, 2e-5);

TEST(Parity, Row13SlopIsTheRestingDepth) {
  EXPECT_NEAR(restingDepth([](BulletWorld& world, btRigidBody&) {
                world.info().m_linearSlop = btScalar(0.01);
              }),
              0.01, resting);
}

/// At rest u = 0: compliance times impulse is the recovery, (cfm/h) m g h = erp depth/h.
double softDepth(double cfm, double erp) { return cfm * g * h / erp; }

TEST(Parity, Row14GlobalSoftness) {
  const double depth = restingDepth([](BulletWorld& world, btRigidBody&) {
    world.info().m_globalCfm = btScalar(0.01);
    world.info().m_erp2 = btScalar(0.3);
  });
  EXPECT_NEAR(depth, softDepth(0.01, 0.3), resting);
}

// Soft bodies rest as deep as their law says, however little that is.
TEST(Contacts, SoftBodiesHaveNoNegligibleDepth) {
  if (!isDouble) GTEST_SKIP() << "float rounds places to more than that";
  constexpr double cfm = 1e-7;
  const double depth = restingDepth(
      [](BulletWorld& world, btRigidBody&) { world.info().m_globalCfm = btScalar(cfm); });
  EXPECT_NEAR(depth, softDepth(cfm, 0.2), 0.01 * softDepth(cfm, 0.2));
}

/// What the contact callback below gives to each new point.
struct PointSoftness {
  int flags = 0;
  btScalar cfm = 0, erp = 0;
};
PointSoftness pointSoftness;

bool soften(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
            const btCollisionObjectWrapper*, int, int) {
  point.m_contactPointFlags |= pointSoftness.flags;
  point.m_contactCFM = pointSoftness.cfm;
  point.m_contactERP = pointSoftness.erp;
  return true;
}

/// Sets the callback for a body, as long as this lives.
struct WithPointSoftness {
  WithPointSoftness(btRigidBody& body, const PointSoftness& softness) {
    pointSoftness = softness;
    gContactAddedCallback = soften;
    body.setCollisionFlags(body.getCollisionFlags() |
                           btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
  }
  ~WithPointSoftness() { gContactAddedCallback = nullptr; }
};

double depthWithPointSoftness(const PointSoftness& softness) {
  std::optional<WithPointSoftness> given;
  return restingDepth([&](BulletWorld& world, btRigidBody& ball) {
    world.info().m_globalCfm = btScalar(0.002);
    given.emplace(ball, softness);
  });
}

TEST(Parity, Row15PointSoftnessReplacesEachNumber) {
  const int cfm = BT_CONTACT_FLAG_HAS_CONTACT_CFM, erp = BT_CONTACT_FLAG_HAS_CONTACT_ERP;
  EXPECT_NEAR(depthWithPointSoftness({0, btScalar(0.01), btScalar(0.4)}), softDepth(0.002, 0.2),
              resting);
  EXPECT_NEAR(depthWithPointSoftness({cfm, btScalar(0.01), btScalar(0.4)}), softDepth(0.01, 0.2),
              resting);
  EXPECT_NEAR(depthWithPointSoftness({erp, btScalar(0.01), btScalar(0.4)}), softDepth(0.002, 0.4),
              resting);
  EXPECT_NEAR(depthWithPointSoftness({cfm | erp, btScalar(0.01), btScalar(0.4)}),
              softDepth(0.01, 0.4), resting);
}

// A point that sets a softness of zero is split as well.
TEST(Parity, Row15OnlyAPointThatGivesIsNotSplit) {
  for (const double cfm : {0.0, 0.01}) {
    DelassusWorld world;
    btRigidBody& ball = addTouching(world, {-0.05});
    const WithPointSoftness given(ball, {BT_CONTACT_FLAG_HAS_CONTACT_CFM, btScalar(cfm)});
    world.advance();
    EXPECT_EQ(world.report().pushIslands, cfm > 0 ? 0 : 1) << cfm;
    EXPECT_EQ(ball.getLinearVelocity().y() > roundOff, cfm > 0) << cfm;
  }
}

TEST(Parity, Row15NegativeSoftnessIsNone) {
  DelassusWorld world;
  btRigidBody& ball = addTouching(world, {0, 1, 0});
  const WithPointSoftness given(ball, {BT_CONTACT_FLAG_HAS_CONTACT_CFM, btScalar(-0.005)});
  world.advance();
  EXPECT_NEAR(ball.getLinearVelocity().y(), 0, roundOff);
}

TEST(Parity, Row16ASpringWithoutStiffnessAndDampingCarriesNothing) {
  DelassusWorld world;
  world.addGround();
  btRigidBody& ball = world.addSphere(ballRadius, {0, btScalar(ballRadius - 0.01), 0});
  const WithPointSoftness given(ball, {BT_CONTACT_FLAG_CONTACT_STIFFNESS_DAMPING});
  world.advance();
  EXPECT_NEAR(ball.getLinearVelocity().y(), -g * h, roundOff);
  EXPECT_EQ(world.report().contacts, 1) << "nothing is wrong with it";
}

TEST(Parity, Row16SpringCarriesAtAllDepthsSplitOrNot) {
  for (bool split : {true, false})
    for (double stiffness : {2000, 500, 200, 100, 50}) {
      SCOPED_TRACE(stiffness);
      const double depth = restingDepth([&](BulletWorld& world, btRigidBody& ball) {
        world.info().m_splitImpulse = split;
        ball.setContactStiffnessAndDamping(btScalar(stiffness), 20);
      });
      EXPECT_NEAR(depth, g / stiffness, 10 * resting);
    }
}

}  // namespace
}  // namespace delassus::test
