#include "demos/report/closed_form.h"

#include <algorithm>
#include <cmath>

namespace demos::report {

namespace {

constexpr double gravity = 9.81;
constexpr int substeps = 20000;  // of Runge and Kutta's fourth order: exact to 1e-12 here

/// An angle and its rate.
struct Turn {
  double angle, rate;
};

/// One step of length h of angle'' = acceleration(angle, rate).
template <class Acceleration>
Turn rungeKutta(const Turn& t, double h, const Acceleration& acceleration) {
  const auto slope = [&](const Turn& s) { return Turn{s.rate, acceleration(s.angle, s.rate)}; };
  const auto ahead = [&](const Turn& k, double step) {
    return Turn{t.angle + step * k.angle, t.rate + step * k.rate};
  };
  const Turn k1 = slope(t), k2 = slope(ahead(k1, h / 2)), k3 = slope(ahead(k2, h / 2)),
             k4 = slope(ahead(k3, h));
  return {t.angle + h / 6 * (k1.angle + 2 * k2.angle + 2 * k3.angle + k4.angle),
          t.rate + h / 6 * (k1.rate + 2 * k2.rate + 2 * k3.rate + k4.rate)};
}

/// Steps `turn` until `left(angle)` changes its sign or `time` is over; the last step ends there.
/// Returns the time passed.
template <class Acceleration, class Left>
double follow(Turn& turn, double time, const Acceleration& acceleration, const Left& left) {
  const double h = time / substeps;
  for (int i = 0; i < substeps; ++i) {
    const Turn next = rungeKutta(turn, h, acceleration);
    if (left(next.angle) < 0) {
      // The event lies within this step; bisection finds its place in it.
      double share = 0;
      for (double width = 0.5; width > 1e-16; width /= 2)
        if (left(rungeKutta(turn, (share + width) * h, acceleration).angle) >= 0) share += width;
      turn = rungeKutta(turn, share * h, acceleration);
      return (i + share) * h;
    }
    turn = next;
  }
  return time;
}

}  // namespace

Plane ballOffBallAt(double time, double distance, double startAngle) {
  Turn turn{startAngle, 0};
  const double leaves = 2.0 / 3 * std::cos(startAngle);
  const double passed = follow(
      turn, time, [&](double angle, double) { return gravity / distance * std::sin(angle); },
      [&](double angle) { return std::cos(angle) - leaves; });
  const double t = time - passed, speed = distance * turn.rate;
  return {distance * std::sin(turn.angle) + speed * std::cos(turn.angle) * t,
          distance * std::cos(turn.angle) - speed * std::sin(turn.angle) * t - gravity * t * t / 2};
}

Plane slidingLadderAt(double time, double halfLength, double startAngle, double inertiaRatio) {
  const double L = halfLength, j = inertiaRatio;
  Turn turn{startAngle, 0};
  const double leaves = 2.0 / 3 * std::sin(startAngle);
  const double passed = follow(
      turn, time, [&](double angle, double) { return -gravity * std::cos(angle) / (L * (1 + j)); },
      [&](double angle) { return std::sin(angle) - leaves; });
  const double x = L * std::cos(turn.angle), speed = -L * std::sin(turn.angle) * turn.rate;
  const double t = time - passed;
  if (t > 0)
    follow(
        turn, t,
        [&](double angle, double rate) {
          const double c = std::cos(angle), s = std::sin(angle);
          return c * (s * rate * rate - gravity / L) / (j + c * c);
        },
        [](double) { return 1.0; });
  return {x + speed * t, L * std::sin(turn.angle)};
}

double inclineWay(double time, double angle, double mu) {
  const double acceleration = gravity * (std::sin(angle) - mu * std::cos(angle));
  return std::max(0.0, acceleration) * time * time / 2;
}

}  // namespace demos::report
