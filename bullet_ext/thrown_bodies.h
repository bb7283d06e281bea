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

// The exact answer may throw a body. A body that is pinched between faces that lean against each
// other by ε leaves them at 1/ε times the speed at which it is pinched. So does a body that a load
// presses off its line by ε, or a link of a chain that is to be shorter than the way between its
// ends. An island whose answer throws a body is solved again (soft_answer.h).

/// How many times as fast a body may leave as anything asks to move, or moved before: out of a
/// wedge of 11 degrees it leaves so fast exactly.
constexpr double reach = 10;

/// Whether a pressing contact leaves more than `times` as fast as anything in the island was, or is
/// asked to be (`demand`, m/s, and the turns that joints ask for, at the arms of the contacts).
bool contactsThrowOne(const Group& group, const Island& island, double demand, const Answer& answer,
                      double times = reach);
/// The work that joints that hold, and contacts beside them, do on the bodies of an island to meet
/// their targets, J. The work done to hold, r (u + u⁺)/2, is what targets ask for: nothing that is
/// held at rest gains energy.
struct TargetWork {
  double done = 0;  ///< less what drives take up at the same time, as a motor that is pushed back
  /// The sum of
  ///
  ///   - ½ target²/W_ii over all targets, which is what each would take alone,
  ///   - the work that is done by what drives joints: motors, limits and springs, which have
  ///     bounds and may do all that these allow (a breaking threshold is no such bound), but
  ///     no more than the same impulse does on its two bodies alone,
  ///   - twice the work of forces: the energy that they take from the bodies in this step, as from
  ///     a load that is lifted, or would give them from rest. It takes once as much to go on as
  ///     before, and the other half makes the bodies faster.
  double fair = 0;
  /// An answer with more work throws a body: timesAlone times the first and twice the second, or a
  /// quarter of the energy that the island has and the third, if that is more. Limbs in a heap take
  /// up to 20 times what they would take alone; limbs that are wedged, or a chain that is too
  /// short, take hundreds and thousands of times as much.
  double allowed = 0;
};
constexpr double timesAlone = 30;
/// The work of `solution`, for the targets of these contacts and rows: those of the group, or
/// others in their place.
TargetWork workOfTargets(const Group& group, const std::vector<Contact>& contacts,
                         const std::vector<Row>& rows, const Island& island, const Problem& problem,
                         const Solution& solution);
/// Whether the contact, or the row, is as soft as a spring: what it asks for is its force.
bool isSpring(const Group& group, const Contact& contact);
bool isSpring(const Group& group, const Row& row);
/// Whether a push of the row up, or down, drives or brakes it, with a bounded force. A bound at
/// which the joint breaks does not count: until then the joint holds.
bool drives(const Group& group, int row, bool up);

/// Whether these bodies may squeeze the island: one that moves does not go the same way as all else
/// that holds it, be it another one, a joint's other body, or what locks an axis. (Several of which
/// one turns count as going different ways.) Otherwise the island can go along as a whole, and what
/// drives it does not jam it.
bool mayBeSqueezed(const Group& group, const Island& island);
/// Whether the body may not go or turn about an axis.
bool hasLockedAxis(const Body& body);
/// The energy of the island's bodies, J, if each that may leave its place went at least so fast.
/// They turn about the axes about which they may turn, with their own inertia.
double energyOf(const Group& group, const Island& island, const std::vector<Body>& bodies,
                double leastSpeed = 0);
/// The energy that the bodies of the island would have, J, if each went at least as fast as what
/// drives there: bodies that do not give way, targets of contacts and joints.
double energyAtHand(const Group& group, const Island& island);

/// Makes the contact give by s' = 1/(2 reach²) of its response, in addition to what it gives
/// already. The response is taken as if no axis of its moving bodies were locked. With one such
/// contact a face, a body that is pinched at the speed p leaves at
///
///     p ε/(ε²/2 + s') ≤ p/√(2 s') = reach p
///
/// With `share`, the contact gives by this share of s'.
void soften(const std::vector<Body>& bodies, Contact& contact, double share = 1);

}  // namespace delassus::bullet
