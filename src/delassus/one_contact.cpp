#include "delassus/one_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delassus {
namespace {

constexpr double rounding = std::numeric_limits<double>::epsilon();

/// (S + s I)⁻¹
Mat2 inverseOf(const Mat2& S, double s) {
  const double a = S(0, 0) + s, d = S(1, 1) + s, perDet = 1 / (a * d - S(0, 1) * S(1, 0));
  Mat2 inverse;
  inverse << d * perDet, -S(0, 1) * perDet, -S(1, 0) * perDet, a * perDet;
  return inverse;
}

}  // namespace

OneContact::OneContact(const Mat3& W) : W_(W), wnt_(W(0, 1) / W(0, 0), W(0, 2) / W(0, 0)) {
  S_ = W.bottomRightCorner<2, 2>() - W.bottomLeftCorner<2, 1>() * wnt_.transpose();
  const double trace = S_.trace();
  const double det = S_(0, 0) * S_(1, 1) - S_(0, 1) * S_(1, 0);
  isSingular_ = !(det > 16 * rounding * trace * trace);
  if (!isSingular_)
    inverse_ = inverseOf(S_, 0);
  else if (S_.squaredNorm() > 0)
    inverse_ = S_ / S_.squaredNorm();  // of rank one
}

Vec3 OneContact::solve(const Vec3& q, double friction, const Vec3& before) const {
  if (q[0] >= 0) return Vec3::Zero();
  const double held = -q[0] / W_(0, 0);  // without tangential reactions
  if (friction <= 0) return {held, 0, 0};

  const Vec2 c = q.tail<2>() + held * W_.bottomLeftCorner<2, 1>();
  const Vec2 rt = -(inverse_ * c);
  const double rn = held - wnt_.dot(rt), most = friction * rn;
  if (rt.allFinite() && rn > 0 && rt.squaredNorm() <= most * most &&
      (!isSingular_ || stops(rt, c, q, held)))
    return {rn, rt[0], rt[1]};

  // Near the end of a search the slip hardly changes any more.
  const double braked = before.tail<2>().squaredNorm();
  const Vec2 ut = W_.bottomRows<2>() * before + q.tail<2>();
  return slide(held, c, friction, braked > 0 ? std::sqrt(ut.squaredNorm() / braked) : 0);
}

/// Whether S r_t + c = 0 to rounding; a singular S can meet that only for some c.
bool OneContact::stops(const Vec2& rt, const Vec2& c, const Vec3& q, double held) const {
  constexpr double digitsLost = 64;
  const double terms = q.tail<2>().norm() + held * W_.bottomLeftCorner<2, 1>().norm();
  return (S_ * rt + c).norm() <= digitsLost * rounding * terms;
}

/// `slip`: where the search for s begins; 0: anywhere.
Vec3 OneContact::slide(double held, const Vec2& c, double friction, double slip) const {
  // φ(s) = μ r_n − ‖r_t‖ is negative at s = 0, where ‖r_t‖ is too large, and positive for large s.
  double low = 0, high = infinity;
  // The s at which a reaction straight against c would have the size that the normal one allows.
  const double drift = c.norm(), size = drift / (friction * held);
  if (!std::isfinite(size)) return {held, 0, 0};  // friction is smaller than any number
  // Nearly vanishing reactions give a slip so large that the search could not come back from it.
  constexpr double farthest = 1e6;
  double s = slip <= farthest * size ? slip : 0;
  if (!(s > 0)) {
    const Vec2 along = c / drift;
    s = size * (1 - friction * wnt_.dot(along)) - along.dot(S_ * along);
  }
  if (!(s > 0)) s = 0.5 * (size + W_.norm());
  constexpr int most = 100;
  // The digits double in every step: one more step after so small a change gives all of them.
  constexpr double lastChange = 1e-9;
  bool isLast = false;
  Vec2 rt;
  double rn = 0, length = 0;
  for (int k = 0; k < most; ++k) {
    const Mat2 inverse = inverseOf(S_, s);
    rt = -(inverse * c);
    rn = held - wnt_.dot(rt);
    length = std::sqrt(rt.squaredNorm());
    const double radius = friction * rn, phi = radius - length;
    if (isLast || std::abs(phi) <= 2 * rounding * length) break;
    (phi < 0 ? low : high) = s;
    const bool isBounded = high < infinity;
    if (isBounded && high - low <= rounding * high) break;

    // Newton on 1/‖r_t‖ − 1/(μ r_n), which is nearly linear in s.
    double next = isBounded ? 0.5 * (low + high) : 4 * s;
    if (rn > 0 && length > 0) {
      const Vec2 slope = -(inverse * rt);
      const double perLength = 1 / length, share = radius * perLength;
      const double change =
          phi * share / (rt.dot(slope) * perLength * share * share + friction * wnt_.dot(slope));
      const double newton = s + change;
      if (newton > low && newton < high) {
        next = newton;
        isLast = std::abs(change) <= lastChange * s;
      }
    }
    if (next == s) break;
    s = next;
  }

  rn = std::max(0.0, rn);
  if (length > 0) rt *= friction * rn / length;
  return {rn, rt[0], rt[1]};
}

}  // namespace delassus
