#include "delassus/block_product.h"

namespace delassus {
namespace {

using Four = double __attribute__((vector_size(32), aligned(8), may_alias));

}  // namespace

// What chooses between the clones runs before a thread sanitizer does, and is instrumented all the same: it would crash.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
__attribute__((target_clones("avx2", "default")))
#endif
void subtractProducts(const Mat6* blocks, const int* row, int count, const Mat6& B,
                      const int* place, Mat6* to) {
  const double* b = B.data();
  for (int i = 0; i < count; ++i) {
    const double* a = blocks[i].data();
    // Twelve entries of two columns are three vectors of four: the first column's, both columns', the second's.
    auto* out = reinterpret_cast<Four*>(to[place[row[i]]].data());
    Four sum[9];
    for (int v = 0; v < 9; ++v) sum[v] = out[v];
    for (int k = 0; k < 6; ++k, a += 6) {
      const Four upper = *reinterpret_cast<const Four*>(a);
      const Four lower = *reinterpret_cast<const Four*>(a + 2);
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

}  // namespace delassus
