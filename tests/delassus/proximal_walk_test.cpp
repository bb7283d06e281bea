/// The walk from region to region.
#include "delassus/proximal_walk.h"

#include <gtest/gtest.h>

#include "tests/support/random_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

/// A walk with all the objects that it needs.
template <class Motion>
class Walk {
 public:
  explicit Walk(const Problem& problem)
      : problem_(problem), tolerance_(1e-10 * problem.q.cwiseAbs().maxCoeff()) {
    map_.setProblem(problem_);
    space_.setProblem(problem_, map_);
  }

  Solution from(const VectorXd& r) const { return startFrom(problem_, map_, r); }
  Solution atRest() const { return from(VectorXd::Zero(problem_.size())); }
  Outcome walk(Solution& best, double alpha = 1e-2, int budget = 200) {
    return walk_.walk(tolerance_, alpha, budget, best);
  }
  Outcome walkOn(Solution& best, int patience, int budget) {
    return walk_.walkOn(tolerance_, 1e-1, patience, budget, best);
  }
  Outcome walkFromRegion(Solution& best, double alpha = 1e-6) {
    return walk_.walkFromRegion(tolerance_, alpha, 200, best);
  }
  double tolerance() const { return tolerance_; }

 private:
  const Problem& problem_;
  double tolerance_;
  NaturalMap map_;
  ProximalSpace<Motion> space_;
  ProximalWalk<Motion> walk_{space_};
};

using BodyWalk = Walk<BodyMotion>;

PileIsland smoothTower(int height, double massRatio, Random& random) {
  return PileIsland(
      withoutFriction(makeTower(randomMasses(height, massRatio, random), 0, 0.5, random)));
}

/// Alternating loads on the corners of the lowest box: J̃ᵀ s = 0, felt by no body.
VectorXd selfStress(const PileIsland& island, double size) {
  VectorXd s = VectorXd::Zero(island.problem.size());
  for (int corner = 0; corner < 4; ++corner)
    s[3 * corner] = corner == 0 || corner == 3 ? size : -size;
  return s;
}

TEST(ProximalWalk, ReachedMeansThatTheLawHolds) {
  Random random(61);
  int reached = 0;
  constexpr int samples = 100;
  for (int k = 0; k < samples; ++k) {
    Pile pile = makeTower(randomMasses(1 + k % 5, 10, random), 0, 0.1, random);
    mixFriction(pile, 0.5, random);
    const PileIsland island(pile);
    BodyWalk walk(island.problem);
    Solution best = walk.atRest();
    const Outcome outcome = walk.walk(best, 1e-1);
    ASSERT_NE(outcome, Outcome::Incompatible);
    if (outcome != Outcome::Reached) continue;
    ++reached;
    const double roundOff = 1e-14 * best.r.cwiseAbs().maxCoeff();
    EXPECT_LE(naturalResidual(island.problem, best.r).max, 1.01 * walk.tolerance() + roundOff);
    EXPECT_LE(infeasibility(island.problem, best.r), 1e-15 * (1 + best.r.norm()));
  }
  EXPECT_GE(reached, 90);
}

// A fixed point is an exact solution for any α: the regularisation leaves no trace.
TEST(ProximalWalk, TheWeightLeavesNoTraceInTheMotion) {
  Random random(62);
  for (int k = 0; k < 30; ++k) {
    const PileIsland island = smoothTower(1 + k % 6, 100, random);
    BodyWalk walk(island.problem);
    Solution first = walk.atRest();
    ASSERT_EQ(walk.walk(first, 1e-1), Outcome::Reached);
    for (const double alpha : {1e-2, 1e-4, 1e-6}) {
      Solution other = walk.atRest();
      ASSERT_EQ(walk.walk(other, alpha), Outcome::Reached) << "tower " << k << " α " << alpha;
      EXPECT_LT(motionDistance(island, first.r, other.r), 1e-7);
    }
  }
}

TEST(ProximalWalk, TheMotionDoesNotDependOnTheStart) {
  Random random(63);
  for (int k = 0; k < 50; ++k) {
    const PileIsland island = smoothTower(1 + k % 6, 1e3, random);
    BodyWalk walk(island.problem);
    Solution cold = walk.atRest();
    Solution warm = walk.from(randomReactions(island.problem, 1, random));
    ASSERT_EQ(walk.walk(cold), Outcome::Reached) << "tower " << k;
    ASSERT_EQ(walk.walk(warm), Outcome::Reached) << "tower " << k;
    EXPECT_LT(motionDistance(island, cold.r, warm.r), 1e-7);
  }
}

// A body space has the columns of J̃, a factored W those of its rank: the walk is the same in both.
TEST(ProximalWalk, TheSpaceDoesNotMatter) {
  Random random(64);
  for (int k = 0; k < 20; ++k) {
    const PileIsland island = smoothTower(1 + k % 4, 10, random);
    const Problem entries = withEntries(island.problem);
    BodyWalk inBodies(island.problem);
    Walk<FactoredMotion> factored(entries);
    Solution a = inBodies.atRest(), b = factored.atRest();
    ASSERT_EQ(inBodies.walk(a), Outcome::Reached);
    ASSERT_EQ(factored.walk(b), Outcome::Reached);
    EXPECT_LT(motionDistance(island, a.r, b.r), 1e-7);
  }
}

// If the region of the solution is given at the start, it is the only one that is factored.
TEST(ProximalWalk, AKnownRegionIsFactoredOnce) {
  Random random(65);
  for (const int height : {1, 4, 10}) {
    const PileIsland island(makeTower(std::vector<double>(height, 2), 0.5, 0, random));
    BodyWalk walk(island.problem);
    Solution best = walk.atRest();
    std::fill(best.activeSet.contacts.begin(), best.activeSet.contacts.end(), Mode::Stick);
    ASSERT_EQ(walk.walkFromRegion(best), Outcome::Reached);
    EXPECT_EQ(best.factorisations, 1);
  }
}

// The corners of a level tower all carry the same, whatever the guess was.
TEST(ProximalWalk, FromTheRegionTheShareIsTheSmoothest) {
  Random random(66);
  const int height = 3;
  const PileIsland island(makeTower(std::vector<double>(height, 2), 0.5, 0, random));
  BodyWalk walk(island.problem);
  for (const double stress : {0.0, 0.01}) {
    Solution best = walk.from(selfStress(island, stress));
    std::fill(best.activeSet.contacts.begin(), best.activeSet.contacts.end(), Mode::Stick);
    ASSERT_EQ(walk.walkFromRegion(best), Outcome::Reached);
    for (int i = 0; i < island.problem.contacts(); ++i) {
      const int above = height - i / 4;
      EXPECT_NEAR(best.r[3 * i], above * 2 * 9.81 / 60 / 4, 1e-6);
    }
  }
}

// The reactions of the last step may hold a self-stress, which no demand asks to change.
TEST(ProximalWalk, ASelfStressThatNothingFeelsIsKept) {
  Random random(67);
  const PileIsland island(makeTower({2, 2, 2}, 0.5, 0, random));
  BodyWalk walk(island.problem);
  Solution smooth = walk.atRest();
  ASSERT_EQ(walk.walk(smooth), Outcome::Reached);
  const VectorXd stress = selfStress(island, 0.02);

  VectorXd disturbed = smooth.r + stress;
  disturbed[2] += 0.01;  // and something to correct
  Solution best = walk.from(disturbed);
  ASSERT_EQ(walk.walk(best, 1e-4), Outcome::Reached);
  const double kept = stress.dot(best.r - smooth.r) / stress.squaredNorm();
  EXPECT_NEAR(kept, 1, 1e-2);
  EXPECT_LT(motionDistance(island, best.r, smooth.r), 1e-7);
}

TEST(ProximalWalk, NeverReturnsAWorseAnswerThanItWasGiven) {
  Random random(68);
  for (int k = 0; k < 60; ++k) {
    Pile pile = makeTower(randomMasses(1 + k % 6, 1e3, random), 0, 1, random);
    mixFriction(pile, 2, random);
    const PileIsland island(pile);
    BodyWalk walk(island.problem);
    Solution best = walk.from(randomReactions(island.problem, 1, random));
    const double before = best.residual;
    const int budget = k % 15;
    walk.walk(best, 1e-2, budget);
    EXPECT_LE(best.residual, before);
    EXPECT_LE(best.regions, budget);
    EXPECT_NEAR(naturalResidual(island.problem, best.r).max, best.residual, 1e-12 * (1 + before));
  }
}

// Masses of one and ten thousand kg: it takes more than 100 regions, each of which gains a little.
TEST(ProximalWalk, GoesOnAsLongAsItGains) {
  Random random(70);
  for (int k = 0; k < 5; ++k) {
    const PileIsland pile(makePyramid(4, 0.4, 0.3, 1e4, random));
    BodyWalk walk(pile.problem);
    Solution patient = walk.atRest(), hasty = walk.atRest(), poor = walk.atRest();
    EXPECT_EQ(walk.walkOn(patient, 400, 10000), Outcome::Reached);
    EXPECT_GT(patient.regions, 100);
    EXPECT_EQ(walk.walkOn(patient, 0, 100), Outcome::Reached);  // is there already

    // And no longer than the patience, plus the rest of an inner solve.
    EXPECT_EQ(walk.walkOn(hasty, 10, 10000), Outcome::Lost);
    EXPECT_GE(hasty.regions, 10);
    EXPECT_LT(hasty.regions, patient.regions);
    EXPECT_EQ(walk.walkOn(poor, 400, 50), Outcome::Lost);
    EXPECT_EQ(poor.regions, 50);
  }
}

// One object serves many islands: nothing of the last one shows.
TEST(ProximalWalk, HasNoMemory) {
  Random random(69);
  const PileIsland large = smoothTower(5, 10, random), small = smoothTower(2, 10, random);
  NaturalMap map;
  ProximalSpace<BodyMotion> used;
  const auto answer = [&](ProximalSpace<BodyMotion>& space, const Problem& problem) {
    map.setProblem(problem);
    space.setProblem(problem, map);
    Solution best = startFrom(problem, map, VectorXd::Zero(problem.size()));
    ProximalWalk<BodyMotion>(space).walk(1e-9, 1e-2, 200, best);
    return best.r;
  };
  answer(used, large.problem);
  const VectorXd second = answer(used, small.problem);
  ProximalSpace<BodyMotion> fresh;
  EXPECT_EQ(second, answer(fresh, small.problem));
}

}  // namespace
}  // namespace delassus
