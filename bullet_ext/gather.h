#pragma once

#include "bullet_ext/group.h"
#include "bullet_ext/group_input.h"
#include "bullet_ext/step_report.h"

namespace delassus::bullet {

class Extension;

/// A push moves a body in vain if that is no more than this share of what it would move if no axis
/// were locked: what leans by less than 1e-4 rad lies in a locked axis. The exact answer there is
/// an impulse 1e8 times as large as without the lock.
constexpr double inVain = 1e-8;

/// Reads a whole solveGroup call into `group`, which forgets what it was. An extension is asked for
/// its parts in between; `asStock`: see gatherTurningFriction. Of Bullet's objects only joints are
/// written to: their impulses and feedback are cleared. The functions below are its parts, in their
/// order.
void gatherGroup(Group& group, const GroupInput& input, StepReport& report,
                 Extension* extension = nullptr, bool asStock = false);

/// Index of the object in `group`, which it joins if it is new: a body, fixedWorld or leftOut.
///
/// A body, contact or row whose numbers are not finite or absurd is left out: the rest is solved as
/// if it were not there, and the report names it.
///
/// Its free velocity over the step h is that of Bullet's solvers, with gyroscopic terms Δω taken at
/// the start of the step and locked axes kept still (L, A: linear and angular factor; F and T carry
/// them already; [A ≠ 0] is 1 for an axis that is not locked, else 0):
///
///     v + h F/m,   ω + [A ≠ 0] (h I⁻¹ T + Δω),   M⁻¹ = diag(L/m, A I⁻¹ A)
int bodyIndex(Group& group, btCollisionObject& object, const btContactSolverInfo& info,
              StepReport& report);

/// The bodies that were passed, by bodyIndex. Contacts and joints may bring more.
void gatherBodies(Group& group, const GroupInput& input, StepReport& report);

/// Which bodies joints hold to each other: gatherContacts asks.
void gatherJoined(Group& group, const GroupInput& input);

/// Contacts with the target velocities of Bullet's sequential impulse solver:
///
///     d = distance + slop        e' = max(0, −e a) if |a| ≥ threshold, else 0
///     d > 0:  target = e' − d/h              the contact may close its gap, no more
///     d ≤ 0:  target = e' + erp (−d)/h
///        or:  target = e',  push = erp (−d)/h    where the impulse is split
///     compliance = cfm/h;  with stiffness k and damping c:  cfm = 1/(h k + c),  erp = h k cfm
///
/// where a is the relative velocity before forces; with a link, whose velocity has them already,
/// after them, as in Bullet. Of points that move no further in a step than four roundings of their
/// places in Bullet's precision (in float at 10 m: 1e-5 m), a distance d of no more than that is
/// none: they touch (but those of links, whose forces move them further). Taken at its word it
/// would have every pile of boxes that has fallen share its loads anew in every step, at the whim
/// of the last digit. A contact with its own softness is never split: the spring would be lost to
/// the push. One whose push moves neither body (inVain), or that of what keeps its place with what
/// stands, is idle. Friction: see contact_frame.h.
///
/// Bodies that a joint holds to each other collide all the same, unless the joint was added to the
/// world as one whose bodies do not. Their contacts give by joinedSoftness and are never split:
/// where they contradict the joint, both would be met, as rigid as they are, by 1e9 N·s. So do,
/// by more, those of two bodies that push both ways at one place (OpposedContacts) and, once joints
/// are gathered, those along which these leave no motion (HeldContacts).
void gatherContacts(Group& group, const GroupInput& input, StepReport& report);

/// Whether the step starts from the reactions of the last one. An exact answer needs no damping of
/// where it starts from: m_warmstartingFactor only says whether to start there.
bool warmStarts(const btContactSolverInfo& info);

/// Rows of the joints as their getInfo1 and getInfo2 answer. With the joint's damping D and its
/// dimensionless softness χ:
///
///     target = error + (1 − D) J v_f,   compliance = max(χ, softness) W_ii   (softness.h)
///
/// W_ii is that of the masses without linear and angular factors, as in Bullet's solvers. A row
/// whose impulse could move nothing, since its bodies are locked along it, takes no part (Bullet's
/// gains no more than a little a sweep there). A disabled joint has no rows. Impulses and feedback
/// are cleared.
void gatherJoints(Group& group, const GroupInput& input, StepReport& report);

/// Rows against rolling and spinning, of the contacts that ask for it; call it when all other rows
/// are gathered. With Bullet's combined coefficients, read from the point and in m:
///
///     |τ_n| ≤ spinning r_n,   ‖τ_t‖ ≤ rolling r_n   (turning_friction.h; axes: contact_frame.h)
///
/// Bullet's solver bounds these impulses by the coefficients themselves too, in N·m·s, so that a
/// heavy body hardly feels them, and knows no spinning friction without rolling friction. `asStock`
/// has both of rigid bodies (those of links are as above in Bullet too). A coefficient that is no
/// number is none: Bullet's rule, κ_A μ_B + κ_B μ_A, makes that of a friction μ without limit.
void gatherTurningFriction(Group& group, bool asStock = false);

/// What is wrong with a row, or null.
const char* faultOfRow(const Row& row);

}  // namespace delassus::bullet
