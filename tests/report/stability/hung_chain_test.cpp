/// A taut chain fails where ω h = 2 with ω² = 12 T/(m l), whatever the solver; with remedies it
/// does not.
#include "demos/report/stability/hung_chain.h"

#include <gtest/gtest.h>

#include <cstring>
#include <utility>

#include "tests/report/stability/run_trial.h"

namespace demos::report::stability {
namespace {

constexpr int links = 10;
constexpr double rate = 120, seconds = 1.5, allowed = 0.05;

HungChain chainWith(double ballMass) { return {links, ballMass, rate}; }

TEST(HungChain, HoldsBelowTheLimitAndBreaksBeyondIt) {
  const double limit = heaviestBall(links, 1 / rate);
  EXPECT_LT(worstError(hungChain(chainWith(0.7 * limit), seconds)), allowed);
  EXPECT_GT(worstError(hungChain(chainWith(2 * limit), seconds)), allowed);
}

TEST(HungChain, LimitsOfMassAndRateAreOne) {
  for (const double ball : {10.0, 1e3, 1e6}) {
    const double h = 1 / leastRate(links, ball);
    EXPECT_NEAR(heaviestBall(links, h) / ball, 1, 1e-9);
  }
}

TEST(HungChain, StiffenedHoldsFarBeyondTheLimit) {
  HungChain chain = chainWith(1000 * heaviestBall(links, 1 / rate));
  EXPECT_GT(worstError(hungChain(chain, seconds)), allowed);
  chain.stiffened = true;
  EXPECT_LT(worstError(hungChain(chain, seconds)), allowed);
}

TEST(HungChain, WithGeometricStiffnessHoldsFarBeyondTheLimit) {
  Trial trial = hungChain(chainWith(1000 * heaviestBall(links, 1 / rate)), seconds);
  trial.geometricStiffness = true;
  EXPECT_LT(worstError(std::move(trial)), allowed);
}

TEST(HungChain, AsManySubstepsAsTheLimitAsksForHoldIt) {
  const double ball = 10 * heaviestBall(links, 1 / rate);
  HungChain chain = chainWith(ball);
  chain.substeps = 4;  // √10 < 4
  ASSERT_GT(rate * chain.substeps, leastRate(links, ball));
  EXPECT_LT(worstError(hungChain(chain, seconds)), allowed);
}

TEST(HungChain, SubstepsAreSteps) {
  NamedSolver solverOfA("delassus"), solverOfB("delassus");
  const Trial a = hungChain({links, 10, 60, 4}, 0.5), b = hungChain({links, 10, 240}, 0.5);
  a.world->setSolver(solverOfA.solver());
  b.world->setSolver(solverOfB.solver());
  for (int step = 0; step < a.steps; ++step) a.world->step(a.timeStep);
  for (int step = 0; step < b.steps; ++step) b.world->step(b.timeStep);
  const auto bodiesOfA = a.world->movableBodies(), bodiesOfB = b.world->movableBodies();
  ASSERT_EQ(bodiesOfA.size(), std::size_t(links + 1));
  for (std::size_t i = 0; i < bodiesOfA.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(bodiesOfA[i]->getWorldTransform().getOrigin()[axis],
                bodiesOfB[i]->getWorldTransform().getOrigin()[axis]);
}

}  // namespace
}  // namespace demos::report::stability
