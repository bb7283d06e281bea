#pragma once

#include "delassus/problem.h"

namespace delassus {

/// The kind of a problem, from its counts alone: n contacts, m rows, b bodies. Where n > 600, rows
/// of disks do not count. Of fewer contacts that resist rolling, sweeps and patches settle no heap
/// sooner than regions do.
///
/// A heap: few contacts for the motions of its bodies, and so little self-stress. Patches can mend
/// its unsettled parts. It has more than 20 contacts, no more rows than contacts, W in body space,
/// and
///
///     n ≤ 3 b   (spheres),   n > 1000:  n ≤ 6 b   (boxes that tumble, too: their regions cost more
///                                                than what patches leave undone)
///
/// Boxes at rest, with 8 b contacts, are no heap, and neither are problems with mostly joints:
/// along a chain, sweeps pass reactions on body by body, but a region gives them at once.
bool isHeap(const Problem& problem);
/// A heap of more than 600 contacts. Its regions are expensive: each costs a hundred sweeps or
/// more.
bool isLargeHeap(const Problem& problem);

/// No heap, and more than 200 contacts and rows: mainly boxes at rest, where patches help only if
/// few contacts are disturbed, but also other large problems: mechanisms, and explicit W.
bool isLargeButNoHeap(const Problem& problem);

}  // namespace delassus
