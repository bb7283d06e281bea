#pragma once

#include <vector>

#include "delassus/lorentz_cone.h"
#include "delassus/motion_space.h"
#include "delassus/residual.h"
#include "delassus/solution.h"

namespace delassus {

/// A primal-dual interior-point method for the whole law, Coulomb's normality gap included, in a
/// motion space.
///
/// With x = (μ r_n, r_t) and y = (u_n/μ + ‖u_t‖, u_t) the law reads L ∋ x ⟂ y ∈ L for the Lorentz
/// cone L. A row is the same with half-lines; a disk is the same with x = (κ r_n, r_d) and y =
/// (y_0, u_d), where y_0 is free (`mostLoad` is ignored here, but not by the walk that follows).
/// Newton's method follows x ∘ y = τ e, τ → 0, with Nesterov and Todd's scaling and Mehrotra's
/// corrector; ‖u_t‖ is differentiated too, smoothed by the slip that τ allows. Each step costs one
/// factorisation of K = I + J̃ᵀ G J̃, however many contacts change their mode. It takes 10 to 40
/// steps from any start; the walk over regions may take hundreds if many contacts are at a wall of
/// their region. A small proximal weight about the last reactions keeps redundant contacts apart
/// and leaves no trace in the answer. Sources: Acary, Armand, Nguyen, Shpakovych (2024) for
/// frictional contact, algorithms §6.1 and §6.10.
template <class Motion>
class InteriorPoint {
 public:
  /// Improves `best` from a cold start. Stops at the natural residual `tolerance` (m/s): true; or
  /// after `budget` factorisations, or when it gains no more.
  bool solve(Motion& motion, const Problem& problem, const NaturalMap& map, double tolerance,
             int budget, Solution& best);

  std::size_t bytes() const {
    return G_.bytes() + bytesOf(scale_, r_, u_, y_, dr_, dv_, du_, weight_, cones_, disks_, lower_,
                                upper_, rowResidual_);
  }

 private:
  /// A contact with friction.
  struct Cone : LorentzPair {
    Vec2 slip;  ///< derivative of the smoothed ‖u_t‖
  };
  /// One side of a row: x = r − lower, y = u⁺, or x = upper − r, y = u⁻.
  struct Side {
    bool bounded = false;
    double x = 1, y = 0, dx = 0, dy = 0;
    double target = 0;  ///< of x dy + y dx
  };

  void start(const Problem& problem, const NaturalMap& map);
  void measure(const Problem& problem);
  void linearise(const Problem& problem);
  /// Solves for the step towards x ∘ y = `tau` e; with `corrector`, the second-order term of the
  /// last step is included.
  bool step(Motion& motion, const Problem& problem, double tau, bool corrector);
  void aim(const Problem& problem, double tau, bool corrector);
  void follow(const Problem& problem);
  double longestStep() const;
  double gapAfter(double length) const;
  void advance(const Problem& problem, double length);

  VectorXd scale_;
  VectorXd r_, u_, y_;
  VectorXd dr_;  ///< right-hand side, then the step of r
  VectorXd dv_, du_;
  VectorXd weight_;  ///< compliance + proximal weight
  std::vector<Cone> cones_;
  std::vector<LorentzPair> disks_;  ///< x = (κ r_n, r_d), y = (y_0, u_d)
  std::vector<Side> lower_, upper_;
  VectorXd rowResidual_;
  Stiffness G_;
  double gap_ = 0;  ///< τ, J per degree of the cones
  int degree_ = 0;
};

}  // namespace delassus
