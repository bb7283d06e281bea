/// Split impulse pushes bodies out of each other exactly, unless they are pinched.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

/// The longest way, m, that a body makes in one of a few steps. It is deep in a floor and in a
/// shelf, which lean against each other.
double furthestStep(BulletWorld& world, bool isBall, double lean, double depth, int steps = 20) {
  constexpr double half = 0.25;
  world.addBox({50, 1, 50}, {0, -1, 0}, 0);
  const btQuaternion turn({0, 0, 1}, btScalar(lean));
  const btVector3 up = quatRotate(turn, btVector3(0, 1, 0));
  const double gap = 2 * (half - depth);
  world.addBody(std::make_unique<btBoxShape>(btVector3(2, 0.25, 2)),
                btTransform(turn, btVector3(0, btScalar(gap), 0) + up * btScalar(0.25)), 0);
  const btVector3 middle(0, btScalar(gap / 2), 0);
  const btRigidBody& body =
      isBall ? world.addSphere(half, middle, 1) : world.addBox({half, half, half}, middle, 1);
  double furthest = 0;
  for (int step = 0; step < steps; ++step) {
    const btVector3 before = body.getWorldTransform().getOrigin();
    world.advance();
    const double moved = (body.getWorldTransform().getOrigin() - before).length();
    furthest = std::max(furthest, moved);
  }
  return furthest;
}

// In a wedge the exact push is in proportion to 1/lean.
TEST(Push, WhatIsPinchedIsNotThrown) {
  constexpr double depth = 0.06, recovery = 0.2 * depth;
  for (const bool isBall : {true, false})
    for (const double lean : {0.3, 1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 0.0}) {
      SCOPED_TRACE(testing::Message() << (isBall ? "ball, lean " : "box, lean ") << lean);
      DelassusWorld world;
      EXPECT_LT(furthestStep(world, isBall, lean, depth), 30 * recovery);
    }
}

// The pushes of a column add up, and its foot touches the floor without overlap.
TEST(Push, DrivesNothingIntoWhatItTouches) {
  for (const double apart : {0.1, 0.5, 0.8}) {
    SCOPED_TRACE(apart);
    constexpr int boxes = 15;
    constexpr double recovery = 0.2;
    DelassusWorld world;
    world.addGround();
    std::vector<btRigidBody*> column;
    for (int i = 0; i < boxes; ++i)
      column.push_back(&world.addCube({0, btScalar(0.5 + apart * i), 0}));
    const double deepest = 1 - apart;
    for (int step = 0; step < 120; ++step) {
      world.advance();
      for (const btRigidBody* box : column)
        ASSERT_GT(box->getWorldTransform().getOrigin().y(), 0.5 - recovery * deepest - 0.01)
            << step;
    }
  }
}

// A few sweeps over bodies at one place raise the residual, and are all that moves them.
TEST(Push, FewSweepsTakeBodiesApart) {
  constexpr int spheres = 20;
  constexpr double radius = 0.5;
  for (const bool isSplit : {true, false})
    for (const int sweeps : {2, 10, 50}) {
      SCOPED_TRACE(testing::Message() << sweeps << " sweeps" << (isSplit ? "" : ", not split"));
      OwningWorld<btDiscreteDynamicsWorld, btDelassusConstraintSolver> world(
          std::make_unique<btDelassusConstraintSolver>(Options::bounded(sweeps)));
      world.info().m_splitImpulse = isSplit;
      world.addGround();
      std::vector<btRigidBody*> all;
      for (int i = 0; i < spheres; ++i) all.push_back(&world.addSphere(radius, {0, 1, 0}, 1));
      world.advance(180);
      for (std::size_t i = 0; i < all.size(); ++i) {
        const btVector3& place = all[i]->getWorldTransform().getOrigin();
        // Unless they are split, recoveries set bodies in motion, and some leave the ground.
        if (isSplit) {
          EXPECT_GT(place.y(), 0.9 * radius) << i;
        }
        for (std::size_t j = 0; j < i; ++j)
          EXPECT_GT((place - all[j]->getWorldTransform().getOrigin()).length(), 1.9 * radius)
              << i << ", " << j;
      }
    }
}

TEST(Push, WhatIsPinchedIsReported) {
  DelassusWorld pinched;
  furthestStep(pinched, true, 1e-3, 0.06);
  EXPECT_EQ(pinched.report().pushSoftened, 1);
}

// The pushes of a column are solved again. That changes nothing for others.
TEST(Push, IslandsDoNotMeddle) {
  DelassusWorld alone, beside;
  for (int i = 0; i < 15; ++i) beside.addCube({40, btScalar(0.5 + 0.1 * i), 0});
  EXPECT_EQ(furthestStep(alone, true, 1e-1, 0.06, 1), furthestStep(beside, true, 1e-1, 0.06, 1));
  EXPECT_EQ(alone.report().pushSoftened, 1);
  EXPECT_EQ(beside.report().pushSoftened, 1);
}

// In a plane world, a thing behind a body touches it with a small part of its normal in the plane.
TEST(Push, WhatIsBehindAPlaneWorldThrowsNothing) {
  for (const double lean : {1e-5, 1e-3, 1e-2}) {
    SCOPED_TRACE(lean);
    DelassusWorld world;
    world.addGround();
    const btTransform behind(btQuaternion({0, 1, 0}, btScalar(lean)),
                             {0, btScalar(2.1), btScalar(-0.9)});
    world.addBody(std::make_unique<btBoxShape>(btVector3(10, 2, 0.5)), behind, 0);
    btRigidBody& player = world.addBox({0.5, 0.5, 0.5}, {0, 0.5, 0}, 1);
    player.setLinearFactor({1, 1, 0});
    player.setAngularFactor(btVector3(0, 0, 1));
    for (int step = 0; step < 20; ++step) {
      const btVector3 before = player.getWorldTransform().getOrigin();
      world.advance();
      EXPECT_LT((player.getWorldTransform().getOrigin() - before).length(), 30 * 0.2 * 0.1) << step;
    }
  }
}

// Each box goes as far as all overlaps below it together: exactly, since no box slips past another.
TEST(Push, StacksThatOverlapArePushedExactly) {
  constexpr int boxes = 10;
  constexpr double depth = 0.05;
  DelassusWorld world;
  world->setGravity({0, 0, 0});
  world.addGround();
  std::vector<btRigidBody*> stack;
  for (int i = 0; i < boxes; ++i)
    stack.push_back(&world.addBox({0.5, 0.5, 0.5}, {0, btScalar(0.5 + i - (i + 1) * depth), 0}, 1));
  world.advance();
  EXPECT_EQ(world.report().pushSoftened, 0);
  for (int i = 0; i < boxes; ++i)
    EXPECT_NEAR(stack[i]->getWorldTransform().getOrigin().y(), 0.5 + i - 0.8 * (i + 1) * depth,
                tolerance(1e-9, 1e-5))
        << i;
}

// The boxes lift a plate off a post, in which it is deep as well. The plate leaves as fast as it
// must.
TEST(Push, WhatLeavesIsNoSlip) {
  constexpr int boxes = 15;
  constexpr double depth = 0.05;
  DelassusWorld world;
  world->setGravity({0, 0, 0});
  world.addGround();
  btRigidBody* plate = nullptr;
  for (int i = 0; i < boxes; ++i)
    plate = &world.addBox({btScalar(i + 1 < boxes ? 0.5 : 1.5), 0.5, 0.5},
                          {0, btScalar(0.5 + i - (i + 1) * depth), 0}, 1);
  const double y = plate->getWorldTransform().getOrigin().y();
  world.addBox({btScalar(0.1), 1, 0.5}, {btScalar(1.2), btScalar(y - 1.5 + depth), 0}, 0);
  world.advance();
  EXPECT_EQ(world.report().pushSoftened, 0);
  EXPECT_NEAR(plate->getWorldTransform().getOrigin().y() - y, 0.2 * boxes * depth,
              tolerance(1e-9, 1e-5));
}

/// What a push does in one step to a tilted cube, one edge of which is deep in the ground.
struct Pushed {
  double rise, turn;
};
Pushed pushLeaning(BulletWorld& world, double turnErp) {
  constexpr double lean = 0.1;
  world->setGravity({0, 0, 0});
  world.info().m_splitImpulseTurnErp = btScalar(turnErp);
  world.addGround();
  const btTransform start(btQuaternion({0, 0, 1}, btScalar(lean)), {0, btScalar(0.46), 0});
  btRigidBody& cube =
      world.addBody(std::make_unique<btBoxShape>(btVector3(0.5, 0.5, 0.5)), start, 1);
  world.advance();
  EXPECT_NEAR(cube.getAngularVelocity().length(), 0, 1e-6) << "it leaves no velocity";
  const btTransform& pose = cube.getWorldTransform();
  const btVector3 side = pose.getBasis().getColumn(0);
  return {pose.getOrigin().y() - start.getOrigin().y(), std::atan2(side.y(), side.x()) - lean};
}

TEST(Parity, Row11PushTurnsByItsShare) {
  DelassusWorld whole;
  const Pushed all = pushLeaning(whole, 1);
  EXPECT_GT(std::abs(all.turn), 1e-3);
  for (const double share : {0.0, 0.1, 0.5}) {
    DelassusWorld ours;
    StockWorld stock;
    const Pushed a = pushLeaning(ours, share), b = pushLeaning(stock, share);
    EXPECT_NEAR(a.turn, share * all.turn, tolerance(1e-12, 2e-5)) << share;
    EXPECT_NEAR(a.rise, all.rise, tolerance(1e-12, 2e-5));
    EXPECT_NEAR(a.turn, b.turn, tolerance(1e-9, 2e-5));
    EXPECT_NEAR(a.rise, b.rise, tolerance(1e-9, 2e-5));
  }
}

}  // namespace
}  // namespace delassus::test
