#pragma once

#include <cstddef>
#include <vector>

#include "bullet_ext/gather.h"
#include "delassus/island.h"
#include "delassus/solver.h"

namespace delassus::bullet {

/// Split impulse: how the bodies have to be moved out of each other, as velocities over one step.
///
///     0 ≤ r' ⟂ W r' + s r' − p ≥ 0
///
/// Bodies start from rest; the contacts with p > 0 alone take part, without friction or joints.
struct Pushes {
  std::vector<Contact> contacts;  ///< those that take part, without friction
  std::vector<Body> bodies;       ///< push velocities; empty if nothing has to move
  int islands = 0, unsolved = 0, regions = 0, factorisations = 0, sweeps = 0;

  Assembler assembler;
  Solution solution;  ///< of the island that is being solved

  void clear();
  std::size_t bytes() const;
};

/// With `all`, contacts with p = 0 take part too; if there are no others nothing moves.
void solvePushes(const Group& group, bool all, Solver& solver, Pushes& pushes);

}  // namespace delassus::bullet
