#pragma once

#include "delassus/types.h"
#include "delassus/wide.h"

namespace delassus {

/// Two numbers at a time, for the products below: every method that goes from contact to contact,
/// or along joints, spends much of its time on them. The two partial sums of a row are added up
/// once for both bodies, not once for each.
using Pair = double __attribute__((vector_size(16), aligned(8), may_alias));

/// One row J̃, with six columns for each of its two bodies. An index below 0 means no body.
struct ScalarRow {
  int a, b;
  Row6 Ja, Jb;

  /// J̃ y
  DELASSUS_WIDE_INLINE double relativeVelocity(const VectorXd& y) const {
    Pair sum = {};
    if (a >= 0) add(Ja, y.data() + 6 * a, sum);
    if (b >= 0) add(Jb, y.data() + 6 * b, sum);
    return sum[0] + sum[1];
  }

  /// y += J̃ᵀ r
  DELASSUS_WIDE_INLINE void addImpulse(double r, VectorXd& y) const {
    if (a >= 0) add(Ja, r, y.data() + 6 * a);
    if (b >= 0) add(Jb, r, y.data() + 6 * b);
  }

 private:
  DELASSUS_WIDE_INLINE static void add(const Row6& J, const double* y, Pair& sum) {
    const auto* row = reinterpret_cast<const Pair*>(J.data());
    const auto* of = reinterpret_cast<const Pair*>(y);
    for (int k = 0; k < 3; ++k) sum += row[k] * of[k];
  }

  DELASSUS_WIDE_INLINE static void add(const Row6& J, double r, double* y) {
    const auto* row = reinterpret_cast<const Pair*>(J.data());
    auto* to = reinterpret_cast<Pair*>(y);
    for (int k = 0; k < 3; ++k) to[k] += row[k] * r;
  }
};

/// The three rows J̃ of a contact.
struct ContactRows {
  int a, b;
  Mat36 Ja, Jb;

  /// J̃ y
  DELASSUS_WIDE_INLINE Vec3 relativeVelocity(const VectorXd& y) const {
    Pair sum[3] = {};
    if (a >= 0) add(Ja, y.data() + 6 * a, sum);
    if (b >= 0) add(Jb, y.data() + 6 * b, sum);
    return {sum[0][0] + sum[0][1], sum[1][0] + sum[1][1], sum[2][0] + sum[2][1]};
  }

  /// y += J̃ᵀ r
  DELASSUS_WIDE_INLINE void addImpulse(const Vec3& r, VectorXd& y) const {
    const Pair twice[3] = {{r[0], r[0]}, {r[1], r[1]}, {r[2], r[2]}};
    if (a >= 0) add(Ja, twice, y.data() + 6 * a);
    if (b >= 0) add(Jb, twice, y.data() + 6 * b);
  }

 private:
  DELASSUS_WIDE_INLINE static void add(const Mat36& J, const double* y, Pair (&sum)[3]) {
    const auto* row = reinterpret_cast<const Pair*>(J.data());
    const auto* of = reinterpret_cast<const Pair*>(y);
    for (int k = 0; k < 3; ++k, row += 3)
      sum[k] += row[0] * of[0] + row[1] * of[1] + row[2] * of[2];
  }

  DELASSUS_WIDE_INLINE static void add(const Mat36& J, const Pair (&r)[3], double* y) {
    const auto* row = reinterpret_cast<const Pair*>(J.data());
    auto* to = reinterpret_cast<Pair*>(y);
    for (int k = 0; k < 3; ++k) to[k] += row[k] * r[0] + row[k + 3] * r[1] + row[k + 6] * r[2];
  }
};

}  // namespace delassus
