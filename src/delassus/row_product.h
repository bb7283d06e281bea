#pragma once

#include "delassus/types.h"

namespace delassus {

/// Three rows of entries, `stride` apart, times the first n numbers of r: two columns at a time, so
/// that each number of r is read once.
inline Vec3 timesRows(const double* rows, int stride, const double* r, int n) {
  using Two = Eigen::Map<const Vec2>;
  const double *first = rows, *second = rows + stride, *third = rows + 2 * stride;
  Vec2 a = Vec2::Zero(), b = a, c = a;
  int k = 0;
  for (; k + 1 < n; k += 2) {
    const Vec2 two = Two(r + k);
    a += Two(first + k).cwiseProduct(two);
    b += Two(second + k).cwiseProduct(two);
    c += Two(third + k).cwiseProduct(two);
  }
  Vec3 sum(a.sum(), b.sum(), c.sum());
  if (k < n) sum += r[k] * Vec3(first[k], second[k], third[k]);
  return sum;
}

}  // namespace delassus
