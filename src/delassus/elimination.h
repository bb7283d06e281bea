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
  /// Rows of one length, whatever n is, so that loops over them are of fixed length; what is not used is zero.
  static constexpr int width = (Most + 1) / 2 * 2;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, width, Eigen::RowMajor, Most, width>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, Most, 1>;

  /// x in b; K is used up. False if K is singular.
  static bool solve(Matrix& K, Vector& b) {
    const int n = static_cast<int>(b.size());
    double least = 0, largest = 0;
    for (int k = 0; k < n; ++k) {
      int pivot = k;
      for (int i = k + 1; i < n; ++i)
        if (std::abs(K(i, k)) > std::abs(K(pivot, k))) pivot = i;
      if (pivot != k) {
        K.row(k).swap(K.row(pivot));
        std::swap(b[k], b[pivot]);
      }
      const double size = std::abs(K(k, k));
      if (!(size > 0)) return false;
      least = k == 0 ? size : std::min(least, size);
      largest = std::max(largest, size);
      const double perPivot = 1 / K(k, k);
      for (int i = k + 1; i < n; ++i) {
        const double share = K(i, k) * perPivot;
        if (share == 0) continue;
        // All of the row, a loop of fixed length: what is left of the pivot is not read again.
        K.row(i) -= share * K.row(k);
        b[i] -= share * b[k];
      }
    }
    for (int k = n - 1; k >= 0; --k) {
      double sum = b[k];
      for (int j = k + 1; j < n; ++j) sum -= K(k, j) * b[j];
      b[k] = sum / K(k, k);
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
