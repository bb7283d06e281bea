#pragma once

#include <vector>

#include "delassus/disjoint_sets.h"
#include "delassus/problem.h"

namespace delassus {

/// The parts of an island that are not settled yet, each with its surroundings a problem of its
/// own.
///
/// Sweeps settle most of a heap soon. What they leave is a few contacts, as a rule about a
/// self-stress that grows by the same little in every sweep until it meets the wall of a cone.
/// There the law is solved exactly while the reactions of all others are held: nonlinear
/// elimination (Cai and Keyes 2002). A patch is made of the contacts, rows and disks among the
/// bodies that unsettled ones touch and the neighbours of those bodies. No two patches share a
/// body. For body space only.
class Patches {
 public:
  /// Finds them: around the parts whose entry of `residuals` (NaturalMap::residuals) is larger than
  /// `unsettled`.
  void find(const Problem& problem, const VectorXd& residuals, double unsettled);

  int count() const { return static_cast<int>(begin_.size()) - 1; }
  /// Contacts and rows of one patch.
  int partsOf(int patch) const { return begin_[patch + 1] - begin_[patch]; }

  /// The problem of one patch, and its reactions now; u = W r + q of the whole island.
  void cutOut(int patch, const Problem& problem, const VectorXd& r, const VectorXd& u, Problem& cut,
              VectorXd& reactions);
  /// Reactions of that patch, back to their places in r.
  void putBack(int patch, const Problem& problem, const VectorXd& reactions, VectorXd& r) const;

  std::size_t bytes() const {
    return bytesOf(reach_, owner_, parts_, begin_, place_, felt_, moved_) + sets_.bytes();
  }

 private:
  void spread(const Problem& problem, const VectorXd& residuals, double unsettled);
  void join(const Problem& problem);
  void leaveOutDisks(const Problem& problem);
  void sort();

  /// Of bodies: touched by an unsettled part, or a neighbour, or neither.
  std::vector<char> reach_;
  DisjointSets sets_;       ///< of bodies that are in one patch
  std::vector<int> owner_;  ///< of contacts and rows: the root of its patch, or −1
  std::vector<int> parts_;  ///< contacts and rows, patch by patch, ascending in each
  std::vector<int> begin_;  ///< patch -> its first among parts_
  std::vector<int> place_;  ///< of bodies: number in the patch; or of roots: number of the patch
  VectorXd felt_, moved_;
};

}  // namespace delassus
