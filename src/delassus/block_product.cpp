#include "delassus/block_product.h"

#include "delassus/four.h"
#include "delassus/wide.h"

namespace delassus {
namespace {

// The twelve entries of two columns are three vectors of four: one of the first column, one of both
// columns, one of the second.

/// Six numbers, each four times, or twice in vectors that belong to two columns.
struct Spread {
  Four first[3], both[3], second[3];

  Spread() = default;
  DELASSUS_WIDE_INLINE explicit Spread(const double* x) {
    for (int pair = 0; pair < 3; ++pair) {
      const double left = x[2 * pair], right = x[2 * pair + 1];
      first[pair] = Four{left, left, left, left};
      both[pair] = Four{left, left, right, right};
      second[pair] = Four{right, right, right, right};
    }
  }
};

/// The columns of a block.
struct SpreadColumns {
  Spread of[6];

  /// In place: they are larger than a copy is worth.
  DELASSUS_WIDE_INLINE void take(const Mat6& B) {
    for (int k = 0; k < 6; ++k) of[k] = Spread(B.data() + 6 * k);
  }
};

/// A x, for an x whose numbers after the first `pairs` pairs are zero. The last two numbers of the
/// product are in the first half of `end`.
template <int pairs = 3>
DELASSUS_WIDE_INLINE void multiply(const double* A, const Spread& x, Four& begin, Four& end) {
  Four upper = fourAt(A) * x.first[0], middle = fourAt(A + 4) * x.both[0],
       lower = fourAt(A + 8) * x.second[0];
  for (int pair = 1; pair < pairs; ++pair) {
    const double* a = A + 12 * pair;
    upper += fourAt(a) * x.first[pair];
    middle += fourAt(a + 4) * x.both[pair];
    lower += fourAt(a + 8) * x.second[pair];
  }
  begin = upper + __builtin_shufflevector(middle, lower, 2, 3, 4, 5);
  end = middle + __builtin_shufflevector(lower, lower, 2, 3, 2, 3);
}

/// A block while products are added to it.
struct Sum {
  Four part[9];

  // One by one: in a loop the compiler would first copy the block, and then read the copy.
  DELASSUS_WIDE_INLINE explicit Sum(const double* x)
      : part{fourAt(x),      fourAt(x + 4),  fourAt(x + 8),  fourAt(x + 12), fourAt(x + 16),
             fourAt(x + 20), fourAt(x + 24), fourAt(x + 28), fourAt(x + 32)} {}
  DELASSUS_WIDE_INLINE void store(double* x) const {
    for (int v = 0; v < 9; ++v) fourAt(x + 4 * v) = part[v];
  }

  /// Subtracts A Bᵀ.
  DELASSUS_WIDE_INLINE void subtract(const double* a, const SpreadColumns& B) {
#pragma GCC unroll 1  // sums stay in registers
    for (int k = 0; k < 6; ++k, a += 6) {
      const Spread& b = B.of[k];
      const Four upper = fourAt(a), lower = fourAt(a + 2);
      const Four both = __builtin_shufflevector(lower, upper, 2, 3, 4, 5);
      for (int pair = 0; pair < 3; ++pair) {
        part[3 * pair] -= upper * b.first[pair];
        part[3 * pair + 1] -= both * b.both[pair];
        part[3 * pair + 2] -= lower * b.second[pair];
      }
    }
  }

  /// Adds aᵀ b for two rows; `upper` has all numbers of a but the last two, `lower` all but the
  /// first two. (To spread b out would take longer for one product than the product itself.)
  DELASSUS_WIDE_INLINE void addRow(const Four& upper, const Four& lower, const double* b) {
    const Four both = __builtin_shufflevector(lower, upper, 2, 3, 4, 5);
    for (int pair = 0; pair < 3; ++pair) {
      const double l = b[2 * pair], r = b[2 * pair + 1];
      const Four left{l, l, l, l}, right{r, r, r, r};
      part[3 * pair] += upper * left;
      part[3 * pair + 1] += both * __builtin_shufflevector(left, right, 0, 1, 6, 7);
      part[3 * pair + 2] += lower * right;
    }
  }
};

/// z −= L_j x for the blocks of column j.
DELASSUS_WIDE_INLINE void subtractColumn(const BlockColumns& L, int j, const Spread& x, double* z) {
  for (int at = L.begin[j]; at < L.begin[j + 1]; ++at) {
    Four begin, end;
    multiply(L.blocks[at].data(), x, begin, end);
    double* to = z + paddedSize * L.row[at];
    fourAt(to) -= begin;
    fourAt(to + 4) -= end;
  }
}

/// Replaces a column of A by A x.
template <int pairs>
DELASSUS_WIDE_INLINE void replaceColumn(double* A, const Spread& x, int column) {
  Four begin, end;
  multiply<pairs>(A, x, begin, end);
  double* to = A + 6 * column;
  fourAt(to) = begin;
  to[4] = end[0];
  to[5] = end[1];
}

/// x ← A x.
DELASSUS_WIDE_INLINE void multiplyInPlace(const Mat6& A, double* x) {
  Four begin, end;
  multiply(A.data(), Spread(x), begin, end);
  fourAt(x) = begin;
  fourAt(x + 4) = end;
}

}  // namespace

DELASSUS_WIDE
void multiplyRows(const Mat3* const* G, const Mat36* const* J, int count, Mat36* products) {
  for (int k = 0; k < count; ++k) {
    const double *g = G[k]->data(), *j = J[k]->data();  // g: by columns
    double* to = products[k].data();
    const Four begin[3] = {fourAt(j), fourAt(j + 6), fourAt(j + 12)};
    const Four end[3] = {fourAt(j + 2), fourAt(j + 8), fourAt(j + 14)};
    for (int i = 0; i < 3; ++i, to += 6) {
      fourAt(to) = g[i] * begin[0] + g[i + 3] * begin[1] + g[i + 6] * begin[2];
      fourAt(to + 2) = g[i] * end[0] + g[i + 3] * end[1] + g[i + 6] * end[2];
    }
  }
}

DELASSUS_WIDE
void addProducts(const Mat36* const* A, const Mat36* const* B, int count, Mat6& to) {
  Sum sum(to.data());
#pragma GCC unroll 1
  for (int k = 0; k < count; ++k) {
    const double *a = A[k]->data(), *b = B[k]->data();
#pragma GCC unroll 1
    for (int row = 0; row < 3; ++row, a += 6, b += 6) sum.addRow(fourAt(a), fourAt(a + 2), b);
  }
  sum.store(to.data());
}

DELASSUS_WIDE
void addRowProducts(const double* a, const double* b, int stride, const double* weight, int count,
                    Mat6& to) {
  Sum sum(to.data());
#pragma GCC unroll 1
  for (int k = 0; k < count; ++k, a += stride, b += stride)
    sum.addRow(weight[k] * fourAt(a), weight[k] * fourAt(a + 2), b);
  sum.store(to.data());
}

DELASSUS_WIDE
void multiplyBy(const Mat6& B, Mat6* blocks, int count) {
  SpreadColumns columns;
  columns.take(B);
  for (int i = 0; i < count; ++i) {
    double* a = blocks[i].data();
    Four begin[6], end[6];
    for (int k = 0; k < 6; ++k) multiply(a, columns.of[k], begin[k], end[k]);
    for (int k = 0; k < 6; ++k) {
      fourAt(a + 6 * k) = begin[k];
      a[6 * k + 4] = end[k][0];
      a[6 * k + 5] = end[k][1];
    }
  }
}

DELASSUS_WIDE
void multiplyByUpper(const Mat6& B, Mat6* blocks, int count) {
  SpreadColumns columns;
  columns.take(B);
  for (int i = 0; i < count; ++i) {
    // From the last column to the first: the later ones are not read again.
    double* a = blocks[i].data();
    replaceColumn<3>(a, columns.of[5], 5);
    replaceColumn<3>(a, columns.of[4], 4);
    replaceColumn<2>(a, columns.of[3], 3);
    replaceColumn<2>(a, columns.of[2], 2);
    replaceColumn<1>(a, columns.of[1], 1);
    replaceColumn<1>(a, columns.of[0], 0);
  }
}

DELASSUS_WIDE
void subtractProducts(const BlockSource* sources, int columns, const int* row, int count,
                      const int* place, Mat6* diagonal, Mat6* to) {
  SpreadColumns spread[mostSources];
  for (int j = 0; j < columns; ++j) spread[j].take(*sources[j].B);
  for (int i = diagonal ? 0 : 1; i < count; ++i) {
    double* at = i == 0 ? diagonal->data() : to[place[row[i]]].data();
    Sum sum(at);
    for (int j = 0; j < columns; ++j) sum.subtract(sources[j].blocks[i].data(), spread[j]);
    sum.store(at);
  }
}

DELASSUS_WIDE
void solveLower(const BlockColumns& L, double* z) {
  for (int j = 0; j < L.columns; ++j) subtractColumn(L, j, Spread(z + paddedSize * j), z);
}

DELASSUS_WIDE
void solveLower(const BlockColumns& L, const Mat6* inverseC, double* z) {
  for (int j = 0; j < L.columns; ++j) {
    multiplyInPlace(inverseC[j], z + paddedSize * j);
    subtractColumn(L, j, Spread(z + paddedSize * j), z);
  }
}

DELASSUS_WIDE
void solveLower(const BlockColumns& L, const Mat6* inverseC, char* touched, double* z) {
  for (int j = 0; j < L.columns; ++j) {
    if (!touched[j]) continue;
    multiplyInPlace(inverseC[j], z + paddedSize * j);
    const Spread x(z + paddedSize * j);
    for (int at = L.begin[j]; at < L.begin[j + 1]; ++at) {
      Four begin, end;
      multiply(L.blocks[at].data(), x, begin, end);
      const int row = L.row[at];
      double* to = z + paddedSize * row;
      fourAt(to) = touched[row] ? fourAt(to) - begin : -begin;
      fourAt(to + 4) = touched[row] ? fourAt(to + 4) - end : -end;
      touched[row] = 1;
    }
  }
}

DELASSUS_WIDE
void addSquares(const double* const* y, const int* at, int count, double* scratch,
                double* const* W) {
  const int width = (count + 3) / 4 * 4;
  double* const sums = scratch + 6 * width;
  for (int k = 0; k < 6; ++k) {
    double* const entries = scratch + k * width;
    for (int j = 0; j < count; ++j) entries[j] = y[j][k];
    for (int j = count; j < width; ++j) entries[j] = 0;
  }
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j <= i; j += 4) {
      Four sum = y[i][0] * fourAt(scratch + j);
      for (int k = 1; k < 6; ++k) sum += y[i][k] * fourAt(scratch + k * width + j);
      fourAt(sums + j) = sum;
    }
    double* const row = W[at[i]];
    for (int j = 0; j <= i; ++j) row[at[j]] += sums[j];
  }
}

DELASSUS_WIDE
void solveUpper(const BlockColumns& U, const Mat6* inverseD, double* z) {
  for (int j = U.columns - 1; j >= 0; --j) {
    double* x = z + paddedSize * j;
    Four begin = fourAt(x), end = fourAt(x + 4);
    Four first[3] = {}, both[3] = {}, second[3] = {};
    for (int at = U.begin[j]; at < U.begin[j + 1]; ++at) {
      const double* a = U.blocks[at].data();
      const double* from = z + paddedSize * U.row[at];
      const Four upper = fourAt(from), rest = fourAt(from + 4);
      const Four middle = __builtin_shufflevector(rest, upper, 0, 1, 4, 5);
      const Four lower = __builtin_shufflevector(upper, rest, 2, 3, 4, 5);
      for (int pair = 0; pair < 3; ++pair, a += 12) {
        first[pair] += fourAt(a) * upper;
        both[pair] += fourAt(a + 4) * middle;
        second[pair] += fourAt(a + 8) * lower;
      }
    }
    Four sum[3];  // of two columns, with two parts each
    for (int pair = 0; pair < 3; ++pair)
      sum[pair] = __builtin_shufflevector(first[pair], second[pair], 0, 1, 4, 5) +
                  __builtin_shufflevector(first[pair], second[pair], 2, 3, 6, 7) + both[pair];
    begin -= __builtin_shufflevector(sum[0], sum[1], 0, 2, 4, 6) +
             __builtin_shufflevector(sum[0], sum[1], 1, 3, 5, 7);
    end -= __builtin_shufflevector(sum[2], sum[2], 0, 2, 0, 2) +
           __builtin_shufflevector(sum[2], sum[2], 1, 3, 1, 3);
    fourAt(x) = begin;
    fourAt(x + 4) = end;
    multiplyInPlace(inverseD[j], x);
  }
}

}  // namespace delassus
