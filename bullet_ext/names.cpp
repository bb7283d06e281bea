#include "bullet_ext/names.h"

#include "BulletCollision/NarrowPhaseCollision/btPersistentManifold.h"
#include "BulletDynamics/ConstraintSolver/btTypedConstraint.h"
#include "BulletDynamics/Featherstone/btMultiBodyConstraint.h"
#include "BulletDynamics/Featherstone/btMultiBodyLinkCollider.h"
#include "bullet_ext/group.h"

namespace delassus::bullet {
namespace {

std::string placeOf(const btCollisionObject& object) {
  const int place = object.getWorldArrayIndex();
  return place >= 0 ? "body " + std::to_string(place) : "a body outside the world";
}

std::string quoted(const char* name) { return "'" + std::string(name) + "'"; }

std::string nameOfTree(const btMultiBody& body) {
  if (body.getBaseName()) return "multibody " + quoted(body.getBaseName());
  const btCollisionObject* first = body.getBaseCollider();
  for (int link = 0; !first && link < body.getNumLinks(); ++link)
    first = body.getLinkCollider(link);
  return first ? "the multibody that begins with " + placeOf(*first)
               : "a multibody without colliders";
}

std::string nameOfLink(const btMultiBody& body, int link) {
  if (link < 0) return "the base of " + nameOfTree(body);
  const char* name = body.getLink(link).m_linkName;
  return "link " + std::to_string(link) + (name ? " " + quoted(name) : "") + " of " +
         nameOfTree(body);
}

}  // namespace

std::string nameOf(const btCollisionObject& object) {
  const btMultiBodyLinkCollider* link = btMultiBodyLinkCollider::upcast(&object);
  if (!link || !link->m_multiBody) return placeOf(object);
  return placeOf(object) + " (" + nameOfLink(*link->m_multiBody, link->m_link) + ")";
}

std::string nameOf(const PointSource& source) {
  return "contact " + std::to_string(source.point) + " of " + nameOf(*source.manifold->getBody0()) +
         " and " + nameOf(*source.manifold->getBody1());
}

std::string nameOf(const btTypedConstraint& joint) {
  const btRigidBody& world = fixedBody();
  const auto partner = [&](const btRigidBody& body) {
    return &body == &world ? std::string("the world") : nameOf(body);
  };
  return "a joint of " + partner(joint.getRigidBodyA()) + " and " + partner(joint.getRigidBodyB());
}

const btRigidBody& fixedBody() {
  static const btRigidBody& world = btTypedConstraint::getFixedBody();
  return world;
}

std::string nameOf(btMultiBodyConstraint& constraint) {
  std::string name = "a constraint of ";
  const btMultiBody *a = constraint.getMultiBodyA(), *b = constraint.getMultiBodyB();
  if (a) name += nameOfLink(*a, constraint.getLinkA());
  if (a && b) name += " and ";
  if (b) name += nameOfLink(*b, constraint.getLinkB());
  return name;
}

}  // namespace delassus::bullet
