#pragma once

#include <vector>

#include "delassus/block_factor.h"
#include "delassus/bytes.h"

namespace delassus {

/// Contacts, or rows, that come one after the other and act on the same two bodies.
struct Bond {
  int begin, end;        ///< among the contacts or rows
  bool couples;          ///< two bodies that move
  int edge = -1;         ///< of the factor; less than 0 if it has none
  int next[2] = {0, 0};  ///< for each body, where its next bond is, as Bonds::first_
};

/// The bonds of an island, and those of each body, in their order.
class Bonds {
 public:
  /// Of the first `count` of `parts`.
  template <class Parts>
  void find(int bodies, const Parts& parts, int count) {
    all_.clear();
    first_.clear();
    if (count == 0) return;
    for (int i = 0, end = 0; i < count; i = end) {
      const int a = parts[i].a, b = parts[i].b;
      while (end < count && parts[end].a == a && parts[end].b == b) ++end;
      all_.push_back({i, end, a >= 0 && b >= 0 && a != b});
    }
    first_.assign(bodies, none);
    for (int k = static_cast<int>(all_.size()) - 1; k >= 0; --k) {
      Bond& bond = all_[k];
      const int bodiesOf[2] = {parts[bond.begin].a, parts[bond.begin].b};
      for (int side = 1; side >= 0; --side)
        if (const int body = bodiesOf[side]; body >= 0) {
          bond.next[side] = first_[body];
          first_[body] = 2 * k + side;
        }
    }
  }

  std::vector<Bond>& all() { return all_; }

  /// Calls visit(bond, side) for each bond of a body, with the side on which the body is.
  template <class Visit>
  void forBondsOf(int body, const Visit& visit) const {
    if (all_.empty()) return;
    for (int at = first_[body]; at != none;) {
      const Bond& bond = all_[at / 2];
      const int side = at % 2;
      visit(bond, side == 0 ? BlockFactor::Side::A : BlockFactor::Side::B);
      at = bond.next[side];
    }
  }

  std::size_t bytes() const { return bytesOf(all_, first_); }

 private:
  static constexpr int none = -1;
  std::vector<Bond> all_;
  std::vector<int> first_;  ///< body -> twice its first bond, plus one if it is body b there
};

}  // namespace delassus
