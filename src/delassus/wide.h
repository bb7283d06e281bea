#pragma once
/// A function with this prefix is compiled once more for wider processors; the right version is
/// chosen when a program starts. Both do the same operations in the same order, so the bits are the
/// same. Not with a thread sanitizer: the code that chooses is instrumented, but runs before the
/// sanitizer is ready, and would crash.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define DELASSUS_WIDE __attribute__((target_clones("avx2", "default")))
// A function may also be compiled for such processors alone.
#define DELASSUS_HAS_AVX2
#else
#define DELASSUS_WIDE
#endif
/// For functions that such a function calls, so that they are compiled for the same processor.
#define DELASSUS_WIDE_INLINE __attribute__((always_inline)) inline
