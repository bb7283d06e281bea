/// What a budget leaves unfinished.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>

#include "delassus/solver.h"
#include "tests/support/random_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

// Not even where having no reactions at all is nearer in the mean: the largest residual counts.
TEST(Solver, ASpentBudgetIsNeverWorseThanAGuessThatIsWrongEverywhere) {
  constexpr int contacts = 1000;
  Problem problem;
  DelassusMatrix::Sparse W(3 * contacts, 3 * contacts);
  W.setIdentity();
  problem.W = DelassusMatrix(W);
  problem.q = VectorXd::Zero(3 * contacts);
  problem.q[0] = -1.05;
  problem.friction = VectorXd::Constant(contacts, 0.5);
  VectorXd guess = VectorXd::Zero(3 * contacts);
  for (int i = 0; i < contacts; ++i) guess[3 * i] = 1;
  Options options;
  options.newtonBudget = options.sweepBudget = options.pathBudget = 0;
  EXPECT_LE(Solver(options).solve(problem, guess).residual, naturalResidual(problem, guess).max);
}

TEST(Solver, BudgetsBelowNothingAreNothing) {
  Random random(2);
  const PileIsland pile(makePyramid(3, 0.5, 0.2, 10, random));
  Options none, less;
  none.newtonBudget = none.sweepBudget = none.pathBudget = 0;
  less.newtonBudget = less.sweepBudget = less.pathBudget = std::numeric_limits<int>::min();
  EXPECT_EQ(Solver(less).solve(pile.problem).r, Solver(none).solve(pile.problem).r);
}

// Where bodies lie deep in each other, a few sweeps from nothing raise the residual. They are kept
// all the same, since they take energy; not if there is a guess, which may be nearer.
TEST(Solver, FewSweepsFromNothingTakeEnergy) {
  // Balls that all overlap: each demand presses all others.
  constexpr int balls = 12;
  Pile pile;
  Random random(211);
  for (int i = 0; i < balls; ++i) pile.bodies.push_back(makeBox(1, 0.5, Vec6::Zero()));
  for (int a = 0; a < balls; ++a)
    for (int b = 0; b < a; ++b) {
      Contact& contact = pile.contacts.emplace_back();
      contact.a = a;
      contact.b = b;
      contact.frame = Eigen::AngleAxisd(uniform(random, 0, 3), normalVector(3, random).normalized())
                          .toRotationMatrix();
      contact.target[0] = 1;
    }
  const PileIsland island(pile);
  const auto energyOf = [&](const VectorXd& r) {
    return r.dot(island.problem.q + (island.problem.W * r + island.problem.q)) / 2;
  };
  for (const int sweeps : {2, 5, 10}) {
    const Solution solution = Solver(Options::bounded(sweeps)).solve(island.problem);
    EXPECT_LT(energyOf(solution.r), 0) << sweeps;
    const VectorXd guess = 1e-3 * VectorXd::Ones(island.problem.size());
    const Solution next = Solver(Options::bounded(sweeps)).solve(island.problem, guess);
    EXPECT_LE(next.residual, next.startResidual) << sweeps;
  }
}

}  // namespace
}  // namespace delassus
