/// Newton's method on all entries of W, alone.
#include "delassus/dense_newton.h"

#include <gtest/gtest.h>

#include "delassus/region.h"
#include "tests/support/random_piles.h"
#include "tests/support/random_problems.h"
#include "tests/support/turning_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

struct DenseAttempt {
  bool reached;
  double tolerance, before;
  Solution solution;
};

template <int Most>
DenseAttempt runWithRoomFor(const Problem& problem, const VectorXd& start, int budget) {
  NaturalMap map;
  map.setProblem(problem);
  EXPECT_TRUE(fitsDenseNewton(problem, map));
  DenseAttempt attempt;
  attempt.tolerance = 1e-10 * problem.q.cwiseAbs().maxCoeff();
  attempt.solution = startFrom(problem, map, start);
  attempt.before = attempt.solution.residual;
  attempt.reached = DenseNewton<Most>().solve(problem, map, attempt.tolerance, budget, Start::Best,
                                              attempt.solution);
  return attempt;
}

/// Solves with room for any number of unknowns, and, if they fit, with room for few: both must go
/// the same way.
DenseAttempt run(const Problem& problem, const VectorXd& start, int budget = 100) {
  const DenseAttempt any = runWithRoomFor<Eigen::Dynamic>(problem, start, budget);
  if (problem.size() <= fewUnknowns) {
    const DenseAttempt few = runWithRoomFor<fewUnknowns>(problem, start, budget);
    EXPECT_EQ(few.reached, any.reached);
    EXPECT_EQ(few.solution.regions, any.solution.regions);
    EXPECT_LE((few.solution.r - any.solution.r).norm(), 1e-9 * any.solution.r.norm());
  }
  return any;
}

/// Contacts whose W has full rank, whatever couples them.
Problem makeRegular(int contacts, double mu, Random& random) {
  const int size = 3 * contacts;
  const MatrixXd A = normalMatrix(size, 2 * size, random);
  Problem problem;
  problem.W = DelassusMatrix(DelassusMatrix::Sparse((A * A.transpose() / size).sparseView()));
  problem.q = normalVector(size, random);
  problem.friction = VectorXd::Constant(contacts, mu);
  problem.lower = problem.upper = VectorXd(0);
  return problem;
}

TEST(DenseNewton, SolvesWhatIsRegularInAFewRegions) {
  Random random(131);
  int reached = 0, regions = 0;
  constexpr int samples = 300;
  for (int k = 0; k < samples; ++k) {
    const Problem problem = makeRegular(1 + k % 12, uniform(random, 0, 0.8), random);
    const DenseAttempt attempt = run(problem, VectorXd::Zero(problem.size()));
    EXPECT_LE(attempt.solution.residual, attempt.before);
    EXPECT_LE(infeasibility(problem, attempt.solution.r), 1e-13 * attempt.solution.r.norm());
    if (!attempt.reached) continue;
    ++reached;
    regions += attempt.solution.regions;
    EXPECT_LE(naturalResidual(problem, attempt.solution.r).max, 1.01 * attempt.tolerance);
  }
  EXPECT_GE(reached, 0.9 * samples);
  EXPECT_LE(regions, 10 * reached);
}

// Without friction there is one answer: that of the paper's region.
TEST(DenseNewton, FindsTheRegionOfThePaper) {
  Random random(132);
  int reached = 0;
  for (int k = 0; k < 200; ++k) {
    Problem problem = makeRegular(1 + k % 6, 0, random);
    const int n = problem.contacts();
    const DenseAttempt attempt = run(problem, VectorXd::Zero(problem.size()));
    if (!attempt.reached) continue;
    ++reached;
    MatrixXd W(n, n);
    VectorXd q(n);
    for (int i = 0; i < n; ++i) {
      q[i] = problem.q[3 * i];
      for (int j = 0; j < n; ++j) W(i, j) = problem.W.entries().coeff(3 * i, 3 * j);
    }
    const RegionAnswer region = solveRegion(W, q);
    for (int i = 0; i < n; ++i)
      EXPECT_NEAR(attempt.solution.r[3 * i], region.r[i], 1e-8 * (1 + region.r.norm()));
  }
  EXPECT_GE(reached, 150);
}

// Four corners of a box at rest: many reactions make the same motion, and the method has no reason
// to take one of them.
TEST(DenseNewton, GivesUpWhereReactionsAreNotTold) {
  Random random(133);
  const PileIsland box(makeTower({1}, 0.8, 0, random));
  const Problem problem = withEntries(box.problem);
  const DenseAttempt attempt = run(problem, VectorXd::Zero(problem.size()));
  EXPECT_FALSE(attempt.reached);
  EXPECT_LE(attempt.solution.regions, 1);
}

TEST(DenseNewton, KeepsBoundsOfRowsAndItsBudget) {
  Random random(134);
  for (int k = 0; k < 100; ++k) {
    Problem problem = makeRegular(3, 0.5, random);
    problem.friction = VectorXd::Constant(2, 0.5);  // the third contact becomes three rows
    problem.lower = Vec3(-0.1, 0, -infinity);
    problem.upper = Vec3(0.1, 0.2, infinity);
    const DenseAttempt attempt = run(problem, VectorXd::Zero(problem.size()), 1 + k % 9);
    EXPECT_LE(attempt.solution.regions, 1 + k % 9);
    EXPECT_LE(infeasibility(problem, attempt.solution.r), 1e-13 * attempt.solution.r.norm());
    EXPECT_EQ(attempt.reached, attempt.solution.residual <= attempt.tolerance);
  }
}

TEST(DenseNewton, LeavesDisksAndBodiesToOthers) {
  Random random(135);
  Pile pile = makeTower({1}, 0.8, 0, random);
  NaturalMap map;
  const PileIsland bodies(pile);
  map.setProblem(bodies.problem);
  EXPECT_FALSE(fitsDenseNewton(bodies.problem, map));
  resistTurning(pile, 0.1, random);
  const Problem turning = withEntries(PileIsland(pile).problem);
  map.setProblem(turning);
  EXPECT_FALSE(fitsDenseNewton(turning, map));
}

}  // namespace
}  // namespace delassus
