#pragma once

#include "delassus/types.h"

namespace delassus {

/// One rigid body at the start of a step, in world axes, about its centre of mass.
///
/// A body whose inverse masses all vanish is immovable; its velocity (a moving platform) still
/// counts.
struct Body {
  Vec3 inverseMass = Vec3::Zero();     ///< 1/kg per world axis; 0 locks that axis
  Mat3 inverseInertia = Mat3::Zero();  ///< 1/(kg m²), symmetric positive semi-definite
  Vec6 velocity = Vec6::Zero();        ///< free velocity v_f = v + h M⁻¹ f, in m/s and rad/s

  /// The speed that forces give it in this step, m/s; 0 if it is not known (Problem::leastDemand).
  double gain = 0;

  bool movable() const { return inverseMass.any() || inverseInertia.any(); }
};

}  // namespace delassus
