#include <cmath>

#include "BulletDynamics/ConstraintSolver/btContactSolverInfo.h"
#include "BulletDynamics/Dynamics/btRigidBody.h"
#include "bullet_ext/convert.h"
#include "bullet_ext/first_room.h"
#include "bullet_ext/gather.h"
#include "bullet_ext/names.h"
#include "bullet_ext/prefetch.h"

namespace delassus::bullet {
namespace {

double smallest(const btVector3& v) { return v[v.minAxis()]; }

bool hasPlace(const btCollisionObject& object) {
  const btTransform& pose = object.getWorldTransform();
  return toCore(pose.getOrigin()).cwiseAbs().sum() + toCore(pose.getBasis()).cwiseAbs().sum() <=
         largestNumber;
}

/// Whether a dynamic body has infinite mass. If its inverse mass is zero, its weight in Bullet is
/// not finite. (A body without mass whose static flag the user has cleared weighs nothing instead.)
bool hasInfiniteMass(const btRigidBody& rigid) {
  if (rigid.isStaticOrKinematicObject()) return false;
  return rigid.getInvMass() == 0 ? !toCore(rigid.getTotalForce()).allFinite()
                                 : std::abs(rigid.getInvMass()) * largestNumber < 1;
}

/// The fault of a body, or null.
const char* faultOfBody(const btRigidBody& rigid) {
  const btTransform& pose = rigid.getWorldTransform();
  if (!toCore(pose.getOrigin()).allFinite() || !toCore(pose.getBasis()).allFinite())
    return "its pose is not finite";
  if (!toCore(rigid.getLinearVelocity(), rigid.getAngularVelocity()).allFinite())
    return "its velocity is not finite";
  if (rigid.isKinematicObject()) return nullptr;
  if (hasInfiniteMass(rigid)) return "its mass is infinite";
  const Mat3 inertia = toCore(rigid.getInvInertiaTensorWorld());
  if (!std::isfinite(rigid.getInvMass()) || !inertia.allFinite() ||
      !toCore(rigid.getLinearFactor(), rigid.getAngularFactor()).allFinite())
    return "its mass is not finite";
  if (rigid.getInvMass() < 0 || inertia.diagonal().minCoeff() < 0 ||
      smallest(rigid.getInvInertiaDiagLocal()) < 0 || smallest(rigid.getLinearFactor()) < 0)
    return "its mass is negative";
  if (!toCore(rigid.getTotalForce(), rigid.getTotalTorque()).allFinite())
    return "the force on it is not finite";
  return nullptr;
}

/// The change of angular velocity that the rotating inertia causes in one step, by the gyroscopic
/// mode that the body asks for.
Vec3 gyroscopicGain(const btRigidBody& rigid, const btContactSolverInfo& info) {
  Vec3 gain = Vec3::Zero();
  const btVector3& inertia = rigid.getInvInertiaDiagLocal();
  const bool round = inertia.x() == inertia.y() && inertia.y() == inertia.z();
  if (round) return gain;  // ω × I ω = 0

  const int flags = rigid.getFlags();
  if (flags & BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT)
    gain -= toCore(rigid.getInvInertiaTensorWorld()) *
            toCore(rigid.computeGyroscopicForceExplicit(info.m_maxGyroscopicForce)) *
            info.m_timeStep;
  if (flags & BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD)
    gain += toCore(rigid.computeGyroscopicImpulseImplicit_World(info.m_timeStep));
  if (flags & BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY)
    gain += toCore(rigid.computeGyroscopicImpulseImplicit_Body(info.m_timeStep));
  return gain;
}

/// Adds the inverse mass of a dynamic body, and the effect of forces on its velocity over the step.
void addForces(const btRigidBody& rigid, const btContactSolverInfo& info, Body& body) {
  const double h = info.m_timeStep;
  const double inverseMass = rigid.getInvMass();
  const Vec3 angularFactor = toCore(rigid.getAngularFactor());
  const Mat3 tensor = toCore(rigid.getInvInertiaTensorWorld());

  body.inverseMass = inverseMass * toCore(rigid.getLinearFactor());
  body.inverseInertia = 0.5 * (tensor + tensor.transpose());

  // Bullet's forces carry the factors already: gravity and applyForce put them in.
  const Vec3 gain = h * inverseMass * toCore(rigid.getTotalForce());
  body.velocity.head<3>() += gain;
  body.gain = gain.norm();
  const Vec3 torque = h * toCore(rigid.getTotalTorque());
  const Vec3 turn = body.inverseInertia * torque + gyroscopicGain(rigid, info);
  const Vec3 isFree = (angularFactor.array() != 0).cast<double>();
  body.velocity.tail<3>() += isFree.cwiseProduct(turn);
  if (angularFactor != Vec3::Ones())
    body.inverseInertia =
        angularFactor.asDiagonal() * body.inverseInertia * angularFactor.asDiagonal();
}

/// Fills a record; its numbers may be NaN, which the caller checks.
void fillBody(const btRigidBody& rigid, const btContactSolverInfo& info, Body& body,
              BodySource& source) {
  source.before = toCore(rigid.getLinearVelocity(), rigid.getAngularVelocity());
  // A kinematic body has a velocity and no inverse mass, even if it was given a mass.
  body.velocity = source.before;
  if (!rigid.isKinematicObject()) addForces(rigid, info, body);
}

/// Whether the record may be used.
bool sound(const btRigidBody& rigid, const Body& body) {
  const double sum = body.inverseMass.cwiseAbs().sum() + body.inverseInertia.cwiseAbs().sum() +
                     body.velocity.cwiseAbs().sum();
  return hasPlace(rigid) && sum <= largestNumber && !hasInfiniteMass(rigid) &&
         body.inverseMass.minCoeff() >= 0 && smallest(rigid.getInvInertiaDiagLocal()) >= 0 &&
         body.inverseInertia.diagonal().minCoeff() >= 0;
}

void prefetchBody(const btCollisionObject& object) {
  const auto* begin = reinterpret_cast<const char*>(&object);
  prefetch(begin, begin + sizeof(btRigidBody));
}

}  // namespace

int bodyIndex(Group& group, btCollisionObject& object, const btContactSolverInfo& info,
              StepReport& report) {
  btRigidBody* rigid = btRigidBody::upcast(&object);
  if (!rigid) {
    const int* limb = group.indexOf.find(&object);
    return limb ? *limb : fixedWorld;
  }
  // A body out of simulation and a static one keep their places, whatever their velocities are.
  const bool fixed = rigid->isStaticObject() || rigid->getInvMass() == 0 ||
                     rigid->getActivationState() == DISABLE_SIMULATION;
  if (fixed && !rigid->isKinematicObject() && hasPlace(*rigid) && !hasInfiniteMass(*rigid))
    return fixedWorld;
  if (const int* known = group.indexOf.find(&object)) return *known;

  const int index = static_cast<int>(group.bodies.size());
  fillBody(*rigid, info, group.bodies.emplace_back(),
           group.bodySources.emplace_back(BodySource{rigid, Vec6::Zero()}));
  if (sound(*rigid, group.bodies.back())) {
    group.indexOf.insert(&object, index);
    return index;
  }

  group.bodies.pop_back();
  group.bodySources.pop_back();
  group.indexOf.insert(&object, leftOut);
  const char* fault = faultOfBody(*rigid);
  report.leaveOut(nameOf(object), fault ? fault : "its numbers are too large");
  return leftOut;
}

void gatherBodies(Group& group, const GroupInput& input, StepReport& report) {
  makeFirstRoom([&] { return input.bodyCount; }, group.bodies, group.bodySources);
  group.indexOf.makeRoom(input.bodyCount);
  constexpr int ahead = 3;
  for (int i = 0; i < input.bodyCount; ++i) {
    if (i + ahead < input.bodyCount) prefetchBody(*input.bodies[i + ahead]);
    bodyIndex(group, *input.bodies[i], *input.info, report);
  }
}

}  // namespace delassus::bullet
