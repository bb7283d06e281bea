#pragma once

#include "delassus/motion_space.h"
#include "delassus/residual.h"
#include "delassus/solution.h"

namespace delassus {

/// The path from bodies that are compliant where they touch to rigid ones, along the answers for
/// all compliances in between.
///
/// If every contact and row gives way by c W_aa r, the motion determines the reactions, and the law
/// is one equation:
///
///     E(δ, c) = δ − J̃ᵀ r = 0,    r = P(z),    z = −u / (compliance + c W_aa),    u = J̃ δ + q
///
/// with P as in ProximalWalk. Its answers are curves. For large c there is only one answer, and if
/// bodies can part there is one for any c (Acary, Cadoux, Lemaréchal, Malick 2011). So the curve
/// that begins at large c can only end at c = 0, at rigid bodies. But it may turn back on its way:
/// where bodies are wedged and snap through, c grows for a while. A search that only takes the next
/// region, or only lets c fall, gets stuck there.
///
/// The curve is followed by its own length. A stride goes along the tangent, K y = J̃ᵀ ∂r/∂ln c
/// with K = I + J̃ᵀ G J̃, and then by Newton's method across it, through any number of regions.
/// Where that fails, steps go from wall to wall of the regions, one contact at a time. The sign of
/// det K orients the tangent: along one curve it tells whether c grows (Eaves and Scarf 1976;
/// Allgower and Georg, Introduction to Numerical Continuation Methods, ch. 2 and 14).
///
/// The compliance may also act only on changes from reactions r_k that nearly keep the law: then
///
///     E(δ, c) = δ − J̃ᵀ (r − r_k) = 0,    z = r_k − (u_k + J̃ δ) / (compliance + c W_aa),
///     u_k = W r_k + q
///
/// and the curve begins at r_k, where c is large, and ends at the same rigid bodies. Contacts far
/// from a wedged place already have their answer at r_k, and follow without turning back. Islands
/// of thousands of contacts are solved in this way.
///
/// For body space without disks.
class CompliancePath {
 public:
  static bool canFollow(const Problem& problem) {
    return problem.W.inBodySpace() && problem.disks.empty();
  }

  /// All must outlive the path. The compliance acts on all reactions.
  void setProblem(BodyMotion& motion, const Problem& problem, const NaturalMap& map);

  /// From now on the compliance acts on changes from `center`, its r and u.
  void setCenter(const Solution& center);

  /// Stands on the answer for bodies that are compliant by `compliance` W_aa, facing rigid ones.
  /// `reactions`: this answer, or near enough for Newton's method to find it. False if it does not.
  /// Work is counted in `count`, one factorisation per region.
  bool setOut(const VectorXd& reactions, double compliance, int budget, WorkDone& count);

  /// Follows the path until bodies are compliant by `compliance` W_aa or less. False if there is no
  /// way on within the budget.
  bool descend(double compliance, int budget, WorkDone& count);

  double compliance() const;
  /// Reactions at this point of the path.
  const VectorXd& reactions();

  std::size_t bytes() const {
    return G_.bytes() + bytesOf(scale_, own_, center_, u0_, here_.delta, start_.delta, from_.delta,
                                tangent_.delta, newTangent_.delta, l_, u_, z_, r_, change_, error_,
                                felt_, drive_, alongZ_, acrossZ_, gaps_, region_.contacts,
                                region_.rows);
  }

 private:
  /// A point on the path or beside it, or the difference of two such points.
  struct Place {
    VectorXd delta;  ///< δ
    double tau = 0;  ///< ln c
  };
  /// A contact or row, and the number of the wall among those of its mode.
  struct Wall {
    int part, side;
    double ahead;  ///< length of path to it
  };
  struct Gap {
    double value, growth;  ///< distance to the wall; its growth along a change of z
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
  double unit() const;
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
  VectorXd scale_, own_;     ///< mean W_aa; the problem's own compliance
  VectorXd center_, u0_;     ///< r_k and u_k
  double least_ = 0;         ///< a ‖δ‖ that is none beside what a part alone asks for
  double smallestFelt_ = 0;  ///< smallest ‖δ‖ that keeps its digits despite rounding in r − r_k

  Place here_;
  Place start_;  ///< of the path
  Place from_;   ///< of this step
  Place tangent_, newTangent_;
  ActiveSet region_;
  double unit_ = 1;         ///< length in δ that counts as a unit of ln c
  bool hasTurned_ = false;  ///< turned round since the start
  bool downward_ = false;   ///< whether det K < 0 where the tangent leads to smaller c
  double strideLength_ = 0;
  int stepsAtWalls_ = 1;  ///< after a stride that failed

  VectorXd l_, u_, z_, r_, change_, error_, felt_, drive_, alongZ_, acrossZ_, gaps_;
  double push_ = 0;  ///< largest reaction, the measure of gaps
  std::vector<Wall> walls_;
  Stiffness G_;
};

}  // namespace delassus
