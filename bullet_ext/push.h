#pragma once

#include <cstddef>
#include <vector>

#include "bullet_ext/workshop.h"
#include "delassus/body.h"
#include "delassus/contact.h"
#include "delassus/island.h"

namespace delassus::bullet {

struct Group;

/// Split impulse: the motion that moves bodies out of each other, as velocities over one step.
///
///     0 ≤ r' ⟂ W r' + s' r' − p ≥ 0
///
/// Bodies start from rest; articulated ones are immovable. Contacts with p > 0 take part, without
/// friction or joints. So do, with p = −gap/h, others that pushes would close faster than the
/// largest p of the island opens.
///
/// A body pinched between faces that lean against each other by ε would leave them at p/ε. In a
/// plane world so would a body that can move only along a small part of a normal. If bodies of an
/// island would slip past each other by more than `reach` times its largest p, the island is solved
/// again as if contacts gave a little, s' > 0 (thrown_bodies.h). Then they slip by no more than
/// some times p, however small ε is.
struct Pushes {
  std::vector<Contact> contacts;  ///< those that take part, without friction
  std::vector<Body> bodies;       ///< push velocities; empty if nothing has to move
  int islands = 0;
  int softened = 0;  ///< islands that were solved again
  Bench::Counts counts;
  Assembler assembler;           ///< the one that split them
  std::vector<char> isSoftened;  ///< of each island
  std::vector<char> takesPart;   ///< of each contact of the group
  std::vector<double> largest;   ///< p of the island of each body, m/s

  void clear();
  std::size_t bytes() const;
};

/// If no contact has p > 0, all contacts take part and nothing moves: that is the cost of a step
/// that does not check whether it needs pushes (Economies::pushes). h: the step, s.
void solvePushes(const Group& group, double h, Workshop& workshop, Pushes& pushes);

}  // namespace delassus::bullet
