#include "delassus/elimination.h"

#include "delassus/four.h"
#include "delassus/wide.h"

namespace delassus {
namespace {

constexpr int atATime = KeptMatrix::atATime;

/// Subtracts multiples of four pivot rows from `count` others, from column `first` on. The four
/// factors of a row are its last entries of L, behind its `stride` numbers.
DELASSUS_WIDE_INLINE void subtractRows(double* const* pivots, double* const* rows, int count,
                                       int first, int stride) {
  int i = 0;
  const auto sharesOf = [&](int row) { return rows[row] + stride + first - atATime; };
  for (; i + 1 < count; i += 2) {
    const double *s = sharesOf(i), *t = sharesOf(i + 1);
    double *const one = rows[i], *const other = rows[i + 1];
    for (int c = first; c < stride; c += atATime) {
      Four a = fourAt(one + c), b = fourAt(other + c);
      for (int k = 0; k < atATime; ++k) {
        const Four& from = fourAt(pivots[k] + c);
        a -= s[k] * from;
        b -= t[k] * from;
      }
      fourAt(one + c) = a;
      fourAt(other + c) = b;
    }
  }
  if (i == count) return;
  const double* s = sharesOf(i);
  for (int c = first; c < stride; c += atATime) {
    Four a = fourAt(rows[i] + c);
    for (int k = 0; k < atATime; ++k) a -= s[k] * fourAt(pivots[k] + c);
    fourAt(rows[i] + c) = a;
  }
}

/// L U = K by rows of `stride` numbers, zero after the n-th; the entries of L follow them. False if
/// K is singular.
DELASSUS_WIDE
bool eliminate(double** row, int* order, int n, int stride) {
  double least = infinity, largest = 0;
  for (int begin = 0; begin < n; begin += atATime) {
    const int end = std::min(begin + atATime, n);
    // Within the columns of these pivots. The entries to the left of a pivot are not read again.
    for (int k = begin; k < end; ++k) {
      int pivot = k;
      double size = std::abs(row[k][k]);
      for (int i = k + 1; i < n; ++i)
        if (const double other = std::abs(row[i][k]); other > size) size = other, pivot = i;
      if (!(size > 0)) return false;
      std::swap(row[k], row[pivot]);
      std::swap(order[k], order[pivot]);
      least = std::min(least, size);
      largest = std::max(largest, size);
      const double perPivot = 1 / row[k][k];
      const Four from = fourAt(row[k] + begin);
      for (int i = k + 1; i < n; ++i) {
        const double share = row[i][k] * perPivot;
        row[i][stride + k] = share;
        fourAt(row[i] + begin) -= share * from;
      }
    }
    if (end == n) break;
    // In the columns after them: first the pivot rows themselves, then the others.
    for (int k = begin + 1; k < end; ++k)
      for (int j = begin; j < k; ++j)
        for (int c = end; c < stride; c += atATime)
          fourAt(row[k] + c) -= row[k][stride + j] * fourAt(row[j] + c);
    subtractRows(row + begin, row + end, n - end, end, stride);
  }
  return least > negligiblePivot * largest;
}

}  // namespace

bool Elimination<Eigen::Dynamic>::factorise(const Matrix& K) {
  const auto n = static_cast<int>(K.rows());
  const auto stride = static_cast<int>(K.outerStride());
  factors_.resize(n, 2 * stride);
  rows_.resize(n);
  order_.resize(n);
  for (int i = 0; i < n; ++i) {
    rows_[i] = &factors_(i, 0);
    order_[i] = i;
    std::copy_n(&K(i, 0), n, rows_[i]);
    std::fill(rows_[i] + n, rows_[i] + stride, 0.0);
  }
  return eliminate(rows_.data(), order_.data(), n, stride);
}

void Elimination<Eigen::Dynamic>::solve(Vector& b) {
  const auto n = static_cast<int>(rows_.size());
  const auto stride = static_cast<int>(factors_.cols()) / 2;
  ordered_.resize(n);
  for (int i = 0; i < n; ++i) ordered_[i] = b[order_[i]];
  // Column by column: none of these sums waits for another.
  for (int k = 0; k < n; ++k)
    for (int i = k + 1; i < n; ++i) ordered_[i] -= rows_[i][stride + k] * ordered_[k];
  for (int k = n - 1; k >= 0; --k) {
    ordered_[k] /= rows_[k][k];
    for (int i = 0; i < k; ++i) ordered_[i] -= rows_[i][k] * ordered_[k];
  }
  b = ordered_;
}

}  // namespace delassus
