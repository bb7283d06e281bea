/// Demands that no motion can meet: the least-squares compromise, and the names of those who asked.
#include <gtest/gtest.h>

#include <algorithm>

#include "delassus/residual.h"
#include "delassus/solver.h"
#include "tests/support/random_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

Row axisRow(int body, int axis, double target, double weight = 1) {
  Row row;
  row.a = body;
  row.jacobianA[axis] = weight;
  row.target = weight * target;
  return row;
}

/// One box of 2 kg that moves at random, and rows on it.
PileIsland boxWith(const std::vector<Row>& rows, Random& random) {
  Pile pile;
  pile.bodies.push_back(makeBox(2, 0.5, normalVector(6, random)));
  pile.rows = rows;
  return PileIsland(pile);
}

Vec6 motionOf(const PileIsland& island, const Solution& solution) {
  return island.after(solution.r).at(0).velocity;
}

/// Both storages of the same problem.
class Storages : public ::testing::TestWithParam<bool> {
 protected:
  /// Whatever the compromise, its velocities and residual are those of its reactions.
  static Solution solve(const PileIsland& island) {
    const Problem problem = GetParam() ? withEntries(island.problem) : island.problem;
    const Solution solution = Solver().solve(problem);
    const double near = 1e-12 * (problem.demand() + solution.r.norm());
    EXPECT_LE((problem.W * solution.r + problem.q - solution.u).norm(), near);
    EXPECT_NEAR(naturalResidual(problem, solution.r).max, solution.residual, near);
    return solution;
  }
};
using Incompatible = Storages;
using Redundant = Storages;
INSTANTIATE_TEST_SUITE_P(Entries, Incompatible, ::testing::Bool());
INSTANTIATE_TEST_SUITE_P(Entries, Redundant, ::testing::Bool());

TEST_P(Incompatible, TwoJointsThatWantDifferentVelocitiesMeetHalfWay) {
  Random random(81);
  for (const double gap : {1e-3, 1.0, 50.0}) {
    const PileIsland island =
        boxWith({axisRow(0, 0, 0.5 * gap), axisRow(0, 0, -1.5 * gap), axisRow(0, 1, 4)}, random);
    const Solution solution = solve(island);
    EXPECT_EQ(solution.status, Status::Incompatible) << "gap " << gap;
    EXPECT_EQ(solution.blamed, (std::vector<int>{0, 1}));
    const Vec6 v = motionOf(island, solution);
    EXPECT_NEAR(v[0], -0.5 * gap, 1e-6 * (gap + 4));
    EXPECT_NEAR(v[1], 4, 1e-6 * (gap + 4));
    EXPECT_NEAR(solution.u[0], -gap, 1e-6 * (gap + 4));
    EXPECT_NEAR(solution.u[1], gap, 1e-6 * (gap + 4));
  }
}

// Least squares in velocities scaled by 1/√W_ii: a demand in other units weighs the same.
TEST_P(Incompatible, UnitsOfARowDoNotWeigh) {
  Random random(82);
  const PileIsland island =
      boxWith({axisRow(0, 0, 0), axisRow(0, 0, -1, 10), axisRow(0, 0, 3, 0.1)}, random);
  const Solution solution = solve(island);
  EXPECT_EQ(solution.status, Status::Incompatible);
  EXPECT_EQ(solution.blamed, (std::vector<int>{0, 1, 2}));
  EXPECT_NEAR(motionOf(island, solution)[0], 2.0 / 3, 1e-5);
}

// A box between a floor that asks it to rise and a ceiling that asks it to sink.
TEST_P(Incompatible, ASqueezedContactIsNamedWithItsOpponent) {
  Random random(83);
  Pile pile;
  pile.bodies.push_back(makeBox(1, 0.5, Vec6::Zero()));
  Contact floor = makeRestingPoint(0, fixedWorld, {0, 0, -0.5}, Vec3::Zero(), 0);
  Contact ceiling = makeRestingPoint(fixedWorld, 0, Vec3::Zero(), {0, 0, 0.5}, 0);
  floor.target[0] = 1;
  ceiling.target[0] = 0.5;
  pile.contacts = {floor, ceiling};
  pile.rows.push_back(axisRow(0, 5, 1));
  const PileIsland island(pile);
  const Solution solution = solve(island);
  EXPECT_EQ(solution.status, Status::Incompatible);
  EXPECT_EQ(solution.blamed, (std::vector<int>{0, 1}));
  EXPECT_NEAR(motionOf(island, solution)[2], 0.25, 1e-6);
  EXPECT_NEAR(motionOf(island, solution)[5], 1, 1e-6);
}

// Where no reaction moves anything a demand cannot be met. It is named, with friction or without.
TEST(IncompatibleContact, IsNamedWhereItsBodyIsLocked) {
  for (const double friction : {0.0, 0.5}) {
    Pile pile;
    pile.bodies.push_back(makeBox(1, 0.5, Vec6::Zero()));
    pile.bodies[0].inverseMass[2] = 0;
    pile.bodies[0].inverseInertia.setZero();
    pile.contacts = {makeRestingPoint(0, fixedWorld, {0, 0, -0.5}, Vec3::Zero(), friction)};
    pile.contacts[0].target[0] = 1;
    const Solution solution = Solver().solve(PileIsland(pile).problem);
    EXPECT_EQ(solution.status, Status::Incompatible) << friction;
    EXPECT_LT(solution.sweeps, 1000) << friction;
    EXPECT_EQ(solution.blamed, std::vector<int>{0}) << friction;
    EXPECT_TRUE(solution.r.allFinite());
  }
}

// The shortfall s of the compromise is normal to all that reactions can do, W s = 0, if rows of
// equal units are free.
TEST_P(Incompatible, TheCompromiseIsLeastSquares) {
  Random random(84);
  for (int k = 0; k < 30; ++k) {
    Pile pile;
    pile.bodies.push_back(makeBox(uniform(random, 1, 5), 0.5, normalVector(6, random)));
    for (int i = 0; i < 8; ++i) {
      Row row;
      row.a = 0;
      row.jacobianA = normalMatrix(1, 6, random);
      pile.rows.push_back(row);
    }
    PileIsland island(pile);
    const VectorXd diagonal = island.problem.W.diagonal();
    for (int i = 0; i < 8; ++i) pile.rows[i].jacobianA /= std::sqrt(diagonal[i]);
    for (Row& row : pile.rows) row.target = uniform(random, -1, 1);
    island = PileIsland(pile);
    const Solution solution = solve(island);
    EXPECT_EQ(solution.status, Status::Incompatible) << "sample " << k;
    EXPECT_LT((island.problem.W * solution.u).norm(), 1e-5 * solution.u.norm()) << "sample " << k;
    EXPECT_GT(solution.u.norm(), 1e-3);
    EXPECT_TRUE(solution.r.allFinite());
  }
}

// Only the rows of one quarrel are blamed: other bodies of the island get what they ask.
TEST_P(Incompatible, BystandersAreServed) {
  Random random(85);
  Pile pile = makeTower({1, 2, 3}, 0, 0.1, random);
  pile.rows = {axisRow(2, 0, 1), axisRow(0, 0, 0.25), axisRow(2, 0, -1)};
  const PileIsland island(pile);
  const Solution solution = solve(island);
  const int first = island.problem.size() - 3;
  EXPECT_EQ(solution.status, Status::Incompatible);
  EXPECT_EQ(solution.blamed, (std::vector<int>{first, first + 2}));
  EXPECT_NEAR(solution.u[first + 1], 0, 1e-6);
  for (int i = 0; i < first; ++i) {
    EXPECT_GE(solution.u[i], -1e-5);
    EXPECT_LE(std::min(solution.u[i], solution.r[i]), 1e-5);
  }
}

TEST_P(Redundant, CompatibleRowsAreSolvedHoweverOftenTheyAreWritten) {
  Random random(86);
  for (int copies = 1; copies <= 6; ++copies) {
    std::vector<Row> rows;
    for (int i = 0; i < copies; ++i) {
      rows.push_back(axisRow(0, 0, 2, 1 + i));
      rows.push_back(axisRow(0, 4, -1));
    }
    const PileIsland island = boxWith(rows, random);
    const Solution solution = solve(island);
    EXPECT_EQ(solution.status, Status::Solved) << copies << " copies";
    EXPECT_TRUE(solution.blamed.empty());
    const Vec6 v = motionOf(island, solution);
    EXPECT_NEAR(v[0], 2, 1e-7);
    EXPECT_NEAR(v[4], -1, 1e-7);
  }
}

// A full set of twelve joint rows on six freedoms, which all agree with one motion.
TEST_P(Redundant, MoreRowsThanFreedomsThatAgree) {
  Random random(87);
  for (int k = 0; k < 30; ++k) {
    const Vec6 wanted = normalVector(6, random);
    std::vector<Row> rows(12);
    for (Row& row : rows) {
      row.a = 0;
      row.jacobianA = normalMatrix(1, 6, random);
      row.target = row.jacobianA.dot(wanted);
    }
    const PileIsland island = boxWith(rows, random);
    const Solution solution = solve(island);
    EXPECT_EQ(solution.status, Status::Solved) << "sample " << k;
    EXPECT_LT((motionOf(island, solution) - wanted).norm(), 1e-5 * wanted.norm());
  }
}

// A motor with a limit gives way to a joint: no quarrel.
TEST_P(Redundant, ABoundedRowGivesWay) {
  Random random(88);
  Row motor = axisRow(0, 0, 5);
  motor.lower = -3, motor.upper = 3;
  const PileIsland island = boxWith({axisRow(0, 0, -1), motor}, random);
  const Solution solution = solve(island);
  EXPECT_EQ(solution.status, Status::Solved);
  EXPECT_NEAR(motionOf(island, solution)[0], -1, 1e-7);
  EXPECT_NEAR(solution.r[1], 3, 1e-7);
}

// A motion that meets the stronger of two one-sided demands along one axis meets both.
TEST_P(Redundant, OneSidedDemandsAreNoQuarrel) {
  Random random(89);
  Row limit = axisRow(0, 2, 1);
  limit.lower = 0, limit.upper = infinity;
  Row stronger = axisRow(0, 2, 3);
  stronger.lower = 0, stronger.upper = infinity;
  const PileIsland island = boxWith({limit, stronger}, random);
  const Solution solution = solve(island);
  EXPECT_EQ(solution.status, Status::Solved);
  EXPECT_GE(motionOf(island, solution)[2], 3 - 1e-6);
}

// A motor against the limit of its axis, which wants a little less, beside joints that want more.
// Each gives by 1e-10 of what it answers: they press with what that takes, and no more.
TEST(SoftMotor, AgainstItsLimitIsNoQuarrel) {
  constexpr double softness = 1e-10, gap = 1e-10;
  for (const double guessed : {0.0, 1.0, 5.0}) {
    SCOPED_TRACE(testing::Message() << "guess " << guessed << " N s");
    Pile pile;
    pile.bodies.push_back(makeBox(2, 0.5, Vec6::Zero()));
    pile.rows = {axisRow(0, 0, 3 * gap), axisRow(0, 0, 2 * gap, -1), axisRow(0, 1, 60 * gap)};
    pile.rows[0].lower = -36;
    pile.rows[0].upper = 36;
    pile.rows[1].lower = 0;
    for (Row& row : pile.rows) row.compliance = softness / 2;
    const PileIsland island(pile);
    const Solution solution = Solver().solve(island.problem, Vec3(guessed, guessed, 0));
    EXPECT_EQ(solution.status, Status::Solved);
    EXPECT_NEAR(solution.r[1], gap / softness, 1e-4);
    EXPECT_NEAR(motionOf(island, solution)[0], 2.5 * gap, 1e-3 * gap);
  }
}

}  // namespace
}  // namespace delassus
