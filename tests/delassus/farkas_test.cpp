/// The proof that demands are incompatible, or need violent motions.
#include "delassus/farkas.h"

#include <gtest/gtest.h>

#include "delassus/solver.h"
#include "tests/support/certificate.h"
#include "tests/support/pressed_piles.h"
#include "tests/support/random_piles.h"
#include "tests/support/turning_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

// No reactions prove more than is true, and those of the motion itself prove all of it.
TEST(Farkas, TheBoundIsBelowEveryMotionAndReachedByTheLeast) {
  Random random(201);
  for (int k = 0; k < 40; ++k) {
    Pile pile = withoutFriction(makeTower(randomMasses(1 + k % 5, 10, random), 0, 0.5, random));
    for (Contact& c : pile.contacts) c.target[0] = uniform(random, 0, 1);
    const Problem problem = PileIsland(pile).problem;
    NaturalMap map;
    map.setProblem(problem);
    FarkasProof proof;
    proof.setProblem(problem, map);
    const Solution least = Solver().solve(problem);
    ASSERT_EQ(least.status, Status::Solved);
    const double motion = std::sqrt(least.r.dot(problem.W * least.r));
    EXPECT_NEAR(proof.leastMotion(least.r), motion, 1e-6 * motion);
    for (int i = 0; i < 20; ++i) {
      const VectorXd r = randomReactions(proof.demands(), 1, random);
      EXPECT_LE(proof.leastMotion(r), motion * (1 + 1e-9));
    }
  }
}

// A self-stress does no work in any motion: however large, its rounding proves nothing either.
TEST(Farkas, SelfStressProvesNothing) {
  Random random(206);
  for (int k = 0; k < 60; ++k) {
    const Pile pile = withoutFriction(makePressed(1 + k % 5, 0, 0, 1e-3, 0, random));
    const Problem problem = PileIsland(pile).problem;
    const Solution least = Solver().solve(problem);
    ASSERT_EQ(least.status, Status::Solved);
    const double motion = std::sqrt(least.r.dot(problem.W * least.r));
    VectorXd stress = VectorXd::Zero(problem.size());
    for (int i = 0; i < problem.contacts(); ++i) stress[3 * i] = 1;
    for (int i = 0; i < problem.rows(); ++i) stress[3 * problem.contacts() + i] = 1;
    ASSERT_LT((problem.W * stress).norm(), 1e-12);
    const VectorXd r = std::pow(10.0, k % 12) * uniform(random, 1, 10) * stress;
    NaturalMap map;
    map.setProblem(problem);
    FarkasProof proof;
    proof.setProblem(problem, map);
    EXPECT_LE(proof.leastMotion(r), motion) << k;
  }
}

// Nor do walls prove anything that come together by no more than the rounding of the velocities.
TEST(Farkas, RoundingOfDemandsProvesNothing) {
  Random random(207);
  for (const double gap : {0.9, 10.0}) {
    Problem problem = PileIsland(withoutFriction(makePressed(1, 0, 0, 0, 0, random))).problem;
    problem.roundOff = 1e-12;
    problem.q.setZero();
    VectorXd stress = VectorXd::Zero(problem.size());
    for (int i = 0; i < problem.contacts(); ++i) {
      stress[3 * i] = 1;
      problem.q[3 * i] = -gap * problem.roundOff;
    }
    for (int i = 0; i < problem.rows(); ++i) {
      stress[3 * problem.contacts() + i] = 1;
      problem.q[3 * problem.contacts() + i] = -gap * problem.roundOff;
    }
    NaturalMap map;
    map.setProblem(problem);
    FarkasProof proof;
    proof.setProblem(problem, map);
    EXPECT_EQ(proof.leastMotion(stress) > 0, gap > 1);
  }
}

// Friction, motors and disks make no demands that they would not give up.
TEST(Farkas, WhatIsBoundedDemandsNothing) {
  Random random(202);
  Pile pile = makeTower({1, 1}, 0.5, 0.1, random);
  pile.rows.push_back(makeWeakMotor());
  Row stop;
  stop.a = 0;
  stop.lower = -3;
  pile.rows.push_back(stop);
  resistTurning(pile, 0.1, random);
  const Problem problem = PileIsland(pile).problem;
  NaturalMap map;
  map.setProblem(problem);
  FarkasProof proof;
  proof.setProblem(problem, map);
  const Problem& demands = proof.demands();
  EXPECT_EQ(demands.size(), problem.size());
  EXPECT_TRUE(demands.disks.empty());
  EXPECT_EQ(demands.friction.cwiseAbs().sum(), 0);
  for (int i = 0; i < problem.rows(); ++i) {
    const bool isStop = problem.lower[i] == -3;
    EXPECT_EQ(demands.lower[i], 0) << i;
    EXPECT_EQ(demands.upper[i], isStop ? infinity : 0) << i;
    if (!isStop) {
      EXPECT_EQ(demands.q[3 * problem.contacts() + i], 0) << i;
    }
  }
}

// Walls that come together, with friction: all contacts are named at once, and the boxes stay
// between the walls.
TEST(Farkas, PressedBoxesAreIncompatible) {
  Random random(203);
  for (const double friction : {0.3, 1.0})
    for (const int height : {1, 2, 5, 10})
      for (const double speed : {1.0, 0.01, 1e-5, 1e-7})
        for (const double disturbance : {0.0, 0.1}) {
          const PileIsland island(makePressed(height, friction, 0, disturbance, speed, random));
          const Solution solution = Solver().solve(island.problem);
          EXPECT_EQ(solution.status, Status::Incompatible) << height << " boxes at " << speed;
          EXPECT_EQ(static_cast<int>(solution.blamed.size()), island.problem.contacts());
          EXPECT_LE(infeasibility(island.problem, solution.r), 1e-12 * solution.r.norm());
          EXPECT_LT(solution.regions, 200);
          EXPECT_LT(solution.sweeps, 1000);
          // Both walls share the shortfall with the faces between the boxes. Where there is hardly
          // any, the weight of the boxes makes them give as much.
          const double share = 2 * speed / (height + 1);
          EXPECT_LT(solution.residual, 10 * share) << height << " boxes at " << speed;
          if (speed < 0.01) continue;
          for (int i = 0; i < island.problem.contacts(); ++i)
            EXPECT_NEAR(solution.u[3 * i], -share, 0.55 * share) << i;
        }
}

/// A pressed box that another box touches, which moves with `velocity`. Its contacts come last.
Pile makeTouched(const Vec6& velocity, Random& random) {
  Pile pile = makePressed(1, 0.5, 0, 0.1, 1, random);
  pile.bodies.push_back(makeBox(1, 0.5, velocity));
  for (const double y : {-0.5, 0.5})
    for (const double z : {-0.5, 0.5}) {
      Contact c = makeRestingPoint(1, 0, {-0.5, y, z}, {0.5, y, z}, 0.5);
      c.frame << 1, 0, 0, 0, 1, 0, 0, 0, 1;
      pile.contacts.push_back(c);
    }
  return pile;
}

// Bodies that only lean on what is pressed are not named.
TEST(Farkas, BystandersAreNotNamed) {
  Random random(205);
  const Pile pile = makeTouched((Vec6() << -1, 0, -0.2, 0, 0, 0).finished(), random);
  const Solution solution = Solver().solve(PileIsland(pile).problem);
  ASSERT_EQ(solution.status, Status::Incompatible);
  std::vector<int> expected;
  for (int i = 0; i < static_cast<int>(pile.contacts.size()) - 4; ++i) expected.push_back(3 * i);
  EXPECT_EQ(solution.blamed, expected);
}

// The reactions of a proof push at demands in the direction that these allow: no contact pulls.
TEST(Farkas, WhatIsFoundPushesAsItMay) {
  Random random(208);
  int found = 0;
  for (int k = 0; k < 40; ++k) {
    const Problem problem = PileIsland(makeTouched(normalVector(6, random), random)).problem;
    NaturalMap map;
    map.setProblem(problem);
    ProximalSpace<BodyMotion> space;
    ProximalWalk<BodyMotion> walk(space);
    FarkasProof proof;
    Solution scratch;
    WorkDone count;
    int budget = 200;
    space.setProblem(problem, map);
    const VectorXd nothing = VectorXd::Zero(problem.size());
    found += proof.find(walk, problem, map, 1e-8, nothing, budget, scratch, count);
    for (int i = 0; i < problem.size(); ++i)
      EXPECT_TRUE(contains(allowedWithoutFriction(proof.demands(), i), proof.reactions()[i]));
  }
  EXPECT_GT(found, 30);
}

// A wedge that can slip out does so.
TEST(Farkas, WhatCanEscapeIsSolved) {
  Random random(204);
  for (const double tilt : {0.1, 0.3}) {
    const PileIsland island(makePressed(1, 0.02, tilt, 0.1, 1, random));
    EXPECT_EQ(Solver().solve(island.problem).status, Status::Solved) << tilt;
  }
}

}  // namespace
}  // namespace delassus
