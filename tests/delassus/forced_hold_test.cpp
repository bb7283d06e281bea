/// Piles at rest: all contacts held at once, with reactions inside their cones.
#include <gtest/gtest.h>

#include <algorithm>

#include "delassus/forced_hold.h"
#include "delassus/solver.h"
#include "tests/support/random_piles.h"
#include "tests/support/turning_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

constexpr int budget = 40;

/// Holds all contacts and rows, from the reactions of `best` if it has any.
template <class Motion>
bool holdAll(const Problem& problem, double tolerance, Solution& best) {
  NaturalMap map;
  map.setProblem(problem);
  best = startFrom(problem, map, best.r.size() > 0 ? best.r : VectorXd::Zero(problem.size()));
  best.activeSet.contacts.assign(problem.contacts(), Mode::Stick);
  best.activeSet.rows.assign(problem.rows(), RowState::Free);
  best.activeSet.disks.assign(problem.disks.size(), Mode::Stick);
  ProximalSpace<Motion> space;
  space.setProblem(problem, map);
  return ForcedHold<Motion>(space).hold(tolerance, budget, best);
}

double toleranceOf(const Problem& problem) { return 1e-10 * problem.q.cwiseAbs().maxCoeff(); }

// Eight contacts share the load of a box in many ways, most of which pull somewhere. A few steps
// find a share that does not.
TEST(Holding, BringsPyramidsToRestInFewSteps) {
  Random random(131);
  for (const int base : {2, 5, 8, 12}) {
    const Problem problem = PileIsland(makePyramid(base, 0.5, 0, 1, random)).problem;
    Solution best;
    EXPECT_TRUE(holdAll<BodyMotion>(problem, toleranceOf(problem), best)) << base;
    EXPECT_LE(naturalResidual(problem, best.r).max, toleranceOf(problem));
    EXPECT_EQ(infeasibility(problem, best.r), 0);
    EXPECT_EQ(best.factorisations, 1);
    EXPECT_LE(best.sweeps, 10) << base;
  }
}

// Holds masses that differ, contacts that give a little, rolling and spinning friction, and W as
// entries.
TEST(Holding, HoldsWhatTheSceneHas) {
  Random random(132);
  for (int k = 0; k < 12; ++k) {
    // Where contacts give, the loads have only one share, which in a pyramid asks for more friction
    // than there is.
    const bool gives = k % 4 == 1;
    Pile pile = gives ? makeTower({1, 3, 2}, 0.6, 0, random)
                      : makePyramid(2 + k % 4, 0.6, 0, k % 3 == 0 ? 10 : 1, random);
    if (k % 2) resistTurning(pile, 0.1, random);
    if (gives)
      for (Contact& contact : pile.contacts) contact.compliance = 1e-3;
    const Problem problem = PileIsland(pile).problem;
    const double tolerance = toleranceOf(problem);
    Solution best;
    EXPECT_TRUE(holdAll<BodyMotion>(problem, tolerance, best)) << k;
    EXPECT_LE(naturalResidual(problem, best.r).max, tolerance) << k;
    constexpr int few = 150;  // contacts whose entries are factored at once
    if (problem.contacts() > few) continue;
    const Problem entries = withEntries(problem);
    Solution explicitly;
    EXPECT_TRUE(holdAll<FactoredMotion>(entries, tolerance, explicitly)) << k;
    EXPECT_LE(naturalResidual(entries, explicitly.r).max, tolerance) << k;
  }
}

Options hurried() {
  Options options;
  options.newtonBudget = 1;
  options.sweepBudget = 2;
  return options;
}

// Holding costs one region. So even with a budget of one region and next to no sweeps, piles at
// rest are solved.
TEST(Holding, IsWithinTheSmallestBudget) {
  Random random(137);
  for (const int base : {3, 5, 12}) {
    const Problem problem = PileIsland(makePyramid(base, 0.5, 0, 1, random)).problem;
    const Solution solution = Solver(hurried()).solve(problem);
    EXPECT_EQ(solution.status, Status::Solved) << base;
    EXPECT_EQ(solution.regions, 1) << base;
    EXPECT_EQ(solution.sweeps, 0) << base;
  }
}

// Where holding fails, the sweeps begin where they would have begun without it.
TEST(Holding, TakesNoSweepsFromASmallBudget) {
  Random random(138);
  Pile pile = makePyramid(8, 0.5, 0, 1, random);
  pile.bodies.back().velocity[0] += 6;
  const Problem problem = PileIsland(pile).problem;
  Options sweepsAlone = hurried();
  sweepsAlone.newtonBudget = 0;
  const Solution tried = Solver(hurried()).solve(problem);
  const Solution swept = Solver(sweepsAlone).solve(problem);
  EXPECT_EQ(tried.regions, 1);
  EXPECT_EQ(tried.sweeps, hurried().sweepBudget);
  EXPECT_LE((tried.r - swept.r).norm(), 1e-12 * swept.r.norm());
}

// Where rounding keeps it from the tolerance, it is still the best answer.
TEST(Holding, IsTakenIfItIsBetterThanSweeps) {
  Random random(139);
  const Problem problem = PileIsland(makePyramid(5, 0.5, 0, 1, random)).problem;
  Options options = hurried();
  options.tolerance = 1e-18;
  const Solution solution = Solver(options).solve(problem);
  EXPECT_LE(solution.residual, 1e-12 * problem.q.cwiseAbs().maxCoeff());
  EXPECT_EQ(solution.sweeps, hurried().sweepBudget);
}

// A box that slides or flies off cannot be held. That is found out soon, and nothing is lost.
TEST(Holding, GivesUpWhereSomethingGivesWay) {
  Random random(133);
  for (int k = 0; k < 40; ++k) {
    Pile pile = k % 2 ? makeHeap(3 + k % 8, 0.4, random)
                      : makeTower({1, 1, 1}, uniform(random, 0.1, 0.5), 0, random);
    for (Body& body : pile.bodies)
      if (body.movable()) body.velocity[0] += uniform(random, 3, 9);
    if (k % 4 > 1) pile.rows.push_back(makeWeakMotor());
    const Problem problem = PileIsland(pile).problem;
    Solution best;
    best.r = randomReactions(problem, 0.3, random);
    const double before = naturalResidual(problem, best.r).max;
    EXPECT_FALSE(holdAll<BodyMotion>(problem, toleranceOf(problem), best)) << k;
    EXPECT_LE(naturalResidual(problem, best.r).max, before) << k;
    EXPECT_LE(best.sweeps, 20) << k;
  }
}

// Contacts that are not held have no reactions. Where bodies would meet, the answer is not taken.
TEST(Holding, LetsGoOfWhatIsOpen) {
  Random random(134);
  Pile pile = makeTower({1, 1}, 0.5, 0, random);
  const Problem problem = PileIsland(pile).problem;
  NaturalMap map;
  map.setProblem(problem);
  ProximalSpace<BodyMotion> space;
  space.setProblem(problem, map);
  ForcedHold<BodyMotion> forced(space);
  for (const int open : {0, problem.contacts()}) {
    Solution best = startFrom(problem, map, randomReactions(problem, 0.3, random));
    best.activeSet.contacts.assign(problem.contacts(), Mode::Stick);
    std::fill_n(best.activeSet.contacts.begin(), open, Mode::Open);
    EXPECT_EQ(forced.hold(toleranceOf(problem), budget, best), open == 0);
  }
}

// A block is held well below the friction angle, and not above it.
TEST(Holding, KnowsTheFrictionAngle) {
  for (const double mu : {0.2, 0.4, 0.6})
    for (const double share : {0.3, 0.6, 1.01, 2.0}) {
      Random random(135);
      Pile pile = makeTower({1}, mu, 0, random);
      for (Body& body : pile.bodies)
        if (body.movable()) body.velocity << share * mu * 0.1635, 0, -0.1635, 0, 0, 0;
      const Problem problem = PileIsland(pile).problem;
      Solution best;
      const bool held = holdAll<BodyMotion>(problem, toleranceOf(problem), best);
      EXPECT_EQ(held, share < 1) << mu << " " << share;
      EXPECT_EQ(held, Solver().solve(problem).u.cwiseAbs().maxCoeff() < 1e-9);
    }
}

// Reactions of the last step that hold already are left as they are.
TEST(Holding, StaysAtASolution) {
  Random random(136);
  const Problem problem = PileIsland(makePyramid(6, 0.5, 0, 1, random)).problem;
  Solution best;
  ASSERT_TRUE(holdAll<BodyMotion>(problem, toleranceOf(problem), best));
  const VectorXd before = best.r;
  EXPECT_TRUE(holdAll<BodyMotion>(problem, toleranceOf(problem), best));
  EXPECT_LE((best.r - before).norm(), 1e-9 * before.norm());
}

}  // namespace
}  // namespace delassus
