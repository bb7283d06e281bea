#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "delassus/body.h"
#include "delassus/contact.h"
#include "delassus/row.h"
#include "delassus/types.h"

namespace delassus {

// Motion of single contacts and rows with their bodies, without W: velocities, m/s (rad/s for rows
// about an axis), and diagonal entries of J M⁻¹ Jᵀ without compliance, 1/kg.

/// v + ω × arm: the velocity of the point of `body` at `arm`; zero for the fixed world.
inline Vec3 velocityAt(const std::vector<Body>& bodies, int body, const Vec3& arm) {
  if (body < 0) return Vec3::Zero();
  const Vec6& v = bodies[body].velocity;
  return v.head<3>() + v.tail<3>().cross(arm);
}

/// The velocity of the point of a relative to that of b, in world axes.
inline Vec3 slip(const std::vector<Body>& bodies, const Contact& c) {
  return velocityAt(bodies, c.a, c.armA) - velocityAt(bodies, c.b, c.armB);
}

/// The same in the frame of the contact, less the target.
inline Vec3 relativeVelocity(const std::vector<Body>& bodies, const Contact& c) {
  return c.frame.transpose() * slip(bodies, c) - c.target;
}

inline double normalVelocity(const std::vector<Body>& bodies, const Contact& c) {
  return c.frame.col(0).dot(slip(bodies, c)) - c.target[0];
}

/// One body's part of the velocity of a row.
inline double along(const std::vector<Body>& bodies, int body, const Row6& J) {
  return body >= 0 ? J.dot(bodies[body].velocity) : 0;
}

inline double relativeVelocity(const std::vector<Body>& bodies, const Row& c) {
  return along(bodies, c.a, c.jacobianA) + along(bodies, c.b, c.jacobianB) - c.target;
}

/// One body's part of the diagonal entry along an axis of a contact:
///
///     eᵀ M⁻¹ e + (arm × e)ᵀ I⁻¹ (arm × e)
inline double diagonalShare(const std::vector<Body>& bodies, int body, const Vec3& arm,
                            const Vec3& axis) {
  if (body < 0) return 0;
  const Vec3 turn = arm.cross(axis);
  return axis.cwiseAbs2().dot(bodies[body].inverseMass) +
         turn.dot(bodies[body].inverseInertia * turn);
}

/// The diagonal entry along an axis; axis 0 is the normal.
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
