#pragma once

#include <vector>

#include "delassus/active_set.h"
#include "delassus/solution.h"
#include "delassus/types.h"

namespace delassus {

/// Reactions and motion of rows with bounds, and the region they lie in.
struct PivotResult {
  /// N·s, within the bounds; where not unique, of least norm Σ W_ii r_i² (nearly so for a
  /// compromise between more than 400 rows)
  VectorXd r;
  VectorXd u;                  ///< W r + q, m/s: unique
  std::vector<RowState> rows;  ///< the region; on a wall between two regions, either of them
  Status status = Status::Solved;
  int regions = 0;
  int factorisations = 0;  ///< from scratch; edits of a factor are not counted
  /// Rows whose demands no motion meets together; u is the least-squares compromise.
  std::vector<int> blamed;
};

/// Finds the region of rows with bounds, for any number of rows (algorithms 3 to 5):
///
///     u = W r + q,   lower ≤ r ≤ upper,   u ≥ 0 at lower, u ≤ 0 at upper, u = 0 in between
///
/// Bounds may be infinite: contacts are [0, ∞), joints (−∞, ∞), motors [−m, m]. W = J M⁻¹ Jᵀ is
/// symmetric positive semi-definite, often singular. A W that is neither is tried too, with an
/// honest status but no promise. Rows that are not linked through W are solved on their own.
/// `regionBudget`: most regions visited, by all groups together, not counting those of groups of up
/// to six unilateral rows; work, never time. Sizes that do not match and bounds that cross are
/// errors of the caller (asserted). If numbers are not finite: NonFinite, no reactions, u = 0.
PivotResult pivot(const MatrixXd& W, const VectorXd& q, const VectorXd& lower,
                  const VectorXd& upper, int regionBudget = 1000);

}  // namespace delassus
