#include "delassus/principal_cholesky.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/support/random_problems.h"

namespace delassus {
namespace {

/// (W + shift I)_SS x − b, relative to b.
double relativeResidual(const PrincipalCholesky& cholesky, const MatrixXd& W, double shift,
                        Random& random) {
  const std::vector<int>& S = cholesky.rows();
  if (S.empty()) return 0;
  const VectorXd b = normalVector(static_cast<int>(S.size()), random);
  const VectorXd x = cholesky.solve(b);
  return (W(S, S) * x + shift * x - b).norm() / b.norm();
}

std::vector<int> sorted(std::vector<int> rows) {
  std::sort(rows.begin(), rows.end());
  return rows;
}

std::vector<int> randomSubset(int n, Random& random) {
  std::vector<int> subset;
  for (int i = 0; i < n; ++i)
    if (uniform(random, 0, 1) < 0.6) subset.push_back(i);
  return subset;
}

TEST(PrincipalCholesky, SolvesWithThePrincipalBlockOfItsRows) {
  Random random(1);
  const MatrixXd W = randomDelassus(12, 100, random);
  PrincipalCholesky cholesky(W);
  EXPECT_TRUE(cholesky.factor({7, 2, 9, 0}));
  EXPECT_EQ(cholesky.rows(), (std::vector<int>{7, 2, 9, 0}));
  EXPECT_LT(relativeResidual(cholesky, W, 0, random), 1e-13);
}

TEST(PrincipalCholesky, TheShiftIsAddedToTheDiagonal) {
  Random random(2);
  const MatrixXd W = randomDelassus(6, 10, random);
  PrincipalCholesky cholesky(W, 0.5);
  EXPECT_TRUE(cholesky.factor({0, 1, 2, 3, 4, 5}));
  EXPECT_LT(relativeResidual(cholesky, W, 0.5, random), 1e-14);
}

TEST(PrincipalCholesky, ReadsOnlyTheLowerTriangle) {
  Random random(3);
  MatrixXd W = randomDelassus(5, 10, random);
  const MatrixXd complete = W;
  W.triangularView<Eigen::StrictlyUpper>().setZero();
  PrincipalCholesky cholesky(W);
  EXPECT_TRUE(cholesky.factor({3, 1, 4}));
  EXPECT_TRUE(cholesky.append(0));
  EXPECT_LT(relativeResidual(cholesky, complete, 0, random), 1e-13);
}

TEST(PrincipalCholesky, KeepsItsDigitsThroughHundredsOfEdits) {
  Random random(4);
  const int n = 30;
  const MatrixXd W = randomDelassus(n, 1e4, random);
  PrincipalCholesky cholesky(W);
  for (int edit = 0; edit < 500; ++edit) {
    const int k = static_cast<int>(uniform(random, 0, n));
    const auto place = std::find(cholesky.rows().begin(), cholesky.rows().end(), k);
    if (place == cholesky.rows().end()) {
      EXPECT_TRUE(cholesky.append(k));
    } else {
      cholesky.remove(static_cast<int>(place - cholesky.rows().begin()));
    }
    // Backward stable: a residual of some ε times the condition number.
    ASSERT_LT(relativeResidual(cholesky, W, 0, random), 1e-10);
  }
  EXPECT_EQ(cholesky.factorisations(), 0);
}

TEST(PrincipalCholesky, RetargetReachesAnySetFromAnyOther) {
  Random random(5);
  const int n = 40;
  const MatrixXd W = randomDelassus(n, 100, random);
  PrincipalCholesky cholesky(W);
  for (int change = 0; change < 50; ++change) {
    const std::vector<int> target = randomSubset(n, random);
    EXPECT_TRUE(cholesky.retarget(target));
    ASSERT_EQ(sorted(cholesky.rows()), target);
    ASSERT_LT(relativeResidual(cholesky, W, 0, random), 1e-12);
  }
}

TEST(PrincipalCholesky, FewChangesAreEditsManyAreAFactorisation) {
  Random random(6);
  const MatrixXd W = randomDelassus(40, 100, random);
  std::vector<int> all(40);
  std::iota(all.begin(), all.end(), 0);
  PrincipalCholesky cholesky(W);
  cholesky.retarget(all);
  EXPECT_EQ(cholesky.factorisations(), 1);
  EXPECT_FALSE(cholesky.edited());

  std::vector<int> fewer(all.begin() + 3, all.end());
  cholesky.retarget(fewer);
  EXPECT_EQ(cholesky.factorisations(), 1);
  EXPECT_TRUE(cholesky.edited());

  cholesky.retarget({all.begin(), all.begin() + 10});
  EXPECT_EQ(cholesky.factorisations(), 2);
  EXPECT_FALSE(cholesky.edited());
}

TEST(PrincipalCholesky, RedundantRowsAreLeftOut) {
  Random random(7);
  const int n = 10, freedoms = 6;
  const MatrixXd J = randomJacobian(n, freedoms, random);
  const MatrixXd W = J * J.transpose();
  std::vector<int> all(n);
  std::iota(all.begin(), all.end(), 0);
  PrincipalCholesky cholesky(W);
  EXPECT_FALSE(cholesky.factor(all));
  EXPECT_EQ(static_cast<int>(cholesky.rows().size()), freedoms);
  EXPECT_LT(relativeResidual(cholesky, W, 0, random), 1e-9);

  // Any row outside is redundant, and refusing a row leaves the factor as it was.
  const std::vector<int> before = cholesky.rows();
  EXPECT_FALSE(cholesky.append(n - 1));
  EXPECT_EQ(cholesky.rows(), before);

  // Once one row has gone, another one is no longer redundant.
  cholesky.remove(0);
  EXPECT_TRUE(cholesky.append(n - 1));
}

TEST(PrincipalCholesky, TheEmptySetNeedsNoFactorisation) {
  const MatrixXd W = MatrixXd::Identity(3, 3);
  PrincipalCholesky cholesky(W);
  EXPECT_TRUE(cholesky.factor({}));
  EXPECT_TRUE(cholesky.retarget({}));
  EXPECT_EQ(cholesky.factorisations(), 0);
  EXPECT_TRUE(cholesky.append(2));
  cholesky.remove(0);
  EXPECT_TRUE(cholesky.rows().empty());
}

}  // namespace
}  // namespace delassus
