#pragma once

#include <vector>

#include "delassus/problem.h"

namespace delassus {

/// The connected components of a problem with explicit W, ordered by their first unknown. An entry
/// W_ij or W_ji ≠ 0 connects i and j, and a disk is connected to its governor. A problem in body
/// space is an island already and is never split.
class ProblemParts {
 public:
  /// Keeps a reference to `whole`.
  explicit ProblemParts(const Problem& whole);

  int count() const { return static_cast<int>(begin_.size()) - 1; }
  int sizeOf(int part) const { return begin_[part + 1] - begin_[part]; }
  /// The index in the whole of the k-th unknown of a part; ascends with k.
  int unknown(int part, int k) const { return unknowns_[begin_[part] + k]; }
  Problem problemOf(int part) const;

 private:
  const Problem& whole_;
  std::vector<int> unknowns_;        ///< unknowns of one part after the other
  std::vector<int> begin_;           ///< where each part begins in unknowns_, and the end
  std::vector<int> partOf_, place_;  ///< of each unknown
};

}  // namespace delassus
