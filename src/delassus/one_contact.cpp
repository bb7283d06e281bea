#include "delassus/one_contact.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace delassus {

OneContact::OneContact(const Mat3& W) : W_(W) {
  // Column by column: Eigen unrolls that, but not the inverse.
  const Eigen::PartialPivLU<Mat3> factor(W);
  for (int k = 0; k < 3; ++k) inverse_.col(k) = factor.solve(Vec3(Vec3::Unit(k)));
}

Vec3 OneContact::solve(const Vec3& q, double friction, double slip) const {
  if (q[0] >= 0) return Vec3::Zero();
  if (friction <= 0) return {-q[0] / W_(0, 0), 0, 0};

  Vec3 stick = -(inverse_ * q);
  const double most = friction * stick[0];
  if (stick.allFinite() && stick[0] > 0 && stick.tail<2>().squaredNorm() <= most * most)
    return stick;
  return slide(q, friction, slip);
}

Vec3 OneContact::slide(const Vec3& q, double friction, double slip) const {
  // The normal velocity is held; what remains is the tangential plane.
  const double wnn = W_(0, 0), held = -q[0] / wnn;
  const Vec2 wnt(W_(0, 1) / wnn, W_(0, 2) / wnn), wtn = W_.bottomLeftCorner<2, 1>();
  const Mat2 S = W_.bottomRightCorner<2, 2>() - wtn * wnt.transpose();
  const Vec2 c = q.tail<2>() + wtn * held;

  // φ(s) = μ r_n − ‖r_t‖ is negative where it still sticks too much, at s = 0, and positive for large s.
  double low = 0, high = std::numeric_limits<double>::infinity();
  double s = slip;
  if (!(s > 0)) {
    // Where the reaction would have the size that the normal alone allows, or else somewhere.
    const double size = c.norm() / (friction * held);
    s = size - 0.5 * S.trace();
    if (!(s > 0)) s = 0.5 * (size + W_.norm());
  }
  constexpr int most = 100;
  constexpr double rounding = std::numeric_limits<double>::epsilon();
  Vec2 rt;
  double rn = 0, length = 0;
  for (int k = 0; k < most; ++k) {
    const double a = S(0, 0) + s, d = S(1, 1) + s;
    const double perDet = 1 / (a * d - S(0, 1) * S(1, 0));
    const auto answer = [&](const Vec2& x) {
      return Vec2((S(0, 1) * x[1] - d * x[0]) * perDet, (S(1, 0) * x[0] - a * x[1]) * perDet);
    };
    rt = answer(c);
    rn = held - wnt.dot(rt);
    length = std::sqrt(rt.squaredNorm());
    const double phi = friction * rn - length;
    (phi < 0 ? low : high) = s;
    if (std::abs(phi) <= rounding * length) break;
    if (std::isfinite(high) && high - low <= rounding * high) break;

    // Newton on 1/‖r_t‖ − 1/(μ r_n), which is nearly linear in s.
    double next = std::isfinite(high) ? 0.5 * (low + high) : 4 * s;
    if (rn > 0 && length > 0) {
      const Vec2 slope = answer(rt);
      const double most2 = friction * rn * rn;
      const double g = 1 / length - 1 / (friction * rn);
      const double dg = -rt.dot(slope) / (length * length * length) - wnt.dot(slope) / most2;
      const double newton = s - g / dg;
      if (newton > low && newton < high) next = newton;
    }
    if (next == s) break;
    s = next;
  }

  rn = std::max(0.0, rn);
  if (length > 0) rt *= friction * rn / length;
  return {rn, rt[0], rt[1]};
}

}  // namespace delassus
