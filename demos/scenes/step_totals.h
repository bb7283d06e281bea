#pragma once

#include "bullet_ext/step_report.h"

namespace demos {

/// Sums over the steps of a run: what they asked for, what was done for it, and how long that took.
struct StepTotals {
  int steps = 0;
  delassus::StepReport sum;  ///< the plan, counts of work and seconds; nothing else is summed

  void add(const delassus::StepReport& report);
  double aStep(double total) const { return steps > 0 ? total / steps : 0; }
};

}  // namespace demos
