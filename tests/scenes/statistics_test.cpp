/// Ranks and maxima of measures.
#include "demos/scenes/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace demos {
namespace {

TEST(Quantile, IsOneOfTheValuesByItsRank) {
  const std::vector<double> values{5, 1, 4, 2, 3};
  EXPECT_EQ(quantile(values, 0), 1);
  EXPECT_EQ(quantile(values, 0.25), 2);
  EXPECT_EQ(quantile(values, 0.95), 5);
  EXPECT_EQ(quantile(values, 1), 5);
  EXPECT_EQ(median(values), 3);
  EXPECT_EQ(median({1, 2, 3, 4}), 3);
  EXPECT_EQ(median({7}), 7);
  EXPECT_TRUE(std::isnan(median({})));
}

TEST(LargerOf, KeepsWhatIsNotANumber) {
  const double lost = std::nan("");
  EXPECT_EQ(largerOf(1, 2), 2);
  EXPECT_EQ(largerOf(2, 1), 2);
  EXPECT_TRUE(std::isnan(largerOf(1, lost)));
  EXPECT_TRUE(std::isnan(largerOf(lost, 1)));
}

}  // namespace
}  // namespace demos
