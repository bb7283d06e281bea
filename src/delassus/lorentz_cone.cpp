#include "delassus/lorentz_cone.h"

#include <algorithm>
#include <cmath>

namespace delassus {
namespace {

/// x ∘ y in the Jordan algebra of the cone.
Vec3 product(const Vec3& x, const Vec3& y) {
  return {x.dot(y), x[0] * y[1] + y[0] * x[1], x[0] * y[2] + y[0] * x[2]};
}

/// c with x ∘ c = b.
Vec3 quotient(const Vec3& x, const Vec3& b) {
  const double tail = std::hypot(x[1], x[2]);
  const double c = (x[0] * b[0] - x[1] * b[1] - x[2] * b[2]) / ((x[0] - tail) * (x[0] + tail));
  return {c, (b[1] - c * x[1]) / x[0], (b[2] - c * x[2]) / x[0]};
}

/// √(x_0² − ‖x_1‖²) for x in the interior of the cone.
double cornerDistance(const Vec3& x) {
  const double tail = std::hypot(x[1], x[2]);
  return std::sqrt(std::max((x[0] - tail) * (x[0] + tail), 1e-300));
}

}  // namespace

namespace lorentz {

double longestStep(const Vec3& x, const Vec3& d) {
  const double a = d[0] * d[0] - d[1] * d[1] - d[2] * d[2];
  const double b = x[0] * d[0] - x[1] * d[1] - x[2] * d[2];
  const double corner = cornerDistance(x), c = corner * corner;
  // The first positive root of a t² + 2 b t + c, if there is one.
  const double discriminant = b * b - a * c;
  double t = infinity;
  if (a < 0) {
    t = c / (-b + std::sqrt(std::max(discriminant, 0.0)));
    if (b > 0) t = (b + std::sqrt(std::max(discriminant, 0.0))) / -a;
  } else if (b < 0 && discriminant >= 0) {
    t = c / (-b + std::sqrt(discriminant));
  }
  if (d[0] < 0) t = std::min(t, -x[0] / d[0]);
  return t;
}

}  // namespace lorentz

void LorentzPair::scale() {
  const double cornerX = cornerDistance(x), cornerY = cornerDistance(y);
  const Vec3 unitX = x / cornerX, unitY = y / cornerY;
  const double gamma = std::sqrt(0.5 * (1 + unitX.dot(unitY)));
  const Vec3 w = Vec3(unitX[0] + unitY[0], unitX[1] - unitY[1], unitX[2] - unitY[2]) / (2 * gamma);
  const double beta = std::sqrt(cornerX / cornerY);
  const Vec3 v = Vec3(w[0] + 1, w[1], w[2]) / std::sqrt(2 * (w[0] + 1));
  const Vec3 jv(v[0], -v[1], -v[2]);
  const Vec3 jw(w[0], -w[1], -w[2]);
  const Vec3 J(1, -1, -1);
  scaling = 2 * beta * v * v.transpose();
  scaling -= (beta * J).asDiagonal().toDenseMatrix();
  inverse = (2 / beta) * jv * jv.transpose();
  inverse -= (J / beta).asDiagonal().toDenseMatrix();
  scaled = scaling * y;
  softness = 2 * jw * jw.transpose();
  softness.diagonal() -= J;
  softness /= beta * beta;
}

void LorentzPair::aim(double tau, bool corrector) {
  // W⁻¹ (λ \ (τ e − λ ∘ λ)), in the form that keeps its digits at the boundary of the cone.
  const double corner = cornerDistance(x);
  shift = (tau / (corner * corner)) * Vec3(x[0], -x[1], -x[2]) - y;
  if (corrector) shift -= inverse * quotient(scaled, product(inverse * dx, scaling * dy));
}

void LorentzPair::follow(const Vec3& step) {
  dx = step;
  dy = shift - inverse * (inverse * dx);
}

}  // namespace delassus
