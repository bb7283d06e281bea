#pragma once

#include "delassus/types.h"

namespace delassus {

/// A contact: a point shared by bodies `a` and `b`, with Coulomb friction.
///
///     u = frameᵀ (v_a + ω_a × arm_a − v_b − ω_b × arm_b) − target,
///     0 ≤ r_n ⊥ u_n + compliance r_n ≥ 0
///
/// A reaction r (N·s) acts as +frame r on a and −frame r on b.
struct Contact {
  int a = fixedWorld, b = fixedWorld;
  Vec3 armA = Vec3::Zero(), armB = Vec3::Zero();  ///< from each centre of mass to its point, m
  /// Columns n, t1, t2, right-handed; n points from body b to body a. Where friction depends on
  /// direction, t1 and t2 are scaled by its strength along them, and need not be at right angles.
  /// Then u_t, r_t, target_t and slipCompliance are in these units, in which the cone is round.
  Mat3 frame = Mat3::Identity();
  double friction = 0;  ///< Coulomb's μ ≥ 0; 0 leaves the tangential rows out
  /// Wanted relative velocity in the frame, m/s (restitution, gap, belt).
  Vec3 target = Vec3::Zero();
  double compliance = 0;  ///< added to W_nn, 1/kg
  /// Added to both tangential diagonals of W, 1/kg. Both have the same: only then does a walk find
  /// friction that opposes the slip (algorithms §6.10).
  double slipCompliance = 0;
};

}  // namespace delassus
