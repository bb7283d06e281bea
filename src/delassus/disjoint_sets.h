#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace delassus {

/// Union-find. The smallest index of a set is its root, so the result has no memory of the order of
/// joins.
class DisjointSets {
 public:
  explicit DisjointSets(int n = 0) { reset(n); }

  /// Everything apart again.
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
