#pragma once

#include "tests/support/box_piles.h"
#include "tests/support/random_problems.h"

namespace delassus::test {

/// Spheres of 1 kg and diameter 1 m, poured into a square bin of that side and pressed a little
/// into each other. There are as many contacts as motions, and many wedged places. One step of
/// gravity at 60 Hz, penetrations to be recovered at a fifth a step, and random velocities of up to
/// `disturbance` m/s (rad/s).
Pile makeSphereHeap(int count, double side, double friction, double disturbance, Random& random);

}  // namespace delassus::test
