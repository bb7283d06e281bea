#include "demos/report/stability/arch_limit.h"

#include <algorithm>
#include <cmath>

namespace demos::report::stability {

namespace {

/// For a thrust H, the joints of the half arch bound G = H y; returns the room between the tightest
/// bounds. With k voussoirs of unit weight above a joint at φ from the vertical, their centre at x,
/// the thrust passes at radius ρ of the joint where
///
///     k (ρ sin φ − x) + H ρ cos φ = G
double room(int voussoirs, double inner, double outer, double thrust) {
  const double angle = M_PI / voussoirs;
  // A voussoir is the trapezium between two rays.
  const double low = inner * std::cos(angle / 2), high = outer * std::cos(angle / 2);
  const double centre = low + (high - low) / 3 * (low + 2 * high) / (low + high);
  double least = thrust * inner, most = thrust * outer, moment = 0;
  for (int k = 1; k <= voussoirs / 2; ++k) {
    moment += centre * std::sin((k - 0.5) * angle);
    const double lever = k * std::sin(k * angle) + thrust * std::cos(k * angle);
    least = std::max(least, inner * lever - moment);
    most = std::min(most, outer * lever - moment);
  }
  return most - least;
}

bool stands(int voussoirs, double radius, double thickness) {
  const double inner = radius - thickness / 2, outer = radius + thickness / 2;
  // The room is concave in the thrust: takes thirds of an interval that contains its maximum.
  double from = 0, to = voussoirs;
  for (int i = 0; i < 200; ++i) {
    const double third = (to - from) / 3;
    if (room(voussoirs, inner, outer, from + third) < room(voussoirs, inner, outer, to - third))
      from += third;
    else
      to -= third;
  }
  return room(voussoirs, inner, outer, (from + to) / 2) >= 0;
}

}  // namespace

double leastArchThickness(int voussoirs, double radius) {
  double falls = 0, standing = radius;
  for (int i = 0; i < 100; ++i) {
    const double middle = (falls + standing) / 2;
    (stands(voussoirs, radius, middle) ? standing : falls) = middle;
  }
  return standing;
}

}  // namespace demos::report::stability
