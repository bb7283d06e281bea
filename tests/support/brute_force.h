#pragma once

#include "delassus/types.h"

namespace delassus {

/// The truth by enumeration, in extended precision: the region whose answer violates its own signs
/// least.
struct BruteForce {
  unsigned persisting = 0;  ///< bit i set: contact i is kept
  VectorXd r, u;
  double violation = infinity;  ///< largest wrong sign, scaled to unit diagonal
};

/// All 2ⁿ regions of u = W r + q, 0 ≤ r ⊥ u ≥ 0, for W symmetric positive definite.
BruteForce enumerateRegions(const MatrixXd& W, const VectorXd& q);

/// All 3ⁿ regions of rows with bounds. Returns the reactions of the region that violates its own
/// signs least.
VectorXd enumerateBoundedRegions(const MatrixXd& W, const VectorXd& q, const VectorXd& lower,
                                 const VectorXd& upper);

}  // namespace delassus
