#pragma once

#include <string>
#include <vector>

#include "demos/scenes/step_totals.h"

namespace demos {

/// Something that a scene may ask for, how often this one does in a step, and what is made for it.
struct Need {
  std::string key, name;
  double aStep;
  std::string therefore;
};
std::vector<Need> needsOf(const StepTotals& totals);

/// A part of a step, its cost, and the work done in that time.
struct Cost {
  std::string key, name;
  double microseconds;
  std::string work;
};
std::vector<Cost> costsOf(const StepTotals& totals);

/// Needs and costs as text for a person.
std::string explain(const StepTotals& totals);

}  // namespace demos
