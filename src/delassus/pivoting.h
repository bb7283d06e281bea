#pragma once

#include <vector>

#include "delassus/active_set.h"
#include "delassus/solution.h"
#include "delassus/types.h"

namespace delassus {

struct PivotOptions {
  /// Natural residual that counts as solved, relative to the largest |q|, both scaled to unit
  /// diagonal of W. Where it lies below the rounding floor ε‖r‖ of the reactions, the floor counts.
  double tolerance = 1e-10;
  int regionBudget = 1000;  ///< most regions visited; work, never time
};

/// Reactions and motion of rows with bounds, and the region they lie in.
struct PivotResult {
  /// N·s, within the bounds; of least norm Σ W_ii r_i² where it is not unique (of a compromise between more than 400 rows: nearly)
  VectorXd r;
  VectorXd u;                  ///< W r + q, m/s: unique
  std::vector<RowState> rows;  ///< the region; on a wall between two regions either name may stand
  Status status = Status::Solved;
  int regions = 0;
  int factorisations = 0;  ///< from scratch; edits of a factor are not counted
  std::vector<int>
      blamed;  ///< rows whose demands no motion meets together; u is the least-squares compromise
};

/// Finds the region of rows with bounds, for any number of rows (algorithms 3 to 5):
///
///     u = W r + q,   lower ≤ r ≤ upper,   u ≥ 0 at lower, u ≤ 0 at upper, u = 0 in between
///
/// Bounds may be infinite: contacts are [0, ∞), joints (−∞, ∞), motors [−m, m]. W = J M⁻¹ Jᵀ is
/// symmetric positive semi-definite, often singular; a W that is neither is served too, with an
/// honest status and no promise. `guess` is the region to look at first, or empty. Rows that are
/// not linked through W are solved on their own.
PivotResult pivot(const MatrixXd& W, const VectorXd& q, const VectorXd& lower,
                  const VectorXd& upper, const std::vector<RowState>& guess = {},
                  const PivotOptions& options = {});

}  // namespace delassus
