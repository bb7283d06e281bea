/// A few sweeps that find the answer make a solver needless.
#include "delassus/quick_answer.h"

#include <gtest/gtest.h>

#include "delassus/solver.h"
#include "delassus/tolerance.h"
#include "tests/support/explicit_problems.h"

namespace delassus {
namespace {

using namespace delassus::test;

// One sweep answers the contacts that approach; the others are not looked at.
TEST(QuickAnswer, LoneContactsNeedOneSweep) {
  Random random(61);
  const Problem problem = loneContacts(200, random);
  const Solution solution = solve(problem);
  EXPECT_EQ(solution.status, Status::Solved);
  EXPECT_LT(solution.residual, 1e-13);
  EXPECT_EQ(solution.sweeps, 1);
  EXPECT_EQ(solution.regions + solution.factorisations, 0);
  const ProblemParts parts(problem);
  for (int i = 0; i < 200; ++i) {
    const Solution alone = solve(parts.problemOf(i));
    EXPECT_LT((solution.r.segment<3>(3 * i) - alone.r).norm(), 1e-12 * (1 + alone.r.norm()));
    EXPECT_LT((solution.u.segment<3>(3 * i) - alone.u).norm(), 1e-12);
    EXPECT_EQ(solution.activeSet.contacts[i], alone.activeSet.contacts[0]);
  }

  Options walked;
  walked.economies.closedForms = false;
  EXPECT_EQ(solve(problem, walked).status, Status::Solved);
}

TEST(QuickAnswer, WhatDoesNotApproachStaysApart) {
  Random random(62);
  Problem problem = loneContacts(4, random);
  MatrixXd W = problem.W.dense();
  W.block<6, 6>(0, 0) = randomDelassus(6, 10, random);
  problem.W = matrix(W);
  problem.q[0] = 0.2;
  problem.q[3] = 0;
  const Solution solution = solve(problem);
  EXPECT_EQ(solution.r.head<6>(), VectorXd::Zero(6));
  EXPECT_EQ(solution.u.head<6>(), problem.q.head<6>());
  EXPECT_EQ(solution.activeSet.contacts[0], Mode::Open);
}

/// Contacts that act on themselves as lone ones do, and on each other as strongly as `coupling`
/// says.
Problem coupledContacts(int n, double coupling, Random& random) {
  Problem problem = loneContacts(n, random);
  MatrixXd W = problem.W.dense();
  W += coupling * randomDelassus(3 * n, 10, random);
  problem.W = matrix(W);
  return problem;
}

// A contact that flies apart asks for nothing, and lets the others leave no more.
TEST(QuickAnswer, WhatFliesApartIsNoDemand) {
  Random random(64);
  int solved = 0;
  for (int k = 0; k < 100; ++k) {
    constexpr int stuck = 18, size = 30;  // a body on six contacts, and four contacts beside it
    const MatrixXd J = normalVector(stuck * 6, random).reshaped(stuck, 6);
    const MatrixXd beside =
        MatrixXd::Identity(12, 12) + 0.12 * normalVector(12 * 12, random).reshaped(12, 12);
    MatrixXd W = MatrixXd::Zero(size, size);
    W.topLeftCorner<stuck, stuck>() = J * J.transpose();
    W.bottomRightCorner<12, 12>() = beside * beside.transpose();
    Problem problem;
    problem.W = matrix(W);
    problem.friction = VectorXd::Constant(size / 3, 0.5);
    problem.q = normalVector(size, random);
    problem.q.head<stuck>() = J * normalVector(6, random);
    for (int i = stuck; i < size; i += 3) problem.q[i] = -std::abs(problem.q[i]);
    problem.q.tail<3>() = Vec3(1e5, 0, 0);
    const Solution solution = solve(problem);
    if (solution.status != Status::Solved) continue;
    ++solved;
    EXPECT_LE(solution.residual, toleranceOf(Options(), problem)) << k;
  }
  EXPECT_GT(solved, 50);
}

TEST(QuickAnswer, ContactsThatFeelLittleOfEachOtherNeedFewSweeps) {
  Random random(63);
  for (const int n : {2, 5, 6, 40}) {
    SCOPED_TRACE(n);
    Problem problem = coupledContacts(n, 1e-3, random);
    for (int i = 0; i < n; i += 2) problem.q[3 * i] = -1;
    const Solution quick = solve(problem), walked = Solver().solve(problem);
    EXPECT_EQ(quick.status, Status::Solved);
    EXPECT_LE(quick.sweeps, 8);
    EXPECT_LE(quick.factorisations, 1);
    EXPECT_LE(naturalResidual(problem, quick.r).max, 1e-8 * problem.q.cwiseAbs().maxCoeff());
    EXPECT_LT((quick.r - walked.r).norm(), 1e-6 * walked.r.norm());
  }
}

TEST(QuickAnswer, IsLeftToASolverWhereContactsFeelEachOther) {
  Random random(64);
  Problem problem = loneContacts(44, random);
  MatrixXd W = problem.W.dense();
  W.topLeftCorner<12, 12>() = randomDelassus(12, 1e4, random);
  problem.W = matrix(W);
  const Solution solution = solve(problem);
  EXPECT_EQ(solution.status, Status::Solved);
  EXPECT_LE(naturalResidual(problem, solution.r).max, 1e-8 * problem.q.cwiseAbs().maxCoeff());
  const ProblemParts parts(problem);
  ASSERT_EQ(parts.count(), 41);
  for (int k = 1; k < parts.count(); ++k) {
    const Solution alone = Solver().solve(parts.problemOf(k));
    EXPECT_LT((solution.r.segment<3>(parts.unknown(k, 0)) - alone.r).norm(),
              1e-9 * (1 + alone.r.norm()));
    EXPECT_EQ(solution.activeSet.contacts[k + 3], alone.activeSet.contacts[0]);
  }
}

// Wherever the budget ends, the residual that is reported is that of the reactions returned.
TEST(QuickAnswer, TellsTheResidualOfItsReactionsAtAnyBudget) {
  Random random(66);
  Problem problem = coupledContacts(44, 0.02, random);
  MatrixXd W = problem.W.dense();
  W.topRightCorner(66, 66).setZero();
  W.bottomLeftCorner(66, 66).setZero();
  problem.W = matrix(W);
  ASSERT_EQ(ProblemParts(problem).count(), 2);
  for (int sweeps = 0; sweeps < 12; ++sweeps) {
    SCOPED_TRACE(sweeps);
    Options options;
    options.sweepBudget = sweeps;
    options.newtonBudget = 0;
    const Solution solution = solve(problem, options);
    const double demand = problem.q.cwiseAbs().maxCoeff();
    EXPECT_NEAR(solution.residual, naturalResidual(problem, solution.r).max, 1e-13 * demand);
    if (solution.status == Status::Solved) {
      EXPECT_LE(solution.residual, 1e-8 * demand);
    }
  }
}

// The best answer comes back, whoever found it: a solver without any budget left finds nothing.
TEST(QuickAnswer, IsTheAnswerWhereItsBudgetWasAll) {
  Random random(68);
  for (const int contacts : {4, 44}) {
    SCOPED_TRACE(contacts);
    Problem problem = coupledContacts(contacts, 0.02, random);
    for (int i = 0; i < contacts; ++i) problem.q[3 * i] = -1;
    if (contacts > 4) {
      MatrixXd W = problem.W.dense();
      W.topRightCorner(66, 66).setZero();
      W.bottomLeftCorner(66, 66).setZero();
      problem.W = matrix(W);
    }
    const double atRest = naturalResidual(problem, VectorXd::Zero(problem.size())).max;
    Options options;
    options.sweepBudget = 2;
    options.newtonBudget = 0;
    options.tolerance = 1e-14;
    const Solution solution = solve(problem, options);
    EXPECT_EQ(solution.status, Status::OutOfBudget);
    EXPECT_LT(solution.residual, 0.1 * atRest);
    EXPECT_NEAR(solution.residual, naturalResidual(problem, solution.r).max, 1e-13);
    ASSERT_FALSE(solution.blamed.empty());
  }
}

// The budget that was used here is not there for the solver any more.
TEST(QuickAnswer, KeepsToTheBudgetTogetherWithTheSolver) {
  Random random(67);
  for (const int contacts : {4, 12}) {
    Problem problem = loneContacts(contacts, random);
    problem.W = matrix(randomDelassus(3 * contacts, 1e4, random));
    for (int i = 0; i < contacts; ++i) problem.q[3 * i] = -1;
    for (int budget = 0; budget < 12; ++budget) {
      Options options;
      options.sweepBudget = options.newtonBudget = budget;
      const Solution solution = solve(problem, options);
      EXPECT_LE(solution.sweeps, budget);
      EXPECT_LE(solution.regions, budget);
    }
  }
}

// No reaction moves anything at such a contact. No sweep answers it, and no budget makes it vanish.
TEST(QuickAnswer, AContactThatMovesNothingIsNotAnswered) {
  Random random(65);
  Problem problem = loneContacts(3, random);
  MatrixXd W = problem.W.dense();
  W.block<3, 3>(3, 3).setZero();
  problem.W = matrix(W);
  problem.q[3] = -1;
  for (const int sweeps : {0, 1, 6000}) {
    SCOPED_TRACE(sweeps);
    Options options;
    options.sweepBudget = sweeps;
    Solution solution;
    EXPECT_FALSE(QuickAnswer(problem, options).find(solution));
    solution = solve(problem, options);
    EXPECT_NE(solution.status, Status::Solved);
    EXPECT_FALSE(solution.blamed.empty());
    EXPECT_GT(solution.residual, 0.5);
  }
}

}  // namespace
}  // namespace delassus
