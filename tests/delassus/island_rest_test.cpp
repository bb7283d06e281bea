/// Which kept islands are brought to rest, and which go on.
#include <gtest/gtest.h>

#include "delassus/island_check.h"
#include "delassus/solver.h"
#include "tests/support/random_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

/// A box of 1 kg on its base, with the reactions that hold it against gravity. `moved` has the
/// velocity that these leave if it moved at `velocity` before.
struct StandingBox {
  Pile pile;
  std::vector<Body> moved;
  Solution seen;
  bool isKept = false;

  StandingBox(const Vec6& velocity, bool hung, Random& random) {
    pile = makeTower({1}, 0.5, 0, random);
    Body& box = pile.bodies.back();
    box.velocity << 0, 0, -fall, 0, 0, 0;
    if (hung) {
      Row row;
      row.a = static_cast<int>(pile.bodies.size()) - 1;
      row.jacobianA << 1, 0, 0, 0, 0, 0;
      pile.rows.push_back(row);
    }
    Options tight;
    tight.tolerance = 1e-14;
    seen.r = Solver(tight).solve(PileIsland(pile).problem).r;
    box.velocity += velocity;
    moved = pile.bodies;
    const PileIsland island(pile);
    isKept = IslandCheck(Options()).isKept(pile.bodies, pile.contacts, pile.rows, island.island, 1,
                                           moved, seen);
  }
  const Vec6& left() const { return moved.back().velocity; }

  static constexpr double fall = 0.16;  ///< m/s a step, by gravity
};

// Motions slower than the tolerance are brought to rest, also those of a box on a joint.
TEST(IslandCheck, WhatIsKeptAtRestIsAtRest) {
  Random random(82);
  const double tolerance = Options().tolerance * StandingBox::fall;
  for (int axis = 0; axis < 6; ++axis)
    for (const double speed : {0.05 * tolerance, 0.3 * tolerance}) {
      const Vec6 velocity = speed * Vec6::Unit(axis);
      const StandingBox box(velocity, false, random), hung(velocity, true, random);
      EXPECT_TRUE(box.isKept && hung.isKept);
      EXPECT_TRUE(box.left().isZero(0)) << box.left().transpose();
      EXPECT_TRUE(hung.left().isZero(0)) << hung.left().transpose();
    }
}

/// The velocity that is left of a ball of 1 kg and 1 kg m². Its centre is at `height` above the
/// plane, on which its weight presses. It may be the second of the two bodies that touch.
Vec6 leftOfBall(double height, const Vec6& velocity, double tolerance, bool isSecond = false) {
  const double fall = StandingBox::fall;
  Pile pile;
  Body& ball = pile.bodies.emplace_back();
  ball.inverseMass.setOnes();
  ball.inverseInertia.setIdentity();
  ball.velocity = velocity - fall * Vec6::Unit(2);
  Contact& contact = pile.contacts.emplace_back();
  (isSecond ? contact.b : contact.a) = 0;
  (isSecond ? contact.armB : contact.armA) << 0, 0, -height;
  contact.frame << 0, 1, 0, 0, 0, 1, isSecond ? -1 : 1, 0, 0;
  const PileIsland island(pile);
  std::vector<Body> moved = pile.bodies;
  Options options;
  options.tolerance = tolerance;
  Solution seen;
  seen.r.setConstant(1, fall);
  EXPECT_TRUE(IslandCheck(options).isKept(pile.bodies, pile.contacts, pile.rows, island.island, 1,
                                          moved, seen));
  return moved[0].velocity;
}

// A ball that spins about the point on which it stands moves no point that touches, even less if
// that point is its centre.
TEST(IslandCheck, WhatSpinsIsNotAtRest) {
  for (const double height : {0.5, 0.0})
    EXPECT_EQ(leftOfBall(height, Vec6::Unit(5), 1e-8)[5], 1) << height;
}

// Points far out may not be slow, however slowly the centre moves.
TEST(IslandCheck, WhatSpinsFarOutIsNotAtRest) {
  constexpr double still = 1e-8 * StandingBox::fall, speed = 0.5 * still;
  for (const bool isSecond : {false, true}) {
    EXPECT_EQ(leftOfBall(1, speed * Vec6::Unit(5), 1e-8, isSecond)[5], 0);
    EXPECT_EQ(leftOfBall(5, speed * Vec6::Unit(5), 1e-8, isSecond)[5], speed);
  }
}

// So it is with what joints hold: here two rows that carry a body on both sides of its centre.
TEST(IslandCheck, WhatJointsHoldFarOutIsNotAtRest) {
  constexpr double still = 1e-8 * StandingBox::fall, speed = 0.5 * still;
  for (const double arm : {1.0, 20.0}) {
    Pile pile;
    Body& body = pile.bodies.emplace_back();
    body.inverseMass.setOnes();
    body.inverseInertia.setIdentity();
    body.velocity = speed * Vec6::Unit(5) - StandingBox::fall * Vec6::Unit(2);
    constexpr double scale = 3;  // of a row, which says nothing
    for (const double side : {-arm, arm}) {
      Row& row = pile.rows.emplace_back();
      row.a = 0;
      row.jacobianA << 0, 0, scale, 0, -scale * side, 0;
    }
    const PileIsland island(pile);
    std::vector<Body> moved = pile.bodies;
    Solution seen;
    seen.r.setConstant(2, StandingBox::fall / (2 * scale));
    ASSERT_TRUE(IslandCheck(Options()).isKept(pile.bodies, pile.contacts, pile.rows, island.island,
                                              1, moved, seen));
    EXPECT_EQ(moved[0].velocity[5], arm > 1 ? speed : 0) << arm;
  }
}

// A ball that nothing resists goes on, however loose the tolerance.
TEST(IslandCheck, WhatGlidesIsNotAtRest) {
  for (const double tolerance : {1e-10, 1e-8, 1e-3})
    EXPECT_EQ(leftOfBall(0.5, 1e-8 * Vec6::Unit(0), tolerance)[0], 1e-8) << tolerance;
}

}  // namespace
}  // namespace delassus
