#pragma once

#include "delassus/types.h"

namespace delassus {

/// The exact reaction of one contact with friction: K_μ ∋ r ⟂ u + μ‖u_t‖ n ∈ K_μ*, u = W r + q (algorithms §6.2).
///
/// Regions in fixed order: released (r = 0), stuck (u = 0), sliding. The sliding reaction is r_t(s) = −(S + s I)⁻¹ c
/// with S what the tangents feel while the normal velocity is held, and s = ‖u_t‖/‖r_t‖ the root of μ r_n(s) = ‖r_t(s)‖, found by a Newton iteration safeguarded by a bracket.
/// W must have a positive normal entry; the tangential block may be singular. It is factored once for many q.
class OneContact {
 public:
  OneContact() = default;
  explicit OneContact(const Mat3& W);

  /// `slip`: where the search for s begins, if it is known about; 0: it is not.
  Vec3 solve(const Vec3& q, double friction, double slip = 0) const;
  const Mat3& W() const { return W_; }

 private:
  Vec3 slide(const Vec3& q, double friction, double slip) const;

  Mat3 W_ = Mat3::Zero(), inverse_ = Mat3::Zero();
};

inline Vec3 solveOneContact(const Mat3& W, const Vec3& q, double friction) {
  return OneContact(W).solve(q, friction);
}

}  // namespace delassus
