/// The law of a disk on problems small enough to be done by hand.
#include "delassus/disk.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "delassus/problem_text.h"
#include "delassus/residual.h"
#include "delassus/solver.h"
#include "tests/support/certificate.h"

namespace delassus {
namespace {

using test::EnergyBalance;
using test::energyBalance;
using test::motionBound;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Two frictionless contacts, then a disk of two numbers for the first one and a disk of one number
/// for the second. W is diagonal.
Problem twoDisks(const VectorXd& q, const VectorXd& W = VectorXd::Ones(5)) {
  Problem problem;
  problem.W = DelassusMatrix(DelassusMatrix::Sparse(MatrixXd(W.asDiagonal()).sparseView()));
  problem.q = q;
  problem.lower = VectorXd::Constant(5, -infinity);
  problem.upper = VectorXd::Constant(5, infinity);
  problem.lower.head<2>().setZero();
  problem.disks = {{2, 2, 0, 0.1}, {4, 1, 1, 0.5}};
  return problem;
}

VectorXd numbers(double a, double b, double c, double d, double e) {
  VectorXd x(5);
  x << a, b, c, d, e;
  return x;
}

TEST(MakeFeasible, TellsWhetherItMovesAnything) {
  Problem contact;
  contact.W = DelassusMatrix(DelassusMatrix::Sparse(MatrixXd::Identity(3, 3).sparseView()));
  contact.q = Vec3(-1, 0, 0);
  contact.friction = VectorXd::Constant(1, 0.5);
  const Problem disks = twoDisks(VectorXd::Zero(5));
  struct Case {
    const Problem& problem;
    VectorXd r;
    bool isMoved;
  };
  for (const Case& c : {Case{contact, Vec3(2, 0.6, 0.8), false},
                        {contact, Vec3(2, 0.7, 0.8), true},
                        {disks, numbers(10, 2, -0.6, 0.8, -1), false},
                        {disks, numbers(-10, 2, 0, 0, -1), true},
                        {disks, numbers(10, 2, -0.7, 0.8, -1), true},
                        {disks, numbers(10, 2, -0.6, 0.8, -1.1), true}}) {
    VectorXd r = c.r;
    EXPECT_EQ(makeFeasible(c.problem, r), c.isMoved) << c.r.transpose();
    EXPECT_EQ(r != c.r, c.isMoved) << c.r.transpose();
  }
}

TEST(Disk, SlidesOnItsRimSticksInsideAndIsOpenAsAPoint) {
  struct Case {
    VectorXd q, r;
    Mode first, second;
  };
  for (const Case& c :
       {Case{numbers(-10, -2, 3, 4, 0.6), numbers(10, 2, -0.6, -0.8, -0.6), Mode::Slide,
             Mode::Stick},
        Case{numbers(-100, -2, 3, 4, -3), numbers(100, 2, -3, -4, 1), Mode::Stick, Mode::Slide},
        Case{numbers(1, -2, 3, 4, -3), numbers(0, 2, 0, 0, 1), Mode::Open, Mode::Slide},
        Case{numbers(1, 1, 3, 4, -3), numbers(0, 0, 0, 0, 0), Mode::Open, Mode::Open}}) {
    const Problem problem = twoDisks(c.q);
    const Solution whole = Solver().solve(problem), apart = solve(problem);
    for (const Solution& s : {whole, apart}) {
      EXPECT_EQ(s.status, Status::Solved);
      EXPECT_LT((s.r - c.r).norm(), 1e-7) << s.r.transpose();
      EXPECT_THAT(s.activeSet.disks, ElementsAre(c.first, c.second));
    }
  }
}

// With unequal W the slip is not opposite to q, but it is opposite to the reaction.
TEST(Disk, TurnsItsReactionAgainstTheSlipThatIsLeft) {
  const Problem problem = twoDisks(numbers(-10, -2, 3, 4, 0), numbers(1, 1, 1, 5, 1));
  const Solution s = Solver().solve(problem);
  const Vec2 r = problem.disks[0].of(s.r), u = problem.disks[0].of(s.u);
  EXPECT_NEAR(r.norm(), 1, 1e-7);
  EXPECT_NEAR(r.dot(u), -u.norm(), 1e-7);
  EXPECT_GT(std::abs(r[0] * 4 - r[1] * 3), 0.1);
}

TEST(Disk, ResidualIsTheDistanceFromTheProjection) {
  const Problem problem = twoDisks(numbers(-10, -2, 3, 4, 0.6), numbers(1, 1, 2, 2, 4));
  // r_n is exact. The disk of radius 1 asks for r = (−0.6, −0.8), the other for −0.15.
  const auto residual = [&](double a, double b, double c) {
    return naturalResidual(problem, numbers(10, 2, a, b, c));
  };
  EXPECT_NEAR(residual(-0.6, -0.8, -0.15).max, 0, 1e-14);
  EXPECT_NEAR(residual(-0.6, -0.8, -0.1).max, 4 * 0.05, 1e-14);
  EXPECT_EQ(residual(-0.6, -0.8, -0.1).worst, 4);
  // Twice too much: back to the rim, in units of velocity.
  EXPECT_NEAR(residual(-1.2, -1.6, -0.15).max, 2 * 1, 1e-14);
  EXPECT_EQ(residual(-1.2, -1.6, -0.15).worst, 2);
  // Squares over all rows.
  EXPECT_NEAR(residual(-1.2, -1.6, -0.15).rms, 2 / std::sqrt(5), 1e-14);
}

TEST(Disk, DissipatesItsReactionTimesTheSlip) {
  const Problem problem = twoDisks(numbers(-10, -2, 3, 4, -3));
  const Solution s = Solver().solve(problem);
  const EnergyBalance energy = energyBalance(problem, VectorXd::Zero(5), s.r);
  EXPECT_NEAR(energy.friction, -1 * (5 - 1) - 1 * (3 - 1), 1e-6);
  EXPECT_NEAR(energy.complementarity, 0, 1e-6);
  EXPECT_EQ(motionBound(problem, s.r, s.u).squared, infinity) << "no bound: not associated";
}

TEST(Disk, ThatNoLawCanBeStatedForIsNamed) {
  const VectorXd q = numbers(-10, -2, 3, 4, 0.6);
  ASSERT_THAT(unfitParts(twoDisks(q)), IsEmpty());
  for (const Disk& bad :
       {Disk{4, 1, 1, 0}, Disk{4, 1, 1, -1}, Disk{4, 1, 1, std::nan("")}, Disk{4, 1, 1, infinity},
        Disk{4, 1, 3, 0.5}, Disk{4, 2, 1, 0.5}, Disk{4, 1, -1, 0.5}}) {
    Problem problem = twoDisks(q);
    problem.disks[1] = bad;
    EXPECT_THAT(unfitParts(problem), ElementsAre(4));
    EXPECT_EQ(Solver().solve(problem).status, Status::NonFinite);
  }
  Problem gap = twoDisks(q);
  gap.disks[0].unknowns = 1;
  EXPECT_THAT(unfitParts(gap), ElementsAre(2));
  // The radius is the only bound of a disk, and its unknowns must exist.
  Problem bounded = twoDisks(q);
  bounded.upper[bounded.rows() - 1] = 1;
  EXPECT_THAT(unfitParts(bounded), ElementsAre(4));
  for (const int far : {1000, -5}) {
    Problem away = twoDisks(q);
    away.disks[1].first = far;
    for (const int unknown : unfitParts(away)) {
      EXPECT_GE(unknown, 0);
      EXPECT_LT(unknown, away.size());
    }
    EXPECT_FALSE(unfitParts(away).empty());
    EXPECT_EQ(Solver().solve(away).status, Status::NonFinite);
  }
}

TEST(Disk, HasNoTextFormat) {
  std::ostringstream text;
  EXPECT_THROW(writeProblem(text, twoDisks(numbers(-1, -1, 0, 0, 0))), std::invalid_argument);
}

}  // namespace
}  // namespace delassus
