// Fronts of cost and error, and the places where one family is above another.
#include "demos/report/pareto.h"

#include <gtest/gtest.h>

#include <random>

namespace demos::report {
namespace {

Effort effort(const std::string& family, double cost, double error) {
  return {family + ":" + std::to_string(cost), family, cost, cost, cost, error};
}

std::vector<Effort> randomEfforts(std::mt19937_64& random, int count) {
  std::lognormal_distribution<double> number(0, 2);
  std::vector<Effort> efforts;
  for (int i = 0; i < count; ++i)
    efforts.push_back(effort(i % 2 == 0 ? "a" : "b", number(random), number(random)));
  return efforts;
}

TEST(Front, KeepsWhatNoOtherBeatsInBoth) {
  std::mt19937_64 random(1);
  for (int sample = 0; sample < 50; ++sample) {
    const std::vector<Effort> efforts = randomEfforts(random, 20);
    const std::vector<Effort> kept = front(efforts);
    for (const Effort& one : efforts) {
      bool beaten = false, isKept = false;
      for (const Effort& other : efforts)
        beaten |= other.cost <= one.cost && other.error <= one.error && other.method != one.method;
      for (const Effort& other : kept) isKept |= other.method == one.method;
      EXPECT_EQ(isKept, !beaten);
    }
  }
}

TEST(Front, FallsInErrorAsCostRises) {
  std::mt19937_64 random(2);
  const std::vector<Effort> kept = front(randomEfforts(random, 100));
  for (std::size_t i = 1; i < kept.size(); ++i) {
    EXPECT_GT(kept[i].cost, kept[i - 1].cost);
    EXPECT_LT(kept[i].error, kept[i - 1].error);
  }
}

TEST(Cheapest, IsAsGoodAsAskedAndNoneIsCheaper) {
  std::mt19937_64 random(3);
  const std::vector<Effort> efforts = randomEfforts(random, 50);
  for (const double error : {1e-9, 0.1, 1.0, 10.0}) {
    const Effort* best = cheapest(efforts, error);
    for (const Effort& one : efforts) {
      if (one.error > error) continue;
      ASSERT_NE(best, nullptr);
      EXPECT_LE(best->cost, one.cost);
      EXPECT_LE(best->error, error);
    }
  }
}

// Wherever some other family is cheaper at some error, a corner of the list shows it. The list is
// compared with a dense scan.
TEST(Defeats, FindEveryErrorAtWhichAnotherIsCheaper) {
  std::mt19937_64 random(4);
  for (int sample = 0; sample < 50; ++sample) {
    const std::vector<Effort> efforts = randomEfforts(random, 12);
    const std::vector<Effort> own = ofFamily(efforts, "a"), others = ofOthers(efforts, "a");
    bool scanned = false;
    for (double error = 1e-4; error < 1e4; error *= 1.001) {
      const Effort *mine = cheapest(own, error), *theirs = cheapest(others, error);
      scanned |= theirs != nullptr && (mine == nullptr || theirs->cost < mine->cost);
    }
    EXPECT_EQ(!defeats(efforts, "a", 1e9).empty(), scanned);
  }
}

TEST(Defeats, LeaveOutErrorsThatAreNotAsked) {
  const std::vector<Effort> efforts{effort("a", 2, 1e-3), effort("b", 1, 1e-1)};
  EXPECT_EQ(defeats(efforts, "a", 1).size(), 1U);
  EXPECT_TRUE(defeats(efforts, "a", 1e-2).empty());
}

TEST(Defeats, TakeCostsWithOverlappingSpreadsAsEqual) {
  std::vector<Effort> efforts{effort("a", 2, 1e-3), effort("b", 1, 1e-2)};
  EXPECT_EQ(defeats(efforts, "a", 1).size(), 1U);
  efforts[0].costLow = 0.9;
  EXPECT_TRUE(defeats(efforts, "a", 1).empty());
}

TEST(Defeats, NameAnErrorThatIsNotReached) {
  const std::vector<Effort> efforts{effort("a", 1, 1e-1), effort("b", 2, 1e-2)};
  const std::vector<Defeat> list = defeats(efforts, "a", 1);
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list[0].own, nullptr);
}

}  // namespace
}  // namespace demos::report
