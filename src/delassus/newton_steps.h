#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "delassus/bytes.h"
#include "delassus/elimination.h"
#include "delassus/reaction_error.h"
#include "delassus/types.h"

namespace delassus {

/// Up to this many unknowns are solved without a workspace.
constexpr int fewUnknowns = 15;

/// A list of at most `Most` entries, which allocates nothing; or of any number (Eigen::Dynamic).
template <class Entry, int Most>
class ShortList {
 public:
  void clear() { size_ = 0; }
  void push_back(const Entry& entry) { entries_[size_++] = entry; }
  std::size_t size() const { return size_; }
  Entry& back() { return entries_[size_ - 1]; }
  const Entry& operator[](std::size_t i) const { return entries_[i]; }
  const Entry* begin() const { return entries_.data(); }
  const Entry* end() const { return entries_.data() + size_; }

 private:
  std::array<Entry, Most> entries_;
  std::size_t size_ = 0;
};
template <class Entry>
class ShortList<Entry, Eigen::Dynamic> : public std::vector<Entry> {};

/// Newton's method on Coulomb's law itself, with all entries of W (Alart and Curnier 1991;
/// algorithms §6.10):
///
///     F(r) = P(r − u/ρ) − r = 0,    u = W r + q,    ρ = mean of the diagonal of W_ii
///
/// P is `reactionTo` for contacts, the projection on their bounds for rows, and that on the disk
/// which P(r_n − u_n/ρ) allows for disks. At most `Most` unknowns, or any number (Eigen::Dynamic).
template <int Most>
class NewtonSteps {
 public:
  using Matrix = typename Elimination<Most>::Matrix;
  using Vector = typename Elimination<Most>::Vector;

  Matrix W;
  Vector rho;
  Vector r, u;  ///< where the next step begins, and afterwards where it ended

  /// Makes room for this many unknowns. W is then zero; the rest must be set.
  void resize(int unknowns);
  /// Call it after W or rho have changed.
  void forgetFactor() { hasFactor_ = false; }
  /// ‖ρ F‖ at r and u, m/s.
  double error(const ReactionBounds& bounds) { return evaluate(bounds, r, u); }
  /// Solves F = 0 in the region of r and u and goes there, or less far if that is worse. A step
  /// that gains nothing is a short one, since behind the wall there may be a better region. `error`
  /// must be ‖ρ F‖ at r and u, from `error` or the last step; afterwards it is that of the new r
  /// and u. False, and nothing is changed, if F is singular in this region.
  bool step(const ReactionBounds& bounds, double& error);
  /// The same, but always the full step, even if that is worse (for `descend`).
  bool fullStep(const ReactionBounds& bounds, double& error);
  void keepLast();
  void goBack();
  /// product = W x
  void multiply(const Vector& x, Vector& product) const;

  std::size_t bytes() const {
    if constexpr (Most == Eigen::Dynamic)
      return W.bytes() + K_.bytes() + elimination_.bytes() +
             bytesOf(rho, r, u, active_, factored_, unknowns_, step_, felt_, error_, right_,
                     trialR_, trialU_, keptR_, keptU_);
    return 0;
  }

 private:
  /// Writes F at these reactions and velocities to error_. Returns ‖ρ F‖.
  double evaluate(const ReactionBounds& bounds, const Vector& at, const Vector& velocity);
  void findActive(const ReactionBounds& bounds);
  void findActiveDisk(const Disk& disk);
  void fillMatrix();
  bool isFactored() const;
  bool findStep(const ReactionBounds& bounds);
  void tryStep(const ReactionBounds& bounds, double share, double& error);

  /// A part that responds to others in the region of r and u: the three unknowns of a contact, one
  /// of a row, or those of a disk.
  struct Active {
    int first, unknowns;
    bool slides;  ///< else it is free in all directions
    /// Its derivative if it slides. That of a disk has two rows: dP/dz and, last, dP/dr_n.
    Mat3 P = Mat3::Zero();
    int governor = -1;  ///< the place of r_n in `unknowns_`; −1: r_n does not move a rim
  };

  Elimination<Most> elimination_;
  Matrix K_;
  ShortList<Active, Most> active_;
  std::vector<Active> factored_;
  ShortList<int, Most> unknowns_;  ///< unknowns of the active parts
  bool hasFactor_ = false;         ///< whether elimination_ has the factor for factored_
  Vector step_, felt_, error_, right_, trialR_, trialU_, keptR_, keptU_;
};

}  // namespace delassus
