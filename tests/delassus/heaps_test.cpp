/// Heaps of hundreds of contacts and more, large (pile_kind.h) or not, in which the walk loses its
/// way, and the methods that find back (search_find_back.cpp).
#include <gtest/gtest.h>

#include "delassus/residual.h"
#include "delassus/solver.h"
#include "tests/support/random_piles.h"
#include "tests/support/sphere_heaps.h"

namespace delassus {
namespace {

using namespace delassus::test;

/// About 400 contacts: a small heap.
PileIsland makeHeapOfHundreds(int seed) {
  Random random(seed);
  return PileIsland(makeSphereHeap(200, 4.7, 0.5, 0.1, random));
}

/// About a thousand.
PileIsland makeHeapOfMany(int spheres, int seed) {
  Random random(seed);
  PileIsland heap(makeSphereHeap(spheres, 7, 0.5, 0.1, random));
  EXPECT_GT(heap.problem.contacts(), 1000);
  return heap;
}

/// Reactions as a step finds them after a step that had little time.
VectorXd sweptReactions(const Problem& problem) {
  Options few;
  few.sweepBudget = 200;
  few.newtonBudget = 1;
  return Solver(few).solve(problem).r;
}

void expectSolved(const Problem& problem, const Options& options, const Solution& solution) {
  EXPECT_EQ(solution.status, Status::Solved);
  EXPECT_LE(naturalResidual(problem, solution.r).max,
            options.tolerance * problem.q.cwiseAbs().maxCoeff());
  EXPECT_LT(infeasibility(problem, solution.r), 1e-14);
}

/// Solves it without the path of compliance, from the reactions that few sweeps left.
Solution solveWithoutPath(const Problem& problem) {
  Options options;
  options.pathBudget = 0;
  const Solution solution = Solver(options).solve(problem, sweptReactions(problem));
  if (solution.status == Status::Solved) expectSolved(problem, options, solution);
  return solution;
}

/// In some of these heaps the path solves what nothing else does, except long walks.
void expectHardened(const std::vector<PileIsland>& heaps) {
  int hardened = 0;
  for (const PileIsland& heap : heaps) {
    Options options;
    options.newtonBudget = options.regionsInVain();
    const VectorXd start = sweptReactions(heap.problem);
    const Solution solution = Solver(options).solve(heap.problem, start);
    if (solution.status != Status::Solved) continue;
    expectSolved(heap.problem, options, solution);
    options.pathBudget = 0;
    hardened += Solver(options).solve(heap.problem, start).status == Status::OutOfBudget;
  }
  EXPECT_GT(hardened, 0);
}

// From the reactions that few sweeps left, and from none.
TEST(SmallHeap, IsSolved) {
  int solved = 0;
  for (const int seed : {1, 5, 10}) {
    const PileIsland heap = makeHeapOfHundreds(seed);
    for (const VectorXd& start : {sweptReactions(heap.problem), VectorXd()}) {
      const Solution solution = Solver().solve(heap.problem, start);
      if (solution.status != Status::Solved) continue;
      expectSolved(heap.problem, Options(), solution);
      ++solved;
    }
  }
  EXPECT_GE(solved, 5) << "of 6";
}

// The budget does not limit the path of compliance, so under a budget there is none.
TEST(Heaps, CostNoMoreThanIsAllowed) {
  for (const PileIsland& heap : {makeHeapOfHundreds(1), makeHeapOfMany(640, 6)})
    for (const int sweeps : {100, 300, 1000}) {
      const Options options = Options::bounded(sweeps);
      const Solution solution = Solver(options).solve(heap.problem, sweptReactions(heap.problem));
      EXPECT_LE(solution.sweeps, options.sweepBudget);
      EXPECT_LE(solution.regions, options.newtonBudget);
      EXPECT_LE(solution.factorisations, 2 * options.newtonBudget);
    }
}

// The guess is spoilt, as one sweep leaves it for the next step. From it, the sweep may end hardly
// farther off than from no reactions.
TEST(Heaps, OneSweepIsNoWorseFromSpoiltReactionsThanFromNone) {
  const PileIsland heap = makeHeapOfMany(640, 6);
  const VectorXd found = sweptReactions(heap.problem);
  const auto errorFrom = [&](const VectorXd& start) {
    return Solver(Options::bounded(1)).solve(heap.problem, start).residualRms;
  };
  const double fromNone = errorFrom(VectorXd());
  for (const double spoilt : {2.0, 4.0, 8.0})
    EXPECT_LE(errorFrom(spoilt * found), 1.5 * fromNone) << spoilt;
  EXPECT_LT(errorFrom(found), 0.5 * fromNone);
}

// Reactions that stopped a blow would throw the other way if they were the guess after the blow.
TEST(Heaps, FewSweepsGainNoEnergyFromWhatStoppedABlow) {
  const PileIsland heap = makeHeapOfMany(640, 6);
  const VectorXd rest = sweptReactions(heap.problem);
  for (const double times : {5, 10})
    for (const int sweeps : {1, 2, 5, 10}) {
      const Solution solution = Solver(Options::bounded(sweeps)).solve(heap.problem, times * rest);
      EXPECT_LE(solution.r.dot(heap.problem.q + solution.u) / 2, 0) << times << ", " << sweeps;
    }
}

/// Sweeps that remember give up within fewer; sweeps by the thousand make more.
constexpr int mostOfSettling = 12000;

// A walk that goes on as long as it gains needs hundreds of regions here, but nothing else.
TEST(LargeHeap, IsWalkedThrough) {
  const Solution solution = solveWithoutPath(makeHeapOfMany(640, 14).problem);
  EXPECT_EQ(solution.status, Status::Solved);
  EXPECT_LT(solution.sweeps, mostOfSettling);
}

// A walk loses its way in one of these (rounding decides in which). Plain sweeps, and walks from
// where these lead, do not.
TEST(LargeHeap, IsOutlasted) {
  bool isOutlasted = false;
  for (const int seed : {10, 7, 23}) {
    const Solution solution = solveWithoutPath(makeHeapOfMany(640, seed).problem);
    isOutlasted |= solution.status == Status::Solved && solution.sweeps > mostOfSettling;
    if (isOutlasted) break;
  }
  EXPECT_TRUE(isOutlasted);
}

// Rounding decides which ones, and which of the others the path of compliance solves.
TEST(LargeHeap, IsMostlySolvedWithoutPathSlow) {
  int solved = 0;
  for (const int seed : {4, 6, 9, 14, 24})
    solved += solveWithoutPath(makeHeapOfMany(640, seed).problem).status == Status::Solved;
  EXPECT_GE(solved, 3);
}

TEST(SmallHeap, WhatNothingElseSolvesIsHardened) {
  expectHardened({makeHeapOfHundreds(28), makeHeapOfHundreds(52)});
}

// Walks and plain sweeps fail in three of ten such heaps (2e-5 to 4e-2 m/s are left).
TEST(LargeHeap, WhatIsNotOutlastedIsHardenedSlow) {
  expectHardened({makeHeapOfMany(660, 22), makeHeapOfMany(660, 32)});
}

}  // namespace
}  // namespace delassus
