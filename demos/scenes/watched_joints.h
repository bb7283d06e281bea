#pragma once

#include <btBulletDynamicsCommon.h>

#include <vector>

namespace demos {

/// Saves the impulses that the last step left in joints, by which our solver recognises them:
/// gathering the rows of joints clears them. Puts them back at the end of its life, so that an
/// observer changes nothing.
class WatchedJoints {
 public:
  WatchedJoints(btTypedConstraint* const* joints, int count) : joints_(joints, joints + count) {
    for (btTypedConstraint* joint : joints_)
      impulses_.push_back(joint->internalGetAppliedImpulse());
  }
  ~WatchedJoints() {
    for (std::size_t i = 0; i < joints_.size(); ++i)
      joints_[i]->internalSetAppliedImpulse(impulses_[i]);
  }
  WatchedJoints(const WatchedJoints&) = delete;
  WatchedJoints& operator=(const WatchedJoints&) = delete;

 private:
  std::vector<btTypedConstraint*> joints_;
  std::vector<btScalar> impulses_;
};

}  // namespace demos
