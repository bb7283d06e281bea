#include "bullet_ext/gather.h"

#include "BulletCollision/NarrowPhaseCollision/btPersistentManifold.h"
#include "BulletDynamics/ConstraintSolver/btTypedConstraint.h"
#include "BulletDynamics/Featherstone/btMultiBodyConstraint.h"
#include "BulletDynamics/Featherstone/btMultiBodyLinkCollider.h"
#include "bullet_ext/extension.h"
#include "delassus/bytes.h"

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

void Group::clear() {
  bodies.clear();
  bodySources.clear();
  contacts.clear();
  contactSources.clear();
  pushes.clear();
  guess.clear();
  idle.clear();
  restless.clear();
  bouncing = turning = turningRows = softRows = 0;
  rows.clear();
  rowGuess.clear();
  joints.clear();
  obsolete.clear();
  articulation.clear();
  multiBodyRows.clear();
  indexOf.clear();
  joined.clear();
}

std::size_t Group::bytes() const {
  return bytesOf(bodies, bodySources, contacts, contactSources, pushes, guess, idle, restless, rows,
                 rowGuess, joints, multiBodyRows, asked) +
         obsolete.capacity() * sizeof(void*) + indexOf.bytes() + joined.bytes() +
         articulation.bytes();
}

void gatherGroup(Group& group, const GroupInput& input, StepReport& report, Extension* extension,
                 bool asStock) {
  const btContactSolverInfo& info = *input.info;
  group.clear();
  gatherBodies(group, input.bodies, input.bodyCount, info, report);
  if (extension) extension->gatherBodies(group, input, report);
  gatherJoined(group, input.constraints, input.constraintCount);
  gatherContacts(group, input.manifolds, input.manifoldCount, info, input.dispatcher, report);
  gatherJoints(group, input.constraints, input.constraintCount, info, report);
  if (extension) extension->gatherRows(group, input, report);
  gatherTurningFriction(group, asStock);
}

const char* faultOfRow(const Row& row) {
  if (!row.jacobianA.allFinite() || !row.jacobianB.allFinite()) return "its axis is not finite";
  if (!std::isfinite(row.target)) return "its target velocity is not finite";
  if (std::isnan(row.lower) || std::isnan(row.upper)) return "a bound is not a number";
  if (row.lower > row.upper) return "its lower bound is above its upper one";
  if (std::isinf(row.lower) && row.lower == row.upper) return "it asks for an infinite impulse";
  if (!std::isfinite(row.compliance) || row.compliance < 0)
    return "its softness is not a number >= 0";
  const double size = row.jacobianA.cwiseAbs().sum() + row.jacobianB.cwiseAbs().sum() +
                      std::abs(row.target) + row.compliance;
  if (!(size <= largestNumber)) return "its numbers are too large";
  return nullptr;
}

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
  // Bullet's partner of those that hold a body to the world, which is in no world.
  const btRigidBody& world = btTypedConstraint::getFixedBody();
  const auto partner = [&](const btRigidBody& body) {
    return &body == &world ? std::string("the world") : nameOf(body);
  };
  return "a joint of " + partner(joint.getRigidBodyA()) + " and " + partner(joint.getRigidBodyB());
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
