#include "delassus/block_product.h"

#include "delassus/wide.h"

namespace delassus {
namespace {

using Four = double __attribute__((vector_size(32), aligned(8), may_alias));

DELASSUS_WIDE_INLINE const Four& fourAt(const double* x) {
  return *reinterpret_cast<const Four*>(x);
}
DELASSUS_WIDE_INLINE Four& fourAt(double* x) { return *reinterpret_cast<Four*>(x); }

// Twelve entries of two columns are three vectors of four: the first column's, both columns', the second's.

/// Six numbers, each four times or, where a vector belongs to two columns, twice.
struct Spread {
  Four first[3], both[3], second[3];

  DELASSUS_WIDE_INLINE explicit Spread(const double* x) {
    for (int pair = 0; pair < 3; ++pair) {
      const double left = x[2 * pair], right = x[2 * pair + 1];
      first[pair] = Four{left, left, left, left};
      both[pair] = Four{left, left, right, right};
      second[pair] = Four{right, right, right, right};
    }
  }
};

/// A x, the last two numbers in the first half of `end`.
DELASSUS_WIDE_INLINE void multiply(const double* A, const Spread& x, Four& begin, Four& end) {
  const Four upper =
      fourAt(A) * x.first[0] + fourAt(A + 12) * x.first[1] + fourAt(A + 24) * x.first[2];
  const Four middle =
      fourAt(A + 4) * x.both[0] + fourAt(A + 16) * x.both[1] + fourAt(A + 28) * x.both[2];
  const Four lower =
      fourAt(A + 8) * x.second[0] + fourAt(A + 20) * x.second[1] + fourAt(A + 32) * x.second[2];
  begin = upper + __builtin_shufflevector(middle, lower, 2, 3, 4, 5);
  end = middle + __builtin_shufflevector(lower, lower, 2, 3, 2, 3);
}

}  // namespace

DELASSUS_WIDE
void subtractProducts(const Mat6* blocks, const int* row, int count, const Mat6& B,
                      const int* place, Mat6* to) {
  const double* b = B.data();
  for (int i = 0; i < count; ++i) {
    const double* a = blocks[i].data();
    auto* out = reinterpret_cast<Four*>(to[place[row[i]]].data());
    Four sum[9];
    for (int v = 0; v < 9; ++v) sum[v] = out[v];
    for (int k = 0; k < 6; ++k, a += 6) {
      const Four upper = fourAt(a), lower = fourAt(a + 2);
      const Four both = __builtin_shufflevector(lower, upper, 2, 3, 4, 5);
      for (int pair = 0; pair < 3; ++pair) {
        const double left = b[6 * k + 2 * pair], right = b[6 * k + 2 * pair + 1];
        sum[3 * pair] -= upper * Four{left, left, left, left};
        sum[3 * pair + 1] -= both * Four{left, left, right, right};
        sum[3 * pair + 2] -= lower * Four{right, right, right, right};
      }
    }
    for (int v = 0; v < 9; ++v) out[v] = sum[v];
  }
}

DELASSUS_WIDE
void solveLower(const BlockColumns& L, double* z) {
  for (int j = 0; j < L.columns; ++j) {
    const Spread x(z + paddedSize * j);
    for (int at = L.begin[j]; at < L.begin[j + 1]; ++at) {
      Four begin, end;
      multiply(L.blocks[at].data(), x, begin, end);
      double* to = z + paddedSize * L.row[at];
      fourAt(to) -= begin;
      fourAt(to + 4) -= end;
    }
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
    Four sum[3];  // of two columns: two halves of each
    for (int pair = 0; pair < 3; ++pair)
      sum[pair] = __builtin_shufflevector(first[pair], second[pair], 0, 1, 4, 5) +
                  __builtin_shufflevector(first[pair], second[pair], 2, 3, 6, 7) + both[pair];
    begin -= __builtin_shufflevector(sum[0], sum[1], 0, 2, 4, 6) +
             __builtin_shufflevector(sum[0], sum[1], 1, 3, 5, 7);
    end -= __builtin_shufflevector(sum[2], sum[2], 0, 2, 0, 2) +
           __builtin_shufflevector(sum[2], sum[2], 1, 3, 1, 3);
    fourAt(x) = begin;
    fourAt(x + 4) = end;
    multiply(inverseD[j].data(), Spread(x), begin, end);
    fourAt(x) = begin;
    fourAt(x + 4) = end;
  }
}

}  // namespace delassus
