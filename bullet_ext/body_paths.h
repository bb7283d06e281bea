#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "delassus/bytes.h"
#include "delassus/disjoint_sets.h"

namespace delassus::bullet {

/// Ways between bodies that are linked. Links that close a loop are left out, so that there is one
/// way from body to body.
class BodyPaths {
 public:
  static constexpr int none = -1;

  /// Starts with this many bodies and no links.
  void reset(int bodies) {
    sets_.reset(bodies);
    next_.assign(bodies, none);
    depth_.assign(bodies, 0);
  }
  void link(int a, int b) {
    if (sets_.root(a) == sets_.root(b)) return;
    sets_.join(a, b);
    for (int body = b, to = a; body != none;) {  // b becomes the root of its tree, and hangs on a
      std::swap(next_[body], to);
      std::swap(body, to);
    }
  }
  /// Call it after the last link.
  void close() {
    for (int body = 0; body < static_cast<int>(next_.size()); ++body) {
      way_.clear();
      int at = body;
      for (; next_[at] != none && depth_[at] == 0; at = next_[at]) way_.push_back(at);
      int depth = depth_[at];
      for (; !way_.empty(); way_.pop_back()) depth_[way_.back()] = ++depth;
    }
  }
  /// The end of the link of this body that is nearer to the root of its tree; none of the root.
  int next(int body) const { return next_[body]; }
  /// The bodies from a to b, which are linked; none if these are more than `most`.
  const std::vector<int>& between(int a, int b, int most) {
    way_.clear();
    back_.clear();
    while (a != b && static_cast<int>(way_.size() + back_.size()) < most) {
      if (depth_[a] >= depth_[b]) {
        way_.push_back(a);
        a = next_[a];
      } else {
        back_.push_back(b);
        b = next_[b];
      }
    }
    if (a == b) {
      way_.push_back(a);
      way_.insert(way_.end(), back_.rbegin(), back_.rend());
    }
    if (a != b || static_cast<int>(way_.size()) > most) way_.clear();
    return way_;
  }
  std::size_t bytes() const { return sets_.bytes() + bytesOf(next_, depth_, way_, back_); }

 private:
  DisjointSets sets_;
  std::vector<int> next_, depth_;
  std::vector<int> way_, back_;
};

}  // namespace delassus::bullet
