#pragma once

#include "delassus/problem.h"

namespace delassus {

/// Few contacts for the motions of its bodies, and so little self-stress: spheres, not boxes.
bool isHeap(const Problem& problem);

/// Boxes: a patch is as hard as the whole, and regions are dear.
bool isLargePile(const Problem& problem);

}  // namespace delassus
