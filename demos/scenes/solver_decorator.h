#pragma once

#include <btBulletDynamicsCommon.h>

#include "bullet_ext/group_input.h"

namespace demos {

using delassus::bullet::GroupInput;

/// A solver that hands everything on to another one. Classes derived from it observe.
class SolverDecorator : public btConstraintSolver {
 public:
  explicit SolverDecorator(btConstraintSolver& inner) : inner_(inner) {}

  void prepareSolve(int bodyCount, int manifoldCount) override {
    inner_.prepareSolve(bodyCount, manifoldCount);
  }
  btScalar solveGroup(btCollisionObject** bodies, int bodyCount, btPersistentManifold** manifolds,
                      int manifoldCount, btTypedConstraint** constraints, int constraintCount,
                      const btContactSolverInfo& info, btIDebugDraw* debugDrawer,
                      btDispatcher* dispatcher) override {
    const GroupInput group{bodies,      bodyCount,       manifolds, manifoldCount,
                           constraints, constraintCount, &info,     dispatcher};
    beforeGroup(group);
    const btScalar answer =
        inner_.solveGroup(bodies, bodyCount, manifolds, manifoldCount, constraints, constraintCount,
                          info, debugDrawer, dispatcher);
    afterGroup(group);
    return answer;
  }
  void allSolved(const btContactSolverInfo& info, btIDebugDraw* debugDrawer) override {
    inner_.allSolved(info, debugDrawer);
  }
  void reset() override { inner_.reset(); }
  btConstraintSolverType getSolverType() const override { return inner_.getSolverType(); }

 protected:
  virtual void beforeGroup(const GroupInput&) {}
  virtual void afterGroup(const GroupInput&) {}

 private:
  btConstraintSolver& inner_;
};

}  // namespace demos
