#pragma once

#include "delassus/proximal_space.h"

namespace delassus {

/// Newton's method on the law in the space of reactions (Alart and Curnier 1991; algorithms §6.10).
/// Around reactions r_k
///
///     F(r) = P(r − v/ρ) − r = 0,    v = u + A (r − r_k),    ρ = (1 + α) W_aa
///
/// In a region P has the derivative P'. With D = (compliance + A)/ρ a step is
///
///     Δr = B F − G J̃ δ,    δ = K⁻¹ J̃ᵀ B F,    K = I + J̃ᵀ G J̃,
///     B = (1 − P' (1 − D))⁻¹,    G = B P'/ρ
///
/// The rim of a disk follows P(r_n − v_n/ρ), which changes by Δr_n − F_n in a step.
///
/// The walk reads its region from r_k − l u: there even tiny velocities lie far behind walls. This
/// method reads it from r − v/ρ, so that a nearly right guess has most of its region right. It
/// takes fewer steps where tens of contacts slide and stick; hundreds are seldom all in the right
/// region at once, unless the guess is nearly right.
template <class Motion>
class ReactionSteps {
 public:
  /// For the problem of `space`, which must outlive it.
  explicit ReactionSteps(ProximalSpace<Motion>& space) : space_(space) {}

  /// Improves best.r, with its u and residual (moveCenters, `next` is scratch): true if the law is
  /// kept to the `tolerance`, m/s. Steps are counted as regions.
  bool solve(double tolerance, int budget, Solution& next, Solution& best);

 private:
  class AroundCenter;

  ProximalSpace<Motion>& space_;
};

}  // namespace delassus
