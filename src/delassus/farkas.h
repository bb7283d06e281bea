#pragma once

#include "delassus/problem.h"

namespace delassus {

/// Farkas' lemma: a proof that demands are incompatible, or that only a violent motion meets them.
///
/// Whatever friction does, contacts demand u_n ≥ 0, rows with one bound u ≥ 0 or u ≤ 0, and rows without bounds u = 0. Let r push
/// at such demands alone, in their sense. A motion v that meets them has 0 ≤ r·(J v + q), and therefore
///
///     |v|_M  ≥  −r·q / √(r·W r)
///
/// Kinetic energy ½|v|²_M; |v|_M in √J.

/// The problem of those demands alone: no tangents, no motors, no disks. Same unknowns.
Problem demandsAlone(const Problem& problem);

/// The right side: ∞ if r moves nothing, 0 if it proves nothing.
double leastMotion(const Problem& demands, const VectorXd& r);

/// |v|_M of the motion that meets the hardest of these demands if it is alone: max |q_i|/√W_ii.
double hardestAlone(const Problem& demands, const VectorXd& diagonal);

}  // namespace delassus
