#pragma once

#include <limits>

namespace delassus {

/// Adds to a count, which stops at the largest number instead of overflowing.
inline void addTo(int& sum, int more) {
  constexpr int most = std::numeric_limits<int>::max();
  sum = more > most - sum ? most : sum + more;
}

}  // namespace delassus
