#pragma once

#include <vector>

#include "delassus/island.h"

namespace demos::report {

/// The answer to the problem of one island, with more digits than the answers that are judged by
/// it.
struct RefinedAnswer {
  delassus::VectorXd r;       ///< reactions, N·s; of redundant contacts one choice of many
  delassus::VectorXd motion;  ///< velocities of the island's bodies, six numbers each
  double residual;  ///< natural residual, largest over contacts and rows, over the largest |q|
  /// √(Δrᵀ W Δr / rᵀ W r) of the Newton step Δr that would come next: the part still unknown.
  double step;

  /// Whether this is the motion to all digits of a double.
  bool certified() const { return residual <= 1e-15 && step <= 1e-15; }
};

/// Newton's method on the natural map F(r) = r − P(r − v/|W_aa|) from the reactions `start`. F is
/// computed with 113 bits of fraction from bodies, contacts and rows as they are. Its derivative,
/// which depends on the region of r, is solved with 64 bits, by steps of least norm, since
/// reactions of redundant contacts are not unique.
///
/// Masses of 1 and 1e9 need such precision: in a 64-bit sum, the reactions between them leave no
/// digits of the light one's velocity. Rows with a governor (turning friction) are not allowed.
RefinedAnswer refine(const std::vector<delassus::Body>& bodies,
                     const std::vector<delassus::Contact>& contacts,
                     const std::vector<delassus::Row>& rows, const delassus::Island& island,
                     const delassus::VectorXd& start);

}  // namespace demos::report
