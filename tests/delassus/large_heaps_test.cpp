/// Heaps of a thousand contacts, whose walk loses its way: what finds back there (find_back.cpp).
#include <gtest/gtest.h>

#include "delassus/residual.h"
#include "delassus/solver.h"
#include "tests/support/random_piles.h"
#include "tests/support/sphere_heaps.h"

namespace delassus {
namespace {

using namespace delassus::test;

PileIsland makeLargeHeap(int seed) {
  Random random(seed);
  return PileIsland(makeSphereHeap(640, 7, 0.5, 0.1, random));
}

/// As a step finds them that comes after one which had little time.
VectorXd sweptReactions(const Problem& problem) {
  Options few;
  few.sweepBudget = 200;
  few.newtonBudget = 1;
  return Solver(few).solve(problem).r;
}

/// Without its plain sweeps by the thousand none of these heaps is solved: what is left is 5e-6 to 5e-3 m/s.
void expectOutlasted(int seed) {
  const PileIsland heap = makeLargeHeap(seed);
  ASSERT_GT(heap.problem.contacts(), 1000);
  Options options;
  options.pathBudget = 0;
  const Solution solution = Solver(options).solve(heap.problem, sweptReactions(heap.problem));
  EXPECT_EQ(solution.status, Status::Solved);
  EXPECT_GT(solution.sweeps, 2000);
  EXPECT_LE(naturalResidual(heap.problem, solution.r).max,
            options.tolerance * heap.problem.q.cwiseAbs().maxCoeff());
  EXPECT_LT(infeasibility(heap.problem, solution.r), 1e-14);
}

TEST(LargeHeap, IsOutlasted) { expectOutlasted(9); }

TEST(LargeHeap, OthersAreOutlastedSlow) {
  for (const int seed : {4, 6, 10, 14}) {
    SCOPED_TRACE(seed);
    expectOutlasted(seed);
  }
}

}  // namespace
}  // namespace delassus
