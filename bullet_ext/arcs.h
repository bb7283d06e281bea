#pragma once

#include "delassus/row.h"

namespace delassus::bullet {

struct Group;

/// Whether the row is about an axis: it does not see how its bodies go.
bool turns(const Row& row);

/// States rows about an axis as rows along an arc of radius ℓ, so that all rows are in m/s and N·s:
///
///     J ← ℓ J,  target ← ℓ target,  bounds ← bounds/ℓ,  compliance ← ℓ² compliance,  κ ← κ/ℓ
///     ℓ² = Σ m⁻¹ / Σ a·I⁻¹a      over the row's bodies, without linear and angular factors
///
/// ℓ is the bodies' radius of gyration about the axis a, so that the row responds as one along an
/// axis does. Of a constraint of articulated bodies, m are the masses of its links, and W_ii stands
/// for Σ a·I⁻¹a. Searches compare answers by their largest error: were it rad/s of one row and m/s
/// of another, small bodies would rather fall than turn.
///
/// Call it once all rows are gathered. Fills Group::arcs.
void stateAlongArcs(Group& group);

}  // namespace delassus::bullet
