/// Heaps of a thousand contacts, whose walk loses its way: what finds back there (find_back.cpp).
#include <gtest/gtest.h>

#include "delassus/residual.h"
#include "delassus/solver.h"
#include "tests/support/random_piles.h"
#include "tests/support/sphere_heaps.h"

namespace delassus {
namespace {

using namespace delassus::test;

PileIsland makeLargeHeap(int spheres, int seed) {
  Random random(seed);
  return PileIsland(makeSphereHeap(spheres, 7, 0.5, 0.1, random));
}

/// As a step finds them that comes after one which had little time.
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

/// Without its plain sweeps by the thousand none of these heaps is solved: what is left is 5e-6 to 5e-3 m/s.
void expectOutlasted(int seed) {
  const PileIsland heap = makeLargeHeap(640, seed);
  ASSERT_GT(heap.problem.contacts(), 1000);
  Options options;
  options.pathBudget = 0;
  const Solution solution = Solver(options).solve(heap.problem, sweptReactions(heap.problem));
  expectSolved(heap.problem, options, solution);
  EXPECT_GT(solution.sweeps, 2000);
}

TEST(LargeHeap, IsOutlasted) { expectOutlasted(9); }

TEST(LargeHeap, OthersAreOutlastedSlow) {
  for (const int seed : {4, 6, 10, 14}) {
    SCOPED_TRACE(seed);
    expectOutlasted(seed);
  }
}

// What is left without the path of compliance is 2e-4 and 5e-6 m/s.
TEST(LargeHeap, WhatIsNotOutlastedIsHardenedSlow) {
  for (const int seed : {23, 32}) {
    SCOPED_TRACE(seed);
    const PileIsland heap = makeLargeHeap(660, seed);
    ASSERT_GT(heap.problem.contacts(), 1000);
    Options options;
    const VectorXd start = sweptReactions(heap.problem);
    expectSolved(heap.problem, options, Solver(options).solve(heap.problem, start));
    options.pathBudget = 0;
    EXPECT_EQ(Solver(options).solve(heap.problem, start).status, Status::OutOfBudget);
  }
}

}  // namespace
}  // namespace delassus
