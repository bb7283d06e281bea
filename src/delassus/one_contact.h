#pragma once

#include "delassus/types.h"

namespace delassus {

/// The exact reaction of one contact with friction: K_μ ∋ r ⟂ u + μ‖u_t‖ n ∈ K_μ*, u = W r + q
/// (algorithms §6.2).
///
/// Regions in fixed order: released (r = 0), stuck, sliding. If u_n = 0 is held, u_t = c + S r_t
/// with S = W_tt − W_tn W_nt / W_nn. The contact sticks if r_t = −S⁻¹ c is in the cone. Otherwise
/// it slides with u_t = −s r_t, so that r_t(s) = −(S + s I)⁻¹ c, and s is the root of μ r_n(s) =
/// ‖r_t(s)‖. A Newton iteration, safeguarded by a bracket, finds it. W must have a positive normal
/// entry. The tangential block may be singular: then the answer is the shortest r_t that stops the
/// contact. W is taken apart once for many q.
class OneContact {
 public:
  OneContact() = default;
  explicit OneContact(const Mat3& W);

  /// `before`: a known reaction, from which the search for s begins; zero if none is known.
  Vec3 solve(const Vec3& q, double friction, const Vec3& before = Vec3::Zero()) const;
  const Mat3& W() const { return W_; }

 private:
  bool stops(const Vec2& rt, const Vec2& c, const Vec3& q, double held) const;
  Vec3 slide(double held, const Vec2& c, double friction, double slip) const;

  Mat3 W_ = Mat3::Zero();
  Mat2 S_ = Mat2::Zero(), inverse_ = Mat2::Zero();  ///< S and S⁻¹, or its pseudoinverse
  Vec2 wnt_ = Vec2::Zero();                         ///< W_nt / W_nn
  bool isSingular_ = false;                         ///< S
};

inline Vec3 solveOneContact(const Mat3& W, const Vec3& q, double friction) {
  return OneContact(W).solve(q, friction);
}

}  // namespace delassus
