/// The Newton matrices of one region after another, in the space of bodies.
#include "delassus/motion_space.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>
#include <vector>

#include "tests/support/box_piles.h"
#include "tests/support/hired_hands.h"
#include "tests/support/random_piles.h"
#include "tests/support/turning_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

/// Balls thrown together, with a motor; some contacts resist turning.
PileIsland heap(Random& random, int balls = 20) {
  Pile pile = makeHeap(balls, 0.5, random);
  resistTurning(pile, 0.1, random);
  pile.rows.insert(pile.rows.begin(), makeWeakMotor());  // those of the disks come last
  return PileIsland(pile);
}

/// A region in which about this share of the contacts is not open; its derivatives are not
/// symmetric.
Stiffness randomRegion(const Problem& problem, double share, Random& random) {
  Stiffness G;
  G.reset(problem);
  for (Mat3& contact : G.contacts)
    if (uniform(random, 0, 1) < share) {
      contact = randomDelassus(3, 10, random);
      contact(1, 2) += 0.3;
    }
  for (int i = 0; i < problem.disksBegin() - 3 * problem.contacts(); ++i)
    G.rows[i] = uniform(random, 0, 1);
  for (Stiffness::OfDisk& disk : G.disks) {
    disk.own = uniform(random, 0, 1) * Mat2::Identity();
    disk.governor.col(0) = Vec2(uniform(random, 0, 1), 0);
  }
  return G;
}

/// J̃ᵀ G J̃ x
VectorXd stiffnessTimes(const Stiffness& G, const Problem& problem, const VectorXd& x) {
  VectorXd u, sum;
  problem.W.bodySpace().relativeVelocity(x, u);
  VectorXd r = VectorXd::Zero(problem.size());
  for (int i = 0; i < problem.contacts(); ++i)
    r.segment<3>(3 * i) = G.contacts[i] * u.segment<3>(3 * i);
  r.tail(problem.rows()) = G.rows.cwiseProduct(u.tail(problem.rows()));
  for (std::size_t k = 0; k < problem.disks.size(); ++k) {
    const Disk& disk = problem.disks[k];
    disk.put(G.disks[k].own * disk.of(u) + G.disks[k].governor.col(0) * u[disk.governor], r);
  }
  problem.W.bodySpace().impulse(r, sum);
  return sum;
}

/// Expects that two factors answer alike, to the bit.
void expectSame(const BodyMotion& a, const BodyMotion& b, Random& random) {
  const VectorXd y = normalVector(a.size(), random);
  VectorXd x = y, z = y;
  a.solve(x);
  b.solve(z);
  EXPECT_EQ(x, z);
}

// The velocities that reactions cause where a region answers: J̃ K⁻¹ J̃ᵀ.
TEST(BodyMotion, CondensesToSomeUnknowns) {
  Random random(172);
  Pile pile = makeHeap(12, 0.5, random);
  pile.rows.push_back(makeWeakMotor());
  const PileIsland island(pile);
  const Problem& problem = island.problem;
  Stiffness G;
  G.reset(problem);
  for (int i = 0; i < problem.contacts(); i += 2) G.contacts[i] = randomDelassus(3, 10, random);
  BodyMotion motion;
  motion.setProblem(problem);
  ASSERT_TRUE(G.isSymmetric());
  ASSERT_TRUE(motion.factorise(G));
  const std::vector<int> unknowns = {0, 1, 2, 7, problem.size() - 1};
  KeptMatrix W;
  ASSERT_TRUE(motion.condense(unknowns, W));
  for (int j = 0; j < 5; ++j) {
    VectorXd r = VectorXd::Zero(problem.size()), y, u;
    r[unknowns[j]] = 1;
    motion.impulse(r, y);
    motion.solve(y);
    motion.relativeVelocity(y, u);
    for (int i = 0; i < 5; ++i) EXPECT_NEAR(W(i, j), u[unknowns[i]], 1e-12);
  }
}

// More contacts of the same two bodies, and of one body with the world, than are taken together.
TEST(BodyMotion, TakesAnyNumberOfContactsOfTheSameBodies) {
  Random random(174);
  for (int times = 1; times < 20; ++times) {
    Pile pile = makeHeap(3, 0.5, random);
    const std::vector<Contact> once = std::move(pile.contacts);
    pile.contacts.clear();
    for (const Contact& contact : once)
      for (int k = 0; k < times; ++k) {
        Contact& another = pile.contacts.emplace_back(contact);
        another.armA += 0.1 * normalVector(3, random);
        another.armB += 0.1 * normalVector(3, random);
      }
    const PileIsland island(pile);
    BodyMotion motion;
    motion.setProblem(island.problem);
    const Stiffness G = randomRegion(island.problem, 0.8, random);
    ASSERT_TRUE(motion.factorise(G));
    const VectorXd y = normalVector(motion.size(), random);
    VectorXd x = y;
    motion.solve(x);
    EXPECT_LE((x + stiffnessTimes(G, island.problem, x) - y).norm(), 1e-9 * y.norm()) << times;
  }
}

// Symmetric, but not positive definite: it has a factor, though not that of Cholesky.
TEST(BodyMotion, FactorsWhatIsIndefinite) {
  Random random(173);
  const PileIsland island = heap(random);
  const Problem& problem = island.problem;
  Stiffness G;
  G.reset(problem);
  for (Mat3& block : G.contacts) block = -randomDelassus(3, 10, random);
  BodyMotion motion;
  motion.setProblem(problem);
  ASSERT_TRUE(G.isSymmetric());
  ASSERT_TRUE(motion.factorise(G));
  const VectorXd y = normalVector(motion.size(), random);
  VectorXd x = y;
  motion.solve(x);
  EXPECT_LE((x + stiffnessTimes(G, problem, x) - y).norm(), 1e-10 * y.norm());
  KeptMatrix W;
  EXPECT_FALSE(motion.condense({0}, W));
}

TEST(BodyMotion, FactorsOneRegionAfterTheOtherWhateverContactsItHolds) {
  Random random(171);
  for (int k = 0; k < 20; ++k) {
    const PileIsland island = heap(random);
    const Problem& problem = island.problem;
    BodyMotion motion;
    motion.setProblem(problem);
    for (const double share : {0.1, 0.1, 0.9, 0.5, 0.0, 1.0}) {
      const Stiffness G = randomRegion(problem, share, random);
      ASSERT_TRUE(motion.factorise(G));
      const VectorXd y = normalVector(motion.size(), random);
      VectorXd x = y;
      motion.solve(x);
      EXPECT_LE((x + stiffnessTimes(G, problem, x) - y).norm(), 1e-10 * y.norm());
    }
  }
}

TEST(BodyMotion, HasNoMemoryOfRegionsOfAnotherProblem) {
  Random random(172);
  const PileIsland one = heap(random), other = heap(random);
  const Stiffness all = randomRegion(one.problem, 1, random);
  const Stiffness few = randomRegion(other.problem, 0.2, random);
  BodyMotion used, fresh;
  used.setProblem(one.problem);
  ASSERT_TRUE(used.factorise(all));
  for (BodyMotion* motion : {&used, &fresh}) {
    motion->setProblem(other.problem);
    ASSERT_TRUE(motion->factorise(few));
  }
  expectSame(used, fresh, random);
}

TEST(BodyMotion, WhatIsOpenTakesNoRoom) {
  Random random(173);
  const PileIsland island(makeHeap(60, 0.5, random));
  const auto bytes = [&](double share) {
    BodyMotion motion;
    motion.setProblem(island.problem);
    EXPECT_TRUE(motion.factorise(randomRegion(island.problem, share, random)));
    return motion.bytes();
  };
  EXPECT_LT(2 * bytes(0.03), bytes(1));
}

// Pairs that are open again give their room back: the factor is that of a motion that never held
// them.
TEST(BodyMotion, WhatOpensGivesItsRoomBack) {
  Random random(175);
  const PileIsland island(makeHeap(60, 0.5, random));
  const Stiffness all = randomRegion(island.problem, 1, random);
  const Stiffness few = randomRegion(island.problem, 0.2, random);
  BodyMotion used, fresh;
  used.setProblem(island.problem);
  fresh.setProblem(island.problem);
  ASSERT_TRUE(used.factorise(all));
  ASSERT_TRUE(used.factorise(few));
  ASSERT_TRUE(fresh.factorise(few));
  expectSame(used, fresh, random);
}

/// Boxes piled up to a pyramid, with joints of three rows between some of them. In contrast to a
/// heap of balls that resist turning, all of K is added when the turn of its columns comes.
PileIsland pyramid(int base, Random& random) {
  Pile pile = makePyramid(base, 0.5, 0.1, 1, random);
  const auto bodies = static_cast<int>(pile.bodies.size());
  for (int body = 0; body + 3 < bodies; body += 5)
    for (int k = 0; k < 3; ++k) {
      Row& row = pile.rows.emplace_back(makeWeakMotor());
      row.a = body + 3;
      row.b = body;
      row.jacobianB = normalVector(6, random);
    }
  return PileIsland(pile);
}

// One motion after the other, large and small.
TEST(BodyMotion, HandsDoNotChangeABitOfPyramids) {
  Random random(216);
  HiredHands hands(3);
  BodyMotion together;
  together.setHands(&hands);
  int shared = 0;
  for (const int base : {8, 2, 9, 8}) {
    const PileIsland island = pyramid(base, random);
    const Stiffness G = randomRegion(island.problem, 0.9, random);
    BodyMotion alone;
    for (BodyMotion* motion : {&alone, &together}) {
      motion->setProblem(island.problem);
      ASSERT_TRUE(motion->factorise(G));
    }
    const VectorXd y = normalVector(alone.size(), random);
    VectorXd a = y, b = y;
    alone.solve(a);
    together.solve(b);
    EXPECT_EQ(a, b) << base;
    EXPECT_LE((a + stiffnessTimes(G, island.problem, a) - y).norm(), 1e-9 * y.norm());
    shared += base > 2;
    EXPECT_EQ(hands.tasks, shared);
  }
}

TEST(BodyMotion, HandsDoNotChangeABitOfHeaps) {
  Random random(212);
  const PileIsland island = heap(random, 150);
  const Stiffness sliding = randomRegion(island.problem, 1, random);
  Stiffness sticking = sliding, indefinite = sliding;
  for (std::size_t i = 0; i < sliding.contacts.size(); ++i) {
    sticking.contacts[i](1, 2) = sticking.contacts[i](2, 1);
    indefinite.contacts[i] = -sticking.contacts[i];
  }
  for (std::size_t k = 0; k < sliding.disks.size(); ++k)
    sticking.disks[k].governor = indefinite.disks[k].governor = Mat23::Zero();
  ASSERT_FALSE(sliding.isSymmetric());
  ASSERT_TRUE(sticking.isSymmetric() && indefinite.isSymmetric());
  const std::vector<Stiffness> regions = {sticking, sliding, indefinite};
  for (const Stiffness& G : regions) {
    BodyMotion alone;
    alone.setProblem(island.problem);
    ASSERT_TRUE(alone.factorise(G));
    const VectorXd y = normalVector(alone.size(), random);
    VectorXd x = y;
    alone.solve(x);
    for (const int count : {1, 2, 4}) {
      HiredHands hands(count);
      BodyMotion together;
      together.setHands(&hands);
      together.setProblem(island.problem);
      for (int again = 1; again <= 3; ++again) {
        ASSERT_TRUE(together.factorise(G));
        EXPECT_EQ(hands.tasks, again * (&G == &regions.back() ? 2 : 1));
        VectorXd z = y;
        together.solve(z);
        EXPECT_EQ(z, x) << count << " hands";
        EXPECT_EQ(together.isDeterminantNegative(), alone.isDeterminantNegative());
      }
    }
  }
}

// A bound that has been overdrawn turns the sign of one pivot, whichever hand finds it.
TEST(BodyMotion, HandsAgreeOnTheSignOfTheDeterminant) {
  Random random(213);
  const PileIsland island = heap(random, 150);
  HiredHands hands(3);
  int negative = 0;
  for (int k = 0; k < 12; ++k) {
    Stiffness G = randomRegion(island.problem, 1, random);
    for (int i = 0; i < k; ++i) G.contacts[4 * i](0, 0) -= 1e4;
    BodyMotion alone, together;
    together.setHands(&hands);
    for (BodyMotion* motion : {&alone, &together}) {
      motion->setProblem(island.problem);
      ASSERT_TRUE(motion->factorise(G));
    }
    EXPECT_EQ(together.isDeterminantNegative(), alone.isDeterminantNegative()) << k;
    EXPECT_EQ(hands.tasks, k + 1);
    negative += alone.isDeterminantNegative();
  }
  EXPECT_GT(negative, 2);
  EXPECT_LT(negative, 10);
}

// One hand meets the broken pivot while the others are at work or wait for it.
TEST(BodyMotion, HandsGiveUpTogether) {
  Random random(214);
  const PileIsland island = heap(random, 150);
  const Stiffness sound = randomRegion(island.problem, 1, random);
  for (const int broken : {0, 100, 200}) {
    ASSERT_LT(broken, island.problem.contacts());
    Stiffness G = sound;
    G.contacts[broken](0, 0) = std::numeric_limits<double>::quiet_NaN();
    HiredHands hands(3);
    BodyMotion together, alone;
    together.setHands(&hands);
    together.setProblem(island.problem);
    EXPECT_FALSE(together.factorise(G)) << broken;
    // Nothing of the failure is left.
    alone.setProblem(island.problem);
    ASSERT_TRUE(alone.factorise(sound));
    ASSERT_TRUE(together.factorise(sound));
    EXPECT_EQ(hands.tasks, 2);
    expectSame(alone, together, random);
  }
}

TEST(BodyMotion, CallsNoHandsForAFewBodies) {
  Random random(215);
  const PileIsland island = heap(random);
  HiredHands hands(2);
  BodyMotion motion;
  motion.setHands(&hands);
  motion.setProblem(island.problem);
  ASSERT_TRUE(motion.factorise(randomRegion(island.problem, 1, random)));
  EXPECT_EQ(hands.tasks, 0);
}

}  // namespace
}  // namespace delassus
