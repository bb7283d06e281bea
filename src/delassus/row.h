#pragma once

#include "delassus/types.h"

namespace delassus {

/// One scalar constraint of a joint, limit or motor between bodies `a` and `b`:
///
///     u = J_a v_a + J_b v_b − target + compliance r,
///     lower ≤ r ≤ upper,  u ≥ 0 where r = lower,  u ≤ 0 where r = upper,  u = 0 in between.
///
/// With a governor it is friction that grows with the normal reaction r_n of a contact between the
/// same bodies (disk.h): |r| ≤ upper r_n, and √(r² + r'²) ≤ upper r_n for two paired rows.
/// `mostLoad` limits the r_n that counts. `upper` is then the κ > 0 of disk.h; `lower` and
/// `compliance` are not read. Such rows come after all others.
///
/// The units below are those of rows along an axis; rows about an axis have rad/s, N·m·s and
/// 1/(kg·m²). Since answers are compared by their largest error, such rows are better stated along
/// an arc: J a and target times its radius, bounds divided by it.
struct Row {
  int a = fixedWorld, b = fixedWorld;
  Row6 jacobianA = Row6::Zero(), jacobianB = Row6::Zero();
  double target = 0;           ///< wanted velocity, m/s
  double lower = -infinity;    ///< N·s
  double upper = infinity;     ///< N·s; with a governor κ, m
  double compliance = 0;       ///< added to the diagonal of W, 1/kg
  int governor = -1;           ///< a contact, or none
  double mostLoad = infinity;  ///< N·s
  bool paired = false;  ///< with the next row, which has the same bodies, governor and bounds
};

}  // namespace delassus
