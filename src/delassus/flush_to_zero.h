#pragma once

#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace delassus {

/// As long as it lives, this thread takes numbers below the smallest normal one for zero, if the
/// processor can (x86). In single precision, changes that die out get there (1e-38, and squares of
/// 1e-19), where each operation costs a hundred cycles and more.
class FlushToZero {
 public:
#ifdef __SSE__
  FlushToZero() : before_(_mm_getcsr()) { _mm_setcsr(before_ | results | operands); }
  ~FlushToZero() { _mm_setcsr(before_); }
#else
  FlushToZero() = default;
  ~FlushToZero() = default;
#endif
  FlushToZero(const FlushToZero&) = delete;
  FlushToZero& operator=(const FlushToZero&) = delete;

#ifdef __SSE__
 private:
  static constexpr unsigned results = 0x8000, operands = 0x0040;  // bits of the control word
  unsigned before_;
#endif
};

}  // namespace delassus
