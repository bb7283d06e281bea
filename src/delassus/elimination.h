#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "delassus/types.h"

namespace delassus {

/// Beside the largest pivot, one so small is none.
constexpr double negligiblePivot = 1e-10;

/// K x = b with at most `Most` unknowns by Gaussian elimination, rows exchanged. For so few, what a library does to be fast for many
/// takes most of the time.
template <int Most>
class Elimination {
 public:
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, Most, Most>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, Most, 1>;

  /// x in b; K is used up. False if K is singular.
  static bool solve(Matrix& K, Vector& b) {
    const int n = static_cast<int>(b.size());
    double least = 0, largest = 0;
    for (int k = 0; k < n; ++k) {
      const int left = n - k - 1;
      int pivot = k;
      for (int i = k + 1; i < n; ++i)
        if (std::abs(K(i, k)) > std::abs(K(pivot, k))) pivot = i;
      if (pivot != k) {
        for (int j = k; j < n; ++j) std::swap(K(k, j), K(pivot, j));
        std::swap(b[k], b[pivot]);
      }
      const double size = std::abs(K(k, k));
      if (!(size > 0)) return false;
      least = k == 0 ? size : std::min(least, size);
      largest = std::max(largest, size);
      K.col(k).tail(left) *= 1 / K(k, k);
      const auto column = K.col(k).tail(left);
      for (int j = k + 1; j < n; ++j)
        if (K(k, j) != 0) K.col(j).tail(left) -= K(k, j) * column;
      b.tail(left) -= b[k] * column;
    }
    for (int k = n - 1; k >= 0; --k) {
      b[k] /= K(k, k);
      b.head(k) -= b[k] * K.col(k).head(k);
    }
    return least > negligiblePivot * largest;
  }
};

/// The same for any number of unknowns.
template <>
class Elimination<Eigen::Dynamic> {
 public:
  using Matrix = MatrixXd;
  using Vector = VectorXd;

  bool solve(const Matrix& K, Vector& b) {
    lu_.compute(K);
    const auto pivots = lu_.matrixLU().diagonal().cwiseAbs();
    if (!(pivots.minCoeff() > negligiblePivot * pivots.maxCoeff())) return false;
    b = lu_.solve(b).eval();
    return true;
  }

 private:
  Eigen::PartialPivLU<MatrixXd> lu_;
};

}  // namespace delassus
