#pragma once

#include "tests/peers/contestant.h"

namespace delassus::peers {

/// The general solvers for contact with Coulomb friction of Siconos' numerics (INRIA, Apache-2.0),
/// with their own settings except tolerance, iterations and, in NSGS, the local solver.
std::vector<Peer> siconosSolvers();

/// Has the BLAS that Siconos calls use one thread, as our solver does.
void useOneThread();

}  // namespace delassus::peers
