#pragma once
/// Vectors and matrices shared by the whole core. Double precision always; frames are normal first.

#include <Eigen/Core>
#include <limits>

#include "delassus/kept_vector.h"

namespace delassus {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat2 = Eigen::Matrix2d;
using Mat3 = Eigen::Matrix3d;
using Mat23 = Eigen::Matrix<double, 2, 3>;
using Vec6 = Eigen::Matrix<double, 6, 1>;  ///< linear part first, then angular
using Row6 = Eigen::Matrix<double, 1, 6>;
/// Row-major: J̃ᵀ r and J̃ᵀ G J̃ are computed along the rows, several numbers at a time.
using Mat36 = Eigen::Matrix<double, 3, 6, Eigen::RowMajor>;
using Mat6 = Eigen::Matrix<double, 6, 6>;
using VectorXd = KeptVector;  ///< not Eigen's own: it keeps its storage, and copies its entries
using MatrixXd = Eigen::MatrixXd;

/// Index of the fixed world where a body index is expected.
constexpr int fixedWorld = -1;

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace delassus
