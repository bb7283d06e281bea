#pragma once

#include <vector>

#include "BulletDynamics/ConstraintSolver/btSolverBody.h"
#include "LinearMath/btAlignedObjectArray.h"
#include "bullet_ext/gather.h"

namespace delassus::bullet {

/// A rigid body of the group as constraints that are written for Bullet's sequential impulse solver
/// expect it: the velocity of the start of the step, and the gain from forces apart. Anything else is
/// immovable.
btSolverBody solverBody(const Group& group, int index);

/// The constraints of a group that have no rows and move bodies themselves, in
/// solveConstraintObsolete.
///
/// They are given solverBody(), and in its delta velocities what reactions have done.
class ObsoleteConstraints {
 public:
  ObsoleteConstraints(const Group& group, const btContactSolverInfo& info);

  /// Calls each constraint once with the motion that the reactions left, `moved`. What the
  /// constraints change is added to the free velocities in `group`. Returns whether anything
  /// changed. A constraint whose change is not finite is left out from then on.
  bool sweep(Group& group, const std::vector<Body>& moved, StepReport& report);

  /// How many constraints have changed a velocity so far.
  int acted() const;

 private:
  void setDeltas(const std::vector<Body>& moved);

  const btContactSolverInfo& info_;
  std::vector<Vec6> free_;  ///< free velocities before any of the constraints acted
  btAlignedObjectArray<btSolverBody> bodies_;  ///< one a body, and the fixed world at the end
  std::vector<char> acted_, leftOut_;          ///< by constraint
};

}  // namespace delassus::bullet
