#pragma once

#include <cstddef>
#include <vector>

#include "BulletDynamics/ConstraintSolver/btSolverBody.h"
#include "delassus/body.h"
#include "delassus/bytes.h"

namespace delassus {
struct StepReport;
}

namespace delassus::bullet {

struct Group;

/// A rigid body of the group as constraints for Bullet's sequential impulse solver expect it: the
/// velocity at the start of the step, and separately its gain from forces. Anything else is
/// immovable.
btSolverBody solverBody(const Group& group, int index);

/// The constraints of a group that have no rows and move bodies themselves, in
/// solveConstraintObsolete.
///
/// They get solverBody(), with the effect of the reactions as its delta velocities.
class ObsoleteConstraints {
 public:
  /// Call it before the first sweep of a group, when nothing has moved its bodies yet.
  void start(const Group& group);

  /// Calls each constraint once with the motion that the reactions left, `moved`. What the
  /// constraints change is added to the free velocities in `group`. Returns whether anything
  /// changed. A constraint whose change is not finite is left out from then on.
  bool sweep(Group& group, double timeStep, const std::vector<Body>& moved, StepReport& report);

  /// By body: whether the last sweep has changed its free velocity.
  const std::vector<char>& changed() const { return changed_; }

  /// How many constraints have changed a velocity so far.
  int acted() const;

  std::size_t bytes() const { return bytesOf(free_, bodies_, changed_, acted_, leftOut_); }

 private:
  void setDeltas(const std::vector<Body>& moved);

  std::vector<Vec6> free_;             ///< free velocities before any of the constraints acted
  std::vector<btSolverBody> bodies_;   ///< one a body, and the fixed world at the end
  std::vector<char> changed_;          ///< of each body
  std::vector<char> acted_, leftOut_;  ///< of each constraint
};

}  // namespace delassus::bullet
