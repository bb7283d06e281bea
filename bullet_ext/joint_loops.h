#pragma once

#include <cstddef>
#include <vector>

#include "delassus/bytes.h"
#include "delassus/disjoint_sets.h"

namespace delassus::bullet {

/// A mechanism is a set of bodies that joints link. Finds mechanisms whose joints close a loop,
/// over moving bodies or over standing ones, which count as one body. The joints of a loop hold
/// some directions twice.
class JointLoops {
 public:
  static constexpr int standing = -1;

  /// Starts with this many bodies and no joints.
  void reset(int bodies) {
    ways_.reset(bodies + 1);
    mechanisms_.reset(bodies);
    closed_.assign(bodies, 0);
    closing_.clear();
  }
  /// Adds a joint between two bodies, of which one may be standing.
  void add(int a, int b) {
    const int ground = static_cast<int>(closed_.size()), moving = a == standing ? b : a;
    const int from = a == standing ? ground : a, to = b == standing ? ground : b;
    if (ways_.root(from) == ways_.root(to))
      closing_.push_back(moving);
    else
      ways_.join(from, to);
    if (a != standing && b != standing) mechanisms_.join(a, b);
  }
  /// Call it after the last joint.
  void close() {
    for (const int body : closing_) closed_[mechanisms_.root(body)] = 1;
  }
  bool hasLoops() const { return !closing_.empty(); }
  /// Whether the mechanism of a moving body has a loop.
  bool isLooped(int body) { return closed_[mechanisms_.root(body)] != 0; }

  std::size_t bytes() const {
    return ways_.bytes() + mechanisms_.bytes() + bytesOf(closed_, closing_);
  }

 private:
  DisjointSets ways_, mechanisms_;  ///< with standing bodies, and without
  std::vector<char> closed_;        ///< of the root of a mechanism
  std::vector<int> closing_;        ///< a body of each joint that closes a loop
};

}  // namespace delassus::bullet
