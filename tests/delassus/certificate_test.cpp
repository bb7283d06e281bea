#include "tests/support/certificate.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

#include "delassus/island.h"
#include "tests/support/random_piles.h"
#include "tests/support/reference_contact.h"

namespace delassus {
namespace {

using test::EnergyBalance;
using test::energyBalance;
using test::MotionBound;
using test::motionBound;

class Draws {
 public:
  explicit Draws(unsigned seed) : random_(seed) {}

  double uniform() { return std::uniform_real_distribution<double>()(random_); }
  double normal() { return std::normal_distribution<double>()(random_); }
  bool coin() { return uniform() < 0.5; }
  VectorXd positive(int n) {
    return VectorXd::Zero(n).unaryExpr([&](double) { return uniform(); });
  }
  MatrixXd matrix(int rows, int columns) {
    return MatrixXd::Zero(rows, columns).unaryExpr([&](double) { return normal(); });
  }
  Vec3 vector() { return matrix(3, 1); }

 private:
  std::mt19937_64 random_;
};

DelassusMatrix explicitMatrix(const MatrixXd& W) {
  return DelassusMatrix(DelassusMatrix::Sparse(W.sparseView()));
}

/// A problem of rows whose solution is known because it was chosen first: q = u* − W r*.
struct KnownRows {
  MatrixXd J;     // with M = 1: |v − v*|_M = |Jᵀ (r − r*)|
  VectorXd soft;  // R
  VectorXd r, u;  // r*, u*
  Problem problem;

  KnownRows(Draws& random, int n, int dofs, bool boxed) : J(random.matrix(n, dofs)), r(n), u(n) {
    soft = random.coin() ? random.positive(n) : VectorXd::Zero(n);
    problem.lower = VectorXd::Zero(n);
    problem.upper = VectorXd::Constant(n, infinity);
    for (int i = 0; i < n; ++i) {
      if (boxed) {
        problem.lower[i] = -random.uniform();
        problem.upper[i] = random.uniform();
      }
      const double where = random.uniform(), push = random.uniform();
      r[i] = problem.lower[i], u[i] = push;
      if (where < 0.6) {
        const double top = boxed ? problem.upper[i] : 1;
        r[i] = problem.lower[i] + (top - problem.lower[i]) * push, u[i] = 0;
      } else if (boxed && where < 0.8) {
        r[i] = problem.upper[i], u[i] = -push;
      }
    }
    const MatrixXd W = J * J.transpose() + MatrixXd(soft.asDiagonal());
    problem.W = explicitMatrix(W);
    problem.q = u - W * r;
  }

  VectorXd velocity(const VectorXd& x) const { return problem.W * x + problem.q; }
  double distance2(const VectorXd& x) const {
    const VectorXd d = x - r;
    return (J.transpose() * d).squaredNorm() + d.dot(soft.cwiseProduct(d));
  }
  VectorXd allowedReactions(Draws& random) const {
    const VectorXd top = problem.upper.cwiseMin(2.0);
    return problem.lower + (top - problem.lower).cwiseProduct(random.positive(int(r.size())));
  }
};

TEST(MotionBound, HoldsForUnilateralRowsWithoutPenetration) {
  Draws random(94);
  int certified = 0;
  for (int k = 0; k < 2000; ++k) {
    const KnownRows known(random, 1 + k % 4, 1 + k % 5, false);
    const VectorXd r = known.allowedReactions(random), u = known.velocity(r);
    const MotionBound bound = motionBound(known.problem, r, u);
    EXPECT_EQ(bound.relaxation, std::max(0.0, -u.minCoeff()));
    if (bound.relaxation > 0) continue;
    ++certified;
    EXPECT_NEAR(bound.squared, r.dot(u), 1e-14 * (1 + r.norm() * u.norm()));
    EXPECT_LE(known.distance2(r), bound.squared * (1 + 1e-12) + 1e-14);
  }
  EXPECT_GT(certified, 200);
}

TEST(MotionBound, HoldsWithALimitOnReactions) {
  Draws random(95);
  for (int k = 0; k < 1000; ++k) {
    const KnownRows known(random, 1 + k % 8, 1 + k % 6, false);
    const VectorXd r = known.allowedReactions(random), u = known.velocity(r);
    // Algorithms §9.4, with the sharpest limit and with one that also contains r.
    const MotionBound sharp = motionBound(known.problem, r, u, known.r);
    const VectorXd limit = known.r.cwiseMax(r);
    const MotionBound wide = motionBound(known.problem, r, u, limit);
    EXPECT_EQ(sharp.relaxation, 0);
    EXPECT_LE(known.distance2(r), sharp.squared * (1 + 1e-12) + 1e-13);
    EXPECT_LE(sharp.squared, wide.squared);
    EXPECT_NEAR(wide.squared, r.dot(u) + limit.dot((-u).cwiseMax(0)),
                1e-13 * (1 + limit.norm() * u.norm()));
  }
}

TEST(MotionBound, HoldsForBoxedRowsWithoutAnyRelaxation) {
  Draws random(96);
  for (int k = 0; k < 1000; ++k) {
    const KnownRows known(random, 1 + k % 8, 1 + k % 6, true);
    const VectorXd r = known.allowedReactions(random);
    const MotionBound bound = motionBound(known.problem, r, known.velocity(r));
    EXPECT_EQ(bound.relaxation, 0);
    EXPECT_LE(known.distance2(r), bound.squared * (1 + 1e-12) + 1e-13);
  }
}

TEST(MotionBound, VanishesAtTheSolution) {
  Draws random(97);
  for (int k = 0; k < 100; ++k) {
    const KnownRows known(random, 5, 6, k % 2 == 0);
    const MotionBound bound = motionBound(known.problem, known.r, known.u);
    EXPECT_EQ(bound.squared, 0);
    EXPECT_EQ(bound.relaxation, 0);
  }
}

/// With penetration the bound holds for the problem whose demands are relaxed by as much. Plain
/// sweeps solve that problem here.
TEST(MotionBound, HoldsForTheRelaxedProblem) {
  Draws random(98);
  for (int k = 0; k < 100; ++k) {
    const int n = 2 + k % 3;
    KnownRows known(random, n, 6, false);
    const VectorXd r = known.allowedReactions(random), u = known.velocity(r);
    const MotionBound bound = motionBound(known.problem, r, u);
    const VectorXd relaxed = known.problem.q + (-u).cwiseMax(0);
    EXPECT_LE((relaxed - known.problem.q).maxCoeff(), bound.relaxation);

    const MatrixXd W = known.problem.W.dense();
    known.r = r;
    for (int sweep = 0; sweep < 20000; ++sweep)
      for (int i = 0; i < n; ++i)
        known.r[i] = std::max(0.0, known.r[i] - (W.row(i).dot(known.r) + relaxed[i]) / W(i, i));
    EXPECT_LE(known.distance2(r), bound.squared + 1e-9);
  }
}

TEST(MotionBound, JointsAreRelaxedByTheirSlip) {
  Problem problem;
  problem.W = explicitMatrix(MatrixXd::Identity(2, 2));
  problem.q = Eigen::Vector2d(1, -1);
  problem.lower = Eigen::Vector2d(-infinity, 0);
  problem.upper = Eigen::Vector2d::Constant(infinity);
  const Eigen::Vector2d r(-0.75, 1.5), u(0.25, 0.5);
  const MotionBound bound = motionBound(problem, r, u);
  EXPECT_DOUBLE_EQ(bound.relaxation, 0.25);
  EXPECT_DOUBLE_EQ(bound.squared, 0.75);
}

TEST(MotionBound, SaysNothingWhereItIsNotValid) {
  Problem contact;
  contact.W = explicitMatrix(MatrixXd::Identity(3, 3));
  contact.q = Vec3(-1, 2, 0);
  contact.friction = VectorXd::Zero(1);
  const Vec3 r(1, 0, 0);
  EXPECT_EQ(motionBound(contact, r, r + contact.q).squared, 0) << "no friction: exact";
  EXPECT_EQ(motionBound(contact, Vec3(1, 0.1, 0), contact.q).squared, infinity) << "r not allowed";
  EXPECT_EQ(motionBound(contact, Vec3(-1e-300, 0, 0), contact.q).squared, infinity);
  EXPECT_EQ(motionBound(contact, Vec3(std::nan(""), 0, 0), contact.q).squared, infinity);
  EXPECT_EQ(motionBound(contact, r, Vec3(std::nan(""), 0, 0)).squared, infinity);
  contact.friction[0] = 0.5;
  EXPECT_EQ(motionBound(contact, r, r + contact.q).squared, infinity) << "friction";
}

/// A small world of free bodies with contacts and rows, all with targets and compliance.
struct World {
  std::vector<Body> bodies;
  std::vector<Contact> contacts;
  std::vector<Row> rows;
  Island island;
  Problem problem;
  VectorXd target;

  explicit World(Draws& random) {
    for (int i = 0; i < 3; ++i) {
      Body body;
      body.inverseMass.setConstant(0.1 + random.uniform());
      const Mat3 root = random.matrix(3, 3);
      body.inverseInertia = root * root.transpose() + Mat3::Identity();
      body.velocity = random.matrix(6, 1);
      bodies.push_back(body);
    }
    for (int i = 0; i < 4; ++i) {
      Contact contact;
      contact.a = i % 3;
      contact.b = i < 2 ? i + 1 : fixedWorld;
      contact.armA = random.vector();
      contact.armB = random.vector();
      contact.friction = i == 3 ? 0 : random.uniform();
      contact.target = random.vector();
      contact.compliance = random.uniform();
      contacts.push_back(contact);
    }
    Row row;
    row.a = 0, row.b = 2;
    row.jacobianA = random.matrix(1, 6), row.jacobianB = random.matrix(1, 6);
    row.target = random.normal(), row.compliance = random.uniform();
    rows.push_back(row);

    island = splitIslands(bodies, contacts, rows).at(0);
    problem = assemble(bodies, contacts, rows, island);
    target.resize(problem.size());
    int at = 0;
    for (const int i : island.frictional) target.segment<3>(3 * at++) = contacts[i].target;
    at *= 3;
    for (const int i : island.frictionless) target[at++] = contacts[i].target[0];
    for (const int i : island.rows) target[at++] = rows[i].target;
  }
};

TEST(EnergyBalance, IsTheKineticEnergyOfTheBodiesForAnyReactions) {
  Draws random(95);
  for (int k = 0; k < 50; ++k) {
    const World world(random);
    const VectorXd r = random.matrix(world.problem.size(), 1);
    std::vector<Body> after = world.bodies;
    applyReaction(after, world.contacts, world.rows, world.island, r);

    const double before = delassus::test::kineticEnergy(world.bodies);
    const double gained = delassus::test::kineticEnergy(after) - before;
    const EnergyBalance balance = energyBalance(world.problem, world.target, r);
    const double scale = before + std::abs(balance.impact) + std::abs(balance.compliance);
    EXPECT_NEAR(balance.change, gained, 1e-12 * scale);
    EXPECT_NEAR(balance.sum(), balance.change, 1e-12 * scale);
    EXPECT_LE(balance.impact, 0);
    EXPECT_LE(balance.compliance, 0);
  }
}

TEST(EnergyBalance, CoulombsLawOnlyLosesEnergy) {
  Draws random(96);
  for (int k = 0; k < 100; ++k) {
    const Mat3 root = random.matrix(3, 3);
    const Mat3 W = root * root.transpose() + 0.5 * Mat3::Identity();
    Problem problem;
    problem.W = explicitMatrix(W);
    problem.q = random.vector();
    problem.friction = VectorXd::Constant(1, 0.1 + random.uniform());
    const test::ReferenceContact contact =
        test::referenceContact(W, problem.q, problem.friction[0]);
    const EnergyBalance balance = energyBalance(problem, Vec3::Zero(), contact.r);
    EXPECT_NEAR(balance.complementarity, 0, 1e-13);
    EXPECT_LE(balance.friction, 0);
    EXPECT_LE(balance.change, 1e-13);
    EXPECT_NEAR(balance.sum(), balance.change, 1e-13);
    EXPECT_EQ(balance.friction < -1e-12, contact.mode == Mode::Slide);
  }
}

}  // namespace
}  // namespace delassus
