#pragma once

#include "tests/peers/contestant.h"

namespace delassus::peers {

/// What `delassus solve --tolerance` does, with a Solver that has solved nothing before.
Contestant ours(double tolerance);

}  // namespace delassus::peers
