#pragma once

#include "delassus/problem.h"

namespace delassus {

/// Few contacts for the motions of its bodies, and so little self-stress: spheres, and of thousands
/// of contacts, whose regions cost more than what patches leave undone, tumbling boxes too; not
/// boxes at rest, and not where joints prevail: what sweeps pass along a chain body by body, a
/// region knows at once.
bool isHeap(const Problem& problem);
/// One whose regions are dear: each costs hundreds of sweeps.
bool isLargeHeap(const Problem& problem);

/// Boxes at rest: a patch is as hard as the whole, and regions are dear.
bool isLargePile(const Problem& problem);

}  // namespace delassus
