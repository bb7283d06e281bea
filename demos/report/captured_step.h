#pragma once

#include <btBulletDynamicsCommon.h>

#include <functional>
#include <vector>

#include "bullet_ext/group_input.h"
#include "delassus/types.h"

namespace demos::report {

/// The arguments of all solveGroup calls of one world step. Good until the step goes on.
struct CapturedStep {
  struct Group {
    std::vector<btCollisionObject*> bodies;
    std::vector<btPersistentManifold*> manifolds;
    std::vector<btTypedConstraint*> constraints;

    delassus::bullet::GroupInput input(const btContactSolverInfo& info,
                                       btDispatcher* dispatcher) const;
  };
  std::vector<Group> groups;
  const btContactSolverInfo* info = nullptr;
  btDispatcher* dispatcher = nullptr;

  /// Gives every group to `solver`, as the world would.
  void solve(btConstraintSolver& solver, const btContactSolverInfo& settings) const;
};

/// Holds back the groups of a step until all are known, shows them to a watcher, then has `inner`
/// solve them. Groups share no movable body, so this order makes no difference to the world.
class StepCapture : public btConstraintSolver {
 public:
  explicit StepCapture(btConstraintSolver& inner) : inner_(inner) {}

  std::function<void(const CapturedStep&)> beforeSolve, afterSolve;

  void prepareSolve(int bodyCount, int manifoldCount) override;
  btScalar solveGroup(btCollisionObject** bodies, int bodyCount, btPersistentManifold** manifolds,
                      int manifoldCount, btTypedConstraint** constraints, int constraintCount,
                      const btContactSolverInfo& info, btIDebugDraw* debugDrawer,
                      btDispatcher* dispatcher) override;
  void allSolved(const btContactSolverInfo& info, btIDebugDraw* debugDrawer) override;
  void reset() override { inner_.reset(); }
  btConstraintSolverType getSolverType() const override { return inner_.getSolverType(); }

 private:
  btConstraintSolver& inner_;
  CapturedStep step_;
};

/// Everything that a solver changes in the groups of a step: motion and poses of bodies, stored
/// impulses of contact points, state and feedback of joints.
class SavedState {
 public:
  explicit SavedState(const CapturedStep& step);
  void restore() const;

 private:
  struct BodyState {
    btRigidBody* body;
    btTransform pose;
    btVector3 linear, angular;
  };
  struct JointState {
    btTypedConstraint* joint;
    bool enabled;
    btScalar impulse;
    btJointFeedback feedback;
  };
  struct PointState {
    btManifoldPoint* place;
    btManifoldPoint point;
  };
  std::vector<BodyState> bodies_;
  std::vector<JointState> joints_;
  std::vector<PointState> points_;
};

/// The memory that a solver has of one contact point from step to step.
struct PointMemory {
  btScalar normal = 0, lateral1 = 0, lateral2 = 0, mode = 0;
  btVector3 direction1{0, 0, 0}, direction2{0, 0, 0};
};
/// The memories of all points of a step, in the order of its groups.
using StepMemory = std::vector<PointMemory>;

StepMemory readMemory(const CapturedStep& step);
void writeMemory(const CapturedStep& step, const StepMemory& memory);

/// Numbers the points of a step, so that the next step can tell which of them are still there.
void numberPoints(const CapturedStep& step);
/// For each point of this step its number in the one before, or -1 if it is new.
std::vector<int> earlierNumbers(const CapturedStep& step);
/// The memory of the step before, carried over to the points of this one.
StepMemory carried(const StepMemory& before, const std::vector<int>& earlier);

}  // namespace demos::report
