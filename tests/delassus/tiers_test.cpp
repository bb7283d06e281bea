/// Every method of the library answers the same question. Where the motion is unique, all must find
/// it: frictionless islands (Gauss' principle) and towers at rest.
#include <gtest/gtest.h>

#include "delassus/alternation.h"
#include "delassus/interior_point.h"
#include "delassus/pivoting.h"
#include "delassus/proximal_walk.h"
#include "delassus/region.h"
#include "delassus/solver.h"
#include "delassus/sweeps.h"
#include "tests/support/random_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

class Tiers {
 public:
  explicit Tiers(const Problem& problem) : problem_(problem) {
    tolerance_ = 1e-10 * problem.q.cwiseAbs().maxCoeff();
    map_.setProblem(problem);
  }

  VectorXd sweeps() {
    VectorXd r = VectorXd::Zero(problem_.size());
    Sweeps sweeps;
    sweeps.setProblem(problem_, map_);
    for (int burst = 0; burst < 200 && residual(r) > tolerance_; ++burst) sweeps.sweep(100, r);
    EXPECT_LE(residual(r), 100 * tolerance_) << "sweeps";
    return r;
  }
  VectorXd newton() {
    ProximalSpace<BodyMotion> space;
    space.setProblem(problem_, map_);
    Solution best = startFrom(problem_, map_, VectorXd::Zero(problem_.size()));
    EXPECT_EQ(ProximalWalk<BodyMotion>(space).walk(tolerance_, 1e-2, 400, best), Outcome::Reached);
    return best.r;
  }
  VectorXd alternating() {
    ProximalSpace<BodyMotion> space;
    space.setProblem(problem_, map_);
    Solution best = startFrom(problem_, map_, VectorXd::Zero(problem_.size()));
    EXPECT_TRUE(Alternation<BodyMotion>(space).alternate(tolerance_, 1000, best)) << best.residual;
    return best.r;
  }
  VectorXd interiorPoint() {
    BodyMotion motion;
    motion.setProblem(problem_);
    Solution best = startFrom(problem_, map_, VectorXd::Zero(problem_.size()));
    InteriorPoint<BodyMotion>().solve(motion, problem_, map_, tolerance_, 100, best);
    EXPECT_LE(best.residual, 1000 * tolerance_) << "interior point";
    return best.r;
  }
  VectorXd whole() {
    Options options;
    options.tolerance = 1e-10;
    const Solution solution = Solver(options).solve(problem_);
    EXPECT_EQ(solution.status, Status::Solved);
    return solution.r;
  }
  VectorXd pivoting() {
    const PivotResult result =
        pivot(problem_.W.dense(), problem_.q, problem_.lower, problem_.upper);
    EXPECT_EQ(result.status, Status::Solved);
    return result.r;
  }

 private:
  double residual(const VectorXd& r) const { return naturalResidual(problem_, r).max; }

  const Problem& problem_;
  double tolerance_;
  NaturalMap map_;
};

TEST(Tiers, FrictionlessIslandsHaveOneMotion) {
  Random random(91);
  for (int k = 0; k < 2000; ++k) {
    SCOPED_TRACE(k);
    const double massRatio = k % 2 ? 10 : 1;
    const PileIsland island(withoutFriction(
        k % 5 == 4 ? makePyramid(2, 0, 0.5, massRatio, random)
                   : makeTower(randomMasses(1 + k % 4, massRatio, random), 0, 0.5, random)));
    Tiers tiers(island.problem);
    const VectorXd truth = tiers.pivoting();
    EXPECT_LT(motionDistance(island, truth, tiers.whole()), 1e-7);
    EXPECT_LT(motionDistance(island, truth, tiers.newton()), 1e-7);
    EXPECT_LT(motionDistance(island, truth, tiers.interiorPoint()), 1e-7);
    EXPECT_LT(motionDistance(island, truth, tiers.sweeps()), 1e-7);
  }
}

// Large mass ratios are for the direct methods: pivoting and both Newton methods.
TEST(Tiers, MassRatiosOfAThousand) {
  Random random(92);
  for (int k = 0; k < 2000; ++k) {
    SCOPED_TRACE(k);
    const PileIsland island(
        withoutFriction(makeTower(randomMasses(1 + k % 8, 1e3, random), 0, 0.5, random)));
    Tiers tiers(island.problem);
    const VectorXd truth = tiers.pivoting();
    EXPECT_LT(motionDistance(island, truth, tiers.whole()), 1e-7);
    EXPECT_LT(motionDistance(island, truth, tiers.newton()), 1e-7);
    EXPECT_LT(motionDistance(island, truth, tiers.interiorPoint()), 1e-7);
  }
}

// All boxes fall together and are stopped together: v = 0.
TEST(Tiers, TowersWithFrictionComeToRest) {
  Random random(93);
  for (int k = 0; k < 2000; ++k) {
    SCOPED_TRACE(k);
    const PileIsland island(
        makeTower(randomMasses(1 + k % 3, 3, random), uniform(random, 0.3, 1.5), 0, random));
    Tiers tiers(island.problem);
    const double free = std::sqrt(kineticEnergy(island.pile.bodies));
    for (const VectorXd& r : {tiers.whole(), tiers.newton(), tiers.alternating(), tiers.sweeps()})
      EXPECT_LT(std::sqrt(kineticEnergy(island.after(r))), 1e-7 * free);
  }
}

// Up to six contacts on one body whose normals are independent: here the answer is the paper's
// region itself.
TEST(Tiers, AHandfulOfContactsFindsTheRegionOfThePaper) {
  Random random(94);
  for (int k = 0; k < 4000; ++k) {
    SCOPED_TRACE(k);
    const int n = 1 + k % 5;
    Pile pile;
    pile.bodies.push_back(makeBox(uniform(random, 1, 10), 0.5, normalVector(6, random)));
    for (int i = 0; i < n; ++i) {
      Contact c = makeRestingPoint(0, fixedWorld, normalVector(3, random), Vec3::Zero(), 0);
      c.frame.col(0) =
          normalVector(3, random).normalized();  // frictionless: tangents are not looked at
      pile.contacts.push_back(c);
    }
    const PileIsland island(pile);
    const RegionAnswer region = solveRegion(island.problem.W.dense(), island.problem.q);
    ASSERT_EQ(region.redundancy, Redundancy::None);
    Tiers tiers(island.problem);
    EXPECT_LT(motionDistance(island, region.r, tiers.pivoting()), 1e-7);
    EXPECT_LT(motionDistance(island, region.r, tiers.whole()), 1e-7);
    EXPECT_LT(motionDistance(island, region.r, tiers.interiorPoint()), 1e-6);
  }
}

// Each storage of W has methods of its own; the motion is that of the bodies.
TEST(Tiers, TheStorageOfWDoesNotMatter) {
  Random random(95);
  for (int k = 0; k < 40; ++k) {
    SCOPED_TRACE(k);
    const std::vector<double> masses = randomMasses(1 + k % 5, 100, random);
    const PileIsland island(k % 2 ? withoutFriction(makeTower(masses, 0, 0.5, random))
                                  : makeTower(masses, 0.6, 0, random));
    const Problem entries = withEntries(island.problem);
    EXPECT_LT(motionDistance(island, Tiers(island.problem).whole(), Tiers(entries).whole()), 1e-7);
  }
}

}  // namespace
}  // namespace delassus
