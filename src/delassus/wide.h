#pragma once
/// Before a function: it is compiled once more for wider processors, and the right one is taken
/// when a program starts. The same operations in the same order, so the same bits. What chooses
/// runs before a thread sanitizer does, and is instrumented all the same: it would crash.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define DELASSUS_WIDE __attribute__((target_clones("avx2", "default")))
// And that a function may be made for such a processor alone.
#define DELASSUS_HAS_AVX2
#else
#define DELASSUS_WIDE
#endif
/// Before what such a function calls, so that it is as wide.
#define DELASSUS_WIDE_INLINE __attribute__((always_inline)) inline
