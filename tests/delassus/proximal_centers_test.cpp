/// Descents whose error may grow before it falls, and centers that move as long as that gains.
#include "delassus/proximal_centers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace delassus {
namespace {

/// Steps through the given errors, and then has no further step.
struct Script {
  std::vector<double> errors;
  std::size_t at = 0, kept = 0;

  double error() const { return errors[at]; }
  bool step(double& error) {
    if (at + 1 == errors.size()) return false;
    error = errors[++at];
    return true;
  }
  void keepLast() { kept = at - 1; }
  void goBack() { at = kept; }
};

// Where no answer is found, the weight grows; it then shrinks in ever smaller steps, until answers
// come easily.
TEST(ProximalWeight, ShrinksMoreGentlyAfterAFailure) {
  constexpr double least = 1e-12, most = 1;
  const auto shrinkOf = [](ProximalWeight weight) {
    const double before = weight.value();
    weight.shrink();
    return weight.value() / before;
  };
  ProximalWeight weight(1e-3, least, most);
  double last = shrinkOf(weight);
  EXPECT_LT(last, 1);
  for (int failures = 1; failures <= 2; ++failures) {
    const double before = weight.value();
    weight.grow();
    EXPECT_GT(weight.value(), before);
    EXPECT_GT(shrinkOf(weight), last);
    last = shrinkOf(weight);
  }
  weight.learn(true);
  EXPECT_EQ(shrinkOf(weight), last) << "one easy answer may be luck";
  for (int answers = 0; answers < 20; ++answers) weight.learn(true);
  EXPECT_NEAR(shrinkOf(weight), shrinkOf(ProximalWeight(1e-3, least, most)), 1e-15);
}

TEST(ProximalWeight, StaysWithinItsBounds) {
  constexpr double least = 1e-10, most = 1e-1;
  ProximalWeight weight(1e-3, least, most);
  const auto expectWithin = [&] {
    EXPECT_GE(weight.value(), least);
    EXPECT_LE(weight.value(), most);
  };
  for (int i = 0; i < 20; ++i) weight.shrink(), expectWithin();
  EXPECT_TRUE(weight.isLeast());
  for (int i = 0; i < 20; ++i) {
    weight.grow(), expectWithin();
    if (i % 3 == 0) weight.shrink(), expectWithin();
  }
  EXPECT_TRUE(weight.isMost());
}

TEST(ProximalCenters, AStepThatMissesMayBeTheWayToOneThatGains) {
  Script script{{1, 30, 5, 0.1}};
  const Descent descent = descend(script, 0.2, 10);
  EXPECT_TRUE(descent.isFound);
  EXPECT_EQ(descent.steps, 3);
  EXPECT_EQ(script.at, 3U);
}

TEST(ProximalCenters, WhatDoesNotGainEndsWhereTheErrorWasLeast) {
  Script never{{1, 0.5, 2, 2, 2, 2, 2, 0.1}};
  const Descent descent = descend(never, 0.2, 10);
  EXPECT_FALSE(descent.isFound);
  EXPECT_EQ(descent.steps, 6);
  EXPECT_EQ(never.at, 1U);

  Script again{{1, 2, 0.9, 3, 0.8, 4}};
  descend(again, 0.2, 10);
  EXPECT_EQ(again.at, 4U);
}

TEST(ProximalCenters, WhatIsFarOffOrNoNumberIsGivenUpAtOnce) {
  for (const double wrong :
       {1e7, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    Script script{{1, wrong, 0.1}};
    const Descent descent = descend(script, 0.2, 10);
    EXPECT_FALSE(descent.isFound);
    EXPECT_EQ(descent.steps, 1);
    EXPECT_EQ(script.at, 0U);
  }
}

TEST(ProximalCenters, TheBudgetEndsADescent) {
  Script script{{1, 3, 2, 0.1}};
  const Descent descent = descend(script, 0.2, 2);
  EXPECT_FALSE(descent.isFound);
  EXPECT_EQ(descent.steps, 2);
  EXPECT_EQ(script.at, 0U);
}

/// How many moves are made if they lead to these residuals, one after the other, starting from 1.
std::size_t movesThrough(const std::vector<double>& residuals) {
  Problem problem;
  problem.W = DelassusMatrix(DelassusMatrix::Sparse(MatrixXd::Identity(1, 1).sparseView()));
  problem.q = problem.lower = VectorXd::Zero(1);
  problem.upper = VectorXd::Ones(1);
  NaturalMap map;
  map.setProblem(problem);
  Solution best, next;
  best.start(problem.q);
  best.residual = 1;
  std::size_t moves = 0;
  const auto moveOn = [&](const Solution& center, double, double, int, Solution& to) {
    to.takeReactions(center);
    to.residual = residuals[moves++];
    return Descent{true, 1};
  };
  const auto budget = static_cast<int>(residuals.size());
  const Descent descent = moveCenters(moveOn, map, 1e-9, budget, next, best);
  EXPECT_EQ(descent.steps, static_cast<int>(moves));
  EXPECT_EQ(best.residual, *std::min_element(residuals.begin(), residuals.begin() + moves));
  return moves;
}

TEST(ProximalCenters, TwoMovesThatGainLittleAreTheLast) {
  EXPECT_EQ(movesThrough({0.9, 0.6, 0.01}), 2U);
  EXPECT_EQ(movesThrough({0.9, 2, 0.01}), 2U);
  EXPECT_EQ(movesThrough({0.9, 0.4, 0.39, 0.38, 0.01}), 4U);
  EXPECT_EQ(movesThrough({0.4, 0.1, 0.02, 0.005}), 4U);
}

}  // namespace
}  // namespace delassus
