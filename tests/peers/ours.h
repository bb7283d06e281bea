#pragma once

#include "tests/peers/contestant.h"

namespace delassus::peers {

/// Solves as `delassus solve` does, from nothing; stops on a measure of its own, as the peers do.
Contestant ours(double ownTolerance);
/// The same, with the problem given in another form: `own`.
Contestant oursOn(const Problem& own, double ownTolerance);

}  // namespace delassus::peers
