#pragma once

#include <vector>

#include "delassus/island.h"

namespace demos::report {

/// The answer to the problem of one island, known to more digits than those who are judged by it
/// have.
struct RefinedAnswer {
  delassus::VectorXd r;       ///< reactions, N·s; of redundant contacts one choice of many
  delassus::VectorXd motion;  ///< velocities of the island's bodies, six numbers each
  double residual;  ///< natural residual, largest over contacts and rows, over the largest |q|
  /// √(Δrᵀ W Δr / rᵀ W r) of the Newton step Δr that would come next: what is still not known.
  double step;

  /// Whether this is the motion to all digits of a double.
  bool certified() const { return residual <= 1e-15 && step <= 1e-15; }
};

/// Newton's method on the natural map F(r) = r − P(r − v/|W_aa|) from the reactions `start`. F is
/// computed with 113 bits of fraction from bodies, contacts and rows as they are; its derivative,
/// which knows the region that r is in, is solved with 64, by steps of least norm, since reactions
/// of redundant contacts are not unique.
///
/// Masses of 1 and 1e9 need that: the reactions between them leave no digits of the light one's
/// velocity to a 64-bit sum. Rows with a governor (turning friction) must not be there.
RefinedAnswer refine(const std::vector<delassus::Body>& bodies,
                     const std::vector<delassus::Contact>& contacts,
                     const std::vector<delassus::Row>& rows, const delassus::Island& island,
                     const delassus::VectorXd& start);

}  // namespace demos::report
