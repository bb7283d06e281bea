/// The method of alternating directions alone.
#include <gtest/gtest.h>

#include "delassus/alternation.h"
#include "delassus/solver.h"
#include "tests/support/random_piles.h"
#include "tests/support/turning_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

template <class Motion>
bool alternate(const Problem& problem, double tolerance, int budget, Solution& best) {
  NaturalMap map;
  map.setProblem(problem);
  best = startFrom(problem, map, best.r.size() > 0 ? best.r : VectorXd::Zero(problem.size()));
  ProximalSpace<Motion> space;
  space.setProblem(problem, map);
  return Alternation<Motion>(space).alternate(tolerance, budget, best);
}

// Eight contacts of each box squeeze each other. A walk needs many regions to unravel them, this
// method hardly any alternations.
TEST(Alternating, BringsPyramidsToRest) {
  Random random(121);
  for (const int base : {2, 5, 8}) {
    const PileIsland island(makePyramid(base, 0.5, 0, 1, random));
    const double tolerance = 1e-10 * island.problem.q.cwiseAbs().maxCoeff();
    Solution best;
    EXPECT_TRUE(alternate<BodyMotion>(island.problem, tolerance, 200, best)) << base;
    EXPECT_LE(naturalResidual(island.problem, best.r).max, tolerance);
    EXPECT_LE(infeasibility(island.problem, best.r), 1e-14 * best.r.norm());
    EXPECT_LE(best.factorisations, 1);
    EXPECT_LE(best.sweeps, 200);
  }
}

// Whatever moves, with rows, with disks, in either motion space: the answer keeps to the cones and
// is never worse than the start.
TEST(Alternating, LosesNothing) {
  Random random(122);
  for (int k = 0; k < 40; ++k) {
    Pile pile = makeHeap(3 + k % 8, 0.4, random);
    pile.rows.push_back(makeWeakMotor());
    if (k % 2) resistTurning(pile, 0.1, random);
    const Problem problem = PileIsland(pile).problem;
    Solution best;
    best.r = randomReactions(problem, 0.3, random);
    const double before = naturalResidual(problem, best.r).max;
    const bool reached = alternate<BodyMotion>(problem, 1e-8, 300, best);
    const double after = naturalResidual(problem, best.r).max;
    EXPECT_LE(after, before);
    EXPECT_EQ(reached, after <= 1e-8);
    Solution explicitly;
    explicitly.r = VectorXd::Zero(problem.size());
    const Problem entries = withEntries(problem);
    const double atRest = naturalResidual(entries, explicitly.r).max;
    alternate<FactoredMotion>(entries, 1e-8, 300, explicitly);
    EXPECT_LE(naturalResidual(entries, explicitly.r).max, atRest);
    EXPECT_LE(infeasibility(entries, explicitly.r), 1e-13 * (1 + explicitly.r.norm()));
  }
}

// Where contacts slide, De Saxcé's shift has to find the slip: the bodies stay on the ground, and
// the friction lies at the edge of its cone.
TEST(Alternating, LetsBodiesSlide) {
  Random random(124);
  for (int k = 0; k < 10; ++k) {
    Pile pile = makeTower({1}, uniform(random, 0.1, 0.5), 0, random);
    pile.bodies[0].velocity[0] += 3;
    const Problem problem = PileIsland(pile).problem;
    Solution best;
    alternate<BodyMotion>(problem, 1e-12, 3000, best);
    EXPECT_LT(best.residual, 1e-2 * problem.q.cwiseAbs().maxCoeff()) << k;
    double most = 0, friction = 0;
    for (int i = 0; i < problem.contacts(); ++i) {
      most += problem.friction[i] * best.r[3 * i];
      friction += best.r.segment<2>(3 * i + 1).norm();
    }
    EXPECT_GT(most, 0) << k;
    EXPECT_NEAR(friction, most, 0.02 * most) << k;
  }
}

// A solution is a fixed point, and is recognised at the first look.
TEST(Alternating, StaysAtASolution) {
  Random random(123);
  for (int k = 0; k < 20; ++k) {
    Pile pile = makeHeap(3 + k % 8, 0.4, random);
    if (k % 2) resistTurning(pile, 0.1, random);
    const Problem problem = PileIsland(pile).problem;
    const Solution solved = Solver().solve(problem);
    ASSERT_EQ(solved.status, Status::Solved);
    Solution best;
    best.r = solved.r;
    EXPECT_TRUE(alternate<BodyMotion>(problem, 1e-7, 10, best));
    EXPECT_LT((best.r - solved.r).norm(), 1e-5 * (1 + solved.r.norm()));
  }
}

}  // namespace
}  // namespace delassus
