#pragma once

#include "delassus/proximal_space.h"

namespace delassus {

/// The forced motion of the paper (theory §2): all contacts that touch are held.
template <class Motion>
class ForcedHold {
 public:
  /// Holds the problem of `space`, which must outlive it.
  explicit ForcedHold(ProximalSpace<Motion>& space);

  /// Holds all parts that `best.activeSet` does not have open or at a bound: W r + q = 0 there.
  /// Redundant contacts share the forced reactions in many ways; this looks for a share inside all
  /// cones, bounds and disks. True if it finds one: then everything stays, and no other region need
  /// be tried. One factor serves all steps,
  ///
  ///     r ← r' − L u,    u = (I + W L)⁻¹ (W r' + q),    L = 1/(α W_aa), less for tangents
  ///
  /// each of which goes to the forced reactions nearest to r'. r' is r with the reactions outside
  /// moved inside, beyond the wall (Gubin, Polyak, Raik 1967, The method of projections for finding
  /// the common point of convex sets). The steps begin at `best`, and then again from nothing, with
  /// the rest of `budget`. They count as sweeps. `tolerance`: natural residual to reach, m/s.
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
  VectorXd& change_;  ///< r' − r, the next move of r
  VectorXd& measuredU_;
  double tangentShare_ = 0;  ///< the ease of friction, relative to normal reactions
};

}  // namespace delassus
