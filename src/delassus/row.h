#pragma once

#include <limits>

#include "delassus/types.h"

namespace delassus {

/// One scalar constraint of a joint, limit or motor between bodies `a` and `b`:
///
///     u = J_a v_a + J_b v_b − target + compliance r,
///     lower ≤ r ≤ upper,  u ≥ 0 where r = lower,  u ≤ 0 where r = upper,  u = 0 in between.
struct Row {
  int a = fixedWorld, b = fixedWorld;
  Row6 jacobianA = Row6::Zero(), jacobianB = Row6::Zero();
  double target = 0;  ///< wanted velocity, m/s (or rad/s for angular rows)
  double lower = -std::numeric_limits<double>::infinity();  ///< N·s
  double upper = std::numeric_limits<double>::infinity();   ///< N·s
  double compliance = 0;                                    ///< added to the diagonal of W
};

}  // namespace delassus
