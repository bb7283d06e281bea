#pragma once

#include <vector>

#include "delassus/motion_space.h"
#include "delassus/newton_steps.h"
#include "delassus/problem.h"
#include "delassus/proximal_centers.h"
#include "delassus/residual.h"
#include "delassus/solution.h"

namespace delassus {

/// Newton's method on few contacts, after joints are eliminated (static condensation).
///
/// Rows of joints without bounds, E, are held in every region. Around reactions r_k they answer to
/// all others, C, by
///
///     Δr_E = −G (u_E + J̃_E δ),   δ = K⁻¹ (J̃_Cᵀ Δr_C − J̃_Eᵀ G u_E),   K = I + J̃_Eᵀ G J̃_E,
///     G = 1/(compliance + α W_aa)
///
/// so that after one factorisation only the contacts and limits of a ragdoll are left,
///
///     u_C(Δr_C) = u_C − J̃_C K⁻¹ J̃_Eᵀ G u_E + (J̃_C K⁻¹ J̃_Cᵀ + compliance + α W_aa) Δr_C
///
/// Their matrix is small, dense and, thanks to α, regular. NewtonSteps solves this problem, from
/// the region of r_k on. Then r_k ← r, until the law itself is kept (moveCenters). This α is that
/// of C; E has its own α, with which K is factored once.
class CondensedNewton {
 public:
  /// Whether this method fits the problem: in body space, not without contacts and bounds, and with
  /// at most `most` unknowns beside E. If there are more, rows whose `r` is within their bounds
  /// count as held, too; and if that leaves nothing beside E, as in a beam whose joints could
  /// break, they do in any case. `map` belongs to the problem; both must outlive `solve`.
  bool setProblem(const Problem& problem, const NaturalMap& map, const VectorXd& r, int most);
  /// As BlockFactor.
  void setHands(Hands* hands) { motion_.setHands(hands); }
  /// Whether there is an E.
  bool hasHeld() const { return !held_.empty(); }

  static constexpr int mostSteps = 30;  ///< beyond that a walk is faster

  /// Improves best.r, with its u and residual: true if the law is kept. The factor counts as a
  /// region. Steps count as sweeps, which cost about as much.
  bool solve(double tolerance, int budget, Solution& best);
  /// The same from another start, after `solve`, with the factor of that. It counts no region.
  bool goOn(double tolerance, int budget, Solution& best);

  std::size_t bytes() const {
    return motion_.bytes() + G_.bytes() + steps_.bytes() + next_.bytes() +
           bytesOf(left_, held_, lower_, upper_, disks_, mean_, diagonal_, change_, delta_, felt_);
  }

 private:
  void divide(const Problem& problem, const VectorXd& r, bool withinBounds);
  bool condense(WorkDone& count);
  void setWeight(double alpha);
  void letHeldAnswer(const VectorXd& u);
  Descent moveOn(const Solution& center, double alpha, double enough, int budget, Solution& next);

  const Problem* problem_ = nullptr;
  const NaturalMap* map_ = nullptr;
  BodyMotion motion_;
  Stiffness G_;
  std::vector<int> left_, held_;  ///< unknowns of C, contacts first, and of E
  VectorXd lower_, upper_;        ///< bounds of the rows of C
  std::vector<Disk> disks_;       ///< their unknowns as places in left_
  NewtonSteps<Eigen::Dynamic> steps_;
  double weight_ = 0;      ///< α of C
  VectorXd diagonal_;      ///< of its matrix without α W_aa
  VectorXd mean_;          ///< of W_aa, per unknown
  VectorXd change_;        ///< r − r_k
  VectorXd delta_, felt_;  ///< δ and J̃ δ
  Solution next_;
};

}  // namespace delassus
