/// The products of a factorisation against plain loops, bit by bit.
#include "delassus/block_product.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace delassus
