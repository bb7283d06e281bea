#include "delassus/one_contact.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "delassus/cone.h"

namespace delassus {
namespace {

using Vec2 = Eigen::Vector2d;
using Mat2 = Eigen::Matrix2d;

Vec3 slide(const Mat3& W, const Vec3& q, double mu) {
  // Hold the normal: what remains is the tangential plane with its Schur complement S.
  const Vec2 wnt = W.block<1, 2>(0, 1).transpose();
  const Vec2 wtn = W.block<2, 1>(1, 0);
  const Mat2 S = W.block<2, 2>(1, 1) - wtn * wnt.transpose() / W(0, 0);
  const Vec2 c = q.tail<2>() - wtn * (q[0] / W(0, 0));

  const auto tangential = [&](double s) -> Vec2 {
    const Mat2 Ss = S + s * Mat2::Identity();
    const double det = Ss.determinant();
    return Vec2(Ss(0, 1) * c[1] - Ss(1, 1) * c[0], Ss(1, 0) * c[0] - Ss(0, 0) * c[1]) / det;
  };
  const auto normal = [&](const Vec2& rt) { return -(q[0] + wnt.dot(rt)) / W(0, 0); };

  // φ(s) = μ r_n − ‖r_t‖ is negative where it still sticks too much and positive for large s.
  double low = 0, high = c.norm() / std::max(-mu * q[0] / W(0, 0), 1e-300) + W.norm();
  const auto excess = [&](double s) {
    const Vec2 rt = tangential(s);
    return mu * normal(rt) - rt.norm();
  };
  for (int k = 0; k < 100 && !(excess(high) > 0); ++k) high *= 4;

  double s = 0.5 * high;
  {
    // Start where the reaction would have the size that the normal alone allows.
    const double scale = -mu * q[0] / W(0, 0);
    const double first = c.norm() / scale - 0.5 * S.trace();
    if (first > low && first < high) s = first;
  }
  constexpr int most = 80;
  for (int k = 0; k < most; ++k) {
    const Vec2 rt = tangential(s);
    const double rn = normal(rt), length = rt.norm();
    const double phi = mu * rn - length;
    (phi < 0 ? low : high) = s;
    if (std::abs(phi) <= 1e-16 * length || high - low <= 1e-16 * high) break;

    // Newton on 1/‖r_t‖ − 1/(μ r_n), which is nearly linear in s.
    double next = 0.5 * (low + high);
    if (rn > 0 && length > 0) {
      const Mat2 Ss = S + s * Mat2::Identity();
      const Vec2 slope = -(Ss.inverse() * rt);
      const double dLength = rt.dot(slope) / length;
      const double dNormal = -wnt.dot(slope) / W(0, 0);
      const double g = 1 / length - 1 / (mu * rn);
      const double dg = -dLength / (length * length) + dNormal / (mu * rn * rn);
      const double newton = s - g / dg;
      if (newton > low && newton < high) next = newton;
    }
    if (next == s) break;
    s = next;
  }

  Vec2 rt = tangential(s);
  const double rn = std::max(0.0, normal(rt));
  const double length = rt.norm();
  if (length > 0) rt *= mu * rn / length;
  return {rn, rt[0], rt[1]};
}

}  // namespace

Vec3 solveOneContact(const Mat3& W, const Vec3& q, double friction) {
  if (q[0] >= 0) return Vec3::Zero();
  if (friction <= 0) return {-q[0] / W(0, 0), 0, 0};

  Vec3 stick = -W.partialPivLu().solve(q);
  if (stick.allFinite() && stick[0] > 0 && std::hypot(stick[1], stick[2]) <= friction * stick[0])
    return stick;
  return slide(W, q, friction);
}

}  // namespace delassus
