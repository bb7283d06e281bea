#pragma once

#include <Eigen/Core>
#include <cmath>

namespace delassus::test {

/// Vectors along x and z, the plane of the ground.
using Vector2 = Eigen::Vector2d;
using Matrix2 = Eigen::Matrix2d;

/// diag(fx, fz) in axes turned by `yaw` about y, on the (x, z) plane.
inline Matrix2 stretch(double fx, double fz, double yaw) {
  Matrix2 R;
  R << std::cos(yaw), std::sin(yaw), -std::sin(yaw), std::cos(yaw);
  return R * Vector2(fx, fz).asDiagonal() * R.transpose();
}

}  // namespace delassus::test
