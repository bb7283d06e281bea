/// Normal rows: gaps, restitution, penetration, slop, softness (Bullet's contract, contact normal
/// rows).

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

constexpr double radius = 0.5;

struct Approach {
  double gap = 0;          ///< between sphere and ground, m
  double approach = 0;     ///< m/s, downwards
  double restitution = 0;  ///< of the pair
};

/// One ball above the ground, without gravity.
btRigidBody& addTouching(BulletWorld& world, const Approach& touch) {
  world->setGravity({0, 0, 0});
  world.addGround().setRestitution(1);
  btRigidBody& ball = world.addSphere(radius, {0, btScalar(radius + touch.gap), 0});
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

/// What gravity leaves of the velocity of a ball, m/s upwards, that is let go, or thrown, `gap` above the ground 50 m from the origin.
double velocityFarOut(double gap, double approach) {
  DelassusWorld world;
  btRigidBody& ball = addTouching(world, {gap, approach, 0});
  ball.translate({50, 0, 0});
  world->setGravity({0, -BulletWorld::gravity, 0});
  world.advance();
  return ball.getLinearVelocity().y();
}

// There float rounds places to 4e-6 m. What may be no more than that is neither closed nor mended, unless something moves.
TEST(Contacts, WhatRoundingTellsOfADistanceIsNoGapAndNoOverlap) {
  constexpr double tiny = 1e-5, gap = 1e-3;
  constexpr bool rounds = sizeof(btScalar) < sizeof(double);
  EXPECT_NEAR(velocityFarOut(tiny, 0), rounds ? 0 : -tiny / h, roundOff);
  EXPECT_NEAR(velocityFarOut(-tiny, 0), rounds ? 0 : 0.2 * tiny / h, roundOff);
  EXPECT_NEAR(velocityFarOut(tiny, 0.1), -tiny / h, roundOff);
  EXPECT_NEAR(velocityFarOut(gap, 0), -gap / h, roundOff);
}

TEST(Parity, Row09RestitutionHasAThreshold) {
  EXPECT_NEAR(velocityAfterOneStep({0, 0.19, 0.5}), 0, roundOff);
  EXPECT_NEAR(velocityAfterOneStep({0, 0.21, 0.5}), 0.105, roundOff);
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
  EXPECT_NEAR(ball.getWorldTransform().getOrigin().y(), radius - 0.05 + 0.2 * 0.05, roundOff);
  EXPECT_EQ(world.report().pushIslands, 1);
  EXPECT_EQ(world.report().pushUnsolved, 0);
}

TEST(Parity, Row12SplitOffSolvesAllDepthsInVelocity) {
  for (double depth : {0.03, 0.05})
    EXPECT_NEAR(velocityAfterOneStep({-depth}, false), 0.2 * depth / h, roundOff);
}

/// The depth at which a ball of 1 kg comes to rest.
template <class Prepare>
double restingDepth(const Prepare& prepare, int steps = 600) {
  DelassusWorld world;
  world.addGround();
  btRigidBody& ball = world.addSphere(radius, {0, radius, 0});
  prepare(world, ball);
  world.advance(steps);
  EXPECT_NEAR(ball.getLinearVelocity().y(), 0, tolerance(1e-8, 1e-4));
  return radius - ball.getWorldTransform().getOrigin().y();
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

double depthWithPointSoftness(const PointSoftness& softness) {
  pointSoftness = softness;
  gContactAddedCallback = soften;
  const double depth = restingDepth([](BulletWorld& world, btRigidBody& ball) {
    world.info().m_globalCfm = btScalar(0.002);
    ball.setCollisionFlags(ball.getCollisionFlags() |
                           btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
  });
  gContactAddedCallback = nullptr;
  return depth;
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
