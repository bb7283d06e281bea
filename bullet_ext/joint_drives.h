#pragma once

class btTypedConstraint;

namespace delassus::bullet {

/// Whether a motor of the joint is on that may push with as much as breaks the joint, or more. Its
/// row then looks as the rows with which joints mend their errors. Joints of the user's own may
/// have any motors.
bool hasUnboundedMotor(btTypedConstraint& joint);

/// The number of rows of a hinge or a slider before those of its own axis, whose limits may lock
/// it, and may be moved; of other joints that of all.
int rowsBesideAxis(const btTypedConstraint& joint);

}  // namespace delassus::bullet
