#pragma once

#include "delassus/types.h"

namespace delassus {

/// Points of the Lorentz cone L = { x : x_0 ≥ ‖(x_1, x_2)‖ }, and operations on them for the
/// interior-point method.
namespace lorentz {

/// Largest t with x + t d in the cone.
double longestStep(const Vec3& x, const Vec3& d);

}  // namespace lorentz

/// x and y in the interior of the cone, on their way to x ⟂ y, and a step.
struct LorentzPair {
  Vec3 x, y;
  Vec3 dx, dy;
  Vec3 residual;          ///< of y against the relative velocity
  Mat3 scaling, inverse;  ///< W and W⁻¹ with W y = W⁻¹ x
  Mat3 softness;          ///< W⁻²: dy = shift − softness dx
  Vec3 scaled;            ///< λ = W y
  Vec3 shift;             ///< dy of the step for a body that stays

  /// Nesterov's and Todd's scaling point of x and y.
  void scale();
  /// Aims the step at x ∘ y = `tau` e; with `corrector`, the second-order term of the last step is
  /// included.
  void aim(double tau, bool corrector);
  /// Takes this dx, and its dy.
  void follow(const Vec3& step);
};

}  // namespace delassus
