#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "delassus/problem.h"

namespace delassus {

/// How far reactions are from the law, per contact, row or disk and together (algorithms §9.1):
///
///     F = r − P(r − ρ v),  ρ = 1/‖W_aa‖,  v = u + μ‖u_t‖ n for contacts, u for rows and disks;
///     P projects on the cone, the bounds or the disk of radius κ r_n
struct VelocityResidual {
  double max = 0;  ///< largest ‖F‖/ρ, m/s (rad/s where it is an angle)
  double rms = 0;  ///< root mean square of ‖F‖/ρ over contacts and rows, m/s
  int worst = -1;  ///< first unknown of the contact or row with the largest ‖F‖/ρ
};

/// Measures many reactions of one problem: all that depends on W alone is computed once.
class NaturalMap {
 public:
  /// Keeps a pointer to `problem`, which must outlive the measuring.
  void setProblem(const Problem& problem);
  /// The same for contacts alone, if their W_aa and ‖W_aa‖ are known.
  void setProblem(const Problem& problem, std::vector<Mat3> blocks, const VectorXd& norms);

  /// The tolerance, m/s, within which a search is to bring the residual. Without it, errors are
  /// residuals.
  void aimAt(double tolerance);

  VelocityResidual residual(const VectorXd& r, const VectorXd& u) const;
  /// The errors by which searches compare answers: the residuals, except of contacts with friction
  /// above 2. Of these, ‖F‖ hides an approach by a factor of μ: one that slips, and nears without
  /// reaction, misses the law by −u_n but may have ‖F‖/ρ = −u_n/√(1+μ²); and what sticks with a
  /// slip u_t has ‖F‖/ρ > μ‖u_t‖. So bodies would rather sink than slip. Of such a contact it is
  /// the larger of the two numbers
  ///
  ///     ‖F‖/ρ, but no more than 1000 times the tolerance,
  ///     ‖G‖/ρ,  G = (min(r_n, ρ u_n), r_t − P(r_t − ρ u_t));
  ///             P projects on the disk of radius μ r_n
  VelocityResidual error(const VectorXd& r, const VectorXd& u) const;
  /// The same, and computes u = W r + q; `y` is storage for the motion of the bodies.
  VelocityResidual measure(const VectorXd& r, VectorXd& y, VectorXd& u) const;
  /// ‖F‖/ρ one by one, m/s: first of the contacts, then of the rows (a disk stands in the place of
  /// its first row).
  void residuals(const VectorXd& r, const VectorXd& u, VectorXd& each) const;
  /// The error that round-off alone leaves in u = W r + q, m/s: a few ε of the largest W_aa r_a. No
  /// residual can be read finer than this.
  double roundOff(const VectorXd& r) const;
  const VectorXd& diagonal() const { return diagonal_; }                    ///< of W
  const Mat3& contactBlock(int contact) const { return blocks_[contact]; }  ///< W_aa
  /// The mean of W_aa over the unknowns of each contact and disk, one number per unknown: a unit
  /// for quantities that should weigh all directions alike. It is at least 1e-14 of the largest,
  /// and 1 where all W is zero: an unknown that moves nothing (W_ii = 0) can do nothing, so any
  /// finite number is harmless.
  void meanDiagonal(VectorXd& mean) const;
  /// Whether a contact has friction above 2, so that errors are not residuals.
  bool isGrippy() const { return isGrippy_; }
  std::size_t bytes() const { return bytesOf(sizes_, diagonal_, blocks_); }

 private:
  template <class OfContact>
  VelocityResidual summary(const VectorXd& r, const VectorXd& u, OfContact ofContact) const;

  const Problem* problem_ = nullptr;
  VectorXd sizes_;     ///< ‖W_aa‖ per contact and row
  VectorXd diagonal_;  ///< one per unknown
  std::vector<Mat3> blocks_;
  bool isGrippy_ = false;
  double near_ = 0;  ///< residuals above this do not count as errors where friction is above 2, m/s
};

/// One-off use, with u = W r + q.
VelocityResidual naturalResidual(const Problem& problem, const VectorXd& r, const VectorXd& u);
VelocityResidual naturalResidual(const Problem& problem, const VectorXd& r);
/// ‖W_aa‖ = 1/ρ of one contact, 1/kg, and with it ‖F‖/ρ, m/s.
double contactSize(const Mat3& W);
double naturalResidual(double size, double friction, const Vec3& r, const Vec3& u);

/// |r − clamp(r − s u)| of a row with the step s, written so that a large r does not swallow s u.
inline double rowResidual(double r, double u, double lower, double upper, double s) {
  return std::abs(std::max(std::min(s * u, r - lower), r - upper));
}

/// The published measures on problem files: unit-dependent, for comparison only.
struct FclibMeasures {
  double rel = 0;  ///< |F(1)| / |q|
  double vel = 0;  ///< |(F_i(s_i)/s_i)_i| / |q|, s_i = 3 / trace(W_ii); for rows s_i = 1/|W_ii|
};

FclibMeasures fclibMeasures(const Problem& problem, const VectorXd& r);

}  // namespace delassus
