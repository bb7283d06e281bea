#pragma once

#include "delassus/types.h"

namespace delassus {

/// A contact point, as one body feels it: a reaction r there makes the wrench
///
///     Jᵀ r = (F r, a × F r / l)      (N·s), J of three rows, or of r_n alone
///
/// Moments are in units of the length l of the largest arms, so that neither forces nor moments
/// prevail.
struct FeltPoint {
  Mat3 frame;       ///< F, the columns of Contact::frame
  Vec3 arm;         ///< a/l, from the body's centre
  double friction;  ///< μ ≥ 0
};

constexpr int mostFeltPoints = 4;  ///< as Bullet keeps for two bodies

/// Changes the reactions of `count` points (N·s, in their frames), within the cones of friction, so
/// that their wrench Σ J_iᵀ r_i comes as near as possible to `wanted`. It takes the least change
/// that makes the wrench, if that leaves no cone. Otherwise it goes in rounds over the points, and
/// measures in the norm of
///
///     (S + 0.01 tr(S) 1)⁻¹,   S = Σ J_iᵀ J_i
///
/// The norm of S⁻¹ alone would pay for a moment that the points can hardly make, as about a line on
/// which three of them nearly lie, with forces thousands of times as large as wanted.
void shareWrench(const FeltPoint* points, int count, const Vec6& wanted, Vec3* reactions);

}  // namespace delassus
