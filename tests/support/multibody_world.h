#pragma once

#include <BulletCollision/CollisionShapes/btEmptyShape.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointFeedback.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include "bullet_ext/btDelassusMultiBodyConstraintSolver.h"
#include "tests/support/bullet_world.h"

namespace delassus::test {

inline btVector3 boxInertia(const btVector3& half, btScalar mass) {
  btVector3 inertia;
  btBoxShape(half).calculateLocalInertia(mass, inertia);
  return inertia;
}

/// A world that owns its articulated bodies too. These are undamped and never sleep.
class MultiBodyWorld : public OwningWorld<btMultiBodyDynamicsWorld, btMultiBodyConstraintSolver> {
 public:
  using OwningWorld::OwningWorld;
  ~MultiBodyWorld() {
    for (auto& constraint : constraints_) world().removeMultiBodyConstraint(constraint.get());
    for (auto& collider : colliders_) world().removeCollisionObject(collider.get());
    for (auto& tree : trees_) world().removeMultiBody(tree.get());
  }

  btMultiBodyDynamicsWorld& world() { return **this; }

  /// A tree whose links are still to be set up; then call `finish`.
  btMultiBody& addTree(int links, btScalar baseMass, const btVector3& baseInertia, bool fixed,
                       const btVector3& position = btVector3(0, 0, 0)) {
    trees_.push_back(std::make_unique<btMultiBody>(links, baseMass, baseInertia, fixed, false));
    btMultiBody& tree = *trees_.back();
    tree.setBasePos(position);
    tree.setLinearDamping(0);
    tree.setAngularDamping(0);
    tree.setHasSelfCollision(false);
    return tree;
  }

  /// Gives link `link` (−1: the base) a shape about its centre of mass.
  btMultiBodyLinkCollider& addCollider(btMultiBody& tree, int link,
                                       std::unique_ptr<btCollisionShape> shape,
                                       btScalar friction = btScalar(0.5)) {
    auto collider = std::make_unique<btMultiBodyLinkCollider>(&tree, link);
    collider->setCollisionShape(shape.get());
    collider->setFriction(friction);
    collider->setActivationState(DISABLE_DEACTIVATION);
    if (link < 0)
      tree.setBaseCollider(collider.get());
    else
      tree.getLink(link).m_collider = collider.get();
    linkShapes_.push_back(std::move(shape));
    colliders_.push_back(std::move(collider));
    return *colliders_.back();
  }

  /// Ends the set-up of a tree: puts its colliders where its joints say.
  void finish(btMultiBody& tree) {
    tree.finalizeMultiDof();
    world().addMultiBody(&tree);
    // Bullet passes on constraints only of links that have colliders.
    for (int link = 0; link < tree.getNumLinks(); ++link)
      if (!tree.getLinkCollider(link)) addCollider(tree, link, std::make_unique<btEmptyShape>());
    place(tree);
    for (int link = -1; link < tree.getNumLinks(); ++link)
      if (btMultiBodyLinkCollider* collider =
              link < 0 ? tree.getBaseCollider() : tree.getLinkCollider(link))
        world().addCollisionObject(collider, btBroadphaseProxy::DefaultFilter,
                                   btBroadphaseProxy::AllFilter);
  }
  static void place(btMultiBody& tree) {
    btAlignedObjectArray<btQuaternion> rotations;
    btAlignedObjectArray<btVector3> origins;
    tree.forwardKinematics(rotations, origins);
    tree.updateCollisionObjectWorldTransforms(rotations, origins);
  }

  template <class Constraint, class... Arguments>
  Constraint& addConstraint(Arguments&&... arguments) {
    auto constraint = std::make_unique<Constraint>(std::forward<Arguments>(arguments)...);
    Constraint& added = *constraint;
    constraints_.push_back(std::move(constraint));
    world().addMultiBodyConstraint(&added);
    return added;
  }

  const StepReport& report() {
    return dynamic_cast<btDelassusMultiBodyConstraintSolver&>(solver()).report();
  }

 private:
  std::vector<std::unique_ptr<btCollisionShape>> linkShapes_;
  std::vector<std::unique_ptr<btMultiBody>> trees_;
  std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders_;
  std::vector<std::unique_ptr<btMultiBodyConstraint>> constraints_;
};

struct DelassusMultiBodyWorld : MultiBodyWorld {
  DelassusMultiBodyWorld()
      : MultiBodyWorld(std::make_unique<btDelassusMultiBodyConstraintSolver>()) {}
};

/// A world with Bullet's own solver, run until it has converged: the measure of parity.
struct StockMultiBodyWorld : MultiBodyWorld {
  explicit StockMultiBodyWorld(int sweeps = 2000)
      : MultiBodyWorld(std::make_unique<btMultiBodyConstraintSolver>()) {
    info().m_numIterations = sweeps;
    info().m_leastSquaresResidualThreshold = 0;
  }
};

}  // namespace delassus::test
