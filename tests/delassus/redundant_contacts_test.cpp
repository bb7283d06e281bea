/// Redundant contacts (algorithms 5): W is singular, the motion is unique, and the reaction is the
/// share of least norm.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/brute_force.h"
#include "tests/support/frictionless_contacts.h"
#include "tests/support/random_problems.h"

namespace delassus {
namespace {

PivotResult pivotJoints(const MatrixXd& W, const VectorXd& q) {
  const auto n = q.size();
  return pivot(W, q, VectorXd::Constant(n, -infinity), VectorXd::Constant(n, infinity));
}

/// Largest violation of 0 ≤ r ⊥ u ≥ 0. W is positive semi-definite, so zero means that the motion
/// is that of Gauss' principle.
double violation(const PivotResult& result) {
  return result.r.cwiseMin(result.u).cwiseAbs().maxCoeff();
}

TEST(RedundantContacts, OneConstraintStatedManyTimesSharesTheLoad) {
  for (const int n : {2, 3, 5, 20}) {
    const PivotResult same = pivotContacts(MatrixXd::Ones(n, n), VectorXd::Constant(n, -1));
    EXPECT_EQ(same.status, Status::Solved);
    EXPECT_LT((same.r - VectorXd::Constant(n, 1.0 / n)).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT(same.u.cwiseAbs().maxCoeff(), 1e-14);

    // A contact that asks for more than the others carries all.
    VectorXd q = VectorXd::Constant(n, -0.5);
    q[0] = -1;
    const PivotResult one = pivotContacts(MatrixXd::Ones(n, n), q);
    EXPECT_EQ(one.status, Status::Solved);
    EXPECT_NEAR(one.r[0], 1, 1e-12);
    EXPECT_LT(one.r.tail(n - 1).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(RedundantContacts, TheMotionIsExact) {
  Random random(31);
  for (int k = 0; k < 2000; ++k) {
    const int n = 2 + k % 24, freedoms = 1 + k % 7;
    const MatrixXd J = randomJacobian(n, freedoms, random);
    const VectorXd free = normalVector(freedoms, random);
    const PivotResult answer = pivotContacts(J * J.transpose(), J * free);
    ASSERT_EQ(answer.status, Status::Solved) << "sample " << k;
    ASSERT_LT(violation(answer), 1e-12) << "sample " << k;
  }
}

TEST(RedundantContacts, TargetsThatDisagreeStillHaveOneMotion) {
  // Restitution and gaps: q is no longer J v. All normals have a positive component, so the demands
  // are compatible.
  Random random(32);
  for (int k = 0; k < 1000; ++k) {
    const int n = 2 + k % 20, freedoms = 1 + k % 6;
    MatrixXd J = randomJacobian(n, freedoms, random);
    J.col(0) = J.col(0).cwiseAbs().array() + 0.1;
    const PivotResult answer = pivotContacts(J * J.transpose(), normalVector(n, random));
    ASSERT_EQ(answer.status, Status::Solved) << "sample " << k;
    ASSERT_LT(violation(answer), 1e-11) << "sample " << k;
  }
}

// Σ W_ii r_i² is least. The truth is enumeration of W + 1e-9 diag W, whose reaction tends to that
// of least norm.
TEST(RedundantContacts, TheReactionHasLeastNorm) {
  Random random(33);
  int compared = 0;
  for (int k = 0; k < 300; ++k) {
    const int n = 3 + k % 6;
    const MatrixXd J = randomJacobian(n, 2, random);
    MatrixXd W = J * J.transpose();
    const VectorXd q = J * normalVector(2, random);
    const PivotResult answer = pivotContacts(W, q);
    W.diagonal() *= 1 + 1e-9;
    const BruteForce truth = enumerateRegions(W, q);
    if (truth.r.norm() > 100) continue;  // nearly parallel rows: the truth itself has no digits
    ASSERT_LT((answer.r - truth.r).norm(), 1e-5 * (1 + truth.r.norm())) << "sample " << k;
    ++compared;
  }
  EXPECT_GT(compared, 250);
}

// A box at rest on its four corners, and stacks of boxes: all corners of a face carry the same.
TEST(RedundantContacts, CornersOfAStackCarryTheirShare) {
  for (const double massRatio : {1.0, 3.0, 0.3}) {
    for (const int boxes : {1, 2, 10}) {
      const MatrixXd J = boxStackJacobian(boxes, massRatio);
      VectorXd free = VectorXd::Zero(3 * boxes);
      double weight = 0;
      VectorXd expected(4 * boxes);
      for (int box = boxes - 1; box >= 0; --box) {
        const double mass = std::pow(massRatio, box);
        free[3 * box] = -std::sqrt(mass);  // falling with 1 m/s
        weight += mass;
        expected.segment<4>(4 * box).setConstant(weight / 4);
      }
      const PivotResult answer = pivotContacts(J * J.transpose(), J * free);
      EXPECT_EQ(answer.status, Status::Solved);
      EXPECT_LT(answer.u.cwiseAbs().maxCoeff(), 1e-10);  // ε times W r of the lightest box
      EXPECT_LT((answer.r - expected).cwiseAbs().maxCoeff(), 1e-7 * expected.maxCoeff());
    }
  }
}

// A box between floor and ceiling. The floor asks it to rise at `rise`, the ceiling to sink at
// `fall`.
class SqueezedBox : public testing::Test {
 protected:
  static MatrixXd jacobian() {
    MatrixXd J(8, 3);
    J << boxStackJacobian(1), -boxStackJacobian(1);
    return J;
  }
  static PivotResult squeeze(double rise, double fall) {
    const MatrixXd J = jacobian();
    VectorXd q(8);
    q << VectorXd::Constant(4, -rise), VectorXd::Constant(4, -fall);
    return pivotContacts(J * J.transpose(), q);
  }
};

TEST_F(SqueezedBox, RoomEnoughIsSolved) {
  const PivotResult answer = squeeze(1, -2);
  EXPECT_EQ(answer.status, Status::Solved);
  EXPECT_LT(violation(answer), 1e-13);
  EXPECT_TRUE(answer.blamed.empty());
}

TEST_F(SqueezedBox, JustFittingIsSolved) {
  const PivotResult answer = squeeze(1, -1);
  EXPECT_EQ(answer.status, Status::Solved);
  EXPECT_LT(answer.u.cwiseAbs().maxCoeff(), 1e-12);
}

TEST_F(SqueezedBox, DemandsThatNoMotionMeetsAreNamedAndShared) {
  const PivotResult answer = squeeze(1, 0.5);
  EXPECT_EQ(answer.status, Status::Incompatible);
  EXPECT_EQ(answer.blamed, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_TRUE(answer.r.allFinite());
  EXPECT_GE(answer.r.minCoeff(), 0);
  EXPECT_LT(answer.r.maxCoeff(), 2);
  // 1.5 m/s too much, halved between floor and ceiling.
  EXPECT_LT((answer.u - VectorXd::Constant(8, -0.75)).cwiseAbs().maxCoeff(), 1e-8);
}

// The shortfall s = max(0, −u) of the compromise is the least: normal to all that reactions can do,
// W s = 0.
TEST(RedundantContacts, TheCompromiseIsLeastSquares) {
  Random random(34);
  int incompatible = 0;
  for (int k = 0; k < 300; ++k) {
    const int n = 4 + k % 10;
    MatrixXd J = randomJacobian(n, 2, random);
    J.rowwise().normalize();  // unit diagonal: scaled and plain norms agree
    const MatrixXd W = J * J.transpose();
    const PivotResult answer = pivotContacts(W, normalVector(n, random));
    ASSERT_TRUE(answer.r.allFinite());
    ASSERT_NE(answer.status, Status::OutOfBudget) << "sample " << k;
    if (answer.status == Status::Solved) {
      ASSERT_LT(violation(answer), 1e-11) << "sample " << k;
      continue;
    }
    ++incompatible;
    const VectorXd shortfall = (-answer.u).cwiseMax(0);
    // Entries of a direction below 1e-6 count as zero.
    ASSERT_LT((W * shortfall).norm(), 1e-5 * shortfall.norm()) << "sample " << k;
    ASSERT_LT((answer.r.array() * (answer.u + shortfall).array()).abs().maxCoeff(), 1e-5);
    for (int i = 0; i < n; ++i) {
      const bool named = std::count(answer.blamed.begin(), answer.blamed.end(), i) > 0;
      if (shortfall[i] > 1e-5 * shortfall.maxCoeff()) {
        ASSERT_TRUE(named) << "sample " << k;
      }
    }
  }
  EXPECT_GT(incompatible, 50);
}

TEST(RedundantContacts, OnlyTheJammedOnesAreBlamed) {
  // Contacts 1 and 3 squeeze one body; 0 and 2 belong to others.
  MatrixXd W = MatrixXd::Identity(4, 4);
  W(1, 3) = W(3, 1) = -1;
  W(0, 2) = W(2, 0) = 0.5;
  const PivotResult answer = pivotContacts(W, (VectorXd(4) << -1, -1, -1, 0.5).finished());
  EXPECT_EQ(answer.status, Status::Incompatible);
  EXPECT_EQ(answer.blamed, (std::vector<int>{1, 3}));
  EXPECT_NEAR(answer.u[0], 0, 1e-14);
  EXPECT_NEAR(answer.u[1], -0.25, 1e-12);
}

TEST(RedundantContacts, RedundantJointsShareOrCompromise) {
  // A joint written twice, and once more in other units.
  const Vec3 J(1, 1, 2);
  const MatrixXd W = J * J.transpose();
  const PivotResult agreed = pivotJoints(W, Vec3(-1, -1, -2));
  EXPECT_EQ(agreed.status, Status::Solved);
  EXPECT_LT(agreed.u.cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_NEAR(agreed.r[0], 1.0 / 3, 1e-9);
  EXPECT_NEAR(agreed.r[2], 1.0 / 6, 1e-9);

  const PivotResult opposed = pivotJoints(W, Vec3(-1, 0, 0));
  EXPECT_EQ(opposed.status, Status::Incompatible);
  EXPECT_EQ(opposed.blamed, (std::vector<int>{0, 1, 2}));
  // Least squares in scaled velocities (u0, u1, u2/2) = v − (1, 0, 0): v = 1/3.
  EXPECT_NEAR(opposed.u[0], 1.0 / 3 - 1, 1e-9);
  EXPECT_NEAR(opposed.u[1], 1.0 / 3, 1e-9);
  EXPECT_NEAR(opposed.u[2], 2.0 / 3, 1e-9);
}

TEST(RedundantContacts, ABoundedRowGivesWay) {
  // Two motors on one axis want different speeds: the weaker saturates.
  const PivotResult answer = pivot(MatrixXd::Ones(2, 2), Eigen::Vector2d(-1, 1),
                                   Eigen::Vector2d(-5, -0.5), Eigen::Vector2d(5, 0.5));
  EXPECT_EQ(answer.status, Status::Solved);
  EXPECT_EQ(answer.rows[1], RowState::AtLower);
  EXPECT_NEAR(answer.r[0], 1.5, 1e-12);
  EXPECT_NEAR(answer.r[1], -0.5, 1e-15);
}

TEST(RedundantContacts, RowsThatNothingMovesKeepTheirVelocity) {
  const Vec3 lower(0, 0, -2), upper(infinity, infinity, 3);
  const PivotResult fine = pivot(MatrixXd::Zero(3, 3), Vec3(1, 0, -1), lower, upper);
  EXPECT_EQ(fine.status, Status::Solved);
  EXPECT_EQ(fine.r, VectorXd(Vec3(0, 0, 3)));
  const PivotResult stuck = pivot(MatrixXd::Zero(3, 3), Vec3(1, -1, 0), lower, upper);
  EXPECT_EQ(stuck.status, Status::Incompatible);
  EXPECT_EQ(stuck.blamed, std::vector<int>{1});
  EXPECT_EQ(stuck.r, VectorXd(Vec3(0, 0, 0)));
}

// The corners disagree by float round-off, as in a world in single precision. There is still one
// motion, with finite shares.
TEST(RedundantContacts, FloatRoundOffDoesNoHarm) {
  Random random(35);
  for (int k = 0; k < 200; ++k) {
    const int boxes = 1 + k % 8;
    MatrixXd J = boxStackJacobian(boxes);
    J += 1e-7 * normalMatrix(static_cast<int>(J.rows()), static_cast<int>(J.cols()), random)
                    .cwiseProduct(J.cwiseAbs());
    VectorXd free = VectorXd::Zero(3 * boxes);
    for (int box = 0; box < boxes; ++box) free[3 * box] = -1;
    const VectorXd noise = 1e-8 * normalVector(4 * boxes, random);
    const PivotResult answer = pivotContacts(J * J.transpose(), J * free + noise);
    ASSERT_EQ(answer.status, Status::Solved) << "sample " << k;
    ASSERT_LT(violation(answer), 1e-10);
    ASSERT_LT(answer.r.maxCoeff(), 2.0 * boxes);
  }
}

}  // namespace
}  // namespace delassus
