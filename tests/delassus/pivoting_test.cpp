#include "delassus/pivoting.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/SVD>
#include <limits>
#include <set>

#include "delassus/region_walk.h"
#include "tests/support/brute_force.h"
#include "tests/support/frictionless_contacts.h"
#include "tests/support/random_problems.h"

namespace delassus {
namespace {

double naturalResidual(const PivotResult& result, const VectorXd& lower, const VectorXd& upper) {
  const VectorXd projected = (result.r - result.u).cwiseMax(lower).cwiseMin(upper);
  return (result.r - projected).cwiseAbs().maxCoeff();
}

unsigned persistingSet(const std::vector<RowState>& rows) {
  unsigned set = 0;
  for (size_t i = 0; i < rows.size(); ++i)
    if (rows[i] == RowState::Free) set |= 1u << i;
  return set;
}

/// Contacts in units that give W a unit diagonal, and walks over their regions from any of these:
/// `pivot` has only one start, and does not walk in small problems.
struct Walks {
  VectorXd inverse;
  BoundedRows rows;

  Walks(const MatrixXd& W, const VectorXd& q)
      : inverse(W.diagonal().cwiseSqrt().cwiseInverse()),
        rows{inverse.asDiagonal() * W * inverse.asDiagonal(), q.cwiseProduct(inverse),
             VectorXd::Zero(q.size()), VectorXd::Constant(q.size(), infinity), true} {}

  RegionWalk from(const std::vector<RowState>& start, RegionWalk::End& end) const {
    RegionWalk walk(rows, start);
    end = walk.settle(VectorXd::Zero(rows.size()), 0, 200);
    return walk;
  }
  VectorXd reactions(const RegionWalk& walk) const {
    return rows.clamp(walk.r()).cwiseProduct(inverse);
  }
};

/// §8, §11: the 2ⁿ regions fill the space and never overlap; the region found is that of
/// enumeration.
///
/// 202 000 random W over n = 1…10, condition numbers 1 to 1e10, half of the q drawn as q = −W f. On
/// a wall, or nearer to it than round-off, two labels belong to one motion: then only the motions
/// must agree.
class RegionTheory : public testing::TestWithParam<int> {
 protected:
  static int samples(int n) {
    return n <= 6 ? 31000 : n == 7 ? 9000 : n == 8 ? 4500 : n == 9 ? 1700 : 800;
  }
};

TEST_P(RegionTheory, TheRegionIsThatOfEnumeration) {
  const int n = GetParam();
  Random random(1000 + n);
  int otherLabels = 0;
  for (int k = 0; k < samples(n); ++k) {
    const double condition = std::pow(10.0, k % 11);
    const MatrixXd W = randomDelassus(n, condition, random);
    const VectorXd f = normalVector(n, random);
    const VectorXd q = k & 1 ? VectorXd(normalVector(n, random)) : VectorXd(-W * f);

    const PivotResult answer = pivotContacts(W, q);
    ASSERT_EQ(answer.status, Status::Solved) << "sample " << k;
    const BruteForce truth = enumerateRegions(W, q);

    // Round-off in q alone changes the motion by ε √condition; the work of the largest reactions
    // sets the scale.
    const double size = std::sqrt(std::max(0.0, -q.dot(truth.r)));
    const double tolerance = 1e-10 * std::sqrt(condition) * (size + q.norm());
    if (persistingSet(answer.rows) != truth.persisting) ++otherLabels;
    ASSERT_LT(motionDistance(W, answer.r, truth.r), tolerance) << "sample " << k;

    const Walks walks(W, q);
    RegionWalk::End end;
    const RegionWalk walk = walks.from(std::vector<RowState>(n, RowState::Free), end);
    if (end == RegionWalk::End::Settled) {
      ASSERT_LT(motionDistance(W, walks.reactions(walk), truth.r), tolerance) << "sample " << k;
    } else {
      ASSERT_EQ(end, RegionWalk::End::Singular) << "sample " << k;
      ASSERT_GT(condition, 1e8);
    }
  }
  EXPECT_LT(otherLabels, samples(n) / 100);
}

INSTANTIATE_TEST_SUITE_P(Contacts, RegionTheory, testing::Range(1, 11));

/// Algorithms 13c: a 3x3 W on which block pivoting without its guard cycles for ever.
class BlockPivotCycle : public testing::Test {
 protected:
  BlockPivotCycle() : W(3, 3), q(3) {
    W << 0.334512, -0.735715, -0.426742, -0.735715, 6.77267, 2.12606, -0.426742, 2.12606, 0.88023;
    q << 0.753427, -0.610738, -0.941291;
  }
  MatrixXd W;
  VectorXd q;
};

TEST_F(BlockPivotCycle, WithoutTheGuardRegionsRepeat) {
  std::set<unsigned> visited;
  unsigned region = 7;
  while (visited.insert(region).second) {
    std::vector<int> S;
    for (int i = 0; i < 3; ++i)
      if (region >> i & 1) S.push_back(i);
    VectorXd r = VectorXd::Zero(3);
    if (!S.empty()) r(S) = -MatrixXd(W(S, S)).llt().solve(VectorXd(q(S)));
    const VectorXd u = W * r + q;
    unsigned objecting = 0;
    for (int i = 0; i < 3; ++i)
      if (region >> i & 1 ? r[i] < 0 : u[i] < 0) objecting |= 1u << i;
    ASSERT_NE(objecting, 0u) << "this walk has ended";
    region ^= objecting;
  }
  EXPECT_EQ(visited.size(), 4u);
}

TEST_F(BlockPivotCycle, WithTheGuardEveryStartEndsInTheRegion) {
  const BoundedRows rows{W, q, VectorXd::Zero(3), VectorXd::Constant(3, infinity), true};
  BoundedRows general = rows;
  general.symmetric = false;  // Murty's guard instead of descent
  for (const BoundedRows& problem : {rows, general}) {
    for (unsigned start = 0; start < 8; ++start) {
      std::vector<RowState> states(3, RowState::AtLower);
      for (int i = 0; i < 3; ++i)
        if (start >> i & 1) states[i] = RowState::Free;
      RegionWalk walk(problem, states);
      EXPECT_EQ(walk.settle(VectorXd::Zero(3), 0, 50), RegionWalk::End::Settled);
      EXPECT_EQ(persistingSet(walk.states()), 4u);
      EXPECT_NEAR(walk.r()[2], 1.06936937, 1e-8);
    }
  }
  const PivotResult answer = pivotContacts(W, q);
  EXPECT_NEAR(answer.u[0], 0.297082177, 1e-9);
  EXPECT_NEAR(answer.u[1], 1.66280544, 1e-8);
  EXPECT_NEAR(answer.u[2], 0, 1e-15);
}

TEST(Pivoting, RowsWithBoundsFindTheRegionOfEnumeration) {
  Random random(21);
  for (int k = 0; k < 1500; ++k) {
    const int n = 1 + k % 6;
    const MatrixXd W = randomDelassus(n, std::pow(10.0, k % 5), random);
    const VectorXd q = normalVector(n, random);
    VectorXd lower, upper;
    randomBounds(n, random, lower, upper);

    const PivotResult answer = pivot(W, q, lower, upper);
    ASSERT_EQ(answer.status, Status::Solved);
    ASSERT_LT(naturalResidual(answer, lower, upper), 1e-9);
    const VectorXd truth = enumerateBoundedRegions(W, q, lower, upper);
    ASSERT_LT(motionDistance(W, answer.r, truth), 1e-9);
    for (int i = 0; i < n; ++i) {
      switch (answer.rows[i]) {
        case RowState::AtLower:
          ASSERT_DOUBLE_EQ(answer.r[i], lower[i]);
          break;
        case RowState::AtUpper:
          ASSERT_DOUBLE_EQ(answer.r[i], upper[i]);
          break;
        case RowState::Free:
          ASSERT_NEAR(answer.u[i], 0, 1e-9);
      }
    }
  }
}

TEST(Pivoting, TheRegionOfTheLastStepIsOneVisit) {
  Random random(22);
  const int n = 60;
  const MatrixXd W = randomDelassus(n, 1e4, random);
  const VectorXd q = normalVector(n, random);
  const PivotResult cold = pivotContacts(W, q);
  const Walks walks(W, 1.001 * q);
  RegionWalk::End end;
  const RegionWalk warm = walks.from(cold.rows, end);
  EXPECT_GT(cold.regions, 1);
  EXPECT_EQ(end, RegionWalk::End::Settled);
  EXPECT_EQ(warm.regions(), 1);
  EXPECT_EQ(warm.factorisations(), 1);
  EXPECT_EQ(warm.states(), cold.rows);
  EXPECT_LT((walks.reactions(warm) - 1.001 * cold.r).norm(), 1e-9 * cold.r.norm());
}

TEST(Pivoting, AnyStartLeadsToTheSameMotion) {
  Random random(23);
  const int n = 40;
  const MatrixXd W = randomDelassus(n, 1e3, random);
  const VectorXd q = normalVector(n, random);
  const PivotResult answer = pivotContacts(W, q);
  const Walks walks(W, q);
  for (int k = 0; k < 50; ++k) {
    std::vector<RowState> start(n);
    for (RowState& state : start)
      state = static_cast<RowState>(static_cast<int>(uniform(random, 0, 3)));
    RegionWalk::End end;
    const RegionWalk walk = walks.from(start, end);
    EXPECT_EQ(end, RegionWalk::End::Settled);
    EXPECT_EQ(walk.states(), answer.rows);
    EXPECT_LT(motionDistance(W, walks.reactions(walk), answer.r), 1e-12);
  }
}

TEST(Pivoting, SameInputSameBits) {
  Random random(24);
  const MatrixXd J = randomJacobian(50, 30, random);
  const MatrixXd W = J * J.transpose();
  const VectorXd q = normalVector(50, random);
  const PivotResult a = pivotContacts(W, q), b = pivotContacts(W, q);
  EXPECT_EQ(a.r, b.r);
  EXPECT_EQ(a.u, b.u);
  EXPECT_EQ(a.rows, b.rows);
}

// Round-off in q must not decide the amount of work where many contacts lie on walls of their
// regions, as contacts at rest do.
TEST(Pivoting, TiesAreHarmless) {
  Random random(25);
  for (int k = 0; k < 300; ++k) {
    const int n = 2 + k % 30;
    const MatrixXd W = randomDelassus(n, 1e3, random);
    VectorXd f = normalVector(n, random).cwiseAbs();
    for (int i = 0; i < n; i += 2) f[i] = 0;  // r_i = 0 = u_i, up to round-off
    const PivotResult answer = pivotContacts(W, -W * f);
    ASSERT_EQ(answer.status, Status::Solved);
    ASSERT_LT(motionDistance(W, answer.r, f), 1e-12);
    ASSERT_LT(answer.regions, 200);
  }
}

TEST(Pivoting, RowsThatAreNotLinkedAreSolvedOnTheirOwn) {
  Random random(26);
  const int n = 9;
  MatrixXd W = MatrixXd::Zero(2 * n, 2 * n);
  const MatrixXd A = randomDelassus(n, 100, random), B = randomDelassus(n, 100, random);
  const VectorXd q = normalVector(2 * n, random);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      W(2 * i, 2 * j) = A(i, j);  // interleaved
      W(2 * i + 1, 2 * j + 1) = B(i, j);
    }
  }
  const PivotResult together = pivotContacts(W, q);
  const PivotResult even = pivotContacts(A, q(Eigen::seqN(0, n, 2)));
  const PivotResult odd = pivotContacts(B, q(Eigen::seqN(1, n, 2)));
  EXPECT_EQ(VectorXd(together.r(Eigen::seqN(0, n, 2))), even.r);
  EXPECT_EQ(VectorXd(together.r(Eigen::seqN(1, n, 2))), odd.r);
  EXPECT_EQ(together.regions, even.regions + odd.regions);
}

TEST(Pivoting, NothingToDo) {
  const PivotResult nothing = pivot(MatrixXd(0, 0), VectorXd(0), VectorXd(0), VectorXd(0));
  EXPECT_EQ(nothing.status, Status::Solved);
  const PivotResult rest =
      pivotContacts(MatrixXd::Identity(8, 8) + MatrixXd::Ones(8, 8), VectorXd::Zero(8));
  EXPECT_EQ(rest.status, Status::Solved);
  EXPECT_EQ(rest.r, VectorXd::Zero(8));
}

TEST(Pivoting, NumbersThatAreNotFiniteAreNotPassedOn) {
  MatrixXd W = MatrixXd::Identity(2, 2);
  W(0, 1) = std::numeric_limits<double>::quiet_NaN();
  const PivotResult answer = pivotContacts(W, VectorXd::Constant(2, -1));
  EXPECT_EQ(answer.status, Status::NonFinite);
  EXPECT_TRUE(answer.r.allFinite());
  EXPECT_TRUE(answer.u.allFinite());
}

// Two contacts with |W_01| > √(W_00 W_11) are not one contact twice.
TEST(Pivoting, SolvedIsNotSaidOfWhatIsNot) {
  Random random(28);
  int solved = 0;
  for (int k = 0; k < 200; ++k) {
    MatrixXd W = MatrixXd::Identity(2, 2);
    W(0, 1) = W(1, 0) = k == 0 ? 2 : uniform(random, -3, 3);
    const VectorXd q = k == 0 ? VectorXd(VectorXd::Constant(2, -1)) : normalVector(2, random);
    const PivotResult answer = pivotContacts(W, q);
    if (answer.status != Status::Solved) continue;
    ++solved;
    const VectorXd u = W * answer.r + q;
    EXPECT_LE(answer.r.cwiseMin(u).cwiseAbs().maxCoeff(), 1e-9) << W << "\n" << q.transpose();
  }
  EXPECT_GE(solved, 100);
}

TEST(Pivoting, ASpentBudgetIsSaid) {
  Random random(27);
  const int n = 60;
  const MatrixXd W = randomDelassus(n, 1e6, random);
  const PivotResult answer =
      pivot(W, normalVector(n, random), VectorXd::Zero(n), VectorXd::Constant(n, infinity), 2);
  EXPECT_EQ(answer.status, Status::OutOfBudget);
  EXPECT_TRUE(answer.r.allFinite());
  EXPECT_GE(answer.r.minCoeff(), 0);
}

// The budget that is spent on the first rows is not there for the others.
TEST(Pivoting, NoBudgetLeavesWhatTheBoundsAsk) {
  MatrixXd W = MatrixXd::Zero(4, 4);
  W.topLeftCorner<2, 2>() << 2, 1, 1, 2;
  W.bottomRightCorner<2, 2>() = W.topLeftCorner<2, 2>();
  const VectorXd one = VectorXd::Ones(4);
  for (const int budget : {1, 0, -1, std::numeric_limits<int>::min()}) {
    const PivotResult answer = pivot(W, -one, -one, one, budget);
    EXPECT_EQ(answer.status, Status::OutOfBudget) << budget;
    EXPECT_TRUE((answer.r.array().abs() <= 1).all()) << budget;
    EXPECT_EQ(answer.u, VectorXd(W * answer.r - one)) << budget;
  }
}

// Lone contacts, be they ever so many, leave a larger group its budget.
TEST(Pivoting, SmallGroupsDoNotCount) {
  constexpr int lone = 1100, linked = 7;
  MatrixXd W = MatrixXd::Identity(lone + linked, lone + linked);
  VectorXd q = VectorXd::Constant(lone + linked, -1);
  for (int i = lone + 1; i < lone + linked; ++i) W(i, i - 1) = W(i - 1, i) = -0.25;
  for (int i = lone; i < lone + linked; i += 2) q[i] = 0.15;
  const PivotResult answer = pivotContacts(W, q);
  EXPECT_EQ(answer.status, Status::Solved);
  EXPECT_LE(answer.r.cwiseMin(answer.u).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Pivoting, ReactionsThatOverflowAreNone) {
  const PivotResult answer =
      pivotContacts(MatrixXd::Constant(1, 1, 1e-300), VectorXd::Constant(1, -1e10));
  EXPECT_EQ(answer.status, Status::NonFinite);
  EXPECT_EQ(answer.r, VectorXd::Zero(1));
}

/// Equations that contradict each other: the compromise is (W⁺) q, in units that give W a unit
/// diagonal.
TEST(Pivoting, ACompromiseHasTheLeastReactions) {
  Random random(29);
  int compromises = 0;
  for (int k = 0; k < 300; ++k) {
    const int n = 2 + k % 7, rank = 1 + k % (n - 1);
    MatrixXd J = normalMatrix(n, rank, random);
    J.rowwise().normalize();
    const MatrixXd W = J * J.transpose();
    const VectorXd q = normalVector(n, random);
    const VectorXd unbounded = VectorXd::Constant(n, infinity);
    const PivotResult answer = pivot(W, q, -unbounded, unbounded);
    compromises += answer.status == Status::Incompatible;
    Eigen::JacobiSVD<Eigen::MatrixXd> inverse(W, Eigen::ComputeThinU | Eigen::ComputeThinV);
    inverse.setThreshold(1e-10);
    const Eigen::VectorXd least = inverse.solve(-Eigen::VectorXd(q));
    EXPECT_LT((answer.r - least).norm(), 1e-7 * least.norm()) << W << "\n" << q.transpose();
  }
  EXPECT_GT(compromises, 250);
}

// Problem files hold matrices that are not Delassus matrices. This one is an upper triangular
// P-matrix on which Murty's least-index rule, one contact at a time, takes 2ⁿ steps.
TEST(Pivoting, NonsymmetricMatricesAreServed) {
  const int n = 8;
  MatrixXd W = MatrixXd::Identity(n, n);
  W.triangularView<Eigen::StrictlyUpper>().setConstant(2);
  const PivotResult answer = pivotContacts(W, VectorXd::Constant(n, -1));
  EXPECT_EQ(answer.status, Status::Solved);
  VectorXd expected = VectorXd::Zero(n);
  expected[n - 1] = 1;
  EXPECT_LT((answer.r - expected).norm(), 1e-14);

  // Random matrices with a positive definite symmetric part.
  Random random(28);
  for (int k = 0; k < 200; ++k) {
    const int m = 2 + k % 20;
    const MatrixXd A = normalMatrix(m, m, random);
    const MatrixXd general = randomDelassus(m, 100, random) + A - A.transpose();
    const PivotResult mixed = pivotContacts(general, normalVector(m, random));
    ASSERT_EQ(mixed.status, Status::Solved);
    ASSERT_LT(mixed.r.cwiseMin(mixed.u).cwiseAbs().maxCoeff(), 1e-9);
  }
}

// The optimality conditions of a linear program have a skew matrix, whose diagonal is zero:
//     minimise cᵀx, A x ≥ b, x ≥ 0:   W = [0 −Aᵀ; A 0],   q = (c, −b)
TEST(Pivoting, LinearProgramsAreServed) {
  Random random(29);
  for (int k = 0; k < 100; ++k) {
    const int n = 2 + k % 7, m = 1 + k % 5;
    const MatrixXd A = normalMatrix(m, n, random).cwiseAbs();
    MatrixXd W = MatrixXd::Zero(n + m, n + m);
    W.topRightCorner(n, m) = -A.transpose();
    W.bottomLeftCorner(m, n) = A;
    VectorXd q(n + m);
    q << normalVector(n, random).cwiseAbs(), -normalVector(m, random).cwiseAbs();
    const PivotResult program = pivotContacts(W, q);
    ASSERT_EQ(program.status, Status::Solved) << "program " << k;
    ASSERT_LT(program.r.cwiseMin(program.u).cwiseAbs().maxCoeff(), 1e-9);
    ASSERT_NEAR(q.dot(program.r), 0, 1e-9);  // strong duality
  }
}

}  // namespace
}  // namespace delassus
