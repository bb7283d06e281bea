#pragma once

#include "tests/peers/contestant.h"

namespace delassus::peers {

/// What `delassus solve` does, from nothing; it stops on a measure of its own, as the peers do.
Contestant ours(double ownTolerance);
/// The same, given the problem in another form: as `own`.
Contestant oursOn(const Problem& own, double ownTolerance);

}  // namespace delassus::peers
