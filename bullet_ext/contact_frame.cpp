#include "bullet_ext/contact_frame.h"

#include <Eigen/Geometry>
#include <cmath>

#include "BulletCollision/CollisionDispatch/btCollisionObject.h"
#include "BulletCollision/NarrowPhaseCollision/btManifoldPoint.h"
#include "BulletDynamics/ConstraintSolver/btContactSolverInfo.h"
#include "bullet_ext/convert.h"

namespace delassus::bullet {
namespace {

using Tangents = Eigen::Matrix<double, 3, 2>;

Mat3 stretchOf(const btCollisionObject& object, int flag) {
  if (!object.hasAnisotropicFriction(flag)) return Mat3::Identity();
  const Mat3 R = toCore(object.getWorldTransform().getBasis());
  return R * toCore(object.getAnisotropicFriction()).asDiagonal() * R.transpose();
}

/// The first direction of btPlaneSpace1, which picks the greatest part of n in its own precision.
Vec3 planeSpace(const btVector3& normal, const Vec3& n) {
  if (btFabs(normal.z()) > SIMDSQRT12) {
    const double k = 1 / std::sqrt(n[1] * n[1] + n[2] * n[2]);
    return {0, -k * n[2], k * n[1]};
  }
  const double k = 1 / std::sqrt(n[0] * n[0] + n[1] * n[1]);
  return {-k * n[1], k * n[0], 0};
}

void setUserDirections(const btManifoldPoint& point, int solverMode, ContactFrame& out) {
  const Vec3 n = out.axes.col(0);
  const auto inPlane = [&](const btVector3& direction) -> Vec3 {
    const Vec3 t = toCore(direction);
    return t - t.dot(n) * n;
  };
  out.axes.col(1) = inPlane(point.m_lateralFrictionDir1);
  out.motion1 = point.m_contactMotion1;
  out.softness = point.m_frictionCFM;
  if (solverMode & SOLVER_USE_2_FRICTION_DIRECTIONS) {
    out.axes.col(2) = inPlane(point.m_lateralFrictionDir2);
    out.motion2 = point.m_contactMotion2;
  } else {
    out.axes.col(2) = n.cross(out.axes.col(1));
  }
}

Anisotropy anisotropyBy(int flag, const btCollisionObject& a, const btCollisionObject& b) {
  Anisotropy out;
  out.any = a.hasAnisotropicFriction(flag) || b.hasAnisotropicFriction(flag);
  if (out.any) out.F = stretchOf(b, flag) * stretchOf(a, flag);
  return out;
}

/// T D.
Tangents tangentsOf(const btManifoldPoint& point, const Vec3& n, const Anisotropy& anisotropy) {
  Tangents T;
  T.col(0) = planeSpace(point.m_normalWorldOnB, n);
  T.col(1) = n.cross(T.col(0));
  if (!anisotropy.any) return T;
  const Tangents stretched = anisotropy.F * T;
  return stretched - n * (n.transpose() * stretched);
}

}  // namespace

Anisotropy anisotropyOf(const btCollisionObject& a, const btCollisionObject& b) {
  return anisotropyBy(btCollisionObject::CF_ANISOTROPIC_FRICTION, a, b);
}

Anisotropy rollingAnisotropyOf(const btCollisionObject& a, const btCollisionObject& b) {
  return anisotropyBy(btCollisionObject::CF_ANISOTROPIC_ROLLING_FRICTION, a, b);
}

ContactFrame contactFrame(const btManifoldPoint& point, const Anisotropy& anisotropy,
                          const btContactSolverInfo& info) {
  ContactFrame out;
  const Vec3 n = toCore(point.m_normalWorldOnB).normalized();
  out.axes.col(0) = n;

  if ((info.m_solverMode & SOLVER_ENABLE_FRICTION_DIRECTION_CACHING) &&
      (point.m_contactPointFlags & BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED)) {
    setUserDirections(point, info.m_solverMode, out);
  } else {
    out.axes.rightCols<2>() = tangentsOf(point, n, anisotropy);
  }

  if (point.m_contactPointFlags & BT_CONTACT_FLAG_FRICTION_ANCHOR) {
    const Vec3 drift = toCore(point.getPositionWorldOnA()) - toCore(point.getPositionWorldOnB());
    const double rate = info.m_frictionERP / info.m_timeStep;
    out.motion1 -= rate * drift.dot(out.axes.col(1));
    out.motion2 -= rate * drift.dot(out.axes.col(2));
  }
  return out;
}

const ContactFrame& ContactFrames::of(const btManifoldPoint& point) {
  constexpr int beyondNormal =
      BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED | BT_CONTACT_FLAG_FRICTION_ANCHOR;
  const bool isPlain = (point.m_contactPointFlags & beyondNormal) == 0;
  if (isPlain && point.m_normalWorldOnB == normal_) return frame_;
  frame_ = contactFrame(point, anisotropy_, info_);
  normal_ = isPlain ? point.m_normalWorldOnB : btVector3(0, 0, 0);
  return frame_;
}

Eigen::Matrix<double, 3, 2> rollingAxes(const btManifoldPoint& point,
                                        const Anisotropy& anisotropy) {
  return tangentsOf(point, toCore(point.m_normalWorldOnB).normalized(), anisotropy);
}

}  // namespace delassus::bullet
