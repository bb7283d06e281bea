#pragma once

#include <chrono>
#include <utility>

#include "demos/scenes/solver_decorator.h"

namespace demos {

/// Measures the time that another solver spends in solveGroup.
class TimedSolver : public SolverDecorator {
 public:
  using SolverDecorator::SolverDecorator;

  /// Seconds since the last call; those of one step, if it is called after each step.
  double takeSeconds() { return std::exchange(seconds_, 0); }

 protected:
  void beforeGroup(const GroupInput&) override { begin_ = Clock::now(); }
  void afterGroup(const GroupInput&) override {
    seconds_ += std::chrono::duration<double>(Clock::now() - begin_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_;
  double seconds_ = 0;
};

}  // namespace demos
