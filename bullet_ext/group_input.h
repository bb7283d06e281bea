#pragma once

class btCollisionObject;
class btDispatcher;
class btMultiBodyConstraint;
class btPersistentManifold;
class btTypedConstraint;
struct btContactSolverInfo;

namespace delassus::bullet {

/// The arguments of solveGroup or solveMultiBodyGroup, good until the call returns.
struct GroupInput {
  btCollisionObject** bodies;
  int bodyCount;
  btPersistentManifold** manifolds;
  int manifoldCount;
  btTypedConstraint** constraints;
  int constraintCount;
  const btContactSolverInfo* info;
  btDispatcher* dispatcher;  ///< null: ask the bodies whether they respond to contacts
  btMultiBodyConstraint** multiBodyConstraints = nullptr;
  int multiBodyConstraintCount = 0;
};

}  // namespace delassus::bullet
