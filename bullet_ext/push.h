#pragma once

#include <cstddef>
#include <vector>

#include "bullet_ext/workshop.h"
#include "delassus/body.h"
#include "delassus/contact.h"
#include "delassus/island.h"

namespace delassus::bullet {

struct Group;

/// Split impulse: how the bodies have to be moved out of each other, as velocities over one step.
///
///     0 ≤ r' ⟂ W r' + s' r' − p ≥ 0
///
/// Bodies start from rest; the contacts with p > 0 alone take part, without friction or joints.
///
/// What is pinched between faces that lean against each other by ε would leave them at p/ε, and
/// what may move along a small part of a normal alone, in a plane world, just so. Where bodies
/// would slip past each other by more than `reach` times the largest p of their island, it is
/// solved again as if contacts gave a little, s' > 0 (thrown_bodies.h): by no more than some times
/// p then, however small ε is.
struct Pushes {
  std::vector<Contact> contacts;  ///< those that take part, without friction
  std::vector<Body> bodies;       ///< push velocities; empty if nothing has to move
  int islands = 0;
  int softened = 0;  ///< islands that were solved again
  Bench::Counts counts;
  Assembler assembler;           ///< has split them
  std::vector<char> isSoftened;  ///< by island

  void clear();
  std::size_t bytes() const;
};

/// If no contact has p > 0 all take part, and nothing moves: what a step costs that does not look
/// whether it needs pushes (Economies::pushes).
void solvePushes(const Group& group, Workshop& workshop, Pushes& pushes);

}  // namespace delassus::bullet
