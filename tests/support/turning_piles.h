#pragma once
/// Piles whose contacts resist rolling and spinning.

#include "delassus/turning_friction.h"
#include "tests/support/box_piles.h"
#include "tests/support/random_problems.h"

namespace delassus::test {

TurningFriction aboutTangents(const Contact& c, double spinning, double rolling);

/// Lets some contacts of the pile resist rolling, some spinning, some both, some neither.
void resistTurning(Pile& pile, double largest, Random& random);

/// Balls of radius ½ thrown together, all on the ground; contacts along the lines of centres.
Pile makeHeap(int balls, double friction, Random& random);

}  // namespace delassus::test
