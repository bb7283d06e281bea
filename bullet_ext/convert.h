#pragma once
/// All conversions between Bullet's types, in the library's precision, and the core's, in double.

#include "LinearMath/btMatrix3x3.h"
#include "LinearMath/btVector3.h"
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

}  // namespace delassus::bullet
