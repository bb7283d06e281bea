#pragma once
/// All conversions between Bullet's types, in the library's precision, and the core's, in double.

#include "BulletCollision/NarrowPhaseCollision/btManifoldPoint.h"
#include "LinearMath/btMatrix3x3.h"
#include "LinearMath/btVector3.h"
#include "delassus/active_set.h"
#include "delassus/types.h"

namespace delassus::bullet {

inline Vec3 toCore(const btVector3& v) { return {v[0], v[1], v[2]}; }

inline Mat3 toCore(const btMatrix3x3& m) {
  Mat3 out;
  for (int i = 0; i < 3; ++i) out.row(i) = toCore(m[i]).transpose();
  return out;
}

inline Vec6 toCore(const btVector3& linear, const btVector3& angular) {
  Vec6 out;
  out << toCore(linear), toCore(angular);
  return out;
}

template <class Derived>
btVector3 toBullet(const Eigen::MatrixBase<Derived>& v) {
  static_assert(Derived::SizeAtCompileTime == 3);
  return {static_cast<btScalar>(v[0]), static_cast<btScalar>(v[1]), static_cast<btScalar>(v[2])};
}

/// A bound on an impulse. Bullet's users write "no bound" as the build's largest number, or as any
/// number that is large enough.
inline double toCoreBound(btScalar bound) {
  if (bound >= BT_LARGE_FLOAT) return infinity;
  if (bound <= -BT_LARGE_FLOAT) return -infinity;
  return bound;
}

/// The mode a contact point had after the last solve.
///
/// It is kept in the point's m_prevRHS. Bullet carries that number along with the impulses when it
/// replaces, moves or saves a point, and clears it in a new point; only the articulated solver
/// reads it.
inline Mode rememberedMode(const btManifoldPoint& point) {
  if (point.m_prevRHS == static_cast<btScalar>(Mode::Stick)) return Mode::Stick;
  if (point.m_prevRHS == static_cast<btScalar>(Mode::Slide)) return Mode::Slide;
  return Mode::Open;
}

inline void rememberMode(btManifoldPoint& point, Mode mode) {
  point.m_prevRHS = static_cast<btScalar>(mode);
}

}  // namespace delassus::bullet
