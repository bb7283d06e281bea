#include "delassus/block_inverse.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "delassus/four.h"
#include "delassus/wide.h"

namespace delassus {
namespace {

/// Six rows of six numbers, the last two in the first half of `end`. They become the rows of the
/// inverse in place (Gauss and Jordan).
struct Rows {
  Four begin[6], end[6];

  DELASSUS_WIDE_INLINE explicit Rows(const double* x) {
    for (int i = 0; i < 6; ++i) {
      begin[i] = fourAt(x + 6 * i);
      end[i] = Four{x[6 * i + 4], x[6 * i + 5], 0, 0};
    }
  }
  DELASSUS_WIDE_INLINE void store(double* x) const {
    for (int i = 0; i < 6; ++i) {
      fourAt(x + 6 * i) = begin[i];
      x[6 * i + 4] = end[i][0];
      x[6 * i + 5] = end[i][1];
    }
  }

  DELASSUS_WIDE_INLINE bool areFinite() const {
    Four none = {};
    for (int i = 0; i < 6; ++i) none += 0 * begin[i] + 0 * end[i];
    return none[0] + none[1] + none[2] + none[3] == 0;
  }

  /// Clears all entries right of the diagonal, which must be finite.
  DELASSUS_WIDE_INLINE void keepLower() {
    const Four upTo[4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 1, 1, 0}, {1, 1, 1, 1}};
    for (int i = 0; i < 6; ++i) {
      begin[i] *= upTo[std::min(i, 3)];
      end[i] *= i < 4 ? Four{} : upTo[i - 4];
    }
  }

  DELASSUS_WIDE_INLINE void scale(int i, double by) {
    begin[i] *= by;
    end[i] *= by;
  }

  /// Clears column `at` below the pivot, and puts the column of L⁻¹ there instead, for a matrix L U
  /// with ones on the diagonal of L. Returns the pivot.
  template <int at>
  DELASSUS_WIDE_INLINE double eliminateBelow() {
    const double pivot = replace<at>(at, 1);
    const double perPivot = 1 / pivot;
    for (int i = at + 1; i < 6; ++i) {
      const double factor = perPivot * (at < 4 ? begin[i] : end[i])[at % 4];
      begin[i] -= factor * begin[at];
      end[i] -= factor * end[at];
      replace<at>(i, -factor);
    }
    return pivot;
  }

  /// Replaces column `at` by that of the inverse. Returns the pivot.
  template <int at>
  DELASSUS_WIDE_INLINE double eliminate() {
    const double pivot = replace<at>(at, 1);
    const double perPivot = 1 / pivot;
    begin[at] *= perPivot;
    end[at] *= perPivot;
    for (int i = 0; i < 6; ++i) {
      if (i == at) continue;
      const double factor = replace<at>(i, 0);
      begin[i] -= factor * begin[at];
      end[i] -= factor * end[at];
    }
    return pivot;
  }

 private:
  /// Writes `by` to this column of row i. Returns the number before.
  template <int column>
  DELASSUS_WIDE_INLINE double replace(int i, double by) {
    Four& part = column < 4 ? begin[i] : end[i];
    constexpr int at = column % 4;
    const double before = part[at];
    // To set one number alone, the compiler would write it to memory and read four back.
    part = __builtin_shufflevector(part, Four{by, by, by, by}, at == 0 ? 4 : 0, at == 1 ? 5 : 1,
                                   at == 2 ? 6 : 2, at == 3 ? 7 : 3);
    return before;
  }
};

/// Infinite pivots leave no trace in the inverse.
DELASSUS_WIDE_INLINE bool areFinite(const double (&pivots)[6]) {
  double none = 0;
  for (const double pivot : pivots) none += 0 * pivot;
  return none == 0;
}

/// Inverts without pivoting. False where that could cost digits. A symmetric positive matrix loses
/// none, and its pivots are no larger than its diagonal.
DELASSUS_WIDE_INLINE bool invertInOrder(const Mat6& A, Mat6& inverse, bool& isNegative) {
  constexpr double mostGrowth = 2;
  Rows rows(A.data());
  const double pivots[6] = {rows.eliminate<0>(), rows.eliminate<1>(), rows.eliminate<2>(),
                            rows.eliminate<3>(), rows.eliminate<4>(), rows.eliminate<5>()};
  isNegative = false;
  bool grows = false;
  for (int i = 0; i < 6; ++i) {
    grows |= !(std::abs(pivots[i]) <= mostGrowth * std::abs(A(i, i)));
    if (pivots[i] < 0) isNegative = !isNegative;
  }
  rows.store(inverse.data());
  return !grows && areFinite(pivots) && rows.areFinite();
}

/// Inverts by Gauss's elimination with partial pivoting of the columns. False if A is singular or
/// not finite.
DELASSUS_WIDE_INLINE bool invertPivoting(const Mat6& A, Mat6& inverse, bool& isNegative) {
  if (!A.allFinite()) return false;
  // Rows of [Aᵀ 1], that is columns of A. The 1 becomes A⁻ᵀ by rows, that is A⁻¹ by columns.
  constexpr int width = 12;
  double rows[6][width] = {};
  double* row[6];
  for (int i = 0; i < 6; ++i) {
    row[i] = rows[i];
    for (int k = 0; k < 6; ++k) rows[i][k] = A(k, i);
    rows[i][6 + i] = 1;
  }
  isNegative = false;
  for (int i = 0; i < 6; ++i) {
    int pivot = i;
    for (int k = i + 1; k < 6; ++k)
      if (std::abs(row[k][i]) > std::abs(row[pivot][i])) pivot = k;
    if (pivot != i) std::swap(row[i], row[pivot]), isNegative = !isNegative;
    if (row[i][i] < 0) isNegative = !isNegative;
    for (int k = i + 1; k < 6; ++k) {
      const double factor = row[k][i] / row[i][i];
      for (int v = 0; v < width; v += 4) fourAt(row[k] + v) -= factor * fourAt(row[i] + v);
    }
  }
  for (int i = 5; i >= 0; --i) {
    // The vectors of four begin within the left half and overwrite the rest of it.
    double own[6];
    for (int k = i; k < 6; ++k) own[k] = row[i][k];
    for (int k = i + 1; k < 6; ++k)
      for (int v = 4; v < width; v += 4) fourAt(row[i] + v) -= own[k] * fourAt(row[k] + v);
    for (int k = 6; k < width; ++k) row[i][k] /= own[i];
    for (int k = 0; k < 6; ++k) inverse(k, i) = row[i][6 + k];
  }
  return inverse.allFinite();
}

}  // namespace

DELASSUS_WIDE
bool invert(const Mat6& A, Mat6& inverse, bool& isNegative) {
  return invertInOrder(A, inverse, isNegative) || invertPivoting(A, inverse, isNegative);
}

DELASSUS_WIDE
bool invertCholesky(const Mat6& A, Mat6& inverseC, Mat6& transposed) {
  // A = L D Lᵀ, C⁻¹ = D^(-1/2) L⁻¹.
  Rows rows(A.data());
  const double pivots[6] = {rows.eliminateBelow<0>(), rows.eliminateBelow<1>(),
                            rows.eliminateBelow<2>(), rows.eliminateBelow<3>(),
                            rows.eliminateBelow<4>(), rows.eliminateBelow<5>()};
  for (int i = 0; i < 6; ++i) rows.scale(i, 1 / std::sqrt(pivots[i]));
  // Where a pivot is not positive, its root is not finite.
  if (!areFinite(pivots) || !rows.areFinite()) return false;
  rows.keepLower();
  rows.store(transposed.data());
  inverseC = transposed.transpose();
  return true;
}

}  // namespace delassus
