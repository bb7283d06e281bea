/// Contacts and joints that contradict each other recover as far as they can, and press with loads.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>

#include "tests/support/bullet_world.h"
#include "tests/support/random_problems.h"

namespace delassus::test {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A plate of 1 kg, 1 m by 1 m, `overlap` deep in the floor. A point joint pins it to the world
/// `behind` one of its edges, in the middle of that edge.
struct PinnedPlate {
  static constexpr double halfThickness = 0.1;
  DelassusWorld world;
  btRigidBody& plate;
  btPoint2PointConstraint& pin;
  btJointFeedback feedback;

  PinnedPlate(double overlap, double behind, double mu)
      : plate((world.addGround(), world.addBox({0.5, btScalar(halfThickness), 0.5},
                                               {0, btScalar(halfThickness - overlap), 0}))),
        pin(world.addJoint<btPoint2PointConstraint>(
            plate, btVector3(btScalar(behind - 0.5), btScalar(halfThickness), 0))) {
    plate.setFriction(btScalar(mu));
    pin.setJointFeedback(&feedback);
  }
  double height() const { return plate.getWorldTransform().getOrigin().y(); }
};

constexpr double weight = 9.81;

// Planks on hinges of the world that lie in each other: what they ask for has no answer, and is not
// searched for as long as an answer would be.
TEST(Quarrels, AreSoonTold) {
  constexpr int mostSweeps = 10000;
  Random random(5);
  for (int start = 0; start < 8; ++start) {
    SCOPED_TRACE(start);
    DelassusWorld world;
    world.addGround();
    for (int k = 0; k < 3; ++k) {
      const btVector3 place(btScalar(uniform(random, -1, 1)), btScalar(uniform(random, 1.2, 1.32)),
                            btScalar(uniform(random, -0.4, 0.4)));
      btRigidBody& plank = world.addBox({1.5, btScalar(0.05), btScalar(0.3)}, place, 8);
      world.addJoint<btHingeConstraint>(plank, btVector3(0, 0, 0), btVector3(0, 0, 1));
    }
    for (int step = 0; step < 120; ++step) {
      world.advance();
      EXPECT_LT(world.report().sweeps, mostSweeps) << step;
    }
  }
}

// Wherever the pin is, some corner can rise only if another one sinks. What the plate presses with
// is its weight, and what it takes to recover.
TEST(Quarrels, APlateThatIsPinnedInTheFloorPressesWithItsWeight) {
  for (const double overlap : {1e-3, 0.01, 0.03})
    for (const double behind : {0.02, 0.05, 0.2, 0.5})
      for (const double mu : {0.0, 0.7}) {
        SCOPED_TRACE(testing::Message() << overlap << " m deep, " << behind << " m, mu " << mu);
        constexpr double erp = 0.2;  // of Bullet's worlds
        const double most = 2 * (weight + erp * overlap / (h * h));
        PinnedPlate pinned(overlap, behind, mu);
        double lowest = pinned.height();
        for (int step = 0; step < 60; ++step) {
          pinned.world.advance();
          ASSERT_LT(pinned.feedback.m_appliedForceBodyA.length(), most) << step;
          for (const btManifoldPoint* point : pinned.world.points())
            ASSERT_LT(point->getAppliedImpulse(), most * pinned.world.step) << step;
          ASSERT_EQ(pinned.world.report().incompatible, 1) << step;
          ASSERT_EQ(pinned.world.report().outOfBudget, 0) << step;
          ASSERT_GE(pinned.height(), lowest - tolerance(1e-9, 1e-6)) << step;
          lowest = pinned.height();
        }
        EXPECT_LT(pinned.plate.getLinearVelocity().length(), tolerance(1e-5, 1e-4));
        EXPECT_LT(pinned.feedback.m_appliedForceBodyA.length(), 1.1 * weight);
        EXPECT_THAT(pinned.world.report().messages, Each(HasSubstr("no motion meets its demand")));
        EXPECT_THAT(pinned.world.report().messages, Not(IsEmpty()));
      }
}

// Friction against turning carries no weight, and bears on none.
TEST(Quarrels, FrictionAgainstTurningChangesNothingOfThat) {
  for (const auto& [rolling, spinning] : {std::pair(0.01, 0.0), {0.0, 0.01}, {0.01, 0.01}}) {
    SCOPED_TRACE(testing::Message() << rolling << ", " << spinning);
    PinnedPlate pinned(0.01, 0.05, 0.7);
    pinned.plate.setRollingFriction(btScalar(rolling));
    pinned.plate.setSpinningFriction(btScalar(spinning));
    for (int step = 0; step < 60; ++step) {
      pinned.world.advance();
      ASSERT_EQ(pinned.world.report().incompatible, 1) << step;
    }
    const Plan& plan = pinned.world.report().plan;
    EXPECT_GT(plan.rolling + plan.spinning, 0);
    EXPECT_LT(pinned.feedback.m_appliedForceBodyA.length(), 1.1 * weight);
  }
}

// A ramp that lies on the floor, and a bit in it, with a hinge just behind its edge. To rise it has
// to slide, and friction would not let it, however hard it is pressed.
TEST(Quarrels, WhatFrictionHoldsInTheFloorRisesAsIfThereWereNone) {
  constexpr double halfHeight = 0.2, behind = 0.05;
  for (const double overlap : {1e-5, 1e-4, 1e-3}) {
    SCOPED_TRACE(testing::Message() << overlap << " m");
    DelassusWorld world;
    world.addGround();
    btRigidBody& ramp = world.addBox({btScalar(0.25), btScalar(halfHeight), btScalar(0.2)},
                                     {0, btScalar(halfHeight - overlap), 0});
    auto& hinge = world.addJoint<btHingeConstraint>(ramp, btVector3(btScalar(-0.25 - behind), 0, 0),
                                                    btVector3(0, 0, 1));
    hinge.setBreakingImpulseThreshold(btScalar(100 * weight * world.step));
    for (int step = 0; step < 60; ++step) {
      world.advance();
      ASSERT_EQ(world.report().outOfBudget, 0) << step;
      for (const btManifoldPoint* point : world.points())
        ASSERT_LT(point->getAppliedImpulse(), 10 * weight * world.step) << step;
    }
    EXPECT_TRUE(hinge.isEnabled());
    EXPECT_GT(ramp.getWorldTransform().getOrigin().y(), halfHeight - 0.1 * overlap);
  }
}

// A slider along a floor that it overlaps. Each corner may rise alone, by a turn about the axis,
// but not all of them.
TEST(Quarrels, WhatMayNotRiseSlidesOn) {
  for (const double overlap : {1e-6, 1e-5, 1e-3}) {
    SCOPED_TRACE(testing::Message() << overlap << " m");
    DelassusWorld world;
    world.addGround();
    btRigidBody& sledge = world.addBox({btScalar(0.2), btScalar(0.1), btScalar(0.2)},
                                       {0, btScalar(0.1 - overlap), 0});
    sledge.setFriction(btScalar(0.05));
    world.addJoint<btSliderConstraint>(sledge, btTransform::getIdentity(), true);
    sledge.setLinearVelocity({1, 0, 0});
    world.advance(60);
    // No weight presses it to the floor: the slider carries all.
    EXPECT_NEAR(sledge.getWorldTransform().getOrigin().x(), 1, tolerance(0.01, 0.02));
    EXPECT_EQ(world.report().outOfBudget, 0);
  }
}

// Beyond its edge the pin leaves the plate a way out of the floor.
TEST(Quarrels, APlateThatIsPinnedBesideTheFloorRises) {
  PinnedPlate pinned(0.01, -0.3, 0.7);
  pinned.world.advance(60);
  EXPECT_EQ(pinned.world.report().incompatible, 0);
  EXPECT_GT(pinned.height(), pinned.halfThickness);
}

// What lies in the same island without a quarrel of its own rises as it would without the pin.
TEST(Quarrels, OnlyWhoQuarrelsDoesWithoutRecovery) {
  constexpr double overlap = 0.01;
  PinnedPlate pinned(overlap, 0.2, 0.7);
  const double top = 2 * pinned.halfThickness - overlap;
  btRigidBody& crate =
      pinned.world.addBox({0.2, 0.2, 0.2}, {0.2, btScalar(top + 0.2 - overlap), 0}, 1);
  int quarrels = 0;
  for (int step = 0; step < 120; ++step) {
    pinned.world.advance();
    quarrels += pinned.world.report().incompatible;
  }
  EXPECT_GT(quarrels, 110);
  const double bottom = crate.getWorldTransform().getOrigin().y() - 0.2;
  EXPECT_GT(bottom, pinned.height() + pinned.halfThickness - 0.1 * overlap);
}

// Friction opposes the slip of bodies, not what the recovery moves.
TEST(Quarrels, FrictionBrakesAsEver) {
  constexpr double overlap = 0.01, speed = 1, time = 10 * h;
  PinnedPlate pinned(overlap, 0.5, 0.7);
  btRigidBody& crate = pinned.world.addBox(
      {btScalar(0.1), btScalar(0.1), btScalar(0.1)},
      {btScalar(-0.3), btScalar(2 * pinned.halfThickness - overlap + 0.1), 0}, 1);
  crate.setFriction(btScalar(0.5));
  crate.setLinearVelocity({btScalar(speed), 0, 0});
  for (int step = 0; step < 10; ++step) {
    pinned.world.advance();
    ASSERT_EQ(pinned.world.report().incompatible, 1) << step;
  }
  const double brake = crate.getFriction() * pinned.plate.getFriction() * g;
  EXPECT_NEAR(crate.getLinearVelocity().x(), speed - brake * time, 0.05 * speed);
}

// What a spring asks for is its force: it is no recovery.
TEST(Quarrels, SpringsKeepTheirForce) {
  constexpr double sag = 0.05;
  PinnedPlate pinned(0.01, 0.5, 0.7);
  btRigidBody& crate =
      pinned.world.addBox({btScalar(0.2), btScalar(0.2), btScalar(0.2)}, {0, btScalar(0.4), 0}, 1);
  const double stiffness = weight / sag / 4;  // of each of four points
  crate.setContactStiffnessAndDamping(btScalar(stiffness), btScalar(2 * std::sqrt(stiffness)));
  pinned.world.advance(240);
  EXPECT_EQ(pinned.world.report().incompatible, 1);
  const double bottom = crate.getWorldTransform().getOrigin().y() - 0.2;
  EXPECT_NEAR(pinned.height() + pinned.halfThickness - bottom, sag, 0.1 * sag);
}

// Once nothing contradicts, the exact answer is back.
TEST(Quarrels, EndWithThePin) {
  PinnedPlate pinned(0.01, 0.2, 0.7);
  pinned.world.addBox({btScalar(0.2), btScalar(0.2), btScalar(0.2)}, {0, btScalar(0.39), 0}, 50);
  pinned.world.advance(60);
  EXPECT_EQ(pinned.world.report().incompatible, 1);
  pinned.world.remove(pinned.pin);
  pinned.world.advance();
  for (int step = 0; step < 60; ++step) {
    pinned.world.advance();
    EXPECT_EQ(pinned.world.report().incompatible, 0) << step;
  }
}

// A bar of ten grams carries a tonne: its joint is strained, but by the load.
TEST(Quarrels, ALoadIsNoQuarrel) {
  constexpr double overlap = 0.01;
  DelassusWorld world;
  btRigidBody& bar = world.addBox({1, btScalar(0.05), btScalar(0.05)}, {0, 0, 0}, btScalar(0.01));
  bar.setAngularFactor(0);
  world.addJoint<btPoint2PointConstraint>(bar, btVector3(0, 0, 0));
  btRigidBody& load = world.addCube({0, btScalar(0.55 - overlap), 0}, 1000);
  load.setLinearFactor({0, 1, 0});
  load.setAngularFactor(0);
  for (int step = 0; step < 120; ++step) {
    world.advance();
    ASSERT_EQ(world.report().incompatible, 0) << step;
  }
  EXPECT_GT(load.getWorldTransform().getOrigin().y(), 0.55 - 0.1 * overlap);
}

// Two plates that lie in the floor, linked to each other and pinned at both ends. With few sweeps
// neither the exact answer nor a compromise is found to the end; the compromise is the better one.
TEST(Quarrels, PlatesBetweenPinsPressLittleWithFewSweeps) {
  constexpr double half = 0.3, overlap = 0.03, most = 10;  // m, m, N·s
  for (const int sweeps : {5, 10})
    for (const double behind : {0.05, 0.15}) {
      DelassusWorld world(Options::bounded(sweeps));
      world.addGround();
      const auto addPlate = [&](double x) -> btRigidBody& {
        return world.addBox({btScalar(half), btScalar(0.1), btScalar(half)},
                            {btScalar(x), btScalar(0.1 - overlap), 0});
      };
      btRigidBody &left = addPlate(0), &right = addPlate(2 * half);
      const btVector3 pin(btScalar(half - behind), 0, 0), edge(btScalar(half), 0, 0);
      world.addJoint<btPoint2PointConstraint>(left, -pin);
      world.addJoint<btPoint2PointConstraint>(left, right, edge, -edge);
      world.addJoint<btPoint2PointConstraint>(right, pin);
      for (int step = 0; step < 60; ++step) {
        world.advance();
        for (const btManifoldPoint* point : world.points())
          ASSERT_LT(point->getAppliedImpulse(), most)
              << sweeps << " sweeps, " << behind << " m, step " << step;
      }
    }
}

// Limbs on both sides of a thin wall, as of a figure that was thrown into it. Joints draw them into
// the wall, until friction wedges them. (Some steps pressed with up to 3e10 N·s, in float 3e8.)
TEST(Quarrels, LimbsJoinedAcrossAThinWallPressWithinReason) {
  constexpr double thick = 0.1, radius = 0.1, length = 0.3, most = 1e6;  // N·s
  for (int seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto direction = [&] {
      const double x = uniform(random, -1, 1), y = uniform(random, -1, 1);
      return btVector3(btScalar(x), btScalar(y), btScalar(uniform(random, -1, 1))).normalized();
    };
    DelassusWorld world;
    world.addGround();
    world.addBox({btScalar(thick / 2), 3, 3}, {0, 3, 0}, 0);
    btRigidBody* before = nullptr;
    for (int i = 0; i < 3; ++i) {
      const double x = (i % 2 == 0 ? -1 : 1) * (thick / 2 + uniform(random, 0.9, 1.05) * radius);
      const double y = uniform(random, 1.4, 1.6), z = uniform(random, -0.2, 0.2);
      const btVector3 axis = direction(), end(0, btScalar(2 * radius), 0);
      const btQuaternion turn(axis, btScalar(uniform(random, 0, 3)));
      btRigidBody& limb =
          world.addBody(std::make_unique<btCapsuleShape>(btScalar(radius), btScalar(length)),
                        btTransform(turn, btVector3(btScalar(x), btScalar(y), btScalar(z))), 3);
      if (before) world.addJoint<btPoint2PointConstraint>(*before, limb, end, -end);
      before = &limb;
    }
    for (int step = 0; step < 180; ++step) {
      world.advance();
      for (const btManifoldPoint* point : world.points())
        ASSERT_LT(point->getAppliedImpulse(), most) << step;
    }
  }
}

// Boxes in a plane, a centimetre in each other, under one that is two thousand times as heavy:
// their locked axes are strained by the load, too.
TEST(Quarrels, APileInAPlaneStandsUnderAHeavyBox) {
  constexpr int rows = 6;
  constexpr double overlap = 0.02;
  DelassusWorld world;
  world.addGround();
  btRigidBody* top = nullptr;
  for (int row = 0; row < rows; ++row)
    for (int k = 0; k < rows - row; ++k) {
      top = &world.addBox({btScalar(0.25), btScalar(0.25), btScalar(0.25)},
                          {btScalar((k - (rows - 1 - row) / 2.0) * 0.52),
                           btScalar(0.25 + (0.5 - overlap) * row), 0},
                          row == rows - 1 ? 2000 : 1);
      top->setLinearFactor({1, 1, 0});
      top->setAngularFactor({0, 0, 1});
    }
  world.advance(60);
  EXPECT_NEAR(top->getWorldTransform().getOrigin().y(), 0.25 + 0.5 * (rows - 1), 0.02);
}

}  // namespace
}  // namespace delassus::test
