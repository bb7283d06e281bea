#pragma once

#include <vector>

#include "delassus/types.h"

struct btContactSolverInfo;

namespace delassus::bullet {

struct Group;

/// What taut joints need of the bodies that hang in them. A step pulls along the directions of its
/// start. So a light body that a joint pulls with the force f at the arm a turns to and fro too
/// fast for steps of h once ω h > 2, and gains energy, whoever solves the step. The torque a × f
/// turns it back with the geometric stiffness
///
///     K = |a| |f| (|s|² 1 − s sᵀ)/4,   s = a/|a| + f/|f|
///
/// (the symmetric part of (a·f) 1 − a fᵀ where a ∥ f; else its positive part or a little more: what
/// pushes adds nothing). ω² is the largest eigenvalue of I⁻¹ K, K summed over the joints of a body.
/// One with ω h > 2, or 0.7 where the last step had another length, which steps can follow less,
/// turns in this step as if it were held by implicit springs of that stiffness (Tournier, Nesme,
/// Gilles, Faure 2015; only where it is needed: Andrews, Teichmann, Kövecses 2017),
///
///     (I + h² K) ω' = I ω + h T + moments of the reactions,
///
/// K growing to its full size as (ω h)² grows by an eighth; all others stay as they are.
class GeometricStiffness {
 public:
  /// Changes the inertia and the free velocity of such bodies; call it when all is gathered and
  /// recalled. The forces are those of the last step, JointSource::lastPullOnA and B; the arms
  /// those of the joint's pivots or frames, so that only Bullet's own kinds of joints count.
  /// `lastStep`: its length, s; 0 if it is not known. Answers with the number of bodies changed.
  int stiffen(Group& group, const btContactSolverInfo& info, double lastStep);

  std::size_t bytes() const { return stiffness_.capacity() * sizeof(Mat3); }

 private:
  std::vector<Mat3> stiffness_;  ///< h² K of each body, kg m²
};

}  // namespace delassus::bullet
