#include "delassus/wall.h"

#include <cmath>

namespace delassus {

double nextWall(const Vec3& z, const Vec3& d, double mu, double after) {
  double first = infinity;
  const auto offer = [&first, after](double t) {
    if (t > after && t < first) first = t;
  };
  offer(-z[0] / d[0]);
  // ‖z_t + t d_t‖² = μ² (z_n + t d_n)²; both roots without a difference of nearly equal numbers
  const double a = d[1] * d[1] + d[2] * d[2] - mu * mu * d[0] * d[0];
  const double b = z[1] * d[1] + z[2] * d[2] - mu * mu * z[0] * d[0];
  const double c = z[1] * z[1] + z[2] * z[2] - mu * mu * z[0] * z[0];
  const double discriminant = b * b - a * c;
  if (mu > 0 && discriminant >= 0) {
    const double k = -(b + std::copysign(std::sqrt(discriminant), b));
    for (const double t : {k / a, c / k})
      if (z[0] + t * d[0] > 0) offer(t);
  }
  return first;
}

double nextWall(double z, double d, double lower, double upper, double after) {
  double first = infinity;
  for (const double bound : {lower, upper}) {
    const double t = (bound - z) / d;
    if (t > after && t < first) first = t;
  }
  return first;
}

}  // namespace delassus
