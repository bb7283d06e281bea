#include "delassus/region.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "tests/support/brute_force.h"
#include "tests/support/frictionless_contacts.h"
#include "tests/support/random_problems.h"

namespace delassus {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

Matrix2d pair(double a, double c, double d) {
  Matrix2d W;
  W << a, c, c, d;
  return W;
}

/// The common rule of which §10 warns: hold the contacts with a positive forced reaction, drop the
/// others.
VectorXd currentIdea(const MatrixXd& W, const VectorXd& q) {
  const VectorXd forced = -W.llt().solve(q);
  std::vector<int> S;
  for (int i = 0; i < q.size(); ++i)
    if (forced[i] > 0) S.push_back(i);
  VectorXd r = VectorXd::Zero(q.size());
  if (!S.empty()) r(S) = -MatrixXd(W(S, S)).llt().solve(VectorXd(q(S)));
  return r;
}

/// Largest violation of 0 ≤ r ⊥ u ≥ 0.
double violation(const MatrixXd& W, const VectorXd& q, const VectorXd& r) {
  const VectorXd u = W * r + q;
  return r.cwiseMin(u).cwiseAbs().maxCoeff();
}

// §6: one contact is kept if and only if its forced reaction is positive.
TEST(Region, OneContactIsKeptWhereItsForcedReactionPushes) {
  EXPECT_DOUBLE_EQ(oneContact(2, -3), 1.5);
  EXPECT_EQ(oneContact(2, 3), 0);
  EXPECT_EQ(oneContact(2, 0), 0);
}

// §10, first surprise (algorithms 13a): both forced reactions are negative, and yet contact 0
// persists.
TEST(Region, BothForcedReactionsNegativeAndYetOnePersists) {
  const Matrix2d W = pair(1, -0.9, 1);
  const Vector2d q(-0.8, 0.91);
  const Vector2d forced = -W.inverse() * q;
  EXPECT_NEAR(forced[0], -0.1, 1e-14);
  EXPECT_NEAR(forced[1], -1, 1e-14);

  const RegionAnswer answer = solveRegion(W, q);
  EXPECT_NEAR(answer.r[0], 0.8, 1e-15);
  EXPECT_EQ(answer.r[1], 0);
  EXPECT_NEAR(answer.u[0], 0, 1e-15);
  EXPECT_NEAR(answer.u[1], 0.19, 1e-15);
  EXPECT_TRUE(answer.persists(0));
  EXPECT_FALSE(answer.persists(1));

  // Dropping both lets contact 0 penetrate.
  EXPECT_GT(violation(W, q, currentIdea(W, q)), 0.7);
}

// §10, second surprise (13b): one forced reaction is positive, and yet both contacts are lost.
TEST(Region, OneForcedReactionPositiveAndYetBothAreLost) {
  const Matrix2d W = pair(1, 0.9, 1);
  const Vector2d q(0.4, 0.55);
  const Vector2d forced = -W.inverse() * q;
  EXPECT_NEAR(forced[0], 0.5, 1e-14);
  EXPECT_NEAR(forced[1], -1, 1e-14);
  EXPECT_EQ(solveRegion(W, q).r, SmallVector::Zero(2));

  // Holding contact 0 alone would need it to pull.
  EXPECT_LT(currentIdea(W, q).minCoeff(), -0.3);
}

TEST(Region, TheCurrentIdeaIsOftenWrong) {
  Random random(11);
  int wrong = 0;
  for (int k = 0; k < 1000; ++k) {
    const MatrixXd W = randomDelassus(3, 100, random);
    const VectorXd q = -W * normalVector(3, random);
    EXPECT_LT(violation(W, q, solveRegion(W, q).r), 1e-12);
    if (violation(W, q, currentIdea(W, q)) > 1e-6) ++wrong;
  }
  EXPECT_GT(wrong, 100);
}

// Theory §2, the four regions of the plane of forced reactions, by their walls.
TEST(Region, TwoContactsFollowTheWallsOfThePaper) {
  Random random(12);
  for (int k = 0; k < 20000; ++k) {
    const double A1 = uniform(random, 0.1, 3), A2 = uniform(random, 0.1, 3);
    const double B = uniform(random, -0.99, 0.99) * std::sqrt(A1 * A2);
    const Vector2d f = normalVector(2, random);
    const Matrix2d W = pair(A1, B, A2);
    const auto r = twoContacts(W, -W * f);
    ASSERT_TRUE(r);
    const Vector2d Wf = W * f;
    Vector2d expected = Vector2d::Zero();
    if (f[0] > 0 && f[1] > 0) expected = f;
    if (f[1] < 0 && Wf[0] > 0) expected = {f[0] + B / A1 * f[1], 0};
    if (f[0] < 0 && Wf[1] > 0) expected = {0, f[1] + B / A2 * f[0]};
    ASSERT_LT((*r - expected).norm(), 1e-12);
  }
}

TEST(Region, CofactorsAreRefusedWhereTheyLoseDigits) {
  EXPECT_TRUE(twoContacts(pair(1, 0.99, 1), {-1, 1}));
  EXPECT_FALSE(twoContacts(pair(1, 0.99999, 1), {-1, 1}));
  EXPECT_TRUE(twoContacts(pair(1e-6, 0, 1e6), {-1, 1}));  // only the scaled pivots count
  Random random(13);
  for (int k = 0; k < 200; ++k) {
    const Matrix3d W = randomDelassus(3, 1e10, random);
    const Vector3d scale = W.diagonal().cwiseSqrt().cwiseInverse();
    const Matrix3d unit = scale.asDiagonal() * W * scale.asDiagonal();
    if (unit.determinant() < 1e-8) {
      EXPECT_FALSE(threeContacts(W, Vector3d(normalVector(3, random))));
    }
  }
}

TEST(Region, ClosedFormsAndRecursionAgree) {
  Random random(14);
  for (int k = 0; k < 20000; ++k) {
    Matrix3d W = randomDelassus(3, 100, random);
    const Vector3d scale = W.diagonal().cwiseSqrt().cwiseInverse();
    W = (scale.asDiagonal() * W * scale.asDiagonal()).eval();
    const Vector3d q = normalVector(3, random);
    const auto closed = threeContacts(W, q);
    const auto recursion = releaseRecursion(W, q);
    ASSERT_TRUE(recursion);
    if (closed) {
      ASSERT_LT(motionDistance(W, *closed, recursion->r), 1e-11);
    }
  }
}

/// Well and badly conditioned W, in units that differ from row to row, compared with enumeration.
class SmallRegions : public testing::TestWithParam<int> {};

TEST_P(SmallRegions, AreThoseOfEnumeration) {
  const int n = GetParam();
  Random random(100 + n);
  for (int k = 0; k < 4000; ++k) {
    MatrixXd W = randomDelassus(n, std::pow(10.0, k % 11), random);
    const VectorXd units = normalVector(n, random).cwiseAbs().cwiseMax(0.01);
    W = (units.asDiagonal() * W * units.asDiagonal()).eval();
    const VectorXd f = normalVector(n, random);
    const VectorXd q = k & 1 ? VectorXd(normalVector(n, random)) : VectorXd(-W * f);

    const RegionAnswer answer = solveRegion(W, q);
    ASSERT_EQ(answer.redundancy, Redundancy::None);
    ASSERT_GE(answer.r.minCoeff(), 0);
    const BruteForce truth = enumerateRegions(W, q);
    const double scale = std::sqrt(-q.dot(truth.r)) + 1e-12 * q.norm();
    ASSERT_LT(motionDistance(W, answer.r, truth.r), 1e-5 * scale);
  }
}

INSTANTIATE_TEST_SUITE_P(Contacts, SmallRegions, testing::Values(1, 2, 3, 4, 5, 6));

// §5 of the theory text: across a wall the label changes, the motion does not.
TEST(Region, TheMotionIsContinuousAcrossWalls) {
  Random random(15);
  int walls = 0;
  for (int k = 0; k < 2000; ++k) {
    const int n = 1 + k % 6;
    const MatrixXd W = randomDelassus(n, 1000, random);
    VectorXd from = normalVector(n, random);
    VectorXd to = normalVector(n, random);
    const auto at = [&](double t) { return VectorXd(-W * ((1 - t) * from + t * to)); };

    // Bisects to a change of region, if the segment crosses one.
    const auto label = [&](double t) { return (solveRegion(W, at(t)).r.array() > 0).eval(); };
    double a = 0, b = 1;
    if ((label(a) == label(b)).all()) continue;
    for (int bisection = 0; bisection < 50; ++bisection) {
      const double middle = (a + b) / 2;
      ((label(middle) == label(a)).all() ? a : b) = middle;
    }
    const VectorXd before = solveRegion(W, at(a)).r, behind = solveRegion(W, at(b)).r;
    ASSERT_LT(motionDistance(W, before, behind), 1e-11);
    ++walls;
  }
  EXPECT_GT(walls, 1400);
}

// r is the projection of f on the non-negative orthant in the metric of W. So two motions are never
// farther apart than their forced motions.
TEST(Region, TheMotionIsANonExpansiveFunctionOfTheForcedMotion) {
  Random random(16);
  for (int k = 0; k < 5000; ++k) {
    const int n = 1 + k % 6;
    const MatrixXd W = randomDelassus(n, std::pow(10.0, k % 7), random);
    const VectorXd f = normalVector(n, random), g = f + 0.5 * normalVector(n, random);
    const VectorXd r = solveRegion(W, -W * f).r, s = solveRegion(W, -W * g).r;
    ASSERT_LE(motionDistance(W, r, s), motionDistance(W, f, g) * (1 + 1e-9));
  }
}

// Algorithms 13f: the same constraint twice.
TEST(Region, OneConstraintStatedTwiceSharesTheLoad) {
  const RegionAnswer same = solveRegion(pair(1, 1, 1), Vector2d(-1, -1));
  EXPECT_EQ(same.redundancy, Redundancy::Shared);
  EXPECT_DOUBLE_EQ(same.r[0], 0.5);
  EXPECT_DOUBLE_EQ(same.r[1], 0.5);

  const RegionAnswer firstAsksMore = solveRegion(pair(1, 1, 1), Vector2d(-1, -0.5));
  EXPECT_DOUBLE_EQ(firstAsksMore.r[0], 1);
  EXPECT_EQ(firstAsksMore.r[1], 0);

  // The same in other units: W = [4 2; 2 1], the second row is half the first.
  const RegionAnswer scaled = solveRegion(pair(4, 2, 1), Vector2d(-4, -2));
  EXPECT_LT(scaled.u.norm(), 1e-15);
  EXPECT_DOUBLE_EQ(scaled.r[0] * 2, scaled.r[1] * 1);

  EXPECT_EQ(solveRegion(pair(1, 1, 1), Vector2d(1, 2)).r, SmallVector::Zero(2));
}

// Algorithms 13g: between two walls that face each other.
TEST(Region, BetweenTwoWallsTheDemandsMayBeIncompatible) {
  const RegionAnswer apart = solveRegion(pair(1, -1, 1), Vector2d(-1, 1));
  EXPECT_EQ(apart.redundancy, Redundancy::Shared);
  EXPECT_DOUBLE_EQ(apart.r[0], 1);
  EXPECT_EQ(apart.r[1], 0);

  const RegionAnswer jammed = solveRegion(pair(1, -1, 1), Vector2d(-1, 0.5));
  EXPECT_EQ(jammed.redundancy, Redundancy::Squeezed);
  EXPECT_DOUBLE_EQ(jammed.u[0], -0.25);  // both give way alike
  EXPECT_DOUBLE_EQ(jammed.u[1], -0.25);
  EXPECT_GE(jammed.r.minCoeff(), 0);
}

TEST(Region, MoreRedundantContactsAreHandedOn) {
  EXPECT_EQ(solveRegion(Matrix3d::Ones(), Vector3d(-1, -1, -1)).redundancy, Redundancy::Dependent);
  EXPECT_EQ(solveRegion(Matrix2d::Zero(), Vector2d(-1, -1)).redundancy, Redundancy::Dependent);
  EXPECT_FALSE(releaseRecursion(Matrix3d::Ones(), Vector3d(-1, -1, -1)));
}

// Mean number of leaves of the recursion: (3/2)ⁿ⁻¹ (algorithms 3.4), far from the 2ⁿ of
// enumeration.
TEST(Region, TheRecursionVisitsFewRegions) {
  Random random(17);
  const int samples = 2000, n = 6;
  double regions = 0;
  for (int k = 0; k < samples; ++k) {
    const MatrixXd W = randomDelassus(n, 100, random);
    regions += solveRegion(W, normalVector(n, random)).regionsTried;
  }
  EXPECT_LT(regions / samples, 12);
}

}  // namespace
}  // namespace delassus
