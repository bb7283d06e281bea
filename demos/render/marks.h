#pragma once

#include <btBulletDynamicsCommon.h>

#include <set>
#include <utility>
#include <vector>

#include "demos/render/film.h"
#include "demos/scenes/solver_decorator.h"

namespace demos::render {

/// Observes another solver and remembers which contacts persisted before the step: those whose
/// point still holds the last reaction, and in a world's first step all that touch.
class PersistenceWatch : public SolverDecorator {
 public:
  explicit PersistenceWatch(btConstraintSolver& inner) : SolverDecorator(inner) {}

  /// Call it before each step.
  void startStep(bool first) {
    first_ = first;
    persisted_.clear();
  }
  bool persisted(const btPersistentManifold& manifold, int point) const {
    return persisted_.count({&manifold, point}) > 0;
  }

 protected:
  void beforeGroup(const GroupInput& group) override;

 private:
  bool first_ = true;
  std::set<std::pair<const btPersistentManifold*, int>> persisted_;
};

/// The contacts of the last step (of `h` seconds) that carry, and those that it released.
std::vector<ContactMark> contactMarks(const World& world, const PersistenceWatch& watch, double h);

/// While it lives, every joint of a world has a place for its reaction, also those that had none.
class JointFeedbacks {
 public:
  explicit JointFeedbacks(World& world);
  ~JointFeedbacks();
  JointFeedbacks(const JointFeedbacks&) = delete;
  JointFeedbacks& operator=(const JointFeedbacks&) = delete;

 private:
  std::vector<btJointFeedback> feedbacks_;
  std::vector<btTypedConstraint*> joints_;
};

/// The joints that hold points together, with their forces in the last step.
std::vector<JointMark> jointMarks(const World& world);

/// The bodies that a joint holds at a point outside their shapes.
std::vector<Rope> ropes(const World& world);

}  // namespace demos::render
