/// The check without W must see what W would have shown.
#include "delassus/island_check.h"

#include <gtest/gtest.h>

#include <limits>

#include "delassus/read_mode.h"
#include "delassus/residual.h"
#include "delassus/solver.h"
#include "delassus/turning_friction.h"
#include "tests/support/random_piles.h"
#include "tests/support/turning_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

/// Towers with contacts of all kinds: with and without friction, soft, some with friction against
/// turning, and with joints on top.
Pile mixedTower(int height, Random& random) {
  Pile pile = makeTower(randomMasses(height, 10, random), 0.7, 0.02, random);
  mixFriction(pile, 1, random);
  for (Contact& c : pile.contacts)
    if (uniform(random, 0, 1) < 0.3) {
      c.compliance = uniform(random, 0, 0.1);
      c.slipCompliance = 0.02;
    }
  Row row;
  row.a = height - 1;
  row.jacobianA = normalMatrix(1, 6, random);
  row.lower = -uniform(random, 0, 0.1);
  row.upper = uniform(random, 0, 0.1);
  row.compliance = uniform(random, 0, 0.01);
  pile.rows.push_back(row);
  resistTurning(pile, 0.1, random);
  return pile;
}

/// The largest difference of the bodies' velocities.
double difference(const std::vector<Body>& a, const std::vector<Body>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, (a[i].velocity - b[i].velocity).cwiseAbs().maxCoeff());
  return largest;
}

/// On a wall between two regions either name is right: where r = 0 and u = 0, or on the cone
/// without sliding.
void expectNamesDifferOnWallsOnly(const Problem& problem, const Solution& a, const Solution& b) {
  const double demand = problem.q.cwiseAbs().maxCoeff(), load = b.r.cwiseAbs().maxCoeff();
  for (int i = 0; i < problem.contacts(); ++i) {
    if (a.activeSet.contacts[i] == b.activeSet.contacts[i]) continue;
    const Vec3 r = b.r.segment<3>(3 * i), u = b.u.segment<3>(3 * i);
    const double slip = std::hypot(u[1], u[2]), gap = std::max(u[0], 0.0);
    const double inside = problem.friction[i] * r[0] - std::hypot(r[1], r[2]);
    EXPECT_LT(std::abs(inside), 1e-6 * load) << i;
    EXPECT_LT(std::min(gap + slip, r[0] > 1e-6 * load ? slip : gap), 1e-6 * demand) << i;
  }
}

/// A row along a locked axis moves nothing, so no size of its reaction is large or small.
TEST(IslandCheck, KeepsWhatNothingMovesIfItRestsOrItsBoundLetsItBe) {
  const auto isKept = [](double velocity, double lower, double upper, double reaction) {
    Pile pile;
    pile.bodies.push_back(makeBox(1, 0.5, Vec6::Zero()));
    pile.bodies[0].inverseMass[0] = 0;
    pile.contacts = {makeRestingPoint(0, fixedWorld, {0, 0, -0.5}, Vec3::Zero(), 0)};
    Row row;
    row.a = 0;
    row.jacobianA[0] = 1;
    row.target = -velocity;
    row.lower = lower;
    row.upper = upper;
    pile.rows.push_back(row);
    const PileIsland island(pile);
    std::vector<Body> moved = pile.bodies;
    Solution seen;
    seen.r = VectorXd::Zero(island.problem.size());
    seen.r[island.problem.size() - 1] = reaction;
    return IslandCheck(Options()).isKept(pile.bodies, pile.contacts, pile.rows, island.island, 1,
                                         moved, seen);
  };
  EXPECT_TRUE(isKept(0, -infinity, infinity, 0));
  EXPECT_TRUE(isKept(0, -1, 1, 0.5));
  EXPECT_TRUE(isKept(1, -1, 1, -1));
  EXPECT_TRUE(isKept(-1, -1, 1, 1));
  EXPECT_FALSE(isKept(1, -1, 1, 0.5));
  EXPECT_FALSE(isKept(1, -1, 1, 1));
  EXPECT_FALSE(isKept(1, -infinity, infinity, 0));
  EXPECT_FALSE(isKept(1, -1e-12, 1e-12, 0.5e-12)) << "in whatever unit";
}

// The same for spinning friction about a locked axis.
TEST(IslandCheck, KeepsWhatNothingTurnsIfItRests) {
  for (const double spin : {0.0, 1.0}) {
    Pile pile;
    Body& ball = pile.bodies.emplace_back();
    ball.inverseMass.setOnes();
    ball.inverseInertia = Vec3(1, 1, 0).asDiagonal();
    ball.velocity << 0, 0, -1, 0, 0, spin;
    Contact& contact = pile.contacts.emplace_back();
    contact.a = 0;
    contact.frame << 0, 1, 0, 0, 0, 1, 1, 0, 0;
    TurningFriction friction;
    friction.spinning = 0.1;
    addRows(friction, contact, 0, pile.rows);
    const PileIsland island(pile);
    std::vector<Body> moved = pile.bodies;
    Solution seen;
    seen.r = Eigen::Vector2d(1, 0);
    EXPECT_EQ(IslandCheck(Options()).isKept(pile.bodies, pile.contacts, pile.rows, island.island, 1,
                                            moved, seen),
              spin == 0);
  }
}

TEST(IslandCheck, KeepsTheReactionsThatTheSolverFound) {
  Random random(81);
  int kept = 0;
  for (int k = 0; k < 100; ++k) {
    SCOPED_TRACE(k);
    const PileIsland island(mixedTower(1 + k % 4, random));
    const auto& [bodies, contacts, rows] = island.pile;
    Options tight;
    tight.tolerance = 1e-12;
    const Solution exact = Solver(tight).solve(island.problem);
    if (exact.status != Status::Solved) continue;

    std::vector<Body> moved = bodies;
    Solution seen;
    seen.r = exact.r;
    ASSERT_TRUE(
        IslandCheck(Options()).isKept(bodies, contacts, rows, island.island, 1, moved, seen));
    ++kept;
    EXPECT_EQ(seen.tier, Tier::Kept);
    EXPECT_EQ(seen.status, Status::Solved);
    EXPECT_LT((seen.r - exact.r).norm(), 1e-12 * exact.r.norm());
    EXPECT_LT((seen.u - exact.u).norm(), 1e-12);
    expectNamesDifferOnWallsOnly(island.problem, seen, exact);
    EXPECT_LT(difference(moved, island.after(exact.r)), 1e-13);
    // The bound lies above the residual itself, and below the tolerance.
    EXPECT_GE(seen.residual * (1 + 1e-6) + 1e-14, naturalResidual(island.problem, seen.r).max);
    EXPECT_LE(seen.residual, Options().tolerance * island.problem.q.cwiseAbs().maxCoeff());
  }
  EXPECT_GT(kept, 90);
}

// Not even if friction depends on the direction, so that tangents are short and W_aa is small.
TEST(IslandCheck, TellsNoLessThanTheNaturalResidual) {
  Random random(86);
  Options loose;
  loose.tolerance = 0.1;
  int kept = 0, sticking = 0;
  for (int k = 0; k < 200; ++k) {
    SCOPED_TRACE(k);
    Pile pile = mixedTower(1 + k % 4, random);
    for (Contact& c : pile.contacts) {
      c.frame.col(1) *= uniform(random, 0.01, 1);
      c.frame.col(2) *= uniform(random, 0.01, 1);
    }
    const PileIsland island(pile);
    Solution seen;
    seen.r = Solver().solve(island.problem).r;
    seen.r += 1e-3 * seen.r.norm() * normalVector(island.problem.size(), random);
    std::vector<Body> moved = pile.bodies;
    if (!IslandCheck(loose).isKept(pile.bodies, pile.contacts, pile.rows, island.island, 1, moved,
                                   seen))
      continue;
    ++kept;
    NaturalMap map;
    map.setProblem(island.problem);
    EXPECT_GE(seen.residual * (1 + 1e-9), map.residual(seen.r, seen.u).max);
    Solution read = seen;
    readActiveSet(island.problem, map.diagonal(), seen.r, seen.u, read.activeSet);
    EXPECT_EQ(seen.activeSet, read.activeSet);
    for (const Mode mode : seen.activeSet.contacts) sticking += mode == Mode::Stick;
  }
  EXPECT_GT(kept, 50);
  EXPECT_GT(sticking, 100);
}

TEST(IslandCheck, RefusesWhatDoesNotKeepTheLawAndLeavesTheBodiesAlone) {
  Random random(82);
  for (int k = 0; k < 100; ++k) {
    SCOPED_TRACE(k);
    const PileIsland island(mixedTower(1 + k % 4, random));
    const auto& [bodies, contacts, rows] = island.pile;
    Solution seen;
    seen.r = Solver().solve(island.problem).r + 1e-3 * normalVector(island.problem.size(), random);
    std::vector<Body> moved = bodies;
    EXPECT_FALSE(
        IslandCheck(Options()).isKept(bodies, contacts, rows, island.island, 1, moved, seen));
    EXPECT_EQ(difference(moved, bodies), 0);
    // It was right to refuse.
    EXPECT_GT(naturalResidual(island.problem, seen.r).max,
              Options().tolerance * island.problem.q.cwiseAbs().maxCoeff());
  }
}

// In a wide cone the natural residual of an approach is small.
TEST(IslandCheck, AWideConeHidesNoApproach) {
  Pile pile;
  Body& ball = pile.bodies.emplace_back();
  ball.inverseMass.setOnes();
  ball.inverseInertia.setIdentity();
  ball.velocity << 1, 0, -1, 0, 0, 0;
  Contact& contact = pile.contacts.emplace_back();
  contact.a = 0;
  contact.frame << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  contact.friction = 1e3;
  const PileIsland island(pile);
  std::vector<Body> moved = pile.bodies;
  Options options;
  options.tolerance = 1e-2;
  Solution seen;
  seen.r = VectorXd::Zero(3);
  EXPECT_LT(naturalResidual(island.problem, seen.r).max, options.tolerance);
  EXPECT_FALSE(IslandCheck(options).isKept(pile.bodies, pile.contacts, pile.rows, island.island, 1,
                                           moved, seen));
}

// Free means q ≥ 0, and only that. Compared with the natural residual of r = 0.
TEST(IslandCheck, FreeMeansThatNoReactionIsAskedFor) {
  Random random(83);
  int free = 0;
  for (int k = 0; k < 400; ++k) {
    SCOPED_TRACE(k);
    Pile pile = mixedTower(1 + k % 2, random);
    pile.rows[0].lower = k % 3 ? 0 : -1;
    pile.rows[0].upper = infinity;
    for (Body& body : pile.bodies) body.velocity[2] = uniform(random, -0.1, 0.6);
    const PileIsland island(pile);
    const double residual =
        naturalResidual(island.problem, VectorXd::Zero(island.problem.size())).max;
    Solution seen;
    const bool says =
        IslandCheck(Options()).isFree(pile.bodies, pile.contacts, pile.rows, island.island, seen);
    EXPECT_EQ(says, residual <= island.problem.roundOff);
    if (!says) continue;
    ++free;
    EXPECT_EQ(seen.tier, Tier::Free);
    EXPECT_TRUE(seen.r.isZero(0));
    EXPECT_LT((seen.u - island.problem.q).norm(), 1e-14);
    EXPECT_EQ(seen.activeSet, Solver().solve(island.problem).activeSet);
  }
  EXPECT_GT(free, 20);
  EXPECT_LT(free, 380);
}

// However such a row moves, it cannot be left alone.
TEST(IslandCheck, WhatMustPushIsNotFree) {
  for (const auto& [lower, upper] : {std::pair(1.0, 2.0), std::pair(-2.0, -1.0)})
    for (const double velocity : {-1.0, 0.0, 1.0}) {
      Pile pile;
      pile.bodies.push_back(makeBox(1, 0.5, velocity * Vec6::Unit(0)));
      Row row;
      row.a = 0;
      row.jacobianA[0] = 1;
      row.lower = lower;
      row.upper = upper;
      pile.rows.push_back(row);
      const PileIsland island(pile);
      Solution seen;
      EXPECT_FALSE(IslandCheck(Options()).isFree(pile.bodies, pile.contacts, pile.rows,
                                                 island.island, seen));
    }
}

TEST(IslandCheck, WhatIsNoNumberIsNeitherFreeNorKept) {
  Random random(85);
  for (const double lower : {-1.0, 0.0})
    for (const int spoilt : {0, 1, 2, 3, 4}) {
      SCOPED_TRACE(spoilt);
      Pile pile = mixedTower(1, random);
      pile.contacts.clear();
      pile.rows.resize(1);
      Row& row = pile.rows[0];
      row.lower = lower;
      row.upper = infinity;
      double* const numbers[] = {&row.target, &pile.bodies[0].velocity[5], &row.lower, &row.upper,
                                 &row.compliance};
      *numbers[spoilt] = std::numeric_limits<double>::quiet_NaN();
      const Island island = splitIslands(pile.bodies, pile.contacts, pile.rows).at(0);
      Solution seen;
      IslandCheck check{Options()};
      EXPECT_FALSE(check.isFree(pile.bodies, pile.contacts, pile.rows, island, seen));
      std::vector<Body> moved = pile.bodies;
      seen.r.setZero(1);
      EXPECT_FALSE(check.isKept(pile.bodies, pile.contacts, pile.rows, island, 1, moved, seen));
    }
}

// Nor is a contact whose bodies part at an infinite speed, or whose friction is no number: no law
// can be stated there.
TEST(IslandCheck, AContactThatIsNoNumberIsNotFree) {
  constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
  Random random(86);
  for (const double friction : {0.5, 0.0})
    for (const double speed : {infinity, notANumber, 1.0}) {
      Pile pile = makeTower({1}, friction, 0, random);
      pile.bodies[0].velocity = speed * Vec6::Unit(2);
      const auto isFree = [&] {
        Solution seen;
        return IslandCheck(Options()).isFree(
            pile.bodies, pile.contacts, pile.rows,
            splitIslands(pile.bodies, pile.contacts, pile.rows).at(0), seen);
      };
      EXPECT_EQ(isFree(), speed == 1);
      if (speed != 1) continue;
      pile.contacts[0].friction = notANumber;
      EXPECT_FALSE(isFree());
    }
}

// Bodies that fall together touch with q_n = 0, up to the rounding of their velocities.
TEST(IslandCheck, RoundingIsNoApproach) {
  Random random(84);
  Pile pile = makeTower({1, 2}, 0.5, 0, random);
  pile.contacts.erase(pile.contacts.begin(), pile.contacts.begin() + 4);  // no ground
  for (int k = 0; k < 50; ++k) {
    // One rigid motion of both boxes.
    const Vec3 v = normalVector(3, random), w = normalVector(3, random);
    for (int i = 0; i < 2; ++i) pile.bodies[i].velocity << v + w.cross(Vec3(0, 0, i)), w;
    const PileIsland island(pile);
    Solution seen;
    EXPECT_TRUE(
        IslandCheck(Options()).isFree(pile.bodies, pile.contacts, pile.rows, island.island, seen));
    EXPECT_LE(seen.residual, island.problem.roundOff);
    pile.bodies[1].velocity[2] -= 1e-9;
    EXPECT_FALSE(
        IslandCheck(Options()).isFree(pile.bodies, pile.contacts, pile.rows, island.island, seen));
  }
}

}  // namespace
}  // namespace delassus
