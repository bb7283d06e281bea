#pragma once

class btCollisionObject;
class btDispatcher;
class btMultiBodyConstraint;
class btPersistentManifold;
class btTypedConstraint;
struct btContactSolverInfo;

namespace delassus::bullet {

/// What Bullet passes to solveGroup or solveMultiBodyGroup, good until that returns.
struct GroupInput {
  btCollisionObject** bodies;
  int bodyCount;
  btPersistentManifold** manifolds;
  int manifoldCount;
  btTypedConstraint** constraints;
  int constraintCount;
  const btContactSolverInfo* info;
  btDispatcher* dispatcher;  ///< null: bodies say themselves whether they respond
  btMultiBodyConstraint** multiBodyConstraints = nullptr;
  int multiBodyConstraintCount = 0;
};

}  // namespace delassus::bullet
