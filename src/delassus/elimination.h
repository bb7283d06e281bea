#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "delassus/bytes.h"
#include "delassus/kept_matrix.h"
#include "delassus/types.h"

namespace delassus {

/// A pivot below this share of the largest counts as zero.
constexpr double negligiblePivot = 1e-10;

/// K x = b with at most `Most` unknowns by Gaussian elimination with row exchanges. For so few
/// unknowns, the set-up that makes a library fast for many takes most of the time.
template <int Most>
class Elimination {
 public:
  /// Rows have one length, whatever n is, so that loops go over `atATime` columns at once; unused
  /// entries are zero.
  static constexpr int atATime = 4, width = (Most + atATime - 1) / atATime * atATime;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, width, Eigen::RowMajor, Most, width>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, Most, 1>;

  /// Replaces b by x and overwrites K. False if K is singular.
  static bool solve(Matrix& K, Vector& b) {
    const int n = static_cast<int>(b.size());
    double least = 0, largest = 0;
    std::array<double, Most> perPivot;
    for (int k = 0; k < n; ++k) {
      int pivot = k;
      double size = std::abs(K(k, k));
      for (int i = k + 1; i < n; ++i)
        if (const double other = std::abs(K(i, k)); other > size) size = other, pivot = i;
      if (pivot != k) {
        K.row(k).swap(K.row(pivot));
        std::swap(b[k], b[pivot]);
      }
      if (!(size > 0)) return false;
      least = k == 0 ? size : std::min(least, size);
      largest = std::max(largest, size);
      perPivot[k] = 1 / K(k, k);
      clearBelow<width>(k, perPivot[k], K, b);
    }
    // Column by column: none of these sums waits for another.
    for (int k = n - 1; k >= 0; --k) {
      b[k] *= perPivot[k];
      for (int i = 0; i < k; ++i) b[i] -= K(i, k) * b[k];
    }
    return least > negligiblePivot * largest;
  }

 private:
  /// Subtracts multiples of the pivot row k from the rows below, in the columns from `first` on:
  /// the entries up to the pivot are not read again.
  template <int columns>
  static void clearBelow(int k, double perPivot, Matrix& K, Vector& b) {
    const int n = static_cast<int>(b.size()), first = k / atATime * atATime;
    if constexpr (columns > atATime)
      if (n - first <= columns - atATime) return clearBelow<columns - atATime>(k, perPivot, K, b);
    // A copy: to the compiler rows might overlap, and it would read this one again for each.
    const Eigen::Matrix<double, 1, columns> pivotRow = K.row(k).template segment<columns>(first);
    for (int i = k + 1; i < n; ++i) {
      const double share = K(i, k) * perPivot;
      if (share == 0) continue;
      K.row(i).template segment<columns>(first) -= share * pivotRow;
      b[i] -= share * b[k];
    }
  }
};

/// The same for any number of unknowns, by blocks of four pivots, whose rows are subtracted from
/// the others all at once. The factor is kept.
template <>
class Elimination<Eigen::Dynamic> {
 public:
  using Matrix = KeptMatrix;
  using Vector = VectorXd;

  /// K is copied. False if it is singular.
  bool factorise(const Matrix& K);
  /// Replaces b by x.
  void solve(Vector& b);
  std::size_t bytes() const { return factors_.bytes() + bytesOf(rows_, order_, ordered_); }

 private:
  KeptMatrix factors_;         ///< each row has its entries of U, then those of L
  std::vector<double*> rows_;  ///< in the order of their pivots
  std::vector<int> order_;     ///< pivot -> row of K
  VectorXd ordered_;           ///< a right-hand side in that order
};

}  // namespace delassus
