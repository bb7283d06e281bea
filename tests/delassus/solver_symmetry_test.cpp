/// Things that must not matter: other islands, units, the order of contacts, names, axes, earlier
/// solves.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "delassus/solver.h"
#include "tests/support/problem_samples.h"
#include "tests/support/random_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;
using test::sameBits;

Pile motorTower(int height, Random& random) {
  Pile pile = makeTower(randomMasses(height, 100, random), 0, 0.3, random);
  mixFriction(pile, 0.8, random);
  Row motor;
  motor.a = height - 1;
  motor.jacobianA << 0, 0, 0, 0, 0, 1;
  motor.target = 1;
  motor.lower = -0.25, motor.upper = 0.25;
  pile.rows.push_back(motor);
  return pile;
}

Pile smoothTower(int height, Random& random) {
  return withoutFriction(makeTower(randomMasses(height, 100, random), 0, 0.5, random));
}

/// The contacts of several piles on common ground, shuffled together.
Pile together(const std::vector<Pile>& piles, Random& random) {
  Pile all;
  for (const Pile& pile : piles) {
    const int first = static_cast<int>(all.bodies.size());
    const auto moved = [&](auto thing) {
      if (thing.a >= 0) thing.a += first;
      if (thing.b >= 0) thing.b += first;
      return thing;
    };
    all.bodies.insert(all.bodies.end(), pile.bodies.begin(), pile.bodies.end());
    for (const Contact& c : pile.contacts) all.contacts.push_back(moved(c));
    for (const Row& row : pile.rows) all.rows.push_back(moved(row));
  }
  // Contacts of one pile keep their order, which is that of its unknowns.
  std::vector<int> owner;
  for (std::size_t p = 0; p < piles.size(); ++p)
    owner.insert(owner.end(), piles[p].contacts.size(), static_cast<int>(p));
  std::vector<std::size_t> next(piles.size(), 0);
  for (std::size_t p = 1; p < piles.size(); ++p)
    next[p] = next[p - 1] + piles[p - 1].contacts.size();
  std::shuffle(owner.begin(), owner.end(), random);
  std::vector<Contact> shuffled;
  for (const int p : owner) shuffled.push_back(all.contacts[next[p]++]);
  all.contacts = shuffled;
  return all;
}

TEST(Solver, IslandsDoNotFeelEachOther) {
  Random random(101);
  for (int k = 0; k < 10; ++k) {
    std::vector<Pile> piles;
    for (int i = 0; i < 5; ++i) piles.push_back(motorTower(1 + (i + k) % 5, random));
    const Pile all = together(piles, random);

    Solver solver;  // one for all: it must not remember earlier islands either
    Assembler assembler;
    assembler.split(all.bodies, all.contacts, all.rows);
    ASSERT_EQ(assembler.islands(), 5);
    for (int i = 0; i < 5; ++i) {
      const Solution inCompany =
          solver.solve(assembler.assemble(all.bodies, all.contacts, all.rows, assembler.island(i)));
      const Solution alone = Solver().solve(PileIsland(piles[i]).problem);
      EXPECT_TRUE(sameBits(inCompany.r, alone.r)) << "island " << i;
      EXPECT_TRUE(sameBits(inCompany.u, alone.u));
      EXPECT_EQ(inCompany.activeSet, alone.activeSet);
      EXPECT_EQ(inCompany.residual, alone.residual);
      EXPECT_EQ(inCompany.regions, alone.regions);
    }
  }
}

// Explicit problems of several parts: solve(problem) takes them apart itself, after it has swept
// all of them.
TEST(Solver, PartsOfAnExplicitProblemDoNotFeelEachOther) {
  Random random(102);
  const Problem a = withEntries(PileIsland(makeTower({1, 2}, 0.5, 0.2, random)).problem);
  const Problem b = withEntries(PileIsland(makeTower({3}, 0.3, 0.2, random)).problem);
  Problem both;
  MatrixXd W = MatrixXd::Zero(a.size() + b.size(), a.size() + b.size());
  W.topLeftCorner(a.size(), a.size()) = a.W.dense();
  W.bottomRightCorner(b.size(), b.size()) = b.W.dense();
  both.W = DelassusMatrix(DelassusMatrix::Sparse(W.sparseView()));
  both.q.resize(W.rows());
  both.q << a.q, b.q;
  both.friction.resize(a.contacts() + b.contacts());
  both.friction << a.friction, b.friction;

  Problem first = a, second = b;
  first.roundOff = second.roundOff = 0;
  const Solution whole = solve(both);
  const VectorXd alone = solve(first).r, beside = solve(second).r;
  EXPECT_LT((whole.r.head(a.size()) - alone).norm(), 1e-6 * alone.norm());
  EXPECT_LT((whole.r.tail(b.size()) - beside).norm(), 1e-6 * beside.norm());
  EXPECT_EQ(whole.status, Status::Solved);
}

/// A step without rows, in units that are 1/mass, 1/length and 1/time times the old ones.
Pile inUnits(Pile pile, double mass, double length, double time) {
  const double speed = length / time;
  for (Body& body : pile.bodies) {
    body.inverseMass /= mass;
    body.inverseInertia /= mass * length * length;
    body.velocity.head<3>() *= speed;
    body.velocity.tail<3>() /= time;
  }
  for (Contact& c : pile.contacts) {
    c.armA *= length;
    c.armB *= length;
    c.target *= speed;
  }
  return pile;
}

struct Units {
  double mass, length, time;
};

class Scaling : public ::testing::TestWithParam<Units> {};

// Powers of four for mass, since Cholesky takes its root, and powers of two for the others: then
// every operation scales exactly.
TEST_P(Scaling, UnitsChangeReactionsExactlyAndModesNotAtAll) {
  const auto [mass, length, time] = GetParam();
  Random random(103);
  for (int k = 0; k < 40; ++k) {
    SCOPED_TRACE(k);
    Pile pile = motorTower(1 + k % 6, random);
    pile.rows.clear();  // their rad/s are not the m/s in which the tolerance counts
    const PileIsland island(pile), scaled(inUnits(pile, mass, length, time));
    const Solution here = Solver().solve(island.problem), there = Solver().solve(scaled.problem);
    EXPECT_TRUE(sameBits(there.r, VectorXd(mass * length / time * here.r)));
    EXPECT_TRUE(sameBits(there.u, VectorXd(length / time * here.u)));
    EXPECT_EQ(there.activeSet, here.activeSet);
    EXPECT_EQ(there.status, here.status);
    EXPECT_EQ(there.regions, here.regions);
  }
}

INSTANTIATE_TEST_SUITE_P(PowersOfTwo, Scaling,
                         ::testing::Values(Units{4, 1, 1}, Units{1.0 / 1024, 1, 1}, Units{1, 2, 1},
                                           Units{1, 1.0 / 256, 1}, Units{1, 1, 64},
                                           Units{1 << 20, 1 << 10, 1.0 / 8}));

TEST(Solver, TheOrderOfContactsDoesNotChangeTheMotion) {
  Random random(104);
  Options options;
  options.tolerance = 1e-12;
  for (int k = 0; k < 40; ++k) {
    SCOPED_TRACE(k);
    const Pile pile = k % 2 ? smoothTower(1 + k % 6, random)
                            : makeTower(randomMasses(1 + k % 6, 100, random), 0.6, 0, random);
    Pile shuffled = pile;
    std::shuffle(shuffled.contacts.begin(), shuffled.contacts.end(), random);
    const PileIsland a(pile), b(shuffled);
    const std::vector<Body> one = a.after(Solver(options).solve(a.problem).r);
    const std::vector<Body> other = b.after(Solver(options).solve(b.problem).r);
    for (std::size_t i = 0; i < one.size(); ++i)
      EXPECT_LT((one[i].velocity - other[i].velocity).norm(), 1e-9);
  }
}

// It must not matter which body is called a and which b, nor where north is.
TEST(Solver, NamesAndAxesDoNotChangeTheMotion) {
  Random random(105);
  Options options;
  options.tolerance = 1e-12;
  for (int k = 0; k < 40; ++k) {
    SCOPED_TRACE(k);
    const Pile pile = smoothTower(1 + k % 6, random);
    const Mat3 T =
        Eigen::Quaterniond(Eigen::Vector4d(normalVector(4, random))).normalized().matrix();
    Pile turned = pile;
    for (Body& body : turned.bodies) {
      body.inverseInertia = T * body.inverseInertia * T.transpose();
      body.velocity.head<3>() = T * body.velocity.head<3>();
      body.velocity.tail<3>() = T * body.velocity.tail<3>();
    }
    for (Contact& c : turned.contacts) {
      std::swap(c.a, c.b);
      std::swap(c.armA, c.armB);
      c.armA = T * c.armA;
      c.armB = T * c.armB;
      c.frame = -(T * c.frame);
    }
    const PileIsland a(pile), b(turned);
    const std::vector<Body> one = a.after(Solver(options).solve(a.problem).r);
    const std::vector<Body> other = b.after(Solver(options).solve(b.problem).r);
    for (std::size_t i = 0; i < one.size(); ++i)
      EXPECT_LT((T * one[i].velocity.head<3>() - other[i].velocity.head<3>()).norm(), 1e-9);
  }
}

TEST(Solver, SameInputSameBitsWhateverWasSolvedBefore) {
  Random random(106);
  Solver used;
  for (int k = 0; k < 30; ++k) {
    const PileIsland island(motorTower(1 + k % 6, random));
    const Problem& problem = island.problem;
    const VectorXd guess = k % 2 ? randomReactions(problem, 0.1, random) : VectorXd();
    const Solution a = used.solve(k % 3 ? problem : withEntries(problem), guess);
    const Solution b = Solver().solve(k % 3 ? problem : withEntries(problem), guess);
    EXPECT_TRUE(sameBits(a.r, b.r)) << "island " << k;
    EXPECT_EQ(a.regions, b.regions);
    EXPECT_EQ(a.sweeps, b.sweeps);
  }
}

// The ground as a body without inverse mass, and as the fixed world.
TEST(Solver, AnImmovableBodyIsTheFixedWorld) {
  Random random(107);
  for (int k = 0; k < 10; ++k) {
    const Pile pile = motorTower(1 + k % 4, random);
    Pile onBody = pile;
    const int ground = static_cast<int>(pile.bodies.size());
    onBody.bodies.emplace_back();
    for (Contact& c : onBody.contacts)
      if (c.b == fixedWorld) c.b = ground;
    EXPECT_TRUE(sameBits(Solver().solve(PileIsland(onBody).problem).r,
                         Solver().solve(PileIsland(pile).problem).r));
  }
}

TEST(Solver, AnEmptyProblemIsSolved) {
  const Solution solution = solve(Problem());
  EXPECT_EQ(solution.status, Status::Solved);
  EXPECT_EQ(solution.r.size(), 0);
  EXPECT_EQ(Solver().solve(Problem()).status, Status::Solved);
}

}  // namespace
}  // namespace delassus
