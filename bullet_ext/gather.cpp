#include "bullet_ext/gather.h"

#include <algorithm>

#include "BulletCollision/BroadphaseCollision/btDispatcher.h"
#include "BulletCollision/NarrowPhaseCollision/btPersistentManifold.h"
#include "BulletDynamics/ConstraintSolver/btContactSolverInfo.h"
#include "BulletDynamics/Dynamics/btRigidBody.h"
#include "bullet_ext/convert.h"

namespace delassus::bullet {
namespace {

/// What is wrong with a body, or null.
const char* faultOf(const btRigidBody& rigid) {
  const btTransform& pose = rigid.getWorldTransform();
  if (!toCore(pose.getOrigin()).allFinite() || !toCore(pose.getBasis()).allFinite())
    return "its pose is not finite";
  if (!toCore(rigid.getLinearVelocity(), rigid.getAngularVelocity()).allFinite())
    return "its velocity is not finite";
  if (rigid.isKinematicObject()) return nullptr;
  const Mat3 inertia = toCore(rigid.getInvInertiaTensorWorld());
  if (!std::isfinite(rigid.getInvMass()) || !inertia.allFinite() ||
      !toCore(rigid.getLinearFactor(), rigid.getAngularFactor()).allFinite())
    return "its mass is not finite";
  if (rigid.getInvMass() < 0 || inertia.diagonal().minCoeff() < 0 ||
      rigid.getLinearFactor()[rigid.getLinearFactor().minAxis()] < 0)
    return "its mass is negative";
  if (!toCore(rigid.getTotalForce(), rigid.getTotalTorque()).allFinite())
    return "the force on it is not finite";
  return nullptr;
}

/// The gain of angular velocity from the inertia of rotation over one step, in each mode the body
/// asks for.
Vec3 gyroscopicGain(const btRigidBody& rigid, const btContactSolverInfo& info) {
  Vec3 gain = Vec3::Zero();
  const int flags = rigid.getFlags();
  if (flags & BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT)
    gain -= toCore(rigid.getInvInertiaTensorWorld()) *
            toCore(rigid.computeGyroscopicForceExplicit(info.m_maxGyroscopicForce)) *
            info.m_timeStep;
  if (flags & BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD)
    gain += toCore(rigid.computeGyroscopicImpulseImplicit_World(info.m_timeStep));
  if (flags & BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY)
    gain += toCore(rigid.computeGyroscopicImpulseImplicit_Body(info.m_timeStep));
  // The implicit modes divide by the inertia; a body that cannot turn has none.
  return gain.allFinite() ? gain : Vec3::Zero();
}

Body dynamicBody(const btRigidBody& rigid, const Vec6& before, const btContactSolverInfo& info) {
  const double h = info.m_timeStep;
  const Vec3 angularFactor = toCore(rigid.getAngularFactor());
  const Mat3 tensor = toCore(rigid.getInvInertiaTensorWorld());
  const Mat3 inverseInertia = 0.5 * (tensor + tensor.transpose());

  Body body;
  body.inverseMass = static_cast<double>(rigid.getInvMass()) * toCore(rigid.getLinearFactor());
  body.inverseInertia = angularFactor.asDiagonal() * inverseInertia * angularFactor.asDiagonal();

  // Bullet's forces carry the factors already: gravity and applyForce put them in.
  body.velocity = before;
  body.velocity.head<3>() += h * rigid.getInvMass() * toCore(rigid.getTotalForce());
  body.velocity.tail<3>() += angularFactor.cwiseProduct(
      h * (inverseInertia * toCore(rigid.getTotalTorque())) + gyroscopicGain(rigid, info));
  return body;
}

/// How hard a contact is: the coefficients that stand for it in Bullet's two descriptions.
struct Softness {
  double erp, cfm;
  bool own;  ///< the point brings a compliance of its own
};

Softness softnessOf(const btManifoldPoint& point, const btContactSolverInfo& info) {
  Softness soft{info.m_erp2, info.m_globalCfm, false};
  const int flags = point.m_contactPointFlags;
  if (flags & (BT_CONTACT_FLAG_HAS_CONTACT_CFM | BT_CONTACT_FLAG_HAS_CONTACT_ERP)) {
    if (flags & BT_CONTACT_FLAG_HAS_CONTACT_CFM) {
      soft.cfm = point.m_contactCFM;
      soft.own = soft.cfm > 0;
    }
    if (flags & BT_CONTACT_FLAG_HAS_CONTACT_ERP) soft.erp = point.m_contactERP;
  } else if (flags & BT_CONTACT_FLAG_CONTACT_STIFFNESS_DAMPING) {
    // An implicit spring and damper: r/h = −k (d + h u) − c u.
    const double spring = static_cast<double>(info.m_timeStep) * point.m_combinedContactStiffness1;
    const double both = std::max<double>(spring + point.m_combinedContactDamping1, SIMD_EPSILON);
    soft = {spring / both, 1 / both, true};
  }
  return soft;
}

/// One manifold, its bodies found.
struct Pair {
  const btPersistentManifold& manifold;
  int a, b;
  Vec3 centreA, centreB;
  Vec6 beforeA, beforeB;
};

struct GatheredPoint {
  Contact contact;
  double push = 0;
};

GatheredPoint gatherPoint(const Pair& pair, const btManifoldPoint& point,
                          const btContactSolverInfo& info) {
  GatheredPoint out;
  Contact& c = out.contact;
  c.a = pair.a;
  c.b = pair.b;
  c.armA = toCore(point.getPositionWorldOnA()) - pair.centreA;
  c.armB = toCore(point.getPositionWorldOnB()) - pair.centreB;
  c.frame = contactFrame(point.m_normalWorldOnB);
  c.friction = point.m_combinedFriction < 0 ? 0 : point.m_combinedFriction;

  const Vec3 approach = pair.beforeA.head<3>() + pair.beforeA.tail<3>().cross(c.armA) -
                        pair.beforeB.head<3>() - pair.beforeB.tail<3>().cross(c.armB);
  const double a = c.frame.col(0).dot(approach);
  const bool bounces = std::abs(a) >= info.m_restitutionVelocityThreshold;
  const double bounce = bounces ? std::max(0.0, -a * point.m_combinedRestitution) : 0;

  const double h = info.m_timeStep;
  const double d = static_cast<double>(point.getDistance()) + info.m_linearSlop;
  const Softness soft = softnessOf(point, info);
  const bool split =
      info.m_splitImpulse && d <= info.m_splitImpulsePenetrationThreshold && !soft.own;
  const double recovery = d < 0 ? -d * soft.erp / h : 0;
  c.target[0] = bounce - std::max(d, 0.0) / h + (split ? 0 : recovery);
  c.compliance = soft.cfm < 0 ? 0 : soft.cfm / h;
  out.push = split ? recovery : 0;
  return out;
}

/// What is wrong with a contact point, or null.
const char* faultOf(const btManifoldPoint& point, const GatheredPoint& gathered) {
  // Float normals are unit to 1e-6; beyond this a normal is a mistake, not rounding.
  constexpr double unitTolerance = 1e-3;
  const Contact& c = gathered.contact;
  const Vec3 normal = toCore(point.m_normalWorldOnB);
  if (!normal.allFinite()) return "its normal is not finite";
  if (std::abs(normal.norm() - 1) > unitTolerance) return "its normal is not a unit vector";
  if (!std::isfinite(point.getDistance())) return "its distance is not finite";
  if (!c.armA.allFinite() || !c.armB.allFinite()) return "its position is not finite";
  if (!std::isfinite(c.friction)) return "its friction is not finite";
  if (!std::isfinite(point.m_combinedRestitution)) return "its restitution is not finite";
  if (!c.target.allFinite() || !std::isfinite(c.compliance) || !std::isfinite(gathered.push))
    return "its softness is not finite";
  return nullptr;
}

Vec3 guessOf(const btManifoldPoint& point, const btContactSolverInfo& info) {
  if (!(info.m_solverMode & SOLVER_USE_WARMSTARTING)) return Vec3::Zero();
  const Vec3 last{point.m_appliedImpulse, point.m_appliedImpulseLateral1,
                  point.m_appliedImpulseLateral2};
  if (!last.allFinite() || last[0] < 0) return Vec3::Zero();
  return info.m_warmstartingFactor * last;
}

/// The dispatcher's word, as in groups that the world has split itself; an unsplit group comes
/// unfiltered.
bool responds(btDispatcher* dispatcher, const btCollisionObject& a, const btCollisionObject& b) {
  return dispatcher ? dispatcher->needsResponse(&a, &b)
                    : a.hasContactResponse() && b.hasContactResponse();
}

Vec6 before(const Group& group, int body) {
  return body >= 0 ? group.bodySources[body].before : Vec6::Zero();
}

void gatherManifold(Group& group, btPersistentManifold& manifold, int a, int b,
                    const btContactSolverInfo& info, StepReport& report) {
  const bool takesPart = a != leftOut && b != leftOut && (group.movable(a) || group.movable(b));
  const Pair pair{manifold,
                  a,
                  b,
                  toCore(manifold.getBody0()->getWorldTransform().getOrigin()),
                  toCore(manifold.getBody1()->getWorldTransform().getOrigin()),
                  before(group, a),
                  before(group, b)};

  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    const btManifoldPoint& point = manifold.getContactPoint(i);
    const bool tooFar = point.getDistance() > manifold.getContactProcessingThreshold();
    if (!takesPart || tooFar) {
      group.idle.push_back({&manifold, i});
      continue;
    }
    const GatheredPoint gathered = gatherPoint(pair, point, info);
    if (const char* fault = faultOf(point, gathered)) {
      report.tell("contact " + std::to_string(i) + " of " + nameOf(*manifold.getBody0()) + " and " +
                  nameOf(*manifold.getBody1()) + " left out: " + fault);
      group.idle.push_back({&manifold, i});
      continue;
    }
    group.contacts.push_back(gathered.contact);
    group.contactSources.push_back({&manifold, i});
    group.pushes.push_back(gathered.push);
    group.guess.push_back(guessOf(point, info));
  }
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
  rows.clear();
  joints.clear();
  obsolete.clear();
  indexOf.clear();
}

std::size_t Group::bytes() const {
  const auto of = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
  return of(bodies) + of(bodySources) + of(contacts) + of(contactSources) + of(pushes) + of(guess) +
         of(idle) + of(rows) + of(joints) + of(obsolete) + indexOf.bucket_count() * sizeof(void*);
}

std::string nameOf(const btCollisionObject& object) {
  const int place = object.getWorldArrayIndex();
  return place >= 0 ? "body " + std::to_string(place) : "a body outside the world";
}

int bodyIndex(Group& group, btCollisionObject& object, const btContactSolverInfo& info,
              StepReport& report) {
  btRigidBody* rigid = btRigidBody::upcast(&object);
  if (!rigid) return fixedWorld;
  // A body out of simulation keeps its place whatever its velocity says, and so does a static one.
  const bool fixed = rigid->isStaticObject() || rigid->getInvMass() == 0 ||
                     rigid->getActivationState() == DISABLE_SIMULATION;
  if (fixed && !rigid->isKinematicObject()) return fixedWorld;

  const auto [entry, isNew] = group.indexOf.try_emplace(&object, leftOut);
  if (!isNew) return entry->second;
  if (const char* fault = faultOf(*rigid)) {
    report.tell(nameOf(object) + " left out: " + fault);
    return leftOut;
  }

  // A kinematic body has a velocity and no inverse mass, whatever mass is left in it.
  const Vec6 velocity = toCore(rigid->getLinearVelocity(), rigid->getAngularVelocity());
  Body body;
  body.velocity = velocity;
  if (!rigid->isKinematicObject()) body = dynamicBody(*rigid, velocity, info);
  entry->second = static_cast<int>(group.bodies.size());
  group.bodies.push_back(body);
  group.bodySources.push_back({rigid, velocity});
  return entry->second;
}

void gatherBodies(Group& group, btCollisionObject** bodies, int count,
                  const btContactSolverInfo& info, StepReport& report) {
  for (int i = 0; i < count; ++i) bodyIndex(group, *bodies[i], info, report);
}

void gatherContacts(Group& group, btPersistentManifold** manifolds, int count,
                    const btContactSolverInfo& info, btDispatcher* dispatcher, StepReport& report) {
  for (int i = 0; i < count; ++i) {
    btPersistentManifold& manifold = *manifolds[i];
    if (manifold.getNumContacts() == 0) continue;
    // Manifolds carry their bodies as const; the solver's are not, as in every Bullet solver.
    auto& a = const_cast<btCollisionObject&>(*manifold.getBody0());
    auto& b = const_cast<btCollisionObject&>(*manifold.getBody1());
    if (!responds(dispatcher, a, b)) continue;
    const int indexA = bodyIndex(group, a, info, report);
    const int indexB = bodyIndex(group, b, info, report);
    gatherManifold(group, manifold, indexA, indexB, info, report);
  }
}

}  // namespace delassus::bullet
