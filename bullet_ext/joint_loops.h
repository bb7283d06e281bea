#pragma once

#include <cstddef>
#include <vector>

#include "delassus/bytes.h"
#include "delassus/disjoint_sets.h"

namespace delassus::bullet {

/// Finds the mechanisms, bodies that joints link to each other, in which joints close a loop: over
/// bodies that move, or over what stands, which is one body here. Those hold some things twice.
class JointLoops {
 public:
  static constexpr int standing = -1;

  /// No joints yet, between so many bodies.
  void reset(int bodies) {
    ways_.reset(bodies + 1);
    mechanisms_.reset(bodies);
    closed_.assign(bodies, 0);
    closing_.clear();
  }
  /// A joint between two bodies, of which one may be standing.
  void add(int a, int b) {
    const int ground = static_cast<int>(closed_.size()), moving = a == standing ? b : a;
    const int from = a == standing ? ground : a, to = b == standing ? ground : b;
    if (ways_.root(from) == ways_.root(to))
      closing_.push_back(moving);
    else
      ways_.join(from, to);
    if (a != standing && b != standing) mechanisms_.join(a, b);
  }
  /// After all of them.
  void close() {
    for (const int body : closing_) closed_[mechanisms_.root(body)] = 1;
  }
  bool hasLoops() const { return !closing_.empty(); }
  /// Whether there is a loop in the mechanism of a body that moves.
  bool isLooped(int body) { return closed_[mechanisms_.root(body)] != 0; }

  std::size_t bytes() const {
    return ways_.bytes() + mechanisms_.bytes() + bytesOf(closed_, closing_);
  }

 private:
  DisjointSets ways_, mechanisms_;  ///< with what stands, and without
  std::vector<char> closed_;        ///< of the root of a mechanism
  std::vector<int> closing_;        ///< a body of each joint that closes a loop
};

}  // namespace delassus::bullet
