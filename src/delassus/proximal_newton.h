#pragma once

#include "delassus/motion_space.h"
#include "delassus/residual.h"
#include "delassus/solution.h"

namespace delassus {

enum class Outcome : unsigned char {
  Reached,       ///< within the tolerance
  Lost,          ///< out of budget, or no way to a better region
  Incompatible,  ///< no motion meets all demands; the compromise was taken
};

/// The walk from region to region: a proximal Newton method in a motion space (algorithms §6.10,
/// written in increments).
///
/// Around reactions r_k the law is answered by z = r_k − l (u_k + J̃ δ) with l = 1/(compliance +
/// A), A = α W_aa, and r = P(z), P the projection of z_n on [0, ∞) and then of z_t on the disk of
/// radius μ r_n (for rows: on the bounds; for disks, with the r_n found so, on that of radius κ
/// r_n). Each inner Newton step solves δ = J̃ᵀ (r − r_k) in one region; each outer step takes r_k ←
/// r. A fixed point is an exact solution of Coulomb's law for any α, and the regularisation leaves
/// no trace in it.
template <class Motion>
class ProximalNewton {
 public:
  /// `map` is that of the problem; both must outlive the walks.
  void setProblem(const Problem& problem, const NaturalMap& map);

  /// Whether a region whose factor is there is not factored again.
  void keepFactors(bool keep) { keepsFactors_ = keep; }

  /// Improves best.r (with its u and residual) until its natural residual is at most `tolerance`
  /// (m/s), or the region budget is spent. `alpha`: first proximal weight. Among redundant contacts
  /// the limit stays near the reactions it came from: a self-stress changes only as much as the
  /// demands ask.
  Outcome walk(const Problem& problem, double tolerance, double alpha, int regionBudget,
               Solution& best);

  /// The same from other reactions than the best: `start` gives r, u and the residual.
  Outcome walkFrom(const Solution& start, const Problem& problem, double tolerance, double alpha,
                   int regionBudget, Solution& best);

  /// The same as `walk`, but tests the region best.activeSet first and starts its reactions from
  /// zero: the limit is the smoothest share (least norm) among redundant contacts, whatever the
  /// guess was.
  Outcome walkFromRegion(const Problem& problem, double tolerance, double alpha, int regionBudget,
                         Solution& best);

  /// One outer step from reactions that keep the law already, which are left as they are if it does
  /// not better them. A second one would find nothing but rounding: errors shrink by `alpha`.
  void polish(const Problem& problem, double tolerance, double alpha, int regionBudget,
              Solution& best);

  /// The answer if all were compliant by `alpha` W_aa: where demands are incompatible, that is a
  /// compromise. Takes the place of `best`, u and residual being those of the problem itself. False
  /// if it is not found within the budget.
  bool yield(const Problem& problem, double tolerance, double alpha, int& regionBudget,
             Solution& best);

  /// Alternating directions (ADMM) for the same law, from `best`, which they improve until its
  /// residual is at most `tolerance`: true; or until `budget` iterations are spent or gain too
  /// little (Carpentier, Le Lidec, Montaut 2024; algorithms §6.8):
  ///
  ///     x ← (W + A)⁻¹ (A y + z − q − s),    y ← P(x − A⁻¹ z),    z ← z − A (x − y),
  ///     s = μ‖z_t‖ n,    A = ρ W_aa
  ///
  /// with P the Euclidean projection on cones, bounds and disks. In a fixed point x = y and z = W y
  /// + q + s: the exact law. One factor serves all iterations: contacts at rest that squeeze each
  /// other settle for the price of a few regions. Where bodies collide or slide it is slow.
  /// Iterations are counted as sweeps.
  bool alternate(const Problem& problem, double tolerance, int budget, Solution& best);

  /// The forced motion of the paper (theory §2): all that `best.activeSet` does not say is open or
  /// at a bound is held, W r + q = 0 there; and of the forced reactions, which redundant contacts
  /// share in many ways, some that lie inside all cones, bounds and disks. True if they are found:
  /// then everything stays, and no other region need be looked at. One factor serves all steps,
  ///
  ///     r ← r' − L u,    u = (I + W L)⁻¹ (W r' + q),    L = 1/(α W_aa), less for tangents
  ///
  /// each of which goes to the forced reactions nearest to r', that is r with what lies outside
  /// moved further inside than to the wall (Gubin, Polyak, Raik 1967, The method of projections for
  /// finding the common point of convex sets). They begin at `best`, and then from nothing, with
  /// what is left of `budget`. Steps are counted as sweeps here.
  bool holdAll(const Problem& problem, double tolerance, int budget, Solution& best);

  /// Newton's method on the law in the space of reactions, without disks (Alart and Curnier 1991;
  /// algorithms §6.10). Around reactions r_k
  ///
  ///     F(r) = P(r − v/ρ) − r = 0,    v = u + A (r − r_k),    ρ = (1 + α) W_aa
  ///
  /// In a region, where P has the derivative P' and D = (compliance + A)/ρ, a step is
  ///
  ///     Δr = B F − G J̃ δ,    δ = K⁻¹ J̃ᵀ B F,    K = I + J̃ᵀ G J̃,
  ///     B = (1 − P' (1 − D))⁻¹,    G = B P'/ρ
  ///
  /// The walk reads its region from r_k − l u, where velocities that are nearly nothing lie far
  /// behind walls; here it is r − v/ρ, and a guess that is nearly right has most of its region
  /// right. That takes fewer steps where tens of contacts slide and stick; hundreds are seldom all
  /// in their region at once. Improves best.r, with its u and residual (moveCenters, `next` is room
  /// for it): true if the law is kept. Steps are counted as regions.
  bool react(const Problem& problem, double tolerance, int budget, Solution& next, Solution& best);

  /// The space of the last problem, for a method that factors in it now; what was factored here is
  /// forgotten.
  Motion& lendMotion() {
    forgetFactor();
    return motion_;
  }
  /// Who borrows the space for longer says so when he has factored in it again.
  void forgetFactor() { hasFactor_ = false; }

  std::size_t bytes() const {
    return motion_.bytes() + G_.bytes() + factored_.bytes() +
           bytesOf(scale_, l_, compliance_, center_, u_, r_, delta_, error_, step_, trialDelta_,
                   trialError_, trialU_, change_, felt_, fromU_, alongU_);
  }

 private:
  enum class Inner { Converged, Failed };
  class Reactions;

  void setWeights(double alpha);
  /// r = P(z), the change r − r_k and, if asked, its derivative, for relative velocities u = u_k +
  /// J̃ δ.
  void respond(const Problem& problem, const VectorXd& u, Stiffness* G);
  /// The same in one given region, that of `from`: an affine answer, right if the region is.
  void respondInRegion(const Problem& problem, const Solution& from);
  void answer(int at, double step, double r);
  void answerOfDisk(const Disk& disk, int k, Mode mode, const Vec2& direction, double turn,
                    bool grows, Stiffness& G) const;
  /// Factors the Newton matrix of G_, unless that very region is factored already.
  bool factorise(Solution& count);
  double tryStep(const Problem& problem, double share);
  bool stepAlong(const Problem& problem, double& error);
  double nextWallAlong(const Problem& problem, double after) const;
  Inner solveProximal(const Problem& problem, int& budget, Solution& count, const Solution* region);
  /// From the reactions center_ with the natural residual `residual`.
  Outcome converge(const Problem& problem, double tolerance, double firstWeight, int regionBudget,
                   bool fromRegion, double residual, Solution& best);
  /// The inner accuracy that answers within this tolerance need.
  void setTolerance(double tolerance);
  /// The natural residual of r_, whose u goes to trialU_.
  VelocityResidual measure() { return map_->measure(r_, felt_, trialU_); }
  /// r_ is the next center, and the best answer if `residual` is the smallest.
  void moveTo(const VelocityResidual& residual, Solution& best);
  void alternateOnce(const Problem& problem);
  void setHold(const Problem& problem, const ActiveSet& set);
  double moveAllInside(const Problem& problem, double demand);
  void holdOnce();
  bool holdOn(const Problem& problem, double tolerance, int budget, Solution& best);
  bool growsInVain(const Problem& problem, double tolerance, double residual);
  void compromise(const Problem& problem, Solution& best);
  const VectorXd& felt();

  const NaturalMap* map_ = nullptr;
  Motion motion_;
  VectorXd scale_;  ///< mean diagonal of W_aa per unknown
  VectorXd l_;      ///< 1/(compliance + A)
  VectorXd compliance_;
  VectorXd center_, u_;  ///< r_k and u_k
  VectorXd r_, delta_;   ///< the answer of the inner problem
  VectorXd change_;      ///< r − r_k
  VectorXd error_;       ///< δ − J̃ᵀ (r − r_k)
  VectorXd step_, trialDelta_, trialError_, trialU_, felt_;
  VectorXd fromU_, alongU_;  ///< u where a step begins, and of all of it
  /// Share of the step that is inner error small enough: what a large weight leaves is larger
  /// anyway.
  double enough_ = 0;
  double fine_ = 0;  ///< inner error that is small enough whatever the size of the step
  Stiffness G_, factored_;
  bool hasFactor_ = false;  ///< that of factored_
  bool keepsFactors_ = true;
};

}  // namespace delassus
