/// Walls of the regions along straight lines.
#include "delassus/wall.h"

#include <gtest/gtest.h>

#include <cmath>

#include "delassus/active_set.h"
#include "delassus/cone.h"
#include "tests/support/random_problems.h"

namespace delassus {
namespace {

/// The mode by `reactionTo`, also without friction, where every closed contact slides.
Mode modeAt(const Vec3& z, double mu) {
  if (z[0] <= 0) return Mode::Open;
  return mu > 0 && lengthOf(z[1], z[2]) <= mu * z[0] ? Mode::Stick : Mode::Slide;
}

/// Goes along a line from wall to wall, and looks a little before and behind each wall.
TEST(Wall, ModesOfAContactChangeThereAndNowhereElse) {
  Random random(5);
  int walls = 0, most = 0;
  for (int k = 0; k < 20000; ++k) {
    const double size = std::pow(10.0, uniform(random, -6, 6));
    const double mu = k % 7 == 0 ? 0 : uniform(random, 0, 2);
    const Vec3 z = size * normalVector(3, random), d = normalVector(3, random);
    double at = 0;
    int met = 0;
    for (;; ++met) {
      const double wall = nextWall(z, d, mu, at);
      const double end = std::isinf(wall) ? at + 100 * size : wall;
      const Mode mode = modeAt(z + (at + 1e-9 * (end - at)) * d, mu);
      for (int step = 1; step < 20; ++step)
        ASSERT_EQ(modeAt(z + (at + 0.05 * step * (end - at)) * d, mu), mode) << "line " << k;
      if (std::isinf(wall)) break;
      ASSERT_GT(wall, at);
      ASSERT_LT(met, 4) << "line " << k;  // z_n = 0 once, the cone twice
      if (wall - at > 1e-6 * size) {
        ASSERT_NE(modeAt(z + (1 + 1e-7) * wall * d, mu), mode) << "line " << k;
        ++walls;
      }
      at = wall;
    }
    most = std::max(most, met);
  }
  EXPECT_GT(walls, 10000);
  EXPECT_EQ(most, 3);
}

TEST(Wall, WhatDoesNotMoveMeetsNone) {
  EXPECT_EQ(nextWall(Vec3(1, 2, 3), Vec3::Zero(), 0.5, 0), infinity);
  EXPECT_EQ(nextWall(Vec3::Zero(), Vec3::Zero(), 0.5, 0), infinity);
  EXPECT_EQ(nextWall(1, 0, 0, infinity, 0), infinity);
  EXPECT_EQ(nextWall(0, 0, 0, 0, 0), infinity);
}

TEST(Wall, ARowMeetsItsBounds) {
  EXPECT_EQ(nextWall(3, -1, 0, infinity, 0), 3);
  EXPECT_EQ(nextWall(3, 1, 0, infinity, 0), infinity);
  EXPECT_EQ(nextWall(3, 1, -infinity, infinity, 0), infinity);
  EXPECT_EQ(nextWall(-1, 2, 0, 4, 0), 0.5);
  EXPECT_EQ(nextWall(-1, 2, 0, 4, 0.5), 2.5);
}

}  // namespace
}  // namespace delassus
