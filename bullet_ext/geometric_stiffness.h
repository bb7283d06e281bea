#pragma once

#include <vector>

#include "delassus/types.h"

struct btContactSolverInfo;

namespace delassus::bullet {

struct Group;

/// Slows light bodies in taut joints to what a step can follow. In a step a joint pulls along the
/// directions of the step's start. So a light body that a joint pulls with the force f at the arm a
/// turns to and fro too fast for steps of h once ω h > 2, and gains energy, whoever solves the
/// step. The torque a × f turns the body back with the geometric stiffness
///
///     K = |a| |f| (|s|² 1 − s sᵀ)/4,   s = a/|a| + f/|f|
///
/// This is the symmetric part of (a·f) 1 − a fᵀ where a ∥ f; elsewhere it is the positive part of
/// that, or a little more: forces that push add nothing. K is summed over the joints of a body, and
/// ω² is the largest eigenvalue of I⁻¹ K. A body with ω h > 2 turns in this step as if it were held
/// by implicit springs of that stiffness (Tournier, Nesme, Gilles, Faure 2015; only where it is
/// needed: Andrews, Teichmann, Kövecses 2017),
///
///     (I + h² K) ω' = I ω + h T + moments of the reactions,
///
/// where K reaches its full size once (ω h)² is an eighth above its bound. If the last step had
/// another length, ω h is bounded by 0.7 instead of 2, since such steps can follow less. Other
/// bodies stay as they are.
class GeometricStiffness {
 public:
  /// Changes the inertia and the free velocity of such bodies; call it when all is gathered and
  /// recalled. The forces are those of the last step (JointSource::lastLoad). The arms are
  /// those of the joint's pivots or frames, so only Bullet's own kinds of joints count. `lastStep`:
  /// the length of the last step, s; 0 if it is not known. Returns the number of bodies changed.
  int stiffen(Group& group, const btContactSolverInfo& info, double lastStep);

  std::size_t bytes() const { return stiffness_.capacity() * sizeof(Mat3); }

 private:
  std::vector<Mat3> stiffness_;  ///< h² K of each body, kg m²
};

}  // namespace delassus::bullet
