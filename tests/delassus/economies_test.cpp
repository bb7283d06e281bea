/// The economies of the core, counted: what they leave out, and that the answer does not show it.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "delassus/solver.h"
#include "tests/support/random_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

Solution solveWith(const Problem& problem, bool Economies::*without, const VectorXd& guess = {}) {
  Options options;
  options.tolerance = 1e-10;
  if (without) options.economies.*without = false;
  return Solver(options).solve(problem, guess);
}

TEST(Economies, NoTangentialPartOfWWithoutFriction) {
  Random random(71);
  for (int k = 0; k < 20; ++k) {
    SCOPED_TRACE(k);
    const PileIsland island(
        withoutFriction(makeTower(randomMasses(1 + k % 4, 10, random), 0, 0.1, random)));
    const Pile& pile = island.pile;
    const auto contacts = static_cast<int>(pile.contacts.size());
    EXPECT_TRUE(island.problem.W.bodySpace().contacts.empty());
    ASSERT_EQ(island.problem.size(), contacts);

    Assembler assembler;
    assembler.split(pile.bodies, pile.contacts, pile.rows, true);
    ASSERT_EQ(assembler.islands(), 1);
    const Problem& full =
        assembler.assemble(pile.bodies, pile.contacts, pile.rows, assembler.island(0));
    ASSERT_EQ(full.size(), 3 * contacts);
    // The small W is the normal part of the large one.
    const auto normals = Eigen::seqN(0, contacts, 3);
    const MatrixXd W = island.problem.W.dense();
    EXPECT_LT((full.W.dense()(normals, normals) - W).norm(), 1e-13 * W.norm());

    const Solution lean = solveWith(island.problem, nullptr), lavish = solveWith(full, nullptr);
    ASSERT_EQ(lean.status, Status::Solved);
    ASSERT_EQ(lavish.status, Status::Solved);
    EXPECT_LT(motionDistance(island, lean.r, lavish.r(normals)), 1e-8);
  }
}

TEST(Economies, NoFactorisationWhereRegionAndWStand) {
  Random random(72);
  int saved = 0;
  for (int k = 0; k < 40; ++k) {
    SCOPED_TRACE(k);
    const PileIsland island(makeTower(randomMasses(2 + k % 4, 10, random), 0.7, 0.05, random));
    const Solution lean = solveWith(island.problem, nullptr),
                   lavish = solveWith(island.problem, &Economies::factors);
    // The same regions in the same order, bit for bit, but each one is factored.
    EXPECT_EQ(lean.r, lavish.r);
    EXPECT_EQ(lean.regions, lavish.regions);
    EXPECT_LE(lean.factorisations, lavish.factorisations);
    saved += lavish.factorisations - lean.factorisations;
  }
  EXPECT_GT(saved, 0);
}

TEST(Economies, WhatKeepsTheLawIsNotSolvedAgain) {
  Random random(73);
  for (int k = 0; k < 20; ++k) {
    SCOPED_TRACE(k);
    const PileIsland island(makeTower(randomMasses(1 + k % 4, 10, random), 0.7, 0, random));
    const Solution first = solveWith(island.problem, nullptr);
    ASSERT_EQ(first.status, Status::Solved);
    EXPECT_EQ(first.tier, Tier::Walk);

    const Solution kept = solveWith(island.problem, nullptr, first.r),
                   again = solveWith(island.problem, &Economies::keptIslands, first.r);
    EXPECT_EQ(kept.tier, Tier::Kept);
    EXPECT_EQ(kept.sweeps + kept.regions + kept.factorisations, 0);
    EXPECT_EQ(again.tier, Tier::Walk);
    EXPECT_GT(again.regions, 0);
    EXPECT_EQ(again.status, Status::Solved);
    EXPECT_LT(motionDistance(island, kept.r, again.r), 1e-8);
  }
}

// Towers, and a pile so large that it starts in another way.
TEST(Economies, WhatKeepsTheLawIsSolvedAgainFromNothing) {
  Random random(78);
  for (const int boxes : {1, 4, 60}) {
    SCOPED_TRACE(boxes);
    const PileIsland island(makeTower(randomMasses(boxes, 2, random), 0.7, 0, random));
    const Solution cold = solveWith(island.problem, &Economies::keptIslands);
    ASSERT_EQ(cold.status, Status::Solved);
    EXPECT_EQ(solveWith(island.problem, &Economies::keptIslands, cold.r).r, cold.r);
  }
}

TEST(Economies, OneRowOrContactTakesAFormula) {
  Random random(74);
  for (int k = 0; k < 100; ++k) {
    SCOPED_TRACE(k);
    Pile pile;
    pile.bodies.push_back(makeBox(uniform(random, 1, 10), 0.5, normalVector(6, random)));
    if (k % 3 == 0) {
      Row row;
      row.a = 0;
      row.jacobianA = normalMatrix(1, 6, random);
      row.target = uniform(random, -1, 1);
      row.lower = -uniform(random, 0, 2);
      row.upper = uniform(random, 0, 2);
      row.compliance = uniform(random, 0, 0.1);
      pile.rows.push_back(row);
    } else {
      pile.contacts.push_back(makeRestingPoint(0, fixedWorld, 0.5 * normalVector(3, random),
                                               Vec3::Zero(), k % 3 == 1 ? 0 : 0.5));
      pile.bodies[0].velocity[2] = -10;
    }
    const PileIsland island(pile);
    const Solution formula = solveWith(island.problem, nullptr),
                   walked = solveWith(island.problem, &Economies::closedForms);
    EXPECT_EQ(formula.tier, Tier::ClosedForm);
    EXPECT_EQ(formula.factorisations, 0);
    EXPECT_EQ(walked.tier, Tier::Walk);
    EXPECT_EQ(formula.status, Status::Solved);
    EXPECT_EQ(walked.status, Status::Solved);
    EXPECT_LT(motionDistance(island, formula.r, walked.r), 1e-8);
  }
}

/// Bodies on a string of ball joints, thrown at random.
Pile makeChain(int length, Random& random) {
  Pile pile;
  for (int i = 0; i < length; ++i) {
    pile.bodies.push_back(makeBox(uniform(random, 1, 10), 0.5, normalVector(6, random)));
    for (int axis = 0; axis < 3; ++axis) {
      // Half a unit above the centre of this body, and half a unit below that of the one before.
      const Vec3 e = Vec3::Unit(axis), arm(0, 0, 0.5);
      Row row;
      row.a = i;
      row.b = i - 1;
      row.jacobianA << e.transpose(), arm.cross(e).transpose();
      row.jacobianB << -e.transpose(), arm.cross(e).transpose();
      pile.rows.push_back(row);
    }
  }
  return pile;
}

TEST(Economies, NothingIsSearchedWhereThereIsOneRegion) {
  Random random(75);
  int known = 0, found = 0;  // regions
  for (int k = 0; k < 20; ++k) {
    SCOPED_TRACE(k);
    const PileIsland island(makeChain(2 + k % 8, random));
    const VectorXd guess = normalVector(island.problem.size(), random);
    const Solution linear = solveWith(island.problem, nullptr, guess),
                   searched = solveWith(island.problem, &Economies::oneRegion, guess);
    EXPECT_EQ(linear.status, Status::Solved);
    EXPECT_EQ(linear.sweeps, 0);
    EXPECT_LT(motionDistance(island, linear.r, searched.r), 1e-7);
    known += linear.regions;
    found += searched.regions;
  }
  EXPECT_LT(known, 0.8 * found);
}

TEST(Economies, JointsAreNotSweptOver) {
  Random random(76);
  int fewer = 0;
  for (int k = 0; k < 20; ++k) {
    SCOPED_TRACE(k);
    Pile pile = makeChain(4, random);
    for (Body& body : pile.bodies) body.velocity[2] -= 1;
    pile.contacts.push_back(makeRestingPoint(3, fixedWorld, Vec3(0.2, 0, -0.5), Vec3::Zero(), 0));
    pile.contacts.push_back(makeRestingPoint(1, fixedWorld, Vec3(0.5, 0, 0), Vec3::Zero(), 0));
    const PileIsland island(pile);
    const VectorXd guess = 0.5 * solveWith(island.problem, nullptr).r;
    const Solution condensed = solveWith(island.problem, nullptr, guess),
                   swept = solveWith(island.problem, &Economies::joints, guess);
    EXPECT_EQ(condensed.status, Status::Solved);
    EXPECT_EQ(swept.status, Status::Solved);
    EXPECT_LT(motionDistance(island, condensed.r, swept.r), 1e-7);
    fewer += condensed.factorisations < swept.factorisations ? 1 : 0;
  }
  EXPECT_GE(fewer, 15);
}

}  // namespace
}  // namespace delassus
