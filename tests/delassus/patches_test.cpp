#include "delassus/patches.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "delassus/solver.h"
#include "tests/support/random_piles.h"
#include "tests/support/turning_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

/// Balls on the ground, some with rolling and spinning friction; two are held together.
Problem heap(int balls, Random& random) {
  Pile pile = makeHeap(balls, 0.4, random);
  Row joint;
  joint.a = 0;
  joint.b = 1;
  joint.jacobianA << 1, 0, 0, 0, 0, 0;
  joint.jacobianB << -1, 0, 0, 0, 0, 0;
  pile.rows.push_back(joint);
  resistTurning(pile, 0.1, random);
  return PileIsland(pile).problem;
}

struct Cut {
  Problem problem;
  VectorXd reactions;
};

Cut cutOut(Patches& patches, int patch, const Problem& problem, const VectorXd& r) {
  Cut cut;
  patches.cutOut(patch, problem, r, problem.W * r + problem.q, cut.problem, cut.reactions);
  return cut;
}

VectorXd residualsOf(const Problem& problem, const VectorXd& r) {
  NaturalMap map;
  map.setProblem(problem);
  VectorXd residuals;
  map.residuals(r, problem.W * r + problem.q, residuals);
  return residuals;
}

TEST(Patches, WhatIsSettledHasNone) {
  Random random(61);
  const Problem problem = heap(12, random);
  Patches patches;
  patches.find(problem, VectorXd::Zero(problem.parts()), 0, 1);
  EXPECT_EQ(patches.count(), 0);
}

// In a tower of 12 boxes the first contact is below the first box, the last one below the last box.
TEST(Patches, FarApartAreTwo) {
  Random random(64);
  const PileIsland island(makeTower(randomMasses(12, 2, random), 0.5, 0, random));
  VectorXd residuals = VectorXd::Zero(island.problem.contacts());
  Patches patches;
  residuals[0] = 1;
  patches.find(island.problem, residuals, 0.5, 1);
  ASSERT_EQ(patches.count(), 1);
  EXPECT_EQ(patches.partsOf(0), 8);  // the first box's, and those between it and its neighbour
  residuals[residuals.size() - 1] = 1;
  patches.find(island.problem, residuals, 0.5, 1);
  ASSERT_EQ(patches.count(), 2);
  EXPECT_EQ(patches.partsOf(0), 8);
  EXPECT_EQ(patches.partsOf(1), 8);  // the last two boxes, and between the second and its neighbour
}

TEST(Patches, ReachAsManyBoxesFurtherAsTheyHaveRings) {
  Random random(65);
  const PileIsland island(makeTower(randomMasses(12, 2, random), 0.5, 0, random));
  VectorXd residuals = VectorXd::Zero(island.problem.contacts());
  residuals[0] = 1;
  Patches patches;
  for (int rings = 0; rings <= 14; ++rings) {
    patches.find(island.problem, residuals, 0.5, rings);
    ASSERT_EQ(patches.count(), 1);
    EXPECT_EQ(patches.partsOf(0), 4 * std::min(rings + 1, 12));
  }
}

// If the other parts are held, a part has in its patch the same velocities, and so the same
// residual, as in the island.
TEST(Patches, SeeTheIslandAsItIs) {
  Random random(62);
  int withDisks = 0;
  for (int k = 0; k < 60; ++k) {
    const Problem problem = heap(4 + k % 20, random);
    const VectorXd r = randomReactions(problem, 0.2, random);
    const VectorXd residuals = residualsOf(problem, r);
    Patches patches;
    patches.find(problem, residuals, uniform(random, 0.5, 1) * residuals.maxCoeff(), 1);
    ASSERT_GE(patches.count(), 1);
    double worst = 0;
    int parts = 0;
    for (int p = 0; p < patches.count(); ++p) {
      const Cut cut = cutOut(patches, p, problem, r);
      ASSERT_TRUE(unfitParts(cut.problem).empty());
      EXPECT_EQ(patches.partsOf(p), cut.problem.parts());
      withDisks += !cut.problem.disks.empty();
      worst = std::max(worst, residualsOf(cut.problem, cut.reactions).maxCoeff());
      parts += patches.partsOf(p);
    }
    EXPECT_LE(parts, problem.parts());
    EXPECT_NEAR(worst, residuals.maxCoeff(), 1e-9 * residuals.maxCoeff());
  }
  EXPECT_GT(withDisks, 20);
}

// A patch that has been solved and put back keeps the law in the island, if nothing else has
// changed its reactions.
TEST(Patches, AreSettledWhenSolved) {
  Random random(63);
  for (int k = 0; k < 40; ++k) {
    const Problem problem = heap(4 + k % 20, random);
    VectorXd r = Solver().solve(problem).r;
    r.head<3>() += Vec3(0.3, 0.01, 0);
    const double before = residualsOf(problem, r).maxCoeff();
    Patches patches;
    patches.find(problem, residualsOf(problem, r), 0.3 * before, 1);
    ASSERT_GE(patches.count(), 1);
    std::set<int> changed;
    for (int p = 0; p < patches.count(); ++p) {
      const Cut cut = cutOut(patches, p, problem, r);
      const Solution solution = Solver().solve(cut.problem, cut.reactions);
      ASSERT_EQ(solution.status, Status::Solved);
      const VectorXd old = r;
      patches.putBack(p, problem, solution.r, r);
      for (int at = 0; at < problem.size(); ++at)
        EXPECT_TRUE(r[at] == old[at] || changed.insert(at).second) << "in two patches";
      // Its own residual now, seen from the island.
      const Cut after = cutOut(patches, p, problem, r);
      EXPECT_LE(residualsOf(after.problem, after.reactions).maxCoeff(),
                1e-7 * problem.q.cwiseAbs().maxCoeff());
    }
    EXPECT_LT(residualsOf(problem, r).maxCoeff(), before);
  }
}

/// A wall of two courses of unit boxes; those of the upper course lie on two of the lower one each.
Pile makeLowWall(int columns, double friction) {
  Pile pile;
  Vec6 v = Vec6::Zero();
  v[2] = -9.81 / 60;
  const auto addPoints = [&](int above, int below, double from, double to, double shift) {
    for (const double x : {from, to})
      for (const double y : {-0.5, 0.5})
        pile.contacts.push_back(
            makeRestingPoint(above, below, {x, y, -0.5}, {x - shift, y, 0.5}, friction));
  };
  for (int i = 0; i < columns; ++i) {
    pile.bodies.push_back(makeBox(1, 0.5, v));
    addPoints(i, fixedWorld, -0.5, 0.5, 0);
  }
  for (int i = 0; i + 1 < columns; ++i) {
    const auto box = static_cast<int>(pile.bodies.size());
    pile.bodies.push_back(makeBox(1, 0.5, v));
    addPoints(box, i, -0.5, 0, -0.5);
    addPoints(box, i + 1, 0, 0.5, 0.5);
  }
  return pile;
}

// In a long wall at rest two boxes are pushed, so that they slide. What lies far from there keeps
// its reactions to the last bit.
TEST(MendedPlaces, LeaveTheRestAsItIs) {
  constexpr int columns = 60, near = 4;
  Random random(66);
  Solver solver;
  const Pile wall = makeLowWall(columns, 0.5);
  const VectorXd atRest = solver.solve(PileIsland(wall).problem).r;
  for (int k = 0; k < 20; ++k) {
    Pile pile = wall;
    const int places[] = {k, k + 15 + k};  // of the upper course
    for (const int place : places) {
      const double heading = uniform(random, 0, 6.28);
      pile.bodies[columns + place].velocity.head<2>() += Vec2(std::cos(heading), std::sin(heading));
    }
    const PileIsland pushed(pile);
    const Solution solution = solver.solve(pushed.problem, atRest);
    ASSERT_EQ(solution.status, Status::Solved);
    for (int i = 0; i < pushed.problem.contacts(); ++i) {
      const int above = pile.contacts[i].a;
      const double column = above < columns ? above : above - columns + 0.5;
      bool isFar = true;
      for (const int place : places) isFar = isFar && std::abs(column - place - 0.5) > near;
      if (!isFar) continue;
      EXPECT_EQ(solution.r.segment<3>(3 * i), atRest.segment<3>(3 * i)) << "column " << column;
    }
  }
}

/// The patches made for a wall at rest after two boxes were pushed and all others got this speed,
/// m/s. Each box has this many weak motors that hold it against any motion.
int patchesFor(double speed, int motors) {
  constexpr int columns = 60;
  Pile pile = makeLowWall(columns, 0.5);
  for (int box = 0; box < static_cast<int>(pile.bodies.size()); ++box)
    for (int axis = 0; axis < motors; ++axis) {
      Row& motor = pile.rows.emplace_back();
      motor.a = box;
      motor.jacobianA[axis] = 1;
      motor.lower = -1e-3, motor.upper = 1e-3;
    }
  Solver solver;
  const VectorXd atRest = solver.solve(PileIsland(pile).problem).r;
  for (Body& body : pile.bodies) body.velocity[1] += speed;
  for (const int place : {10, 40}) pile.bodies[columns + place].velocity[1] += 1;
  const Solution solution = solver.solve(PileIsland(pile).problem, atRest);
  EXPECT_EQ(solution.status, Status::Solved);
  return solution.patches;
}

// Where all is disturbed, however little, the whole comes first.
TEST(MendedPlaces, AreFew) {
  EXPECT_GT(patchesFor(0, 0), 0);
  EXPECT_EQ(patchesFor(1e-4, 0), 0);
}

// So it does where rows prevail: here there are 119 boxes with 712 contacts.
TEST(MendedPlaces, HaveMoreContactsThanRows) {
  EXPECT_GT(patchesFor(0, 5), 0);
  EXPECT_EQ(patchesFor(0, 6), 0);
}

}  // namespace
}  // namespace delassus
