#pragma once

#include <vector>

#include "delassus/disjoint_sets.h"
#include "delassus/problem.h"

namespace delassus {

/// The parts of an island that are not settled yet, each with its surroundings as a problem of its
/// own.
///
/// Sweeps soon settle most of a heap. They leave a few contacts, usually about a self-stress that
/// grows by the same small amount in every sweep until it meets the wall of a cone. There the law
/// is solved exactly while the reactions of all others are held: nonlinear elimination (Cai and
/// Keyes 2002). In a pile at rest they are the places where something has just moved.
///
/// A patch has the contacts, rows and disks among the bodies that unsettled parts touch and the
/// neighbours of these bodies, in one or more rings. No two patches share a body. For body space
/// only.
class Patches {
 public:
  /// Finds the patches around the parts whose entry of `residuals` (NaturalMap::residuals) is
  /// larger than `unsettled`, with this many rings of neighbours (at most 100).
  void find(const Problem& problem, const VectorXd& residuals, double unsettled, int rings);

  int count() const { return static_cast<int>(begin_.size()) - 1; }
  /// Number of contacts and rows of one patch.
  int partsOf(int patch) const { return begin_[patch + 1] - begin_[patch]; }

  /// Writes the problem of one patch, and its present reactions; u = W r + q of the whole island.
  void cutOut(int patch, const Problem& problem, const VectorXd& r, const VectorXd& u, Problem& cut,
              VectorXd& reactions);
  /// Puts the reactions of a patch back to their places in r.
  void putBack(int patch, const Problem& problem, const VectorXd& reactions, VectorXd& r) const;

  std::size_t bytes() const {
    return bytesOf(reach_, owner_, parts_, begin_, place_, felt_, moved_) + sets_.bytes();
  }

 private:
  void spread(const Problem& problem, const VectorXd& residuals, double unsettled, int rings);
  void join(const Problem& problem);
  void leaveOutDisks(const Problem& problem);
  void sort();

  /// Per body: 0, or 1 if an unsettled part touches it, or 1 + the ring of its neighbourhood.
  std::vector<char> reach_;
  DisjointSets sets_;       ///< bodies of one patch are one set
  std::vector<int> owner_;  ///< contact or row -> root of its patch, or −1
  std::vector<int> parts_;  ///< contacts and rows, patch by patch, ascending in each
  std::vector<int> begin_;  ///< patch -> its first among parts_
  std::vector<int> place_;  ///< body -> number in the patch; or root -> number of the patch
  VectorXd felt_, moved_;
};

}  // namespace delassus
