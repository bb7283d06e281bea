#pragma once

#include <stdexcept>

namespace demos {

/// The user pressed Ctrl-C: what is finished is kept.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

/// While one lives, Ctrl-C or a polite kill does not end the process: it ends the work, at the next
/// call of `throwIfAsked`.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  static bool asked();
  static void throwIfAsked();

 private:
  void (*beforeInterrupt_)(int);
  void (*beforeTerminate_)(int);
};

}  // namespace demos
