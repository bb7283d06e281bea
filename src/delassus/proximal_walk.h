#pragma once

#include "delassus/outcome.h"
#include "delassus/proximal_space.h"

namespace delassus {

/// The walk from region to region: a proximal Newton method in a motion space (algorithms §6.10,
/// written in increments).
///
/// Around reactions r_k the law is answered by z = r_k − l (u_k + J̃ δ) with l = 1/(compliance +
/// A), A = α W_aa, and r = P(z). P projects z_n on [0, ∞) and then z_t on the disk of radius μ r_n
/// (rows: on their bounds; disks: on that of radius κ r_n, with the r_n found in this way). Each
/// inner Newton step solves δ = J̃ᵀ (r − r_k) in one region; each outer step takes r_k ← r. A fixed
/// point is an exact solution of Coulomb's law for any α: the regularisation leaves no trace in it.
template <class Motion>
class ProximalWalk {
 public:
  /// Walks on the problem of `space`, which must outlive it.
  explicit ProximalWalk(ProximalSpace<Motion>& space);
  ProximalSpace<Motion>& space() { return space_; }

  /// Improves best.r (with its u and residual) until its natural residual is at most `tolerance`
  /// (m/s), or the region budget is spent. `alpha`: first proximal weight. Among redundant contacts
  /// the limit stays near the reactions it came from: a self-stress changes only as much as the
  /// demands ask.
  Outcome walk(double tolerance, double alpha, int regionBudget, Solution& best);

  /// The same for as long as it gains: it ends where the root mean square of the residual has not
  /// halved for `patience` regions. Between light and heavy bodies errors vanish that slowly.
  Outcome walkOn(double tolerance, double alpha, int patience, int regionBudget, Solution& best);

  /// The same, but from `start`, which gives r, u and the residual, instead of from the best.
  Outcome walkFrom(const Solution& start, double tolerance, double alpha, int regionBudget,
                   Solution& best);

  /// The same as `walk`, but tests the region best.activeSet first and starts its reactions from
  /// zero: the limit is the smoothest share (least norm) among redundant contacts, whatever the
  /// guess was.
  Outcome walkFromRegion(double tolerance, double alpha, int regionBudget, Solution& best);

  /// Makes one outer step from reactions that already keep the law, and leaves them as they are if
  /// the step does not better them. A second step would find nothing but rounding: errors shrink by
  /// the factor `alpha`.
  void polish(double tolerance, double alpha, int regionBudget, Solution& best);

  /// Finds the answer as if all contacts and rows were compliant by `alpha` W_aa: where demands are
  /// incompatible, that is a compromise. It replaces `best`, whose u and residual are then those of
  /// the problem itself. False if it is not found within the budget. The way to it sets out from
  /// the motion of `start`.
  bool answerCompliant(double tolerance, double alpha, const VectorXd& start, int& regionBudget,
                       Solution& best);

 private:
  enum class Inner { Converged, Failed };

  // proximal_walk.cpp: inner and outer steps.
  void setTolerance(double tolerance);
  void setWeights(double alpha);
  double tryStep(double share);
  bool stepAlong(double& error);
  double nextWallAlong(double after) const;
  void startFromCenter();
  void startFromReactions(const VectorXd& r);
  bool startFromRegion(const Solution& region, int& budget, WorkDone& count);
  Inner solveProximal(int& budget, WorkDone& count);
  Outcome converge(double tolerance, double firstWeight, int patience, int regionBudget,
                   bool fromRegion, double residual, Solution& best);
  VelocityResidual measure() { return space_.measure(r_, trialU_); }
  void moveTo(const VelocityResidual& residual, Solution& best);
  const VectorXd& felt();

  // proximal_walk_response.cpp: how contacts, rows and disks answer the motion.
  void respond(const VectorXd& u, Stiffness* G);
  void respondInRegion(const Solution& from);
  void answer(int at, double step, double r);

  // proximal_walk_incompatible.cpp: where demands contradict each other.
  bool growsInVain(double tolerance, double residual);
  void compromise(Solution& best);

  const Problem& problem() const { return space_.problem(); }

  ProximalSpace<Motion>& space_;
  const VectorXd &scale_, &l_;
  VectorXd& felt_;
  Stiffness& G_;
  VectorXd &center_, &u_;  ///< r_k and u_k
  VectorXd &r_, &delta_;   ///< the answer of the inner problem
  VectorXd& change_;       ///< r − r_k
  VectorXd& error_;        ///< δ − J̃ᵀ (r − r_k)
  VectorXd &step_, &trialDelta_, &trialError_, &trialU_;
  VectorXd &fromU_, &alongU_;  ///< u where a step begins, and its change by the whole step
  /// Inner error that is small enough, as a share of the step: a large weight leaves more than that
  /// anyway.
  double enough_ = 0;
  double fine_ = 0;  ///< inner error that is small enough whatever the size of the step
};

}  // namespace delassus
