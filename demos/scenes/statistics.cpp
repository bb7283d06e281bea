#include "demos/scenes/statistics.h"

#include <algorithm>
#include <cmath>

namespace demos {

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::nan("");
  const auto place = values.begin() + std::lround(share * double(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

double largerOf(double a, double b) { return std::isnan(a) || a > b ? a : b; }

}  // namespace demos
