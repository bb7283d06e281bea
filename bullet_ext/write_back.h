#pragma once

#include <vector>

#include "LinearMath/btScalar.h"
#include "bullet_ext/contact_event.h"

struct btContactSolverInfo;

namespace delassus {
struct StepReport;
}

namespace delassus::bullet {

struct Answer;
struct Group;
struct JointSource;
struct Pushes;

/// Writes the velocities of the movable bodies.
void writeVelocities(const Group& group, const Answer& answer);

/// Moves the bodies that are pushed: x + h p, and a turn scaled by the turn factor of `info`.
void writePushes(const Group& group, const Pushes& pushes, const btContactSolverInfo& info);

/// Writes impulses, their directions and the modes of all points, idle ones included (zero, open).
/// Counts modes in `report`. If `events` is given, it receives the contacts that changed mode or
/// are in trouble and, with `turning`, those in which a moment acts, in the order of the group.
void writeContacts(const Group& group, const Answer& answer, StepReport& report,
                   std::vector<ContactEvent>* events, bool turning);

/// The impulse that is written into a joint: that of its last row, the only one that Bullet's
/// joints report (the feedback holds all). A zero is written as −0, to differ from the zero in a
/// joint that was never solved.
btScalar writtenImpulse(const Group& group, const JointSource& joint, const Answer& answer);

/// Writes impulses and feedback of the joints. Disables a joint whose reaction reaches its breaking
/// impulse.
void writeJoints(const Group& group, const Answer& answer, const btContactSolverInfo& info);

}  // namespace delassus::bullet
