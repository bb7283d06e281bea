#pragma once

#include <btBulletDynamicsCommon.h>

#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "bullet_ext/btDelassusConstraintSolver.h"

namespace delassus::test {

/// Rounding of the Bullet library under test; tolerances are multiples of it.
constexpr double precision = SIMD_EPSILON;
constexpr btScalar notANumber = std::numeric_limits<btScalar>::quiet_NaN();
constexpr bool isDouble = sizeof(btScalar) == sizeof(double);

/// Picks the tolerance that goes with the precision of the build.
constexpr double tolerance(double inDouble, double inFloat) {
  return isDouble ? inDouble : inFloat;
}

/// A tolerance that poses and velocities of this precision can meet from step to step.
Options optionsOfPrecision();

constexpr double friction = 0.5;  ///< of two bodies, where a test does not say otherwise

/// A world that owns everything in it: gravity 9.81 along −y, 60 Hz, bodies with friction 0.5 that
/// never sleep.
template <class World, class Solver>
class OwningWorld {
 public:
  explicit OwningWorld(std::unique_ptr<Solver> solver)
      : solver_(std::move(solver)),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, solver_.get(), &configuration_) {
    world_.setGravity(btVector3(0, -gravity, 0));
  }

  ~OwningWorld() { clear(); }
  OwningWorld(const OwningWorld&) = delete;
  OwningWorld& operator=(const OwningWorld&) = delete;

  static constexpr btScalar gravity = btScalar(9.81);
  static constexpr btScalar step = btScalar(1) / 60;

  World* operator->() { return &world_; }
  World& operator*() { return world_; }
  btContactSolverInfo& info() { return world_.getSolverInfo(); }
  btCollisionDispatcher& dispatcher() { return dispatcher_; }
  /// The solver of a world that was made with ours.
  btDelassusConstraintSolver& delassus() {
    return dynamic_cast<btDelassusConstraintSolver&>(*solver_);
  }
  const StepReport& report() { return delassus().report(); }
  Solver& solver() { return *solver_; }

  btRigidBody& addBody(std::unique_ptr<btCollisionShape> shape, const btTransform& pose,
                       btScalar mass) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shape->calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape.get(), inertia);
    info.m_startWorldTransform = pose;
    info.m_friction = btScalar(friction);
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    bodies_.back()->setActivationState(DISABLE_DEACTIVATION);
    shapes_.push_back(std::move(shape));
    world_.addRigidBody(bodies_.back().get());
    return *bodies_.back();
  }
  btRigidBody& addBox(const btVector3& half, const btVector3& position, btScalar mass = 1) {
    return addBody(std::make_unique<btBoxShape>(half), at(position), mass);
  }
  btRigidBody& addCube(const btVector3& position, btScalar mass = 1) {
    return addBox(btVector3(0.5, 0.5, 0.5), position, mass);
  }
  btRigidBody& addSphere(btScalar radius, const btVector3& position, btScalar mass = 1) {
    return addBody(std::make_unique<btSphereShape>(radius), at(position), mass);
  }
  /// A wide static slab with its top at y = 0. Its friction is 1, so that a pair has the friction
  /// of the other body.
  btRigidBody& addGround() {
    btRigidBody& ground = addBox(btVector3(100, 1, 100), btVector3(0, -1, 0), 0);
    ground.setFriction(1);
    return ground;
  }

  template <class Joint, class... Arguments>
  Joint& addJoint(Arguments&&... arguments) {
    auto joint = std::make_unique<Joint>(std::forward<Arguments>(arguments)...);
    Joint& added = *joint;
    joints_.push_back(std::move(joint));
    world_.addConstraint(&added);
    return added;
  }

  void remove(btRigidBody& body) {
    world_.removeRigidBody(&body);
    erase(bodies_, body);
  }
  void remove(btTypedConstraint& joint) {
    world_.removeConstraint(&joint);
    erase(joints_, joint);
  }

  /// Takes out and deletes all bodies, joints and shapes.
  void clear() {
    for (auto& joint : joints_) world_.removeConstraint(joint.get());
    for (auto& body : bodies_) world_.removeRigidBody(body.get());
    joints_.clear();
    bodies_.clear();
    shapes_.clear();
  }

  void advance(int steps = 1) {
    for (int i = 0; i < steps; ++i) world_.stepSimulation(step, 0);
  }

  /// All contact points of all manifolds, in the order of the dispatcher.
  std::vector<btManifoldPoint*> points() {
    std::vector<btManifoldPoint*> all;
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
      btPersistentManifold* manifold = dispatcher_.getManifoldByIndexInternal(i);
      for (int j = 0; j < manifold->getNumContacts(); ++j)
        all.push_back(&manifold->getContactPoint(j));
    }
    return all;
  }

  static btTransform at(const btVector3& position) {
    return btTransform(btQuaternion::getIdentity(), position);
  }

 private:
  template <class List, class Item>
  static void erase(List& list, const Item& item) {
    for (auto it = list.begin(); it != list.end(); ++it)
      if (it->get() == &item) {
        list.erase(it);
        return;
      }
  }

  std::unique_ptr<Solver> solver_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  World world_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<std::unique_ptr<btTypedConstraint>> joints_;
};

using BulletWorld = OwningWorld<btDiscreteDynamicsWorld, btConstraintSolver>;

constexpr double g = BulletWorld::gravity, h = BulletWorld::step;

/// A world with our solver.
struct DelassusWorld : BulletWorld {
  explicit DelassusWorld(const Options& options = {});
};

/// A world with Bullet's own solver, run until it has converged: the measure of parity.
struct StockWorld : BulletWorld {
  explicit StockWorld(int sweeps = 1000);
};

}  // namespace delassus::test
