#pragma once

#include <cmath>

namespace delassus {

/// √(x² + y²). std::hypot takes five times as long; it is used only where the squares leave the
/// range of numbers.
inline double lengthOf(double x, double y) {
  constexpr double smallest = 1e-280, largest = 1e300;
  if (x == 0) return std::abs(y);
  const double squares = x * x + y * y;
  return squares > smallest && squares < largest ? std::sqrt(squares) : std::hypot(x, y);
}

}  // namespace delassus
