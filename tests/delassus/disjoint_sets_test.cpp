/// Sets that are joined have one root, their smallest index, in whatever order they are joined.
#include "delassus/disjoint_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace delassus {
namespace {

TEST(DisjointSets, TheRootIsTheSmallestIndexWhateverTheOrder) {
  constexpr int n = 60;
  std::mt19937 random(7);
  std::vector<std::pair<int, int>> joins;
  for (int i = 0; i + 6 < n; ++i)
    if (i % 5 > 0) joins.emplace_back(i, i + 6);
  // The smallest index of each set, by going on until nothing changes.
  std::vector<int> smallest(n);
  for (int i = 0; i < n; ++i) smallest[i] = i;
  for (bool changes = true; changes;) {
    changes = false;
    for (const auto& [a, b] : joins) {
      const int least = std::min(smallest[a], smallest[b]);
      changes = changes || smallest[a] != least || smallest[b] != least;
      smallest[a] = smallest[b] = least;
    }
  }
  DisjointSets sets;
  for (int round = 0; round < 20; ++round) {
    sets.reset(n);
    for (auto [a, b] : joins) {
      if (random() % 2) std::swap(a, b);
      sets.join(a, b);
    }
    for (int i = n - 1; i >= 0; --i) EXPECT_EQ(sets.root(i), smallest[i]) << i;
    std::shuffle(joins.begin(), joins.end(), random);
  }
  sets.reset(n);
  for (int i = 0; i < n; ++i) EXPECT_EQ(sets.root(i), i) << "each is a set of its own again";
}

}  // namespace
}  // namespace delassus
