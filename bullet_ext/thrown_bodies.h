#pragma once

#include <vector>

#include "delassus/body.h"
#include "delassus/contact.h"
#include "delassus/island.h"
#include "delassus/problem.h"
#include "delassus/row.h"
#include "delassus/solution.h"

namespace delassus::bullet {

struct Answer;
struct Group;

// The exact answer may throw a body: what is pinched between faces that lean against each other by
// ε leaves them at 1/ε of what pinches it, and so does what a load presses that is off its line by
// ε, or a link of a chain that is to be shorter than the way between its ends. An island whose
// answer does so is solved again (soft_answer.h).

/// How many times as fast as all that asks for motion, or moved before, a body may leave: out of a
/// wedge of 11 degrees it does so exactly.
constexpr double reach = 10;

/// Whether what presses leaves more than `times` as fast as anything in the island was, or is asked
/// to be (`demand`, m/s, and what turns joints, at the arms of the contacts).
bool contactsThrowOne(const Group& group, const Island& island, double demand, const Answer& answer,
                      double times = reach);
/// What joints that hold, and contacts beside them, do to the bodies of an island for what they ask
/// for, J. Work that is done to hold, r (u + u⁺)/2, is what targets ask for: held at rest nothing
/// gains any.
struct TargetWork {
  double done = 0;
  /// The larger of ½ target²/W_ii of all targets, which is what each would take alone, with the
  /// work of what drives joints, whichever way, and of the energy that the island has. Motors,
  /// limits and springs drive, which have bounds and may do all that these allow (a breaking
  /// threshold is no such bound).
  double fair = 0;
  /// The same with timesAlone times the former: who does more throws a body. Limbs in a heap take
  /// up to 20 times what they would take alone; those that are wedged, or a chain that is too
  /// short, hundreds and thousands.
  double allowed = 0;
};
constexpr double timesAlone = 30;
/// Of `solution`, for the targets of these contacts and rows: those of the group, or others in the
/// place of these.
TargetWork workOfTargets(const Group& group, const std::vector<Contact>& contacts,
                         const std::vector<Row>& rows, const Island& island, const Problem& problem,
                         const Solution& solution);
/// Whether what pushes the row up, or down, drives it, or brakes: with so much and no more. What
/// breaks at so much holds until then.
bool drives(const Group& group, int row, bool up);

/// The fastest of what touches the island and does not give way, m/s.
double driveOf(const Group& group, const Island& island);
/// What the bodies of the island would have, J, if each went at least as fast as what drives there:
/// bodies that do not give way, targets of contacts and joints.
double energyAtHand(const Group& group, const Island& island);

/// Has the contact give, in addition, by s' of what it answers if no axis of a body that moves is
/// locked, s' = 1/(2 reach²). With one such contact a face, what is pinched at the speed p leaves
/// at
///
///     p ε/(ε²/2 + s') ≤ p/√(2 s') = reach p
///
/// or by a `share` of that.
void soften(const std::vector<Body>& bodies, Contact& contact, double share = 1);

}  // namespace delassus::bullet
