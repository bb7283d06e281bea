#pragma once

#include "delassus/types.h"

namespace delassus {

/// A point at which a body is touched, as far as the body feels it: a reaction r there makes the
/// wrench
///
///     Jᵀ r = (F r, a × F r / l)      (N·s), J of three rows, or of r_n alone
///
/// The length l, in whose unit moments are counted, is that of the largest arms: neither forces nor
/// moments prevail then.
struct FeltPoint {
  Mat3 frame;       ///< F, the columns of Contact::frame
  Vec3 arm;         ///< a/l, from the body's centre
  double friction;  ///< μ ≥ 0
};

constexpr int mostFeltPoints = 4;  ///< as Bullet keeps of two bodies

/// Changes the reactions of `count` points (N·s, in their frames), within the cones of friction, so
/// that their wrench Σ J_iᵀ r_i comes as near as it can to `wanted`: by the least change that makes
/// the wrench, if that leaves no cone; else in rounds over the points, in the norm of
///
///     (S + 0.01 tr(S) 1)⁻¹,   S = Σ J_iᵀ J_i
///
/// That of S⁻¹ would buy a moment that the points hardly make, as about a line on which three of
/// them nearly lie, by forces that are thousands of times what is wanted.
void shareWrench(const FeltPoint* points, int count, const Vec6& wanted, Vec3* reactions);

}  // namespace delassus
