#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace delassus {

/// Union-find. The root of a set is its smallest index, so the result does not depend on the order
/// of joins.
class DisjointSets {
 public:
  explicit DisjointSets(int n = 0) { reset(n); }

  /// Makes each index a set of its own again.
  void reset(int n) {
    parent_.resize(n);
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  int root(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(int i, int j) {
    i = root(i), j = root(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }
  std::size_t bytes() const { return parent_.capacity() * sizeof(int); }

 private:
  std::vector<int> parent_;
};

}  // namespace delassus
