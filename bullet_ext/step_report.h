#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "bullet_ext/plan.h"

namespace delassus {

/// Report of the last world step: sums over all its groups and islands. A count that would overflow
/// stays at the largest number, as it may where nobody announces steps (a solver pool).
struct StepReport {
  Plan plan;  ///< what the step asked for, and what was made for it
  int islands = 0;
  int contacts = 0;  ///< contact points that took part
  int rows = 0;      ///< joint rows
  /// Modes of the contacts; frictionless persisting contacts count as slide.
  int open = 0, stick = 0, slide = 0;
  int modeChanges = 0;  ///< contacts whose mode differs from that after the step before
  int events = 0;       ///< contact events made
  /// Islands by their answer: no reactions (nothing approaches), the last reactions, a formula, or
  /// a search.
  int freeIslands = 0, keptIslands = 0, closedForms = 0, walks = 0;
  int matrices = 0;        ///< problems whose W was built, without pushes
  int regions = 0;         ///< regions visited, pushes included
  int factorisations = 0;  ///< pushes included
  int sweeps = 0;          ///< sweeps and alternations, pushes included
  int patches = 0;         ///< parts of islands that were solved apart on the way, pushes included
  /// Natural residual (residual.h), m/s, along arcs for rows about an axis (arcs.h); without
  /// pushes. Infinite if numbers of an island overflow.
  double residualMax = 0;
  double residualRms = 0;  ///< m/s, over contacts and rows
  int solved = 0, outOfBudget = 0, incompatible = 0, nonFinite = 0;  ///< islands by status
  /// Islands that jam, or whose exact answer would throw or wedge a body: they are solved as if
  /// contacts gave a little, or joints asked for less (soft_answer.h), and count as incompatible,
  /// too.
  int softened = 0;
  /// Bodies, contacts, rows and steps with numbers that are not finite or absurd; the rest is
  /// solved as if they were not there.
  int leftOut = 0;
  int held = 0;          ///< contacts that leave their load to joints (held_contacts.h)
  int opposed = 0;       ///< contacts that give, since they push one body both ways (gather.h)
  int stiffened = 0;     ///< bodies that turn more slowly because of setGeometricStiffness
  int pushIslands = 0;   ///< islands of the split-impulse problem, not counted in `islands`
  int pushUnsolved = 0;  ///< islands of the split-impulse problem whose status is not Solved
  int pushSoftened = 0;  ///< softened islands of the split-impulse problem (push.h)
  /// Constraints without rows that moved something in their own solveConstraintObsolete.
  int obsoleteConstraints = 0;
  /// Time to read bodies, contacts, joints and the reactions of the last step.
  double secondsGather = 0;
  double secondsPlan = 0;   ///< plan, islands, and the check which islands need no solving
  double secondsSolve = 0;  ///< other islands, and constraints that solve themselves
  double secondsPush = 0;   ///< split impulse
  double secondsWriteBack = 0;
  double secondsListener = 0;      ///< inside the user's function
  std::size_t workspaceBytes = 0;  ///< kept from step to step, for all threads
  /// Bodies, contacts, joints that were left out or not solved: which, where, why.
  std::vector<std::string> messages;

  /// Adds a message unless it is there already. The list is kept short: if it was cut, the last
  /// message says so.
  void tell(const std::string& message);
  /// Counts a part that was left out, and tells which and why.
  void leaveOut(const std::string& part, const char* why);
};

}  // namespace delassus
