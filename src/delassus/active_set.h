#pragma once

#include <vector>

namespace delassus {

/// How a contact takes part in the motion. A persisting contact is one that is not Open.
enum class Mode : unsigned char { Open, Stick, Slide };

/// How a bounded row takes part: at its lower bound, in between (u = 0), at its upper bound.
enum class RowState : unsigned char { AtLower, Free, AtUpper };

/// Names a region: the set of all q for which these modes are right.
struct ActiveSet {
  std::vector<Mode> contacts;
  std::vector<RowState> rows;  ///< rows of disks are Free
  std::vector<Mode> disks;     ///< Open where the disk is a point

  bool operator==(const ActiveSet& other) const {
    return contacts == other.contacts && rows == other.rows && disks == other.disks;
  }
};

}  // namespace delassus
