#pragma once

#include "LinearMath/btVector3.h"
#include "delassus/types.h"

class btManifoldPoint;
class btCollisionObject;
struct btContactSolverInfo;

namespace delassus::bullet {

/// How friction differs with the direction on the bodies of one manifold: F = F_B F_A, with
/// F_X = R_X diag(f_X) R_Xᵀ of a body's anisotropic friction f_X and its axes R_X.
struct Anisotropy {
  bool any = false;  ///< otherwise F is the identity
  Mat3 F = Mat3::Identity();
};
Anisotropy anisotropyOf(const btCollisionObject& a, const btCollisionObject& b);
/// The same for rolling friction (CF_ANISOTROPIC_ROLLING_FRICTION).
Anisotropy rollingAnisotropyOf(const btCollisionObject& a, const btCollisionObject& b);

/// The frame of a contact, columns n, t1, t2, and the velocity wanted along t1 and t2.
///
/// Tangents are those of btPlaneSpace1, orthonormal to double precision: narrow phase resets the
/// directions of a point that it replaces to btPlaneSpace1 of the new normal and keeps the lateral
/// impulses, so that components along these are the only ones that survive.
///
/// Where friction depends on the direction, tangents are not orthonormal. With T the orthonormal
/// ones and D the part of F in their plane,
///
///     tangents = T D,   u_s = Dᵀ u_t,   r_t = D s,   |s| ≤ μ r_n,  s opposite to u_s,
///
/// Coulomb's disk in s is the ellipse { D s } of the forces with which Bullet's solver opposes slip
/// in all directions; on it the force is the one of maximum dissipation.
///
/// Directions set by the user (SOLVER_ENABLE_FRICTION_DIRECTION_CACHING, and the flag of the point)
/// are tangents as they are, but for their part along n; their length scales friction. The wanted
/// velocity is the point's contact motion, of body 0 relative to body 1. Without
/// SOLVER_USE_2_FRICTION_DIRECTIONS the second direction is the one across the first.
///
/// Such a point may have a friction softness χ: u + χ W_ii r = wanted velocity while it sticks.
///
/// A friction anchor wants back the drift d between the two points, at the rate frictionERP / h.
struct ContactFrame {
  Mat3 axes = Mat3::Zero();
  double motion1 = 0, motion2 = 0;  ///< m/s, times the length of the tangent
  double softness = 0;              ///< χ
};
ContactFrame contactFrame(const btManifoldPoint& point, const Anisotropy& anisotropy,
                          const btContactSolverInfo& info);

/// Those of the points of one manifold. Most have the same normal, and nothing else that their
/// frames depend on: such a frame is found once.
class ContactFrames {
 public:
  ContactFrames(const Anisotropy& anisotropy, const btContactSolverInfo& info)
      : anisotropy_(anisotropy), info_(info) {}

  /// That of the point; good until the next call.
  const ContactFrame& of(const btManifoldPoint& point);

 private:
  Anisotropy anisotropy_;
  const btContactSolverInfo& info_;
  ContactFrame frame_;
  btVector3 normal_{0, 0, 0};  ///< of frame_; zero where that depends on more
};

/// The axes T D that rolling friction acts about, as those above and whatever directions the user
/// has set for sliding.
Eigen::Matrix<double, 3, 2> rollingAxes(const btManifoldPoint& point, const Anisotropy& anisotropy);

}  // namespace delassus::bullet
