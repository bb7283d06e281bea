#pragma once

#include <vector>

namespace demos {

/// The value that lies `share` of the way from the least to the largest by rank, rounded to the
/// nearest existing one. NaN if there are none.
double quantile(std::vector<double> values, double share);
/// For an even number of values, the upper one of the two in the middle.
double median(std::vector<double> values);

/// The larger one; NaN if either is. std::max would keep whichever of the two comes first.
double largerOf(double a, double b);

}  // namespace demos
