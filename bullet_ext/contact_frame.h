#pragma once

#include "LinearMath/btVector3.h"
#include "delassus/types.h"

class btManifoldPoint;
class btCollisionObject;
struct btContactSolverInfo;

namespace delassus::bullet {

/// How the friction of one manifold's bodies depends on direction: F = F_B F_A. For a body X with
/// anisotropic friction f_X and axes R_X, F_X = R_X diag(f_X) R_Xᵀ.
struct Anisotropy {
  bool any = false;  ///< otherwise F is the identity
  Mat3 F = Mat3::Identity();
};
Anisotropy anisotropyOf(const btCollisionObject& a, const btCollisionObject& b);
/// The same for rolling friction (CF_ANISOTROPIC_ROLLING_FRICTION).
Anisotropy rollingAnisotropyOf(const btCollisionObject& a, const btCollisionObject& b);

/// The frame of a contact (columns n, t1, t2) and the velocity wanted along t1 and t2.
///
/// The tangents are those of btPlaneSpace1, orthonormal to double precision. When the narrow phase
/// replaces a point, it resets the point's directions to btPlaneSpace1 of the new normal and keeps
/// the lateral impulses; so only components along these tangents survive.
///
/// Where friction depends on the direction, tangents are not orthonormal. With T the orthonormal
/// ones and D the part of F in their plane,
///
///     tangents = T D,   u_s = Dᵀ u_t,   r_t = D s,   |s| ≤ μ r_n,  s opposite to u_s,
///
/// Coulomb's disk in s becomes the ellipse { D s } of the forces with which Bullet's solver opposes
/// slip in all directions; here the force is the one of maximum dissipation on that ellipse.
///
/// Directions that the user sets (SOLVER_ENABLE_FRICTION_DIRECTION_CACHING, and the flag of the
/// point) serve as tangents without their part along n; their length scales friction. The wanted
/// velocity is the point's contact motion, of body 0 relative to body 1. Without
/// SOLVER_USE_2_FRICTION_DIRECTIONS the second direction is perpendicular to the first.
///
/// Such a point may have a friction softness χ: u + χ W_ii r = wanted velocity while it sticks.
///
/// A friction anchor takes back the drift d between the two points, at the rate frictionERP / h.
struct ContactFrame {
  Mat3 axes = Mat3::Zero();
  double motion1 = 0, motion2 = 0;  ///< m/s, times the length of the tangent
  double softness = 0;              ///< χ of the point
};
ContactFrame contactFrame(const btManifoldPoint& point, const Anisotropy& anisotropy,
                          const btContactSolverInfo& info);

/// The frames of the points of one manifold. Most points have the same normal, and their frames
/// depend on nothing else: such a frame is computed once.
class ContactFrames {
 public:
  ContactFrames(const Anisotropy& anisotropy, const btContactSolverInfo& info)
      : anisotropy_(anisotropy), info_(info) {}

  /// The frame of the point; good until the next call.
  const ContactFrame& of(const btManifoldPoint& point);

 private:
  Anisotropy anisotropy_;
  const btContactSolverInfo& info_;
  ContactFrame frame_;
  btVector3 normal_{0, 0, 0};  ///< of frame_; zero if frame_ depends on more than the normal
};

/// The axes T D about which rolling friction acts, with T and D as above, whatever directions the
/// user has set for sliding.
Eigen::Matrix<double, 3, 2> rollingAxes(const btManifoldPoint& point, const Anisotropy& anisotropy);

}  // namespace delassus::bullet
