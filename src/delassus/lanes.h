#pragma once

#include <cmath>
#include <cstring>

#include "delassus/wide.h"

namespace delassus {

/// Four single-precision numbers at once, as all processors can, or eight. Lanes do not mix, so the
/// results have the same bits with either.
using Lanes4 = float __attribute__((vector_size(16)));
using Lanes8 = float __attribute__((vector_size(32)));

/// Vectors are passed by address, never by value: how eight numbers are passed depends on the
/// processor that the caller was compiled for.
template <class V>
DELASSUS_WIDE_INLINE void load(const float* from, V& to) {
  std::memcpy(&to, from, sizeof(V));
}
template <class V>
DELASSUS_WIDE_INLINE void store(const V& from, float* to) {
  std::memcpy(to, &from, sizeof(V));
}
template <class V>
DELASSUS_WIDE_INLINE void squareRoot(const V& x, V& root) {
  for (unsigned k = 0; k < sizeof(V) / sizeof(float); ++k) root[k] = std::sqrt(x[k]);
}
/// Whether any flag, which is −1 or 0, is set.
template <class Flags>
DELASSUS_WIDE_INLINE bool any(const Flags& flags) {
  long long halves[sizeof(Flags) / sizeof(long long)], all = 0;
  std::memcpy(halves, &flags, sizeof(Flags));
  for (const long long half : halves) all |= half;
  return all != 0;
}

/// Turns rows into columns; with eight lanes, each half on its own.
DELASSUS_WIDE_INLINE void transpose(Lanes4& a, Lanes4& b, Lanes4& c, Lanes4& d) {
  const Lanes4 ab = __builtin_shufflevector(a, b, 0, 4, 1, 5);
  const Lanes4 cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
  const Lanes4 AB = __builtin_shufflevector(a, b, 2, 6, 3, 7);
  const Lanes4 CD = __builtin_shufflevector(c, d, 2, 6, 3, 7);
  a = __builtin_shufflevector(ab, cd, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
  c = __builtin_shufflevector(AB, CD, 0, 1, 4, 5);
  d = __builtin_shufflevector(AB, CD, 2, 3, 6, 7);
}
DELASSUS_WIDE_INLINE void transpose(Lanes8& a, Lanes8& b, Lanes8& c, Lanes8& d) {
  const Lanes8 ab = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
  const Lanes8 cd = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13);
  const Lanes8 AB = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
  const Lanes8 CD = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
  a = __builtin_shufflevector(ab, cd, 0, 1, 8, 9, 4, 5, 12, 13);
  b = __builtin_shufflevector(ab, cd, 2, 3, 10, 11, 6, 7, 14, 15);
  c = __builtin_shufflevector(AB, CD, 0, 1, 8, 9, 4, 5, 12, 13);
  d = __builtin_shufflevector(AB, CD, 2, 3, 10, 11, 6, 7, 14, 15);
}

/// Moves four numbers, from `offset` on, of each of the given places to lanes, and back: of[k] has
/// number k of all places.
DELASSUS_WIDE_INLINE void gather(const float* const* places, int offset, Lanes4* of) {
  for (int k = 0; k < 4; ++k) load(places[k] + offset, of[k]);
  transpose(of[0], of[1], of[2], of[3]);
}
DELASSUS_WIDE_INLINE void gather(const float* const* places, int offset, Lanes8* of) {
  for (int k = 0; k < 4; ++k) {
    Lanes4 low, high;
    load(places[k] + offset, low);
    load(places[k + 4] + offset, high);
    of[k] = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
  }
  transpose(of[0], of[1], of[2], of[3]);
}
DELASSUS_WIDE_INLINE void scatter(Lanes4* of, float* const* places, int offset) {
  transpose(of[0], of[1], of[2], of[3]);
  for (int k = 0; k < 4; ++k) store(of[k], places[k] + offset);
}
DELASSUS_WIDE_INLINE void scatter(Lanes8* of, float* const* places, int offset) {
  transpose(of[0], of[1], of[2], of[3]);
  for (int k = 0; k < 4; ++k) {
    const Lanes4 low = __builtin_shufflevector(of[k], of[k], 0, 1, 2, 3);
    const Lanes4 high = __builtin_shufflevector(of[k], of[k], 4, 5, 6, 7);
    store(low, places[k] + offset);
    store(high, places[k + 4] + offset);
  }
}

}  // namespace delassus
