#pragma once

#ifdef __SSE__
#include <xmmintrin.h>
#else
#include <cfenv>
#endif

namespace delassus {

/// As long as it lives, no operation of this thread on numbers traps, and none leaves a trace in
/// the flags: here x/0 is a wall that is met nowhere, and what a user has asked his processor to
/// stop at is in his own code.
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
