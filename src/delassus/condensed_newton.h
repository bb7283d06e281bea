#pragma once

#include <vector>

#include "delassus/motion_space.h"
#include "delassus/newton_steps.h"
#include "delassus/problem.h"
#include "delassus/residual.h"
#include "delassus/solution.h"

namespace delassus {

/// Newton's method on the few contacts of an island whose joints are eliminated first (static condensation).
///
/// Rows without bounds, E, are held in every region. Around reactions r_k they answer to what all others, C, do by
///
///     Δr_E = −G (u_E + J̃_E δ),   δ = K⁻¹ (J̃_Cᵀ Δr_C − J̃_Eᵀ G u_E),   K = I + J̃_Eᵀ G J̃_E,   G = 1/(compliance + α W_aa)
///
/// so that one factor leaves of a ragdoll its contacts and limits alone,
///
///     u_C(Δr_C) = u_C − J̃_C K⁻¹ J̃_Eᵀ G u_E + (J̃_C K⁻¹ J̃_Cᵀ + compliance + α W_aa) Δr_C
///
/// whose matrix is small, dense and, thanks to α, regular. This is solved by NewtonSteps, from the region of r_k on. Then r_k ← r, until the
/// law itself is kept: as in ProximalNewton, the fixed points know nothing of α.
class CondensedNewton {
 public:
  /// Whether a problem is for it: in body space, without disks, with an E and few unknowns beside it.
  static bool fits(const Problem& problem);

  /// Improves best.r (with its u and residual) until its natural residual is at most `tolerance` (m/s), or some digits less where they come
  /// by themselves: true; or until `budget` regions are spent, or hardly anything is gained. `map` is that of the problem, which fits.
  bool solve(const Problem& problem, const NaturalMap& map, double tolerance, int budget,
             Solution& best);

  std::size_t bytes() const {
    return motion_.bytes() + G_.bytes() + steps_.bytes() +
           bytesOf(left_, held_, lower_, upper_, mean_, diagonal_, center_, u_, change_, delta_,
                   felt_);
  }

 private:
  bool condense(const Problem& problem, const NaturalMap& map, Solution& count);
  void setWeight(const Problem& problem, double alpha);
  void letHeldAnswer();
  bool solveLeft(const Problem& problem, double enough, int budget, Solution& count);

  BodyMotion motion_;
  Stiffness G_;
  std::vector<int> left_, held_;  ///< unknowns of C, contacts first, and of E
  VectorXd lower_, upper_;        ///< bounds of the rows of C
  NewtonSteps<Eigen::Dynamic> steps_;
  VectorXd diagonal_;      ///< of its matrix without α W_aa
  VectorXd mean_;          ///< of W_aa, per unknown
  VectorXd center_, u_;    ///< r_k and its u
  VectorXd change_;        ///< r − r_k
  VectorXd delta_, felt_;  ///< δ and J̃ δ
};

}  // namespace delassus
