#pragma once

namespace demos::report::stability {

/// Centre-line radius of `buildArch`, m.
constexpr double archRadius = 5;

/// Least thickness at which a semicircular arch of an even number of equal voussoirs stands, m,
/// without regard to sliding. By Heyman's safe theorem it stands if a horizontal thrust H at height
/// y of the crown's joint leaves the thrust within the ends of every joint.
double leastArchThickness(int voussoirs, double radius);

}  // namespace demos::report::stability
