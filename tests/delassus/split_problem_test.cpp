/// Problems with explicit W fall into parts that nothing couples.
#include "delassus/split_problem.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "delassus/solver.h"
#include "tests/support/explicit_problems.h"
#include "tests/support/random_piles.h"
#include "tests/support/turning_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

std::vector<int> unknownsOf(const ProblemParts& parts, int part) {
  std::vector<int> unknowns;
  for (int k = 0; k < parts.sizeOf(part); ++k) unknowns.push_back(parts.unknown(part, k));
  return unknowns;
}

TEST(ProblemParts, AreWhatEntriesOfEitherTriangleConnect) {
  Problem problem;
  MatrixXd W = MatrixXd::Identity(11, 11);
  W(1, 7) = 0.1;   // contact 0 feels contact 2
  W(10, 4) = 0.1;  // the last row feels contact 1
  problem.W = matrix(W);
  problem.q = VectorXd::LinSpaced(11, -1, 1);
  problem.friction = Eigen::Vector3d(0.1, 0.2, 0.3);
  problem.lower = Eigen::Vector2d(0, -1);
  problem.upper = Eigen::Vector2d(2, 1);
  problem.roundOff = 1e-9;
  problem.leastDemand = 2;

  const ProblemParts parts(problem);
  ASSERT_EQ(parts.count(), 3);
  EXPECT_THAT(unknownsOf(parts, 0), ::testing::ElementsAre(0, 1, 2, 6, 7, 8));
  EXPECT_THAT(unknownsOf(parts, 1), ::testing::ElementsAre(3, 4, 5, 10));
  EXPECT_THAT(unknownsOf(parts, 2), ::testing::ElementsAre(9));

  const Problem second = parts.problemOf(1);
  EXPECT_EQ(second.W.dense()(3, 1), 0.1);
  EXPECT_EQ(second.q, problem.q({3, 4, 5, 10}));
  EXPECT_EQ(second.friction, VectorXd::Constant(1, 0.2));
  EXPECT_EQ(second.lower, VectorXd::Constant(1, -1));
  EXPECT_EQ(second.upper, VectorXd::Constant(1, 1));
  EXPECT_EQ(second.roundOff, problem.roundOff);
  EXPECT_EQ(second.leastDemand, problem.leastDemand);
}

TEST(ProblemParts, AnEntryThatIsZeroConnectsNothing) {
  DelassusMatrix::Sparse W = matrix(MatrixXd::Identity(2, 2)).entries();
  for (const double entry : {0.0, 0.1}) {
    W.coeffRef(0, 1) = W.coeffRef(1, 0) = entry;
    Problem problem;
    problem.W = DelassusMatrix(W);
    problem.q = Eigen::Vector2d(-1, 1);
    problem.lower = Eigen::Vector2d(0, 0);
    problem.upper = Eigen::Vector2d(1, 1);
    EXPECT_EQ(ProblemParts(problem).count(), entry == 0 ? 2 : 1);
  }
}

TEST(ProblemParts, ADiskIsConnectedToItsGovernor) {
  Random random(60);
  Problem problem = loneContacts(2, random);
  MatrixXd W = MatrixXd::Identity(9, 9);
  W.topLeftCorner<6, 6>() = problem.W.dense();
  problem.W = matrix(W);
  problem.q = VectorXd::Constant(9, -1);
  problem.lower = problem.upper = VectorXd::Constant(3, infinity);
  problem.lower *= -1;
  problem.disks = {{6, 1, 0, 0.1}, {7, 2, 3, 0.2}};
  const ProblemParts parts(problem);
  ASSERT_EQ(parts.count(), 2);
  EXPECT_THAT(unknownsOf(parts, 1), ::testing::ElementsAre(3, 4, 5, 7, 8));
  EXPECT_THAT(parts.problemOf(1).disks, ::testing::ElementsAre(Disk{3, 2, 0, 0.2}));
}

// Towers need factors. Heaps, which have few contacts, settle by sweeps, which are far cheaper.
TEST(SolveParts, AnEasyProblemNeedsNoFactor) {
  Random random(63);
  int factored = 0;
  constexpr int problems = 20;
  for (int k = 0; k < problems; ++k) {
    const Problem problem = withEntries(PileIsland(makeHeap(12, 0.4, random)).problem);
    const Solution solution = solve(problem);
    EXPECT_EQ(solution.status, Status::Solved);
    factored += solution.factorisations > 0;
  }
  EXPECT_LT(factored, problems / 2);

  const Problem tower =
      withEntries(PileIsland(makeTower({1, 1, 1, 1, 1, 1, 1, 100}, 0.5, 0.2, random)).problem);
  const Solution solution = solve(tower);
  EXPECT_EQ(solution.status, Status::Solved);
  EXPECT_GT(solution.factorisations, 0);
}

}  // namespace
}  // namespace delassus
