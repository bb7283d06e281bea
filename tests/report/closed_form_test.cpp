// The mechanics with which the report compares, judged by laws that its own code does not use.
#include "demos/report/closed_form.h"

#include <gtest/gtest.h>

#include <cmath>

namespace demos::report {
namespace {

constexpr double gravity = 9.81;

/// Speed by central differences.
template <class Motion>
double speedAt(const Motion& motion, double t) {
  constexpr double dt = 1e-4;
  const Plane a = motion(t - dt), b = motion(t + dt);
  return std::hypot(b.x - a.x, b.y - a.y) / (2 * dt);
}

TEST(BallOffBall, KeepsItsEnergyOnTheBallAndInTheAir) {
  const double start = 0.05;
  const auto motion = [&](double t) { return ballOffBallAt(t, 1, start); };
  for (const double t : {0.3, 0.6, 0.9, 1.2, 1.5}) {
    const double v = speedAt(motion, t);
    EXPECT_NEAR(v * v / 2 + gravity * motion(t).y, gravity * std::cos(start), 1e-5) << t;
  }
}

TEST(BallOffBall, LeavesAtTwoThirdsOfItsHeight) {
  const double start = 0.05;
  // On the ball the distance is one; it is never less.
  for (double t = 0.01; t < 2; t += 0.01) {
    const Plane p = ballOffBallAt(t, 1, start);
    const double distance = std::hypot(p.x, p.y);
    if (p.y > 2.0 / 3 * std::cos(start))
      EXPECT_NEAR(distance, 1, 1e-12) << t;
    else
      EXPECT_GT(distance, 1) << t;
  }
}

TEST(SlidingLadder, KeepsItsEnergyOnTheWall) {
  // ½ m L² (1 + j) θ'² + m g L sin θ, with |v| = L |θ'| as long as both ends slide.
  const double start = 1.3, j = 1.0 / 3;
  const auto motion = [&](double t) { return slidingLadderAt(t, 1, start, j); };
  for (const double t : {0.1, 0.2, 0.3}) {
    const Plane p = motion(t);
    ASSERT_GT(p.y, 2.0 / 3 * std::sin(start)) << t;
    const double v = speedAt(motion, t);
    EXPECT_NEAR((1 + j) * v * v / 2 + gravity * p.y, gravity * std::sin(start), 1e-5) << t;
  }
}

TEST(SlidingLadder, MovesOnWithConstantSpeedFromTheWall) {
  const double start = 1.3, j = 1.0 / 3;
  const auto x = [&](double t) { return slidingLadderAt(t, 1, start, j).x; };
  double left = 0.1;
  while (slidingLadderAt(left, 1, start, j).y > 2.0 / 3 * std::sin(start)) left += 0.01;
  const double dt = 0.02;
  EXPECT_NEAR(x(left + 2 * dt) - x(left + dt), x(left + dt) - x(left), 1e-9);
  // Before it left the wall it gained speed all the time.
  EXPECT_LT(x(left - 0.1) - x(left - 0.1 - dt), x(left - 0.05) - x(left - 0.05 - dt));
}

TEST(Incline, MovesOnlyAboveTheFrictionAngle) {
  EXPECT_EQ(inclineWay(1, std::atan(0.5) - 0.01, 0.5), 0);
  EXPECT_NEAR(inclineWay(2, 0.5, 0), 2 * gravity * std::sin(0.5), 1e-12);
}

}  // namespace
}  // namespace demos::report
