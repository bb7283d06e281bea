#pragma once

class btTypedConstraint;

namespace delassus::bullet {

/// Whether a motor of the joint is on that may push with as much as breaks the joint, or more. Its
/// row then looks as the rows with which joints mend their errors. Joints of the user's own may
/// have any motors.
bool hasUnboundedMotor(btTypedConstraint& joint);

}  // namespace delassus::bullet
