#pragma once

namespace demos::report {

/// Where a body's centre is in its plane, m.
struct Plane {
  double x, y;
};

/// A frictionless ball on a fixed one, `distance` between their centres, at rest at `startAngle`
/// from the vertical at t = 0:
///
///     θ'' = (g / distance) sin θ,  until cos θ = 2/3 cos(startAngle), then free flight
Plane ballOffBallAt(double time, double distance, double startAngle);

/// A rod sliding down a frictionless wall and floor, centre at L (cos θ, sin θ) from rest at
/// `startAngle`:
///
///     (m L² + I) θ'' = −m g L cos θ,  until sin θ = 2/3 sin(startAngle),
///
/// then with constant x' on the floor alone:  (I + m L² cos²θ) θ'' = m L cos θ (L sin θ θ'² − g).
/// `inertiaRatio` is I/(m L²). Good until the rod lies flat.
Plane slidingLadderAt(double time, double halfLength, double startAngle, double inertiaRatio);

/// Way of a box that starts from rest on a slope of `angle` with friction μ: ½ g (sin − μ cos) t²,
/// or 0 if that is less.
double inclineWay(double time, double angle, double mu);

}  // namespace demos::report
