#pragma once

class btCollisionObject;
class btDispatcher;
class btPersistentManifold;
class btTypedConstraint;
struct btContactSolverInfo;

namespace delassus::bullet {

/// What Bullet passes to solveGroup, good until that returns.
struct GroupInput {
  btCollisionObject** bodies;
  int bodyCount;
  btPersistentManifold** manifolds;
  int manifoldCount;
  btTypedConstraint** constraints;
  int constraintCount;
  const btContactSolverInfo* info;
  btDispatcher* dispatcher;  ///< null: bodies say themselves whether they respond
};

}  // namespace delassus::bullet
