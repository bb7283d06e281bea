#include "bullet_ext/obsolete.h"

#include <algorithm>

#include "BulletDynamics/ConstraintSolver/btTypedConstraint.h"
#include "bullet_ext/convert.h"
#include "bullet_ext/group.h"
#include "bullet_ext/names.h"
#include "bullet_ext/step_report.h"

namespace delassus::bullet {
namespace {

btSolverBody fixedSolverBody() {
  btSolverBody body;
  const btVector3 zero(0, 0, 0), one(1, 1, 1);
  body.m_worldTransform.setIdentity();
  body.m_deltaLinearVelocity = body.m_deltaAngularVelocity = zero;
  body.m_angularFactor = body.m_linearFactor = one;
  body.m_invMass = zero;
  body.m_pushVelocity = body.m_turnVelocity = zero;
  body.m_linearVelocity = body.m_angularVelocity = zero;
  body.m_externalForceImpulse = body.m_externalTorqueImpulse = zero;
  body.m_originalBody = nullptr;
  return body;
}

Vec6 delta(const btSolverBody& body) {
  return toCore(body.m_deltaLinearVelocity, body.m_deltaAngularVelocity);
}

void setDelta(btSolverBody& body, const Vec6& gain) {
  body.m_deltaLinearVelocity = toBullet(gain.head<3>());
  body.m_deltaAngularVelocity = toBullet(gain.tail<3>());
}

}  // namespace

btSolverBody solverBody(const Group& group, int index) {
  btSolverBody out = fixedSolverBody();
  if (index < 0 || group.isLimb(index)) return out;
  const Body& body = group.bodies[index];
  const BodySource& source = group.bodySources[index];
  out.m_worldTransform = source.rigid->getWorldTransform();
  out.m_angularFactor = source.rigid->getAngularFactor();
  out.m_linearFactor = source.rigid->getLinearFactor();
  out.m_invMass = toBullet(body.inverseMass);
  out.m_linearVelocity = source.rigid->getLinearVelocity();
  out.m_angularVelocity = source.rigid->getAngularVelocity();
  const Vec6 gain = body.velocity - source.before;
  out.m_externalForceImpulse = toBullet(gain.head<3>());
  out.m_externalTorqueImpulse = toBullet(gain.tail<3>());
  out.m_originalBody = source.rigid;
  return out;
}

void ObsoleteConstraints::start(const Group& group) {
  acted_.assign(group.obsolete.size(), 0);
  leftOut_.assign(group.obsolete.size(), 0);
  free_.clear();
  bodies_.clear();
  for (std::size_t i = 0; i < group.bodies.size(); ++i) {
    free_.push_back(group.bodies[i].velocity);
    bodies_.push_back(solverBody(group, static_cast<int>(i)));
  }
  bodies_.push_back(solverBody(group, fixedWorld));
}

void ObsoleteConstraints::setDeltas(const std::vector<Body>& moved) {
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const Vec6 gain = moved[i].velocity - free_[i];
    setDelta(bodies_[static_cast<int>(i)], gain);
  }
}

bool ObsoleteConstraints::sweep(Group& group, double timeStep, const std::vector<Body>& moved,
                                StepReport& report) {
  setDeltas(moved);
  changed_.assign(group.bodies.size(), 0);
  const std::size_t fixed = bodies_.size() - 1;
  for (std::size_t i = 0; i < group.obsolete.size(); ++i) {
    btTypedConstraint& constraint = *group.obsolete[i];
    if (leftOut_[i] || !constraint.isEnabled()) continue;  // it may disable itself
    const auto indexOf = [&](const btCollisionObject& object) {
      const int* index = group.indexOf.find(&object);
      return index ? *index : fixedWorld;
    };
    const int a = indexOf(constraint.getRigidBodyA()), b = indexOf(constraint.getRigidBodyB());
    if (a == leftOut || b == leftOut) continue;

    btSolverBody& bodyA = bodies_[a >= 0 ? a : fixed];
    btSolverBody& bodyB = bodies_[b >= 0 ? b : fixed];
    const Vec6 beforeA = delta(bodyA), beforeB = delta(bodyB);
    constraint.solveConstraintObsolete(bodyA, bodyB, static_cast<btScalar>(timeStep));
    if (!((delta(bodyA) - beforeA).norm() + (delta(bodyB) - beforeB).norm() <= largestNumber)) {
      report.leaveOut(nameOf(constraint), "the velocities that it sets are not finite");
      leftOut_[i] = 1;
      setDelta(bodyA, beforeA);
      setDelta(bodyB, beforeB);
      continue;
    }

    const auto take = [&](int body, const Vec6& gain) {
      if (!group.movable(body) || !gain.any()) return;
      group.bodies[body].velocity += gain;
      acted_[i] = changed_[body] = 1;
    };
    take(a, delta(bodyA) - beforeA);
    if (b != a) take(b, delta(bodyB) - beforeB);
  }
  return std::find(changed_.begin(), changed_.end(), 1) != changed_.end();
}

int ObsoleteConstraints::acted() const {
  return static_cast<int>(std::count(acted_.begin(), acted_.end(), 1));
}

}  // namespace delassus::bullet
