#include "delassus/lemke.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "delassus/pivoting.h"
#include "tests/support/random_problems.h"

namespace delassus {
namespace {

TEST(Lemke, AgreesWithPivotingOnEveryKindOfRow) {
  Random random(30);
  for (int k = 0; k < 500; ++k) {
    const int n = 1 + k % 12;
    BoundedRows rows;
    rows.W = randomDelassus(n, 100, random);
    rows.q = normalVector(n, random);
    randomBounds(n, random, rows.lower, rows.upper);
    int pivots = 0;
    const auto r = lemke(rows, 500, pivots);
    ASSERT_TRUE(r);
    const PivotResult pivoted = pivot(rows.W, rows.q, rows.lower, rows.upper);
    const VectorXd difference = *r - pivoted.r;
    ASSERT_LT(std::sqrt(std::max(0.0, difference.dot(rows.W * difference))), 1e-9);
  }
}

TEST(Lemke, ARayIsSaid) {
  const BoundedRows impossible{MatrixXd::Zero(2, 2), VectorXd::Constant(2, -1), VectorXd::Zero(2),
                               VectorXd::Constant(2, infinity), false};
  int pivots = 0;
  EXPECT_FALSE(lemke(impossible, 100, pivots));
}

}  // namespace
}  // namespace delassus
