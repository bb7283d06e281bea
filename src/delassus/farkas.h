#pragma once

#include "delassus/proximal_walk.h"

namespace delassus {

/// Farkas' lemma: a proof that demands are incompatible, for W in body space.
///
/// Whatever friction does, contacts demand u_n ≥ 0, rows with one bound u ≥ 0 or u ≤ 0, and rows
/// without bounds u = 0. Let r push only at these demands, each in its sense. A motion v that meets
/// them has 0 ≤ r·(J v + q), and therefore
///
///     |v|_M  ≥  −r·q / √(r·W r)
///
/// with the kinetic energy ½|v|²_M, |v|_M in √J. Reactions that push and move nothing prove that
/// there is no such motion.
class FarkasProof {
 public:
  /// Takes the demands alone: no tangents, no motors, no disks. The unknowns stay, with q = 0 for
  /// those left out. Refers to W.
  void setProblem(const Problem& problem, const NaturalMap& map);
  const Problem& demands() const { return demands_; }

  /// The right side, less what rounding may add to it; 0 if r proves nothing.
  double leastMotion(const VectorXd& r) { return weigh(r).leastMotion; }

  /// Looks, from the reactions `start`, for a proof that no motion meets the demands of `problem`,
  /// or none in any proportion to them. Uses up the region budget and counts its work in `count`.
  /// The space of `walk` forgets its problem. `map` belongs to the problem, `scratch` is
  /// overwritten.
  bool find(ProximalWalk<BodyMotion>& walk, const Problem& problem, const NaturalMap& map,
            double tolerance, const VectorXd& start, int& regionBudget, Solution& scratch,
            WorkDone& count);
  /// The reactions that `find` found.
  const VectorXd& reactions() const { return reactions_; }
  /// Every motion misses some demand by at least this, m/s.
  double missed() const { return missed_; }

  std::size_t bytes() const { return demands_.bytes() + bytesOf(reactions_, last_, felt_); }

 private:
  struct Push {
    double leastMotion = 0;     ///< as above
    double missed = 0;          ///< −r·q / Σ|r|, less rounding
    bool movesNothing = false;  ///< beyond rounding
  };
  Push weigh(const VectorXd& r);
  /// |v|_M of the motion that meets only the hardest of these demands: the largest missing
  /// |u_i|/√W_ii at u = q.
  double hardestAlone() const;
  bool refine(ProximalWalk<BodyMotion>& walk, const Problem& problem, const NaturalMap& map,
              int& regionBudget, Solution& scratch, WorkDone& count);
  void keepPushes(VectorXd& r) const;
  bool isProof();

  Problem demands_;
  const NaturalMap* map_ = nullptr;  ///< of the problem, with the same W
  VectorXd reactions_, last_, felt_;
  double missed_ = 0;
};

}  // namespace delassus
