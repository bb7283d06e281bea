#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "delassus/body.h"
#include "delassus/contact.h"
#include "delassus/row.h"
#include "delassus/types.h"

namespace delassus {

// How contacts and rows move with their bodies, one by one and without W: velocities, m/s (rad/s of
// rows about an axis), and entries of the diagonal of J M⁻¹ Jᵀ, compliance left out, 1/kg.

/// v + ω × arm of the point of `body` at `arm`; that of the fixed world is zero.
inline Vec3 velocityAt(const std::vector<Body>& bodies, int body, const Vec3& arm) {
  if (body < 0) return Vec3::Zero();
  const Vec6& v = bodies[body].velocity;
  return v.head<3>() + v.tail<3>().cross(arm);
}

/// The velocity of the point of a relative to that of b, in world axes.
inline Vec3 slip(const std::vector<Body>& bodies, const Contact& c) {
  return velocityAt(bodies, c.a, c.armA) - velocityAt(bodies, c.b, c.armB);
}

/// The same in the frame of the contact, less what is wanted.
inline Vec3 relativeVelocity(const std::vector<Body>& bodies, const Contact& c) {
  return c.frame.transpose() * slip(bodies, c) - c.target;
}

inline double normalVelocity(const std::vector<Body>& bodies, const Contact& c) {
  return c.frame.col(0).dot(slip(bodies, c)) - c.target[0];
}

/// What one body adds to the velocity of a row.
inline double along(const std::vector<Body>& bodies, int body, const Row6& J) {
  return body >= 0 ? J.dot(bodies[body].velocity) : 0;
}

inline double relativeVelocity(const std::vector<Body>& bodies, const Row& c) {
  return along(bodies, c.a, c.jacobianA) + along(bodies, c.b, c.jacobianB) - c.target;
}

/// What one body adds to the diagonal along an axis of a contact:
///
///     eᵀ M⁻¹ e + (arm × e)ᵀ I⁻¹ (arm × e)
inline double diagonalShare(const std::vector<Body>& bodies, int body, const Vec3& arm,
                            const Vec3& axis) {
  if (body < 0) return 0;
  const Vec3 turn = arm.cross(axis);
  return axis.cwiseAbs2().dot(bodies[body].inverseMass) +
         turn.dot(bodies[body].inverseInertia * turn);
}

/// Axis 0 is the normal.
inline double diagonal(const std::vector<Body>& bodies, const Contact& c, int axis) {
  return diagonalShare(bodies, c.a, c.armA, c.frame.col(axis)) +
         diagonalShare(bodies, c.b, c.armB, c.frame.col(axis));
}

/// The same for a row.
inline double diagonalShare(const std::vector<Body>& bodies, int body, const Row6& J) {
  if (body < 0) return 0;
  const Vec3 linear = J.head<3>(), angular = J.tail<3>();
  return linear.cwiseAbs2().dot(bodies[body].inverseMass) +
         angular.dot(bodies[body].inverseInertia * angular);
}

inline double diagonal(const std::vector<Body>& bodies, const Row& c) {
  return diagonalShare(bodies, c.a, c.jacobianA) + diagonalShare(bodies, c.b, c.jacobianB);
}

}  // namespace delassus
