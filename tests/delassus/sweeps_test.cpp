/// Block Gauss-Seidel with both kinds of acceleration.
#include "delassus/sweeps.h"

#include <gtest/gtest.h>

#include "delassus/one_contact.h"
#include "tests/support/random_piles.h"
#include "tests/support/turning_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

/// 0: conjugate gradient; otherwise Anderson's acceleration, with so many steps remembered.
constexpr int memories[] = {0, 4, Anderson::longest};

void sweep(Sweeps& sweeps, int count, int memory, VectorXd& r) {
  if (memory > 0)
    sweeps.sweepOn(count, memory, r);
  else
    sweeps.sweep(count, r);
}

VectorXd swept(const Problem& problem, int count, VectorXd r, int memory = 0) {
  NaturalMap map;
  map.setProblem(problem);
  Sweeps sweeps;
  sweeps.setProblem(problem, map);
  sweep(sweeps, count, memory, r);
  return r;
}

/// A tower with friction, a motor and a joint; both rows have bounds, of different kinds.
PileIsland towerWithRows(int height, Random& random) {
  Pile pile = makeTower(randomMasses(height, 10, random), 0, 0.3, random);
  mixFriction(pile, 1, random);
  pile.rows.push_back(makeWeakMotor());
  Row joint;
  joint.a = height - 1;
  joint.jacobianA << 1, 0, 0, 0, 0.5, 0;
  joint.compliance = 0.01;
  pile.rows.push_back(joint);
  return PileIsland(pile);
}

TEST(Sweeps, ReactionsStayInTheirConesAndBounds) {
  Random random(41);
  for (int k = 0; k < 60; ++k) {
    const PileIsland island = towerWithRows(1 + k % 5, random);
    const VectorXd start = randomReactions(island.problem, 3, random);
    for (const int memory : memories) {
      for (const int count : {1, 2, 7, 20}) {
        const VectorXd r = swept(island.problem, count, start, memory);
        EXPECT_LE(infeasibility(island.problem, r), 1e-15 * (1 + r.norm())) << count << " sweeps";
      }
    }
  }
}

TEST(Sweeps, OneContactAloneNeedsOneSweep) {
  Random random(42);
  for (int k = 0; k < 100; ++k) {
    Pile pile;
    pile.bodies.push_back(makeBox(uniform(random, 1, 10), 0.5, normalVector(6, random)));
    pile.contacts.push_back(makeRestingPoint(0, fixedWorld, 0.5 * normalVector(3, random),
                                             Vec3::Zero(), uniform(random, 0.1, 1)));
    const Problem problem = PileIsland(pile).problem;
    const VectorXd exact =
        solveOneContact(problem.W.contactBlock(0), problem.q, problem.friction[0]);
    const VectorXd r = swept(problem, 1, randomReactions(problem, 1, random));
    EXPECT_LT((r - exact).norm(), 1e-10 * (1 + exact.norm()));
  }
}

// Without friction each row in turn finds the least value of ½ rᵀW r + qᵀr along itself (Gauss'
// principle). So a sweep descends.
TEST(Sweeps, OneSweepNeverRaisesTheGaussianCostOfFrictionlessIslands) {
  Random random(43);
  for (int k = 0; k < 60; ++k) {
    const PileIsland island(
        withoutFriction(makeTower(randomMasses(1 + k % 6, 1e3, random), 0, 0.5, random)));
    const auto cost = [&](const VectorXd& r) {
      return 0.5 * r.dot(island.problem.W * r) + r.dot(island.problem.q);
    };
    VectorXd r = randomReactions(island.problem, 3, random);
    for (int sweep = 0; sweep < 20; ++sweep) {
      const VectorXd next = swept(island.problem, 1, r);
      EXPECT_LE(cost(next), cost(r) + 1e-13 * (std::abs(cost(r)) + r.norm()));
      r = next;
    }
  }
}

// Sweeps leave a solution where it is.
TEST(Sweeps, ASolutionIsAFixedPoint) {
  Random random(44);
  for (int k = 0; k < 20; ++k) {
    const PileIsland island = towerWithRows(1 + k % 2, random);
    const VectorXd r = swept(island.problem, 20000, VectorXd::Zero(island.problem.size()));
    ASSERT_LT(naturalResidual(island.problem, r).max, 1e-9);
    for (const int memory : memories)
      EXPECT_LT((swept(island.problem, 5, r, memory) - r).norm(), 1e-7 * (1 + r.norm())) << k;
  }
}

TEST(Sweeps, TheStorageOfWDoesNotMatter) {
  Random random(45);
  for (int k = 0; k < 30; ++k) {
    PileIsland island = towerWithRows(1 + k % 5, random);
    island.problem.roundOff = 0;
    const VectorXd start = randomReactions(island.problem, 1, random);
    const VectorXd inBodySpace = swept(island.problem, 8, start);
    const VectorXd explicitly = swept(withEntries(island.problem), 8, start);
    EXPECT_LT((inBodySpace - explicitly).norm(), 1e-9 * (1 + explicitly.norm()));
  }
}

TEST(Sweeps, NoneMeansNone) {
  Random random(46);
  const PileIsland island = towerWithRows(3, random);
  const VectorXd start = randomReactions(island.problem, 1, random);
  EXPECT_EQ(swept(island.problem, 0, start), start);
}

// A row that nothing can move, in either storage.
TEST(Sweeps, RowsThatNothingMovesAreLeftAlone) {
  Random random(47);
  PileIsland island = towerWithRows(1, random);
  Row idle;
  idle.a = 0;
  idle.target = -1;
  idle.lower = 0;
  island.pile.rows.push_back(idle);
  const Problem problem = PileIsland(island.pile).problem;
  VectorXd start = randomReactions(problem, 1, random);
  const Eigen::Index last = start.size() - 1;
  start[last] = 0.25;
  for (const Problem& same : {problem, withEntries(problem)}) {
    const VectorXd r = swept(same, 5, start);
    EXPECT_TRUE(r.allFinite());
    EXPECT_EQ(r[last], 0.25);
  }
}

// One object serves many islands, with each acceleration in turn: nothing of the last one shows.
TEST(Sweeps, HaveNoMemory) {
  Random random(48);
  const PileIsland large = towerWithRows(4, random), small = towerWithRows(1, random);
  const VectorXd start = VectorXd::Zero(small.problem.size());
  NaturalMap largeMap, smallMap;
  largeMap.setProblem(large.problem);
  smallMap.setProblem(small.problem);
  Sweeps used;
  VectorXd r;
  for (const int last : memories) {
    for (const int memory : memories) {
      used.setProblem(large.problem, largeMap);
      r = VectorXd::Zero(large.problem.size());
      sweep(used, 5, last, r);
      used.setProblem(small.problem, smallMap);
      r = start;
      sweep(used, 5, last, r);
      r = start;
      sweep(used, 5, memory, r);
      EXPECT_EQ(r, swept(small.problem, 5, start, memory));
    }
  }
}

// Anderson's acceleration remembers steps of one problem and of the sweeps just before. If anything
// else came in between, it forgets them.
TEST(Sweeps, AndersonsForgetWhatIsOfAnotherProblemOrOtherSweeps) {
  Random random(50);
  for (int k = 0; k < 10; ++k) {
    const auto makeProblem = [&] {
      return PileIsland(makeTower({1, 2, 3}, 0.5, 0.3, random)).problem;
    };
    const Problem problem = makeProblem(), other = makeProblem();
    ASSERT_EQ(problem.size(), other.size());
    NaturalMap map, otherMap;
    map.setProblem(problem);
    otherMap.setProblem(other);
    Sweeps used;
    used.setProblem(other, otherMap);
    VectorXd r = VectorXd::Zero(problem.size());
    used.sweepOn(5, 4, r);
    used.setProblem(problem, map);
    VectorXd expected = swept(problem, 5, r, 4);
    used.sweepOn(5, 4, r);
    EXPECT_EQ(r, expected);
    used.sweep(5, r);
    expected = swept(problem, 5, r, 4);
    used.sweepOn(5, 4, r);
    EXPECT_EQ(r, expected);
  }
}

// Sweeps in one call are accelerated; sweeps in calls of one sweep each are not.
TEST(Sweeps, TheConjugateGradientHurriesThem) {
  Random random(51);
  for (const int height : {4, 8, 16}) {
    const Problem problem =
        PileIsland(makeTower(randomMasses(height, 1, random), 0.5, 0, random)).problem;
    constexpr int count = 60;
    const VectorXd start = VectorXd::Zero(problem.size());
    VectorXd plain = start;
    for (int n = 0; n < count; ++n) plain = swept(problem, 1, plain);
    EXPECT_LT(naturalResidual(problem, swept(problem, count, start)).max,
              0.3 * naturalResidual(problem, plain).max)
        << height;
  }
}

TEST(Sweeps, PlainOnesAreOneAfterTheOther) {
  Random random(52);
  const PileIsland island = towerWithRows(6, random);
  const Problem& problem = island.problem;
  constexpr int count = 40;
  VectorXd one = VectorXd::Zero(problem.size()), all = one;
  for (int n = 0; n < count; ++n) one = swept(problem, 1, one);
  NaturalMap map;
  map.setProblem(problem);
  Sweeps sweeps;
  sweeps.setProblem(problem, map);
  sweeps.sweepPlainly(count, all);
  EXPECT_LT((all - one).norm(), 1e-12 * one.norm());
  EXPECT_GT((swept(problem, count, VectorXd::Zero(problem.size())) - one).norm(), 1e-6 * one.norm())
      << "hurried ones go elsewhere";
}

// One call uses what the last one has learnt: in small bites as few sweeps are needed as in one.
TEST(Sweeps, AndersonsGoOnFromWhatTheyLearnt) {
  Random random(49);
  constexpr int problems = 20, bites = 6, bite = 10, memory = 8;
  double inBites = 0, alone = 0;
  for (int k = 0; k < problems; ++k) {
    const Problem problem = PileIsland(makeHeap(12, 0.4, random)).problem;
    NaturalMap map;
    map.setProblem(problem);
    Sweeps sweeps;
    sweeps.setProblem(problem, map);
    VectorXd r = VectorXd::Zero(problem.size());
    for (int n = 0; n < bites; ++n) sweeps.sweepOn(bite, memory, r);
    inBites += std::log10(naturalResidual(problem, r).max);
    r.setZero();
    for (int n = 0; n < bites; ++n) r = swept(problem, bite, r, memory);
    alone += std::log10(naturalResidual(problem, r).max);
  }
  EXPECT_LT(inBites, alone - 0.5 * problems);
}

}  // namespace
}  // namespace delassus
