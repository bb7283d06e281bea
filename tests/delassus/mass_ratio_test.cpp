/// Light and heavy bodies in one pile.
#include <gtest/gtest.h>

#include "delassus/solver.h"
#include "tests/support/random_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

/// A pyramid all of whose boxes move and turn, every other layer heavier by the ratio.
PileIsland makeMixedPyramid(int layers, double ratio, int seed) {
  constexpr double friction = 0.4, speed = 0.3;
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

// 1024 and 1652 contacts: what is left goes slowly, and goes.
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

}  // namespace
}  // namespace delassus
