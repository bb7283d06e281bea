#pragma once

#include "delassus/economies.h"

namespace delassus {

namespace bullet {
struct Group;
class GroupIslands;
}  // namespace bullet

/// What a step asks for, counted from the gathered parts before anything is solved, and what the
/// solver makes for it. The step contains nothing else: no other unknowns, passes or events.
struct Plan {
  // What the step asks for.
  int frictional = 0;    ///< contacts with friction
  int frictionless = 0;  ///< contacts without
  int bouncing = 0;      ///< contacts with restitution
  int soft = 0;          ///< contacts with a compliance, of the normal or of slip
  int deep = 0;          ///< contacts whose penetration is left to the push
  int rolling = 0;       ///< contacts with rolling friction
  int spinning = 0;      ///< contacts with spinning friction
  int joints = 0;        ///< joints that have rows
  int rows = 0;          ///< of the joints
  int boundedRows = 0;   ///< rows with a finite bound: limits, motors, joints that can break
  int softRows = 0;      ///< rows whose joint asks for a compliance
  int obsolete = 0;      ///< constraints that solve themselves, in turns with the rest
  int islands = 0;
  int largestIsland = 0;  ///< unknowns of the largest island
  bool heard = false;     ///< somebody listens to contact events

  // What is made for it.
  int unknowns = 0;      ///< of contacts (three or one), rows, rolling (two) and spinning (one)
  int pushContacts = 0;  ///< contacts of the push problem; 0: there is none
  bool events = false;   ///< contact events are made

  int contacts() const { return frictional + frictionless; }
  /// Adds another group of the same step.
  void add(const Plan& group);
};

namespace bullet {

Plan makePlan(const Group& group, bool heard, const Economies& economies,
              const GroupIslands& islands);

}  // namespace bullet
}  // namespace delassus
