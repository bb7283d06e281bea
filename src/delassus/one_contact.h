#pragma once

#include "delassus/types.h"

namespace delassus {

/// The exact reaction of one contact with friction: K_μ ∋ r ⟂ u + μ‖u_t‖ n ∈ K_μ*, u = W r + q (algorithms §6.2).
///
/// Regions in fixed order: released (r = 0), stuck (u = 0), sliding. The sliding reaction is r_t(s) = −(S + s I)⁻¹ c
/// with s = ‖u_t‖/‖r_t‖ the root of μ r_n(s) = ‖r_t(s)‖, found by a Newton iteration safeguarded by a bracket.
/// W must have a positive normal entry; the tangential block may be singular.
Vec3 solveOneContact(const Mat3& W, const Vec3& q, double friction);

}  // namespace delassus
