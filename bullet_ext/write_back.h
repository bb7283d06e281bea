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

/// Velocities of the movable bodies.
void writeVelocities(const Group& group, const Answer& answer);

/// Poses of the bodies that are pushed: x + h p, and a turn scaled by the turn factor of the info.
void writePushes(const Group& group, const Pushes& pushes, const btContactSolverInfo& info);

/// Impulses, the directions they refer to and modes of all points, idle ones included (zero, open).
/// Counts modes in `report`. Where `events` is given it receives the contacts that changed their
/// mode or are in trouble, with `turning` those too that a moment acts in, in the order of the
/// group.
void writeContacts(const Group& group, const Answer& answer, StepReport& report,
                   std::vector<ContactEvent>* events, bool turning);

/// What a joint is left with: the impulse of its last row, for Bullet's joints answer with that
/// alone (the feedback is the whole record). A zero is negative: by that it differs from the one in
/// a joint that was never solved.
btScalar writtenImpulse(const JointSource& joint, const Answer& answer);

/// Impulses and feedback of the joints. A joint with a reaction at its breaking impulse is
/// disabled.
void writeJoints(const Group& group, const Answer& answer, const btContactSolverInfo& info);

}  // namespace delassus::bullet
