/// The products of a factorisation are compared with plain loops, bit by bit, and its solutions
/// with dense matrices.
#include "delassus/block_product.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>
#include <vector>

#include "tests/support/random_problems.h"

namespace delassus {
namespace {

// Whatever the width of the processor, each product and each sum is rounded once, column by column
// and k by k.
TEST(BlockProduct, HasTheBitsOfPlainLoops) {
  Random random(21);
  const std::vector<int> row = {2, 3, 0, 5, 4}, place = {1, -1, -1, 4, 0, 2};
  for (int round = 0; round < 100; ++round) {
    const int columns = 1 + round % mostSources;
    std::vector<std::vector<Mat6>> blocks(columns, std::vector<Mat6>(row.size()));
    std::vector<Mat6> B(columns), to(5);
    for (std::vector<Mat6>& column : blocks)
      for (Mat6& block : column) block = normalMatrix(6, 6, random);
    for (Mat6& block : B) block = normalMatrix(6, 6, random);
    for (Mat6& block : to) block = normalMatrix(6, 6, random);

    Mat6 diagonal = normalMatrix(6, 6, random), expectedDiagonal = diagonal;
    const bool hasDiagonal = round % 2 == 0;
    std::vector<Mat6> expected = to;
    for (std::size_t i = hasDiagonal ? 0 : 1; i < row.size(); ++i)
      for (int c = 0; c < 6; ++c)
        for (int r = 0; r < 6; ++r)
          for (int j = 0; j < columns; ++j)
            for (int k = 0; k < 6; ++k) {
              const double product = blocks[j][i](r, k) * B[j](c, k);
              (i == 0 ? expectedDiagonal : expected[place[row[i]]])(r, c) -= product;
            }
    std::vector<BlockSource> sources;
    for (int j = 0; j < columns; ++j) sources.push_back({blocks[j].data(), &B[j]});
    subtractProducts(sources.data(), columns, row.data(), static_cast<int>(row.size()),
                     place.data(), hasDiagonal ? &diagonal : nullptr, to.data());
    EXPECT_EQ(diagonal, expectedDiagonal);
    for (std::size_t i = 0; i < to.size(); ++i) EXPECT_EQ(to[i], expected[i]) << "block " << i;
  }
}

TEST(BlockProduct, SingleBlocksAgreeWithTheLibrary) {
  Random random(23);
  for (int round = 0; round < 100; ++round) {
    const Mat6 A = normalMatrix(6, 6, random), B = normalMatrix(6, 6, random);
    const Mat36 J = normalMatrix(3, 6, random), GJ = normalMatrix(3, 6, random);
    Mat6 more = A;
    const Mat3 G = normalMatrix(3, 3, random), H = normalMatrix(3, 3, random);
    const Mat3* weights[2] = {&G, &H};
    const Mat36* rows[2] = {&J, &GJ};
    Mat36 products[2];
    multiplyRows(weights, rows, 2, products);
    EXPECT_LT((products[0] - G * J).norm(), 1e-14);
    EXPECT_LT((products[1] - H * GJ).norm(), 1e-14);

    const Mat36 *left[2] = {&J, &GJ}, *right[2] = {&GJ, &J};
    addProducts(left, right, 1, more);
    EXPECT_LT((more - (A + J.transpose() * GJ)).norm(), 1e-14);
    Mat6 most = more;
    addProducts(left + 1, right + 1, 1, most);
    more = A;
    addProducts(left, right, 2, more);
    EXPECT_EQ(more, most);

    const Vec3 g = normalVector(3, random);
    more = A;
    addRowProducts(J.data(), GJ.data(), 6, g.data(), 3, more);
    EXPECT_LT((more - (A + J.transpose() * g.asDiagonal() * GJ)).norm(), 1e-14);

    Mat6 blocks[3] = {A, B, Mat6::Constant(7)};
    multiplyBy(B, blocks, 2);
    EXPECT_LT((blocks[0] - A * B).norm(), 1e-14 * A.norm() * B.norm());
    EXPECT_LT((blocks[1] - B * B).norm(), 1e-14 * B.norm() * B.norm());
    EXPECT_EQ(blocks[2], Mat6::Constant(7));

    const Mat6 upper = B.triangularView<Eigen::Upper>();
    Mat6 others[2] = {A, Mat6::Constant(7)};
    multiplyByUpper(upper, others, 1);
    EXPECT_LT((others[0] - A * upper).norm(), 1e-14 * A.norm() * B.norm());
    EXPECT_EQ(others[1], Mat6::Constant(7));
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

  /// matrix⁻¹ x by the dense matrix and by `solve`. The rest of the room is filled with NaN.
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
    compare(diagonal_ + offDiagonal, [&](double* z) { solveLower(blocks(), inverseD_.data(), z); });
    compare(diagonal_ + offDiagonal.transpose(),
            [&](double* z) { solveUpper(blocks(), inverseD_.data(), z); });
  }
}

}  // namespace
}  // namespace delassus
