#include "bullet_ext/gather.h"

#include "BulletCollision/NarrowPhaseCollision/btPersistentManifold.h"
#include "BulletDynamics/ConstraintSolver/btTypedConstraint.h"

namespace delassus::bullet {

void Group::clear() {
  bodies.clear();
  bodySources.clear();
  contacts.clear();
  contactSources.clear();
  pushes.clear();
  guess.clear();
  idle.clear();
  restless.clear();
  bouncing = 0;
  rows.clear();
  rowGuess.clear();
  joints.clear();
  obsolete.clear();
  articulation.clear();
  indexOf.clear();
}

std::size_t Group::bytes() const {
  const auto of = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
  return of(bodies) + of(bodySources) + of(contacts) + of(contactSources) + of(pushes) + of(guess) +
         of(idle) + of(restless) + of(rows) + of(joints) + obsolete.capacity() * sizeof(void*) +
         of(asked) + indexOf.bytes();
}

std::string nameOf(const btCollisionObject& object) {
  const int place = object.getWorldArrayIndex();
  return place >= 0 ? "body " + std::to_string(place) : "a body outside the world";
}

std::string nameOf(const PointSource& source) {
  return "contact " + std::to_string(source.point) + " of " + nameOf(*source.manifold->getBody0()) +
         " and " + nameOf(*source.manifold->getBody1());
}

std::string nameOf(const btTypedConstraint& joint) {
  return "a joint of " + nameOf(joint.getRigidBodyA()) + " and " + nameOf(joint.getRigidBodyB());
}

}  // namespace delassus::bullet
