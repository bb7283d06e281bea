/// The inverses of pivot blocks, by what they leave of the identity.
#include "delassus/block_inverse.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "tests/support/random_problems.h"

namespace delassus {
namespace {

// Rows of any scale, and pivots that are not where they should be: the error that rounding leaves
// is that of |A⁻¹| |A|.
TEST(BlockInverse, InvertsWhatIsNotSingular) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  Random random(24);
  for (int round = 0; round < 1000; ++round) {
    Mat6 A = normalMatrix(6, 6, random);
    if (round % 2 == 1)
      for (int i = 0; i < 6; ++i) A.row(i) *= std::pow(10, uniform(random, -6, 6));
    if (round % 3 == 1) A.diagonal().setZero();
    Mat6 inverse;
    bool isNegative;
    ASSERT_TRUE(invert(A, inverse, isNegative));
    EXPECT_EQ(isNegative, A.determinant() < 0) << "round " << round;
    const double rounding = epsilon * (inverse.cwiseAbs() * A.cwiseAbs()).norm();
    EXPECT_LT((inverse * A - Mat6::Identity()).norm(), 4 * rounding) << "round " << round;
  }
}

// Sums of squares need no pivots: weights of all sizes cost no more digits than the condition does.
TEST(BlockInverse, InvertsWhatMayBeStiff) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  Random random(25);
  for (int round = 0; round < 300; ++round) {
    Mat6 A = Mat6::Identity();
    for (int k = 0; k < round % 8; ++k) {
      const Vec6 row = normalVector(6, random);
      A += std::pow(10, uniform(random, 0, 9)) * row * row.transpose();
    }
    Mat6 inverse;
    bool isNegative;
    ASSERT_TRUE(invert(A, inverse, isNegative));
    EXPECT_FALSE(isNegative);
    EXPECT_LT((inverse * A - Mat6::Identity()).norm(), 16 * epsilon * inverse.norm() * A.norm());

    Mat6 inverseC, transposed;
    ASSERT_TRUE(invertCholesky(A, inverseC, transposed));
    EXPECT_EQ(inverseC, Mat6(transposed.transpose()));
    EXPECT_EQ(inverseC, Mat6(inverseC.triangularView<Eigen::Lower>()));
    EXPECT_LT((inverseC * A * transposed - Mat6::Identity()).norm(),
              16 * epsilon * inverseC.norm() * inverseC.norm() * A.norm());
  }
}

TEST(BlockInverse, SingularAndBrokenBlocksHaveNoInverse) {
  Mat6 inverse;
  bool isNegative;
  EXPECT_FALSE(invert(Mat6::Zero(), inverse, isNegative));
  EXPECT_FALSE(invert(Mat6::Ones(), inverse, isNegative));
  Mat6 broken = Mat6::Identity();
  broken(4, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(invert(broken, inverse, isNegative));
  // An infinite pivot leaves only zeros behind.
  Mat6 infinite = Mat6::Identity();
  infinite(2, 2) = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(invert(infinite, inverse, isNegative));
  Mat6 coupled = infinite;
  coupled(5, 2) = coupled(2, 5) = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(invert(coupled, inverse, isNegative));

  Mat6 transposed, indefinite = Mat6::Identity();
  indefinite(3, 3) = -1;
  for (const Mat6& A :
       {Mat6(Mat6::Zero()), Mat6(Mat6::Ones()), broken, infinite, coupled, indefinite})
    EXPECT_FALSE(invertCholesky(A, inverse, transposed));
}

}  // namespace
}  // namespace delassus
