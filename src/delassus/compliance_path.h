#pragma once

#include "delassus/motion_space.h"
#include "delassus/residual.h"
#include "delassus/solution.h"

namespace delassus {

/// The way from bodies that are compliant where they touch to rigid ones, along the answers to all
/// compliances in between.
///
/// If every contact and row gives way by c W_aa r, reactions follow from the motion, and the law is
/// one equation there:
///
///     E(δ, c) = δ − J̃ᵀ r = 0,    r = P(z),    z = −u / (compliance + c W_aa),    u = J̃ δ + q
///
/// with P as in ProximalWalk. Its answers are curves. For large c there is but one, and one there
/// is for any c where bodies can part (Acary, Cadoux, Lemaréchal, Malick 2011). So the curve that
/// begins there ends nowhere but at c = 0, at rigid bodies; but it may turn back on its way, where
/// what is wedged snaps through, and c grows for a while. A search that only ever takes the next
/// region, or only lets c fall, is stuck there.
///
/// The curve is followed by its own length. A stride goes along the tangent, K y = J̃ᵀ ∂r/∂ln c
/// with K = I + J̃ᵀ G J̃, and then by Newton's method across it, through as many regions as it may.
/// Where that fails, steps go from wall to wall of the regions, one contact at a time. Which of its
/// two ways a tangent points is told by the sign of det K: along one curve it tells whether c grows
/// (Eaves and Scarf 1976; Allgower and Georg, Introduction to Numerical Continuation Methods, ch. 2
/// and 14).
///
/// It may also be compliance to what changes at reactions r_k that all but keep the law: then
///
///     E(δ, c) = δ − J̃ᵀ (r − r_k) = 0,    z = r_k − (u_k + J̃ δ) / (compliance + c W_aa),
///     u_k = W r_k + q
///
/// and the curve begins at r_k, where c is large, and ends at the same rigid bodies. What is far
/// from where something is wedged has found its answer there, and follows without turning back:
/// that is the way in islands of thousands.
///
/// For body space without disks.
class CompliancePath {
 public:
  static bool canFollow(const Problem& problem) {
    return problem.W.inBodySpace() && problem.disks.empty();
  }

  /// All must outlive the path. Compliance to all reactions.
  void setProblem(BodyMotion& motion, const Problem& problem, const NaturalMap& map);

  /// Compliance to what changes at `center`, its r and u, from now on.
  void setCenter(const Solution& center);

  /// Stands on the answer for bodies that are compliant by `compliance` W_aa, looking towards rigid
  /// ones. `reactions`: that answer, or so near to it that Newton's method finds it: if not, false.
  /// Work is counted in `count`, a factorisation a region.
  bool setOut(const VectorXd& reactions, double compliance, int budget, WorkDone& count);

  /// Goes on until bodies are compliant by `compliance` W_aa or less. False if there is no way on
  /// within the budget.
  bool descend(double compliance, int budget, WorkDone& count);

  double compliance() const;
  /// Reactions where it stands.
  const VectorXd& reactions();

  std::size_t bytes() const {
    return G_.bytes() + bytesOf(scale_, own_, center_, u0_, here_.delta, start_.delta, from_.delta,
                                tangent_.delta, newTangent_.delta, l_, u_, z_, r_, change_, error_,
                                felt_, drive_, alongZ_, acrossZ_, gaps_, region_.contacts,
                                region_.rows);
  }

 private:
  /// On the path or beside it; or what leads from one place to another.
  struct Place {
    VectorXd delta;  ///< δ
    double tau = 0;  ///< ln c
  };
  /// A contact or row, and which of the walls that its mode has.
  struct Wall {
    int part, side;
    double ahead;  ///< length of path to it
  };
  struct Gap {
    double value, growth;  ///< to the wall; of it, along a change of z
  };

  int parts() const { return static_cast<int>(region_.contacts.size() + region_.rows.size()); }
  int wallsOf(int part) const;
  Gap gapTo(int part, int side, const VectorXd& change) const;
  double leastGap(int part) const;

  void respond(bool inRegion);
  void readRegion();
  bool factorise(WorkDone& count);
  bool stand(bool upward, WorkDone& count);
  double error();
  double noise() const;
  double gapNoise() const;
  void findDrive();
  double findTangent();
  void takeTangent();
  void changeOfZ(const VectorXd& delta, double tau, VectorXd& change);
  double distance(const VectorXd& delta, double tau) const;
  double strayed(double length);

  void advance(double length);
  void goBack() { here_ = from_; }
  bool meetCurve(bool inRegion, int most, WorkDone& count);
  bool stride(double length, WorkDone& count);
  bool stepToWall(WorkDone& count);
  bool stepInRegion(double length, WorkDone& count);
  bool meetWall(const Wall& wall, WorkDone& count);
  void findWalls(double within);
  bool hasLeftRegion() const;
  void pass(const Wall& wall);

  BodyMotion* motion_ = nullptr;
  const Problem* problem_ = nullptr;
  VectorXd scale_, own_;     ///< mean W_aa; compliance of the problem itself
  VectorXd center_, u0_;     ///< r_k and u_k
  double smallestFelt_ = 0;  ///< ‖δ‖ whose digits rounding in r − r_k has not taken

  Place here_;
  Place start_;  ///< where it set out
  Place from_;   ///< where this step did
  Place tangent_, newTangent_;
  ActiveSet region_;
  double unit_ = 1;         ///< length in δ that counts as much as one in ln c
  bool hasTurned_ = false;  ///< round, since it set out
  bool downward_ = false;   ///< sign of det K where the tangent leads to smaller c: negative?
  double strideLength_ = 0;
  int stepsAtWalls_ = 1;  ///< after a stride that failed

  VectorXd l_, u_, z_, r_, change_, error_, felt_, drive_, alongZ_, acrossZ_, gaps_;
  double push_ = 0;  ///< largest reaction, the measure of gaps
  std::vector<Wall> walls_;
  Stiffness G_;
};

}  // namespace delassus
