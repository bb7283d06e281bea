#pragma once

#include "delassus/length.h"
#include "delassus/types.h"

namespace delassus {

/// Euclidean projection on Coulomb's cone K_μ = { r : ‖r_t‖ ≤ μ r_n }, normal first (algorithms
/// §6.1).
inline Vec3 projectOnCone(const Vec3& x, double mu) {
  const double t = lengthOf(x[1], x[2]);
  if (x[0] >= 0 && t <= mu * x[0]) return x;
  if (mu * t <= -x[0]) return Vec3::Zero();
  const double n = (x[0] + mu * t) / (1 + mu * mu);
  const double scale = t > 0 ? mu * n / t : 0;
  return {n, scale * x[1], scale * x[2]};
}

/// The derivative of a reaction that slides along the direction t = (c, s), of length 1 (or 0, in
/// the corner of the cone), from its normal and tangential parts:
///
///     [ normal          0         ]
///     [ along t  across (1 − t tᵀ) ]
inline Mat3 slidingBlock(double normal, double along, double across, double c, double s) {
  Mat3 block;
  block << normal, 0, 0,                           //
      along * c, across * s * s, -across * s * c,  //
      along * s, -across * s * c, across * c * c;
  return block;
}

/// The reaction of a sliding contact: z_t is scaled to the rim, whether it lies beyond the rim or
/// not. With t = z_t/‖z_t‖, `zt` = ‖z_t‖ > 0:
///
///     r = (z_n, μ z_n t),   dr_t/dz_n = μ t,   dr_t/dz_t = (μ z_n/‖z_t‖) (1 − t tᵀ)
inline Vec3 slidingReaction(const Vec3& z, double zt, double mu, Mat3* derivative) {
  const double radius = mu * z[0];
  const double c = z[1] / zt, s = z[2] / zt, turn = radius / zt;
  if (derivative) *derivative = slidingBlock(1, mu, turn, c, s);
  return {z[0], radius * c, radius * s};
}

/// P(z), Coulomb's law in the form of Alart and Curnier (1991): projects z_n on [0, ∞), then z_t on
/// the disk of radius μ r_n. If asked, also its derivative dr/dz.
inline Vec3 reactionTo(const Vec3& z, double mu, Mat3* derivative) {
  if (z[0] <= 0) {
    if (derivative) derivative->setZero();
    return Vec3::Zero();
  }
  const double zt = lengthOf(z[1], z[2]);
  if (zt <= mu * z[0]) {
    if (derivative) derivative->setIdentity();
    return z;
  }
  return slidingReaction(z, zt, mu, derivative);
}

/// De Saxcé's corrected velocity u + μ‖u_t‖ n: with it Coulomb's law reads K_μ ∋ r ⟂ corrected ∈
/// K_μ*.
inline Vec3 correctedVelocity(const Vec3& u, double mu) {
  return {u[0] + mu * lengthOf(u[1], u[2]), u[1], u[2]};
}

}  // namespace delassus
