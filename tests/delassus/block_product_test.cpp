/// The products of a factorisation against plain loops, bit by bit, and its solutions against dense matrices.
#include "delassus/block_product.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>
#include <vector>

#include "tests/support/random_problems.h"

namespace delassus {
namespace {

// However wide the processor is: one rounding after each product and each sum, k by k.
TEST(BlockProduct, HasTheBitsOfPlainLoops) {
  Random random(21);
  const std::vector<int> row = {3, 0, 5, 4}, place = {1, -1, -1, 4, 0, 2};
  for (int round = 0; round < 100; ++round) {
    std::vector<Mat6> blocks(row.size()), to(5);
    for (Mat6& block : blocks) block = normalMatrix(6, 6, random);
    for (Mat6& block : to) block = normalMatrix(6, 6, random);
    const Mat6 B = normalMatrix(6, 6, random);

    std::vector<Mat6> expected = to;
    for (std::size_t i = 0; i < row.size(); ++i)
      for (int c = 0; c < 6; ++c)
        for (int r = 0; r < 6; ++r)
          for (int k = 0; k < 6; ++k) {
            const double product = blocks[i](r, k) * B(c, k);
            expected[place[row[i]]](r, c) -= product;
          }
    subtractProducts(blocks.data(), row.data(), static_cast<int>(row.size()), B, place.data(),
                     to.data());
    for (std::size_t i = 0; i < to.size(); ++i) EXPECT_EQ(to[i], expected[i]) << "block " << i;
  }
}

/// Four columns: one with two blocks below it, one with one, one with none.
class BlockSolves : public ::testing::Test {
 protected:
  static constexpr int columns = 4;
  const std::vector<int> begin_ = {0, 2, 3, 3, 3}, row_ = {1, 3, 2};
  Random random_{22};
  std::vector<Mat6> blocks_, D_, inverseD_;
  MatrixXd lower_, diagonal_;

  BlockSolves() : lower_(MatrixXd::Identity(24, 24)), diagonal_(MatrixXd::Zero(24, 24)) {
    for (int j = 0, at = 0; j < columns; ++j) {
      D_.emplace_back(Mat6::Identity() + 0.1 * normalMatrix(6, 6, random_));
      inverseD_.emplace_back(D_.back().inverse());
      diagonal_.block<6, 6>(6 * j, 6 * j) = D_.back();
      for (; at < begin_[j + 1]; ++at) {
        blocks_.emplace_back(normalMatrix(6, 6, random_));
        lower_.block<6, 6>(6 * row_[at], 6 * j) = blocks_.back();
      }
    }
  }

  BlockColumns blocks() const { return {columns, begin_.data(), row_.data(), blocks_.data()}; }

  /// matrix⁻¹ x as the dense matrix and as `solve` has it. What is left of the room holds no numbers.
  template <class Solve>
  void compare(const MatrixXd& matrix, Solve solve) {
    const VectorXd x = normalMatrix(24, 1, random_).col(0);
    VectorXd z = VectorXd::Constant(paddedSize * columns, std::numeric_limits<double>::quiet_NaN());
    for (int j = 0; j < columns; ++j) z.segment<6>(paddedSize * j) = x.segment<6>(6 * j);
    solve(z.data());
    const VectorXd expected = matrix.partialPivLu().solve(x);
    for (int j = 0; j < columns; ++j)
      EXPECT_LT((z.segment<6>(paddedSize * j) - expected.segment<6>(6 * j)).norm(),
                1e-11 * expected.norm())
          << j;
  }
};

TEST_F(BlockSolves, AgreeWithDenseMatrices) {
  for (int round = 0; round < 20; ++round) {
    compare(lower_, [&](double* z) { solveLower(blocks(), z); });
    const MatrixXd offDiagonal = lower_ - MatrixXd::Identity(24, 24);
    compare(diagonal_ + offDiagonal.transpose(),
            [&](double* z) { solveUpper(blocks(), inverseD_.data(), z); });
  }
}

}  // namespace
}  // namespace delassus
