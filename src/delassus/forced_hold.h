#pragma once

#include "delassus/proximal_space.h"

namespace delassus {

/// The forced motion of the paper (theory §2): all that touches is held.
template <class Motion>
class ForcedHold {
 public:
  /// Holds the problem of `space`, which must outlive it.
  explicit ForcedHold(ProximalSpace<Motion>& space);

  /// All that `best.activeSet` does not say is open or at a bound is held, W r + q = 0 there; and
  /// of the forced reactions, which redundant contacts share in many ways, some that lie inside all
  /// cones, bounds and disks are looked for. True if they are found: then everything stays, and no
  /// other region need be looked at. One factor serves all steps,
  ///
  ///     r ← r' − L u,    u = (I + W L)⁻¹ (W r' + q),    L = 1/(α W_aa), less for tangents
  ///
  /// each of which goes to the forced reactions nearest to r', that is r with what lies outside
  /// moved further inside than to the wall (Gubin, Polyak, Raik 1967, The method of projections for
  /// finding the common point of convex sets). They begin at `best`, and then from nothing, with
  /// what is left of `budget`. Steps are counted as sweeps here. `tolerance`: of the natural
  /// residual, m/s.
  bool hold(double tolerance, int budget, Solution& best);

 private:
  void setHold(const ActiveSet& set);
  double moveAllInside(double demand);
  void holdOnce();
  bool holdOn(double tolerance, int budget, Solution& best);
  const Problem& problem() const { return space_.problem(); }

  ProximalSpace<Motion>& space_;
  const VectorXd &scale_, &compliance_;
  VectorXd &l_, &felt_;
  Stiffness& G_;
  VectorXd &r_, &u_;
  VectorXd& change_;  ///< how r is to move
  VectorXd& moved_;   ///< r'
  VectorXd& measuredU_;
};

}  // namespace delassus
