#pragma once

#include <cstddef>

#include "delassus/articulation.h"
#include "delassus/economies.h"
#include "delassus/island.h"

namespace delassus::bullet {

struct Group;

/// The islands of a group, each to be answered alone.
class GroupIslands {
 public:
  /// Those of this group; good until the next call.
  void find(const Group& group, const Economies& economies);

  int count() const {
    return areJoined_ ? static_cast<int>(joiner_.islands().size()) : assembler_.islands();
  }
  const Island& operator[](int i) const {
    return areJoined_ ? joiner_.islands()[i] : assembler_.island(i);
  }

  std::size_t bytes() const { return assembler_.bytes() + joiner_.bytes(); }

 private:
  Assembler assembler_;     ///< splits, and knows nothing of trees
  IslandJoiner joiner_;     ///< of what these link
  bool areJoined_ = false;  ///< there are trees
};

}  // namespace delassus::bullet
