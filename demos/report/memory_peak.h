#pragma once

#include "demos/scenes/solver_decorator.h"

namespace demos::report {

/// The resident memory that another solver comes to need while it solves a group: its highest, not
/// its last.
class MemoryPeak : public SolverDecorator {
 public:
  using SolverDecorator::SolverDecorator;

  /// Of the hungriest group so far; NaN where the system does not tell. A few pages are its grain.
  double bytes() const { return peak_; }

 protected:
  void beforeGroup(const GroupInput&) override;
  void afterGroup(const GroupInput&) override;

 private:
  double before_ = 0, peak_ = 0;
};

}  // namespace demos::report
