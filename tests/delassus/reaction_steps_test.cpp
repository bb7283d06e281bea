/// Newton's method in the space of reactions.
#include <gtest/gtest.h>

#include "delassus/proximal_walk.h"
#include "delassus/reaction_steps.h"
#include "delassus/read_mode.h"
#include "delassus/solver.h"
#include "tests/support/random_piles.h"
#include "tests/support/turning_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

template <class Motion>
class Attempt {
 public:
  explicit Attempt(const Problem& problem, double share = 1e-9)
      : problem_(problem), tolerance_(share * problem.q.cwiseAbs().maxCoeff()) {
    map_.setProblem(problem_);
    space_.setProblem(problem_, map_);
  }

  bool from(const VectorXd& r, int budget = 100) {
    best = startFrom(problem_, map_, r);
    before = best.residual;
    Solution next;
    return steps_.solve(tolerance_, budget, next, best);
  }
  bool fromRest() { return from(VectorXd::Zero(problem_.size())); }
  double tolerance() const { return tolerance_; }
  const NaturalMap& map() const { return map_; }
  ProximalSpace<Motion>& space() { return space_; }

  Solution best;
  double before = 0;

 private:
  const Problem& problem_;
  double tolerance_;
  NaturalMap map_;
  ProximalSpace<Motion> space_;
  ReactionSteps<Motion> steps_{space_};
};

/// Boxes on each other after a disturbance. Friction differs from contact to contact; some have
/// none.
PileIsland disturbedTower(int height, double massRatio, double disturbance, Random& random) {
  Pile pile = makeTower(randomMasses(height, massRatio, random), 0, disturbance, random);
  mixFriction(pile, 0.5, random);
  return PileIsland(pile);
}

TEST(ReactionSteps, ReachedMeansThatTheLawHolds) {
  Random random(301);
  constexpr int samples = 100;
  int reached = 0;
  for (int k = 0; k < samples; ++k) {
    const PileIsland island = disturbedTower(1 + k % 5, 10, 0.1, random);
    Attempt<BodyMotion> attempt(island.problem);
    const bool isReached = attempt.fromRest();
    EXPECT_EQ(isReached, attempt.best.residual <= attempt.tolerance());
    EXPECT_LE(attempt.best.residual, attempt.before);
    EXPECT_LE(infeasibility(island.problem, attempt.best.r), 1e-15 * (1 + attempt.best.r.norm()));
    EXPECT_NEAR(naturalResidual(island.problem, attempt.best.r).max, attempt.best.residual,
                1e-12 * (1 + attempt.before));
    if (isReached) ++reached;
  }
  EXPECT_GE(reached, 0.9 * samples);
}

// Without friction there is one motion, whatever finds it and from wherever.
TEST(ReactionSteps, MovesAsTheWalkDoes) {
  Random random(302);
  for (int k = 0; k < 30; ++k) {
    const PileIsland island(
        withoutFriction(makeTower(randomMasses(1 + k % 6, 100, random), 0, 0.5, random)));
    Attempt<BodyMotion> attempt(island.problem);
    ASSERT_TRUE(attempt.from(randomReactions(island.problem, 1, random))) << k;
    const Solution walked = solve(island.problem);
    ASSERT_EQ(walked.status, Status::Solved);
    EXPECT_LT(motionDistance(island, attempt.best.r, walked.r), 1e-7);
  }
}

// A body space has the columns of J̃, a factored W those of its rank: the steps are the same in
// both.
TEST(ReactionSteps, TheSpaceDoesNotMatter) {
  Random random(303);
  int both = 0;
  for (int k = 0; k < 30; ++k) {
    const PileIsland island = disturbedTower(1 + k % 4, 3, 0.1, random);
    const Problem entries = withEntries(island.problem);
    Attempt<BodyMotion> inBodySpace(island.problem);
    Attempt<FactoredMotion> factored(entries);
    const bool isReached = inBodySpace.fromRest() && factored.fromRest();
    if (!isReached || inBodySpace.best.regions != factored.best.regions) continue;
    ++both;
    EXPECT_LT(motionDistance(island, inBodySpace.best.r, factored.best.r), 1e-7);
  }
  EXPECT_GE(both, 20);
}

// Reactions that are right but for a few digits have the right region, and need no search.
TEST(ReactionSteps, FewStepsMendWhatIsNearlyRight) {
  Random random(304);
  int few = 0;
  constexpr int samples = 50;
  for (int k = 0; k < samples; ++k) {
    const PileIsland island = disturbedTower(2 + k % 4, 10, 0.1, random);
    const Solution solved = solve(island.problem);
    ASSERT_EQ(solved.status, Status::Solved);
    const VectorXd nearly =
        solved.r + 1e-3 * solved.r.cwiseProduct(normalVector(island.problem.size(), random));
    Attempt<BodyMotion> attempt(island.problem);
    const bool isReached = attempt.from(nearly);
    few += isReached && attempt.best.regions <= 10 ? 1 : 0;
  }
  EXPECT_GE(few, 0.9 * samples);
}

// A pyramid slides over the ground as a whole, so that all its contacts are at the limit of their
// friction, and three in four of them do not slip. Its hundreds of contacts change their regions
// one after the other on the way from far off; from reactions that are nearly right, steps in the
// space of reactions lead home.
TEST(ReactionSteps, MendAPileThatSlidesAsAWhole) {
  constexpr int few = 15;
  int regions = 0, samples = 0;
  for (const int base : {4, 5})
    for (const double speed : {0.3, 1.0}) {
      Random random(308);
      Pile pile = makePyramid(base, 0.4, 0, 1, random);
      for (Body& box : pile.bodies) box.velocity.head<2>() += speed * Vec2(1, 0.3);
      const PileIsland island(pile);
      const int n = island.problem.contacts();
      const Solution solved = solve(island.problem);
      ASSERT_EQ(solved.status, Status::Solved);
      int atTheLimit = 0;
      for (const Mode mode : solved.activeSet.contacts) atTheLimit += mode == Mode::Slide ? 1 : 0;
      EXPECT_GT(atTheLimit, 0.9 * n);
      for (const double error : {1e-7, 1e-6, 1e-5}) {
        const VectorXd nearly =
            solved.r + error * solved.r.cwiseProduct(normalVector(3 * n, random));
        const Solution mended = Solver().solve(island.problem, nearly);
        EXPECT_EQ(mended.status, Status::Solved);
        EXPECT_LT(motionDistance(island, mended.r, solved.r), 1e-7);
        regions += mended.regions;
        ++samples;
      }
    }
  EXPECT_LE(regions, few * samples);
}

/// Balls that resist rolling and spinning, some of them only up to a load.
PileIsland turningHeap(int balls, double disturbance, Random& random) {
  Pile pile = makeHeap(balls, 0.5, random);
  for (Body& ball : pile.bodies) ball.velocity += disturbance * normalVector(6, random);
  mixFriction(pile, 0.8, random);
  resistTurning(pile, 0.2, random);
  for (Row& row : pile.rows)
    if (uniform(random, 0, 1) < 0.3) row.mostLoad = uniform(random, 0.01, 0.3);
  return PileIsland(pile);
}

TEST(ReactionSteps, TurningFrictionTakesFewSteps) {
  Random random(307);
  int reached = 0, few = 0;
  std::vector<int> modes(3);
  constexpr int samples = 200;
  for (int k = 0; k < samples; ++k) {
    const PileIsland heap = turningHeap(1 + k % 5, k % 2, random);
    Attempt<BodyMotion> attempt(heap.problem);
    const bool isReached = attempt.fromRest();
    EXPECT_EQ(isReached, attempt.best.residual <= attempt.tolerance());
    EXPECT_LE(infeasibility(heap.problem, attempt.best.r), 1e-15 * (1 + attempt.best.r.norm()));
    EXPECT_NEAR(naturalResidual(heap.problem, attempt.best.r).max, attempt.best.residual,
                1e-12 * (1 + attempt.before));
    if (!isReached) continue;
    ++reached;
    readActiveSet(heap.problem, attempt.map().diagonal(), attempt.best.r, attempt.best.u,
                  attempt.best.activeSet);
    for (const Mode mode : attempt.best.activeSet.disks) ++modes[static_cast<int>(mode)];
    // Newton's method doubles the digits of reactions that are right but for a few.
    const VectorXd nearly = attempt.best.r + 1e-3 * attempt.best.r.cwiseProduct(
                                                        normalVector(heap.problem.size(), random));
    Attempt<BodyMotion> second(heap.problem);
    few += second.from(nearly) && second.best.regions <= 5 ? 1 : 0;
  }
  EXPECT_GE(reached, 0.9 * samples);
  EXPECT_GE(few, 0.9 * reached);
  for (const int count : modes) EXPECT_GE(count, 20);
}

TEST(ReactionSteps, SpendsNoMoreThanItsBudgetAndLosesNothing) {
  Random random(305);
  for (int k = 0; k < 60; ++k) {
    const PileIsland island = disturbedTower(1 + k % 6, 1e3, 1, random);
    Attempt<BodyMotion> attempt(island.problem);
    const int budget = 1 + k % 15;
    attempt.from(randomReactions(island.problem, 1, random), budget);
    EXPECT_LE(attempt.best.residual, attempt.before);
    EXPECT_LE(attempt.best.regions, budget);
    EXPECT_EQ(attempt.best.regions, attempt.best.factorisations);
  }
}

// It uses the vectors of the walk, but the walk does not show it.
TEST(ReactionSteps, LeaveTheWalkAsItWas) {
  Random random(306);
  const PileIsland island = disturbedTower(4, 10, 0.1, random);
  const auto walk = [&](Attempt<BodyMotion>& attempt) {
    NaturalMap map;
    map.setProblem(island.problem);
    Solution best = startFrom(island.problem, map, VectorXd::Zero(island.problem.size()));
    ProximalWalk<BodyMotion>(attempt.space()).walk(attempt.tolerance(), 1e-2, 200, best);
    return best.r;
  };
  Attempt<BodyMotion> used(island.problem), fresh(island.problem);
  used.fromRest();
  EXPECT_EQ(walk(used), walk(fresh));
}

}  // namespace
}  // namespace delassus
