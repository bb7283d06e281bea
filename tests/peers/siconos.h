#pragma once

#include "tests/peers/contestant.h"

namespace delassus::peers {

/// The general solvers of Siconos' numerics (INRIA, Apache-2.0) for contact with Coulomb friction,
/// with their own settings but for tolerance, iterations and, in NSGS, the local solver.
std::vector<Peer> siconosSolvers();

/// One thread for the BLAS that Siconos calls, as for our solver.
void useOneThread();

}  // namespace delassus::peers
