#pragma once

#include "delassus/problem.h"

namespace delassus {

/// What a problem is like to solve, told from its counts alone: n contacts, m rows, b bodies.
///
/// Few contacts for the motions of its bodies, and so little self-stress: what is unsettled can be
/// mended by patches. More than 20 contacts, no more rows than these, W in body space, and
///
///     n ≤ 3 b   (spheres),   n > 1000:  n ≤ 6 b   (boxes that tumble, too: their regions cost more
///                                                than what patches leave undone)
///
/// Not boxes at rest, which have 8 b contacts, and not where joints prevail: what sweeps pass along
/// a chain body by body, a region knows at once.
bool isHeap(const Problem& problem);
/// A heap of more than 600 contacts, whose regions are dear: each costs a hundred sweeps or more.
bool isLargeHeap(const Problem& problem);

/// No heap, and more than 200 contacts and rows: boxes at rest above all, of which a patch is as
/// hard as the whole; but whatever else is large, too: mechanisms, and explicit W.
bool isLargeButNoHeap(const Problem& problem);

}  // namespace delassus
