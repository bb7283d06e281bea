#pragma once

#include <stdexcept>

namespace demos {

/// The user pressed Ctrl-C: what is finished is kept.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

/// While one lives, Ctrl-C and a polite kill end the work at the next call of `throwIfAsked`
/// instead of the process.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  static bool asked();
  static void throwIfAsked();
};

}  // namespace demos
