/// Light and heavy bodies in one pile.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "delassus/cone.h"
#include "delassus/solver.h"
#include "tests/support/random_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

/// A pyramid whose boxes all move and turn; every other layer is heavier by the ratio.
PileIsland makeMixedPyramid(int layers, double ratio, int seed, double friction = 0.4) {
  constexpr double speed = 0.3;
  Random random(seed);
  return PileIsland(makePyramid(layers, friction, speed, ratio, random));
}

void expectSolved(const Problem& problem, const Solution& solution) {
  EXPECT_EQ(solution.status, Status::Solved);
  EXPECT_LE(naturalResidual(problem, solution.r).max,
            Options().tolerance * problem.q.cwiseAbs().maxCoeff());
  EXPECT_LT(infeasibility(problem, solution.r), 1e-14 * solution.r.norm());
}

TEST(MassRatio, PilesInMotionAreSolved) {
  for (const int layers : {3, 4})
    for (const double ratio : {1e3, 1e6})
      for (const int seed : {1, 2, 3}) {
        SCOPED_TRACE(testing::Message() << layers << " layers, ratio " << ratio << ", " << seed);
        const PileIsland pile = makeMixedPyramid(layers, ratio, seed);
        expectSolved(pile.problem, Solver().solve(pile.problem));
      }
}

// 1024 and 1652 contacts: the residual falls slowly, but it falls.
TEST(MassRatio, LargePilesAreSolvedByWalksThatGainSlow) {
  Options inVain;
  inVain.newtonBudget = inVain.regionsInVain();
  int notInVain = 0;
  for (const auto& [layers, seed] : {std::pair(6, 1), std::pair(7, 1), std::pair(7, 2)}) {
    SCOPED_TRACE(testing::Message() << layers << " layers, " << seed);
    const PileIsland pile = makeMixedPyramid(layers, 1e6, seed);
    const Solution solution = Solver().solve(pile.problem);
    expectSolved(pile.problem, solution);
    EXPECT_LE(solution.regions, Options().newtonBudget);
    notInVain += Solver(inVain).solve(pile.problem).status == Status::OutOfBudget;
  }
  EXPECT_GE(notInVain, 1);
}

// A walk from no reactions is lost, but one from the answer for less friction is not.
TEST(MassRatio, PilesWithMuchFrictionAreSolvedFromLess) {
  constexpr double friction = 1;
  Options fromNothing;
  fromNothing.pathBudget = 0;
  int lostFromNothing = 0;
  for (const int seed : {1, 2, 3, 10}) {
    SCOPED_TRACE(seed);
    const PileIsland pile = makeMixedPyramid(4, 1e5, seed, friction);
    const Solution solution = Solver().solve(pile.problem);
    expectSolved(pile.problem, solution);
    EXPECT_LE(solution.regions, Options().newtonBudget);
    lostFromNothing += Solver(fromNothing).solve(pile.problem).status == Status::OutOfBudget;
  }
  EXPECT_GE(lostFromNothing, 1);
}

/// The factor by which an outer step of the walk (ProximalWalk) with the weight α multiplies small
/// errors: the largest eigenvalue, in absolute value, of
///
///     (1 + P' l W)⁻¹ P',   l = 1/(α W_aa),   P' = dr/dz at z = r − l u
double growthNear(const Problem& problem, const Solution& answer, double weight) {
  const MatrixXd W = problem.W.dense();
  MatrixXd derivative = MatrixXd::Zero(W.rows(), W.cols());
  VectorXd l(W.rows());
  for (int i = 0; i < problem.contacts(); ++i) {
    const int at = 3 * i;
    l.segment<3>(at).setConstant(3 / (weight * W.diagonal().segment<3>(at).sum()));
    const Vec3 z = answer.r.segment<3>(at) - l.segment<3>(at).cwiseProduct(answer.u.segment<3>(at));
    Mat3 block;
    reactionTo(z, problem.friction[i], &block);
    derivative.block<3, 3>(at, at) = block;
  }
  const MatrixXd response = derivative * l.asDiagonal() * W;
  const MatrixXd step =
      (MatrixXd::Identity(W.rows(), W.cols()) + response).partialPivLu().solve(derivative);
  return Eigen::EigenSolver<MatrixXd>(step, false).eigenvalues().cwiseAbs().maxCoeff();
}

// One reason why walks are lost: errors grow from step to step, unless the weight is so small that
// no walk from afar can solve its steps.
TEST(MassRatio, WithMuchFrictionAnswersMayRepel) {
  constexpr double weight = 1e-2, rounding = 1e-6;
  const auto repel = [](double friction) {
    int count = 0;
    for (int seed = 10; seed <= 15; ++seed) {
      const PileIsland pile = makeMixedPyramid(3, 1e3, seed, friction);
      const Solution answer = Solver().solve(pile.problem);
      expectSolved(pile.problem, answer);
      count += growthNear(pile.problem, answer, weight) > 1 + rounding;
    }
    return count;
  };
  EXPECT_EQ(repel(0.4), 0);
  EXPECT_GE(repel(1), 1);
}

}  // namespace
}  // namespace delassus
