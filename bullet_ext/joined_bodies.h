#pragma once

#include <vector>

#include "bullet_ext/address_table.h"

class btCollisionObject;

namespace delassus::bullet {

/// Knows which bodies a joint holds, and to which others; bodies are recognised by address.
class JoinedBodies {
 public:
  void clear() {
    held_.clear();
    first_.clear();
    partners_.clear();
  }
  void add(const btCollisionObject& a, const btCollisionObject& b) {
    addPartner(a, b);
    addPartner(b, a);
  }
  /// Adds a body that a joint holds, be it to the world.
  void addHeld(const btCollisionObject& body) { held_.insert(&body, 0); }
  bool isHeld(const btCollisionObject& body) const { return held_.find(&body) != nullptr; }
  bool areJoined(const btCollisionObject& a, const btCollisionObject& b) const {
    if (partners_.empty()) return false;
    const int* first = first_.find(&a);
    for (int i = first ? *first : none; i != none; i = partners_[i].next)
      if (partners_[i].body == &b) return true;
    return false;
  }
  bool empty() const { return partners_.empty(); }
  /// Calls `visit(a, b)` for each pair of joined bodies, in the order of the joints.
  template <class Visit>
  void eachPair(const Visit& visit) const {
    for (std::size_t i = 0; i < partners_.size(); i += 2)
      visit(*partners_[i + 1].body, *partners_[i].body);
  }
  std::size_t bytes() const {
    return held_.bytes() + first_.bytes() + partners_.capacity() * sizeof(Partner);
  }

 private:
  static constexpr int none = -1;
  /// One partner of a body, and the index of the body's next one.
  struct Partner {
    const btCollisionObject* body;
    int next;
  };
  void addPartner(const btCollisionObject& of, const btCollisionObject& body) {
    const int* first = first_.find(&of);
    partners_.push_back({&body, first ? *first : none});
    first_.insert(&of, static_cast<int>(partners_.size()) - 1);
  }

  AddressTable held_;
  AddressTable first_;  ///< index of each body's first partner
  std::vector<Partner> partners_;
};

}  // namespace delassus::bullet
