#pragma once

#include <vector>

#include "delassus/body.h"
#include "delassus/contact.h"

namespace delassus::bullet {

// The exact answer may throw a body: what is pinched between faces that lean against each other by
// ε leaves them at 1/ε of what pinches it, and so does what a load presses that is off its line by
// ε. An island whose answer does so is solved again as if its contacts gave a little.

/// How many times as fast as all that asks for motion, or moved before, a body may leave: out of a
/// wedge of 11 degrees it does so exactly.
constexpr double reach = 10;

/// Has the contact give, in addition, by s' of what it answers if no axis of a body that moves is
/// locked, s' = 1/(2 reach²). With one such contact a face, what is pinched at the speed p leaves
/// at
///
///     p ε/(ε²/2 + s') ≤ p/√(2 s') = reach p
void soften(const std::vector<Body>& bodies, Contact& contact);

}  // namespace delassus::bullet
