#pragma once
/// Piles between walls that come together.

#include "tests/support/random_piles.h"

namespace delassus::test {

/// A tower of boxes between a floor that rises and a ceiling that comes down, both at `speed`. The
/// ceiling is tilted by `tilt`. Only the corners of the boxes touch.
Pile makePressed(int height, double friction, double tilt, double disturbance, double speed,
                 Random& random);

}  // namespace delassus::test
