#include "demos/scenes/world.h"

#include <cmath>

namespace demos {

btScalar surfaceFriction(double mu) { return btScalar(std::sqrt(mu)); }

World::World()
    : dispatcher_(&configuration_),
      dynamics_(std::make_unique<btDiscreteDynamicsWorld>(&dispatcher_, &broadphase_, &stockSolver_,
                                                          &configuration_)) {
  dynamics_->setGravity(vec3(0, -9.81, 0));
  dynamics_->getDispatchInfo().m_deterministicOverlappingPairs = true;
}

World::~World() {
  // First the things that take their own bodies out of the world.
  kept_.clear();
  for (int i = dynamics_->getNumConstraints() - 1; i >= 0; --i)
    dynamics_->removeConstraint(dynamics_->getConstraint(i));
  for (int i = dynamics_->getNumCollisionObjects() - 1; i >= 0; --i)
    dynamics_->removeCollisionObject(dynamics_->getCollisionObjectArray()[i]);
}

void World::setSolver(btConstraintSolver& solver) { dynamics_->setConstraintSolver(&solver); }

btBoxShape& World::box(const btVector3& halfSize) {
  return own(std::make_unique<btBoxShape>(halfSize));
}

btSphereShape& World::sphere(btScalar radius) {
  return own(std::make_unique<btSphereShape>(radius));
}

btStaticPlaneShape& World::plane(const btVector3& normal, btScalar offset) {
  return own(std::make_unique<btStaticPlaneShape>(normal, offset));
}

btRigidBody& World::add(btScalar mass, btCollisionShape& shape, const btTransform& pose,
                        const Material& material) {
  btVector3 inertia(0, 0, 0);
  if (mass > 0) shape.calculateLocalInertia(mass, inertia);
  btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
  info.m_startWorldTransform = pose;
  info.m_friction = material.friction;
  info.m_restitution = material.restitution;
  return add(std::make_unique<btRigidBody>(info));
}

btRigidBody& World::add(std::unique_ptr<btRigidBody> body) {
  body->setActivationState(DISABLE_DEACTIVATION);
  dynamics_->addRigidBody(body.get());
  bodies_.push_back(std::move(body));
  return *bodies_.back();
}

btTypedConstraint& World::join(std::unique_ptr<btTypedConstraint> joint, bool linkedCollide) {
  dynamics_->addConstraint(joint.get(), !linkedCollide);
  joints_.push_back(std::move(joint));
  return *joints_.back();
}

void World::step(double dt) {
  if (script_) script_(time_);
  if (substeps_ == 1)
    dynamics_->stepSimulation(btScalar(dt), 0);
  else
    dynamics_->stepSimulation(btScalar(dt), substeps_, btScalar(dt) / btScalar(substeps_));
  time_ += dt;
}

void World::run(double seconds, double hz) {
  const long steps = std::lround(seconds * hz);
  for (long i = 0; i < steps; ++i) step(1 / hz);
}

std::vector<btRigidBody*> World::movableBodies() const {
  std::vector<btRigidBody*> movable;
  for (int i = 0; i < dynamics_->getNumCollisionObjects(); ++i) {
    btRigidBody* body = btRigidBody::upcast(dynamics_->getCollisionObjectArray()[i]);
    if (body != nullptr && !body->isStaticOrKinematicObject()) movable.push_back(body);
  }
  return movable;
}

int World::contactCount() const {
  int count = 0;
  for (int i = 0; i < dynamics_->getDispatcher()->getNumManifolds(); ++i)
    count += dynamics_->getDispatcher()->getManifoldByIndexInternal(i)->getNumContacts();
  return count;
}

}  // namespace demos
