#pragma once

#include <string>
#include <vector>

#include "demos/scenes/step_totals.h"

namespace demos {

/// Something that scenes may ask for, how often this one does in a step, and what exists for it
/// therefore.
struct Need {
  std::string key, name;
  double aStep;
  std::string therefore;
};
std::vector<Need> needsOf(const StepTotals& totals);

/// A part of a step, what it cost and what was done in that time.
struct Cost {
  std::string key, name;
  double microseconds;
  std::string work;
};
std::vector<Cost> costsOf(const StepTotals& totals);

/// Both as a person reads them.
std::string explain(const StepTotals& totals);

}  // namespace demos
