#pragma once

#include "demos/scenes/solver_decorator.h"

namespace demos::report {

/// The most resident memory that another solver adds at any time while it solves a group.
class MemoryPeak : public SolverDecorator {
 public:
  using SolverDecorator::SolverDecorator;

  /// That of the hungriest group so far; NaN where the system does not tell. It is exact to a few
  /// pages.
  double bytes() const { return peak_; }

 protected:
  void beforeGroup(const GroupInput&) override;
  void afterGroup(const GroupInput&) override;

 private:
  double before_ = 0, peak_ = 0;
};

}  // namespace demos::report
