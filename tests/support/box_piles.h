#pragma once

#include <random>
#include <vector>

#include "delassus/island.h"

namespace delassus::test {

/// Bodies and contacts of one step, without Bullet.
struct Pile {
  std::vector<Body> bodies;
  std::vector<Contact> contacts;
  std::vector<Row> rows;
};

Body makeBox(double mass, double halfSize, const Vec6& velocity);

/// A point where the underside of body `above` rests on `below` (or the ground); n = z, up.
Contact makeRestingPoint(int above, int below, const Vec3& armAbove, const Vec3& armBelow,
                         double friction);

/// Turns body 0 at 1 rad/s about the vertical with at most 0.1 N·m·s.
Row makeWeakMotor();

/// A tower of unit boxes on the ground, each on four corners, after one step of gravity; `masses`
/// from the bottom up. Random velocities of up to `disturbance` m/s (rad/s) are added.
Pile makeTower(const std::vector<double>& masses, double friction, double disturbance,
               std::mt19937_64& random);

/// A square pyramid in 3D of base x base boxes. Each upper box lies on the four below it, with four
/// points a pair (quarters overlap).
Pile makePyramid(int base, double friction, double disturbance, double massRatio,
                 std::mt19937_64& random);

}  // namespace delassus::test
