#pragma once

#ifdef __SSE__
#include <xmmintrin.h>
#else
#include <cfenv>
#endif

namespace delassus {

/// As long as it lives, no arithmetic of this thread traps or leaves a trace in the flags. Here x/0
/// is harmless, a wall that is never met; the traps that a user has enabled are meant for his own
/// code.
class QuietArithmetic {
 public:
#ifdef __SSE__
  QuietArithmetic() : before_(_mm_getcsr()) { _mm_setcsr(before_ | masks); }
  ~QuietArithmetic() { _mm_setcsr(before_); }
#else
  QuietArithmetic() { std::feholdexcept(&before_); }
  ~QuietArithmetic() { std::fesetenv(&before_); }
#endif
  QuietArithmetic(const QuietArithmetic&) = delete;
  QuietArithmetic& operator=(const QuietArithmetic&) = delete;

 private:
#ifdef __SSE__
  static constexpr unsigned masks = 0x1f80;  // of all exceptions, in the control word
  unsigned before_;
#else
  std::fenv_t before_;
#endif
};

}  // namespace delassus
