#pragma once

namespace demos::report::stability {

/// Centre-line radius of `buildArch`, m.
constexpr double archRadius = 5;

/// Least thickness at which a semicircular arch of an even number of equal voussoirs stands, m,
/// sliding left out (Heyman's safe theorem): horizontal thrust H at height y of the crown's joint,
/// and in every joint the thrust within its ends.
double leastArchThickness(int voussoirs, double radius);

}  // namespace demos::report::stability
