#pragma once

#include "bullet_ext/group.h"
#include "bullet_ext/group_input.h"
#include "bullet_ext/step_report.h"

namespace delassus::bullet {

class Extension;

/// A push along a normal moves a body in vain if the body's response is at most this share of its
/// response without locked axes. So a normal counts as locked if it leans by less than 1e-4 rad out
/// of a locked axis: the exact impulse there is 1e8 times as large as without the lock.
constexpr double inVain = 1e-8;

/// How contacts and joints are gathered.
struct Manner {
  bool rollsAsStock = false;     ///< see gatherTurningFriction
  bool leavesOutWelded = false;  ///< see HeldContacts
};

/// Reads a whole solveGroup call into `group`, which is cleared first. An extension adds its parts
/// in between. Of Bullet's objects only joints are written to: their impulses and feedback are
/// cleared. The functions below are its parts, in their order.
void gatherGroup(Group& group, const GroupInput& input, StepReport& report,
                 Extension* extension = nullptr, const Manner& manner = {});

/// Index of the object in `group`, which it joins if it is new: a body, fixedWorld or leftOut.
///
/// A body, contact or row with numbers that are not finite or absurd is left out: the rest is
/// solved as if it were not there, and the report names it.
///
/// The body's free velocity over the step h is that of Bullet's solvers, with the gyroscopic terms
/// Δω of the step's start and with locked axes kept still. L and A are the linear and angular
/// factors, which F and T carry already; [A ≠ 0] is 1 for an axis that is not locked, else 0:
///
///     v + h F/m,   ω + [A ≠ 0] (h I⁻¹ T + Δω),   M⁻¹ = diag(L/m, A I⁻¹ A)
int bodyIndex(Group& group, btCollisionObject& object, const btContactSolverInfo& info,
              StepReport& report);

/// Gathers the bodies that were passed, by bodyIndex. Contacts and joints may add more.
void gatherBodies(Group& group, const GroupInput& input, StepReport& report);

/// Notes which bodies joints hold to each other, for gatherContacts.
void gatherJoined(Group& group, const GroupInput& input);

/// Gathers contacts with the target velocities of Bullet's sequential impulse solver:
///
///     d = distance + slop        e' = max(0, −e a) if |a| ≥ threshold, else 0
///     d > 0:  target = e' − d/h              the contact may close its gap, no more
///     d ≤ 0:  target = e' + erp (−d)/h
///        or:  target = e',  push = erp (−d)/h    where the impulse is split
///     compliance = cfm/h;  with stiffness k and damping c:  cfm = 1/(h k + c),  erp = h k cfm
///
/// where a is the relative velocity before forces. In contacts with a link it is the one after
/// forces, as in Bullet, since the link's velocity includes them already.
///
/// A distance |d| of no more than four roundings of the point's place in Bullet's precision (in
/// float at 10 m: 1e-5 m) counts as 0 if the bodies slip by no more than that in the step (for
/// links: forces included). Otherwise every pile of boxes that has fallen would share its loads
/// anew in every step, at the whim of the last digit.
///
/// A contact with its own softness is never split: the push would make the spring useless. A
/// contact is idle if its push moves neither body (inVain), or if neither body can leave its place.
/// Friction: see contact_frame.h.
///
/// Bodies that a joint holds to each other collide nevertheless, unless the joint was added to the
/// world with collisions between them disabled. Their contacts give by joinedSoftness and are never
/// split: a rigid contact that contradicts a rigid joint would take 1e9 N·s. Two more kinds of
/// contacts give, by more: those of two bodies that push both ways at one place (OpposedContacts)
/// and, once joints are gathered, those along whose normal the joints leave no motion
/// (HeldContacts).
void gatherContacts(Group& group, const GroupInput& input, StepReport& report);

/// Whether the step starts from the reactions of the last one. An exact answer needs no damped
/// start: m_warmstartingFactor only says whether to start there.
bool warmStarts(const btContactSolverInfo& info);

/// Gathers the rows that the joints give in getInfo1 and getInfo2. With the joint's damping D and
/// its dimensionless softness χ:
///
///     target = error + (1 − D) J v_f,   compliance = max(χ, softness) W_ii   (softness.h)
///
/// As in Bullet's solvers, W_ii is computed from the masses without linear and angular factors. A
/// row takes no part if its axis is no longer than rounding (‖J‖² ≤ SIMD_EPSILON for both bodies;
/// Bullet leaves out rows with W_ii ≤ SIMD_EPSILON), or if its impulse could move nothing, since
/// its bodies are locked along it (in Bullet its impulse grows by no more than a little a sweep). A
/// disabled joint has no rows.
/// Impulses and feedback are cleared.
void gatherJoints(Group& group, const GroupInput& input, StepReport& report);

/// Gathers rows against rolling and spinning for the contacts that ask for them; call it after all
/// other rows are gathered. With Bullet's combined coefficients, read from the point and in m:
///
///     |τ_n| ≤ spinning r_n,   ‖τ_t‖ ≤ rolling r_n   (turning_friction.h; axes: contact_frame.h)
///
/// Bullet's solver bounds these impulses by the coefficients themselves, too, in N·m·s, so that a
/// heavy body hardly feels them; and without rolling friction it ignores spinning friction. With
/// `asStock` both rules hold for rigid bodies. (Links follow the formula above in Bullet, too.) A
/// coefficient that is not a number counts as 0: Bullet's rule, κ_A μ_B + κ_B μ_A, yields one if a
/// friction μ is infinite.
void gatherTurningFriction(Group& group, bool asStock = false);

/// The fault of a row, or null.
const char* faultOfRow(const Row& row);

}  // namespace delassus::bullet
