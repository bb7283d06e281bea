/// The order in which blocks are eliminated, and how hands share them.
#include "delassus/block_pattern.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/random_problems.h"

namespace delassus {
namespace {

TEST(BlockPattern, TasksNeedNoOthersOrComeOneByOneAfterThem) {
  Random random(211);
  int few = 0, many = 0, shared = 0;  // patterns; those with a task of several columns
  for (int k = 0; k < 200; ++k) {
    const int bodies = k;
    std::vector<BlockPattern::Edge> edges;
    for (int i = 0; bodies > 1 && i < k % 5 * bodies; ++i) {
      const int a = random() % bodies, b = random() % bodies;
      if (a != b) edges.push_back({a, b});
    }
    const BlockPattern pattern(bodies, edges);
    ++(pattern.isLarge() ? many : few);
    if (!pattern.isLarge()) continue;
    constexpr int nobody = -1;
    std::vector<int> taskOf(bodies, nobody);
    bool hasLong = false, needsOthers = false;
    for (std::size_t t = 0; t < pattern.tasks.size(); ++t) {
      const auto [begin, end] = pattern.tasks[t];
      for (int column = begin; column < end; ++column) {
        ASSERT_EQ(taskOf[column], nobody) << "twice";
        taskOf[column] = static_cast<int>(t);
        for (int i = pattern.ancestorBegin[column]; i < pattern.ancestorBegin[column + 1]; ++i) {
          const int needed = taskOf[pattern.ancestors[i].column];
          ASSERT_NE(needed, nobody) << "needed, but not yet there";
          needsOthers = needsOthers || needed != static_cast<int>(t);
        }
      }
      hasLong = hasLong || end > begin + 1;
      ASSERT_TRUE(!needsOthers || end == begin + 1) << "those that wait come last, one by one";
    }
    for (int body = 0; body < bodies; ++body) ASSERT_EQ(pattern.bodyAt[pattern.place[body]], body);
    for (int column = 0; column < bodies; ++column) ASSERT_NE(taskOf[column], nobody) << "left out";
    shared += hasLong;
  }
  EXPECT_GT(few, 50);
  EXPECT_GT(many, 50);
  EXPECT_GT(shared, many / 2);
}

}  // namespace
}  // namespace delassus
