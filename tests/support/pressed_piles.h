#pragma once
/// Piles between walls that come together.

#include "tests/support/random_piles.h"

namespace delassus::test {

/// A tower of boxes whose floor rises and whose ceiling, tilted by so much, comes down at that
/// speed. Its corners alone touch.
Pile makePressed(int height, double friction, double tilt, double disturbance, double speed,
                 Random& random);

}  // namespace delassus::test
