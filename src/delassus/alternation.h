#pragma once

#include "delassus/proximal_space.h"

namespace delassus {

/// Alternating directions (ADMM) for the law (Carpentier, Le Lidec, Montaut 2024; algorithms §6.8):
///
///     x ← (W + A)⁻¹ (A y + z − q − s),    y ← P(x − A⁻¹ z),    z ← z − A (x − y),
///     s = μ‖z_t‖ n,    A = ρ W_aa
///
/// with P the Euclidean projection on cones, bounds and disks. In a fixed point x = y and z = W y +
/// q + s: the exact law. One factor serves all iterations: contacts at rest that squeeze each other
/// settle at the cost of a few regions. The method is slow where bodies collide or slide.
template <class Motion>
class Alternation {
 public:
  /// For the problem of `space`, which must outlive it.
  explicit Alternation(ProximalSpace<Motion>& space);

  /// Improves `best` until its natural residual is at most `tolerance`, m/s: true. Stops without
  /// that if `budget` iterations are spent or gain too little. Iterations are counted as sweeps.
  bool alternate(double tolerance, int budget, Solution& best);

 private:
  void alternateOnce();
  const Problem& problem() const { return space_.problem(); }

  ProximalSpace<Motion>& space_;
  const VectorXd &scale_, &l_;
  VectorXd& felt_;
  VectorXd &x_, &y_, &z_;
  VectorXd& u_;  ///< of y
};

}  // namespace delassus
