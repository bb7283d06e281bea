#pragma once

#include <cstddef>

#include "delassus/articulation.h"
#include "delassus/economies.h"
#include "delassus/island.h"

namespace delassus::bullet {

struct Group;

/// The islands of a group; each is solved alone.
class GroupIslands {
 public:
  /// Finds the islands of this group; they are good until the next call.
  void find(const Group& group, const Economies& economies);

  int count() const {
    return areJoined_ ? static_cast<int>(joiner_.islands().size()) : assembler_.islands();
  }
  const Island& operator[](int i) const {
    return areJoined_ ? joiner_.islands()[i] : assembler_.island(i);
  }

  std::size_t bytes() const { return assembler_.bytes() + joiner_.bytes(); }

 private:
  Assembler assembler_;     ///< splits without regard to trees
  IslandJoiner joiner_;     ///< joins islands that trees link
  bool areJoined_ = false;  ///< there are trees
};

}  // namespace delassus::bullet
