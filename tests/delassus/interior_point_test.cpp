/// The interior-point method alone, from its cold start.
#include "delassus/interior_point.h"

#include <gtest/gtest.h>

#include "tests/support/random_piles.h"
#include "tests/support/turning_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

struct InteriorAttempt {
  bool reached;
  double tolerance;
  Solution solution;
};

template <class Motion>
InteriorAttempt run(const Problem& problem, int budget, const VectorXd& start) {
  NaturalMap map;
  map.setProblem(problem);
  Motion motion;
  motion.setProblem(problem);
  InteriorAttempt attempt;
  attempt.tolerance = 1e-8 * problem.q.cwiseAbs().maxCoeff();
  attempt.solution = startFrom(problem, map, start);
  attempt.reached = InteriorPoint<Motion>().solve(motion, problem, map, attempt.tolerance, budget,
                                                  attempt.solution);
  return attempt;
}

template <class Motion>
InteriorAttempt run(const Problem& problem, int budget = 60) {
  return run<Motion>(problem, budget, VectorXd::Zero(problem.size()));
}

PileIsland mixedTower(int height, double massRatio, double friction, Random& random) {
  Pile pile = makeTower(randomMasses(height, massRatio, random), 0, 0.5, random);
  mixFriction(pile, friction, random);
  return PileIsland(pile);
}

/// `reached` means that the law holds, computed again from r alone, and that the reactions are
/// inside their cones and bounds.
void expectSolved(const Problem& problem, const InteriorAttempt& attempt) {
  EXPECT_LE(naturalResidual(problem, attempt.solution.r).max, 1.01 * attempt.tolerance);
  EXPECT_LE(infeasibility(problem, attempt.solution.r),
            1e-8 * (1 + attempt.solution.r.cwiseAbs().maxCoeff()));
}

TEST(InteriorPoint, SolvesPilesAtRestInFewFactorisations) {
  Random random(51);
  int reached = 0, factorisations = 0;
  constexpr int samples = 100;
  for (int k = 0; k < samples; ++k) {
    const PileIsland island(makeTower(randomMasses(1 + k % 6, 10, random), 0.5, 0, random));
    const InteriorAttempt cold = run<BodyMotion>(island.problem);
    if (!cold.reached) continue;
    ++reached;
    factorisations += cold.solution.factorisations;
    expectSolved(island.problem, cold);
  }
  EXPECT_GE(reached, 95);
  EXPECT_LE(factorisations, 20 * reached);
}

// Where contacts slide, reaction and velocity both lie on the boundary of the cone, and the last
// digits are lost. The walk can finish from there.
TEST(InteriorPoint, BringsMovingPilesNearTheLaw) {
  Random random(58);
  int near = 0;
  constexpr int samples = 100;
  for (int k = 0; k < samples; ++k) {
    const PileIsland island = mixedTower(1 + k % 6, 10, 0.8, random);
    const InteriorAttempt cold = run<BodyMotion>(island.problem);
    if (cold.solution.residual < 1e-2 * island.problem.q.cwiseAbs().maxCoeff()) ++near;
    EXPECT_LE(cold.solution.factorisations, 60);
  }
  EXPECT_GE(near, 90);
}

// The same with rolling and spinning friction.
TEST(InteriorPoint, BringsTurningHeapsNearTheLaw) {
  Random random(59);
  int near = 0, atRest = 0;
  constexpr int samples = 60;
  for (int k = 0; k < samples; ++k) {
    Pile heap = makeHeap(1 + k % 8, 0.5, random);
    resistTurning(heap, 0.1, random);
    const Problem moving = PileIsland(heap).problem;
    const InteriorAttempt cold = run<BodyMotion>(moving);
    if (cold.solution.residual < 1e-2 * moving.q.cwiseAbs().maxCoeff()) ++near;

    Pile tower = makeTower(randomMasses(1 + k % 4, 3, random), 0.5, 0, random);
    resistTurning(tower, 0.1, random);
    const PileIsland island(tower);
    const InteriorAttempt still = run<BodyMotion>(island.problem);
    if (!still.reached) continue;
    ++atRest;
    expectSolved(island.problem, still);
  }
  EXPECT_GE(near, 50);
  EXPECT_GE(atRest, 55);
}

// W = I: r = −q_n (1, −μ d), d the direction of the slip.
TEST(InteriorPoint, ASlidingParticleInClosedForm) {
  for (const double mu : {0.1, 0.5, 2.0}) {
    Problem problem;
    problem.W = DelassusMatrix(DelassusMatrix::Sparse(MatrixXd::Identity(3, 3).sparseView()));
    problem.q = Vec3(-1, 2.4, -3.2);
    problem.friction = VectorXd::Constant(1, mu);
    const InteriorAttempt cold = run<FactoredMotion>(problem);
    EXPECT_TRUE(cold.reached) << "mu " << mu;
    EXPECT_LT((cold.solution.r - Vec3(1, -0.6 * mu, 0.8 * mu)).norm(), 1e-6) << "mu " << mu;
  }
}

// Without friction the problem is convex: no start and no mass ratio can stop it.
TEST(InteriorPoint, AlwaysSolvesFrictionlessIslands) {
  Random random(52);
  for (int k = 0; k < 60; ++k) {
    const PileIsland island(
        withoutFriction(makeTower(randomMasses(1 + k % 8, 1e3, random), 0, 0.5, random)));
    const InteriorAttempt cold = run<BodyMotion>(island.problem);
    EXPECT_TRUE(cold.reached) << "tower " << k;
    expectSolved(island.problem, cold);
  }
}

// Joints, motors, limits; bounded on either side, on both or on none.
TEST(InteriorPoint, RowsOfEveryKind) {
  Random random(53);
  for (int k = 0; k < 100; ++k) {
    const int m = 1 + k % 12;
    Problem problem;
    problem.W = DelassusMatrix(
        DelassusMatrix::Sparse(randomDelassus(m, std::pow(10, k % 4), random).sparseView()));
    problem.q = normalVector(m, random);
    problem.friction.resize(0);
    problem.lower.resize(m);
    problem.upper.resize(m);
    for (int i = 0; i < m; ++i) {
      problem.lower[i] = i % 4 == 1 ? -infinity : i % 4 == 2 ? -0.3 : i % 4 == 3 ? -infinity : 0;
      problem.upper[i] = i % 4 == 1 ? 0.1 : i % 4 == 2 ? 0.2 : infinity;
    }
    const InteriorAttempt cold = run<FactoredMotion>(problem);
    EXPECT_TRUE(cold.reached) << "sample " << k;
    expectSolved(problem, cold);
  }
}

// Bounds that are finite, but so far off that hi − lo overflows, act as if there were none.
TEST(InteriorPoint, BoundsThatNoReactionComesNear) {
  Random random(55);
  constexpr int rows = 6;
  Problem problem;
  problem.W = DelassusMatrix(DelassusMatrix::Sparse(randomDelassus(rows, 10, random).sparseView()));
  problem.q = normalVector(rows, random);
  problem.friction.resize(0);
  problem.lower = VectorXd::Constant(rows, -1.5e308);
  problem.upper = VectorXd::Constant(rows, 1.5e308);
  problem.lower[0] = 0;
  const InteriorAttempt bounded = run<FactoredMotion>(problem);
  EXPECT_TRUE(bounded.reached);
  expectSolved(problem, bounded);
  problem.lower.tail(rows - 1).setConstant(-infinity);
  problem.upper.setConstant(infinity);
  EXPECT_EQ(bounded.solution.r, run<FactoredMotion>(problem).solution.r);
}

// W = I, one number each: the reaction is at the rim −κ r_n, or less where that is enough to stop.
TEST(InteriorPoint, ASpinningParticleInClosedForm) {
  for (const double spin : {0.1, 0.4, 3.0}) {
    Problem problem;
    problem.W = DelassusMatrix(DelassusMatrix::Sparse(MatrixXd::Identity(2, 2).sparseView()));
    problem.q = Vec2(-2, spin);
    problem.lower = Vec2(0, -infinity);
    problem.upper = Vec2(infinity, infinity);
    problem.disks = {{1, 1, 0, 0.1}};
    const InteriorAttempt cold = run<FactoredMotion>(problem);
    EXPECT_TRUE(cold.reached) << spin;
    EXPECT_NEAR(cold.solution.r[1], -std::min(spin, 0.2), 1e-6) << spin;
  }
}

// Both motion spaces are spaces of the same motion, and without friction there is only one motion.
TEST(InteriorPoint, FindsTheSameMotionInEitherSpace) {
  Random random(54);
  for (int k = 0; k < 20; ++k) {
    const PileIsland island(
        withoutFriction(makeTower(randomMasses(1 + k % 4, 10, random), 0, 0.5, random)));
    const InteriorAttempt bodies = run<BodyMotion>(island.problem);
    const InteriorAttempt factored = run<FactoredMotion>(withEntries(island.problem));
    ASSERT_TRUE(bodies.reached && factored.reached);
    EXPECT_LT(motionDistance(island, bodies.solution.r, factored.solution.r), 1e-6);
  }
}

// Four corners under a level box have equal shares, since the proximal weight shares evenly between
// redundant contacts.
TEST(InteriorPoint, EqualContactsShareEqually) {
  Random random(55);
  const PileIsland island(makeTower({2}, 0.5, 0, random));
  const InteriorAttempt cold = run<BodyMotion>(island.problem);
  ASSERT_TRUE(cold.reached);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(cold.solution.r[3 * i], 2 * 9.81 / 60 / 4, 1e-6);
}

// Whatever the guess, and however early it is stopped, the answer is not worse than the guess.
TEST(InteriorPoint, NeverReturnsAWorseAnswerThanItWasGiven) {
  Random random(56);
  for (int k = 0; k < 60; ++k) {
    const PileIsland island = mixedTower(1 + k % 6, 1e3, 2, random);
    const VectorXd start = randomReactions(island.problem, 1, random);
    const double before = naturalResidual(island.problem, start).max;
    const int budget = k % 20;
    const InteriorAttempt stopped = run<BodyMotion>(island.problem, budget, start);
    EXPECT_LE(stopped.solution.residual, before);
    EXPECT_LE(stopped.solution.factorisations, budget);
    EXPECT_NEAR(naturalResidual(island.problem, stopped.solution.r).max, stopped.solution.residual,
                1e-12 * (1 + before));
  }
}

// The start is cold: the guess is only the answer that must be beaten.
TEST(InteriorPoint, DoesNotDependOnTheGuess) {
  Random random(57);
  for (int k = 0; k < 20; ++k) {
    const PileIsland island = mixedTower(1 + k % 5, 10, 0.5, random);
    const InteriorAttempt cold = run<BodyMotion>(island.problem);
    const InteriorAttempt warm =
        run<BodyMotion>(island.problem, 60, randomReactions(island.problem, 1, random));
    ASSERT_EQ(cold.reached, warm.reached);
    if (cold.reached) {
      EXPECT_EQ(cold.solution.r, warm.solution.r);
    }
  }
}

}  // namespace
}  // namespace delassus
