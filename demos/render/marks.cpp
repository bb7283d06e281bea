#include "demos/render/marks.h"

#include <BulletDynamics/ConstraintSolver/btGeneric6DofSpring2Constraint.h>
#include <LinearMath/btAabbUtil2.h>

#include <optional>

#include "demos/render/shape_mesh.h"
#include "demos/scenes/measures.h"

namespace demos::render {

using delassus::Mode;
using Eigen::Vector3d;

namespace {

/// Relative velocity at the point, body 0 against body 1, along the surface, m/s.
double slidingSpeed(const btPersistentManifold& manifold, const btManifoldPoint& point) {
  const auto velocity = [](const btCollisionObject* object, const btVector3& place) {
    const btRigidBody* body = btRigidBody::upcast(object);
    return body == nullptr ? btVector3(0, 0, 0)
                           : body->getVelocityInLocalPoint(place - body->getCenterOfMassPosition());
  };
  const btVector3 u = velocity(manifold.getBody0(), point.getPositionWorldOnA()) -
                      velocity(manifold.getBody1(), point.getPositionWorldOnB());
  return double((u - point.m_normalWorldOnB * u.dot(point.m_normalWorldOnB)).length());
}

/// A contact slides if its reaction is on the border of its cone and it has speed. A contact at
/// rest that uses all its friction still sticks.
Mode carryingMode(const btPersistentManifold& manifold, const btManifoldPoint& point) {
  // Stock solvers bound friction by a normal impulse that is not final yet.
  constexpr double nearly = 0.999;
  constexpr double atRest = 1e-3;  // m/s
  const double bound = double(point.m_combinedFriction) * double(point.m_appliedImpulse);
  const btVector3 lateral =
      writtenReaction(point) - point.m_normalWorldOnB * point.m_appliedImpulse;
  const bool slides =
      double(lateral.length()) >= nearly * bound && slidingSpeed(manifold, point) > atRest;
  return slides ? Mode::Slide : Mode::Stick;
}

/// The reaction on the one body that moves, or else in the direction against gravity. `force` is
/// the reaction on body 0.
Vector3d carrying(const Vector3d& force, const btCollisionObject& body0,
                  const btCollisionObject& body1, const Vector3d& gravity) {
  const bool fixed0 = body0.isStaticOrKinematicObject(), fixed1 = body1.isStaticOrKinematicObject();
  if (fixed0 != fixed1) return fixed0 ? Vector3d(-force) : force;
  return force.dot(gravity) > 0 ? Vector3d(-force) : force;
}

/// Where a joint holds its bodies together, in the world.
std::optional<btVector3> anchor(const btTypedConstraint& joint) {
  const btTransform& a = joint.getRigidBodyA().getWorldTransform();
  switch (joint.getConstraintType()) {
    case POINT2POINT_CONSTRAINT_TYPE:
      return a * static_cast<const btPoint2PointConstraint&>(joint).getPivotInA();
    case HINGE_CONSTRAINT_TYPE:
      return a * static_cast<const btHingeConstraint&>(joint).getAFrame().getOrigin();
    case CONETWIST_CONSTRAINT_TYPE:
      return a * static_cast<const btConeTwistConstraint&>(joint).getAFrame().getOrigin();
    case SLIDER_CONSTRAINT_TYPE:
      // Body b travels along the slide, and the force acts at the joint's frame on it.
      return joint.getRigidBodyB().getWorldTransform() *
             static_cast<const btSliderConstraint&>(joint).getFrameOffsetB().getOrigin();
    case D6_CONSTRAINT_TYPE:
    case D6_SPRING_CONSTRAINT_TYPE:
      return a * static_cast<const btGeneric6DofConstraint&>(joint).getFrameOffsetA().getOrigin();
    case D6_SPRING_2_CONSTRAINT_TYPE:
    case FIXED_CONSTRAINT_TYPE:
      return a * static_cast<btGeneric6DofSpring2Constraint&>(const_cast<btTypedConstraint&>(joint))
                     .getFrameOffsetA()
                     .getOrigin();
    default:
      return std::nullopt;
  }
}

}  // namespace

void PersistenceWatch::beforeGroup(const GroupInput& group) {
  for (int i = 0; i < group.manifoldCount; ++i) {
    const btPersistentManifold& manifold = *group.manifolds[i];
    for (int j = 0; j < manifold.getNumContacts(); ++j) {
      const btManifoldPoint& point = manifold.getContactPoint(j);
      if (point.m_appliedImpulse > 0 || (first_ && point.getDistance() <= 0))
        persisted_.insert({&manifold, j});
    }
  }
}

std::vector<ContactMark> contactMarks(const World& world, const PersistenceWatch& watch, double h) {
  std::vector<ContactMark> marks;
  const Vector3d gravity = toDouble(world.dynamics().getGravity());
  btDispatcher* dispatcher = const_cast<btDiscreteDynamicsWorld&>(world.dynamics()).getDispatcher();
  for (int i = 0; i < dispatcher->getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *dispatcher->getManifoldByIndexInternal(i);
    const btCollisionObject &body0 = *manifold.getBody0(), &body1 = *manifold.getBody1();
    for (int j = 0; j < manifold.getNumContacts(); ++j) {
      const btManifoldPoint& point = manifold.getContactPoint(j);
      const bool carries = point.m_appliedImpulse > 0;
      if (!carries && !watch.persisted(manifold, j)) continue;
      // The bodies have moved since the point was found, and the point moves with them.
      const btVector3 place = (body0.getWorldTransform() * point.m_localPointA +
                               body1.getWorldTransform() * point.m_localPointB) /
                              2;
      ContactMark mark{toDouble(place), Vector3d::Zero(), Mode::Open};
      if (carries) {
        mark.force = carrying(toDouble(writtenReaction(point)) / h, body0, body1, gravity);
        mark.mode = carryingMode(manifold, point);
      }
      marks.push_back(mark);
    }
  }
  return marks;
}

JointFeedbacks::JointFeedbacks(World& world)
    : feedbacks_(std::size_t(world.dynamics().getNumConstraints())) {
  for (int i = 0; i < world.dynamics().getNumConstraints(); ++i) {
    btTypedConstraint* joint = world.dynamics().getConstraint(i);
    if (joint->getJointFeedback() != nullptr) continue;
    joint->setJointFeedback(&feedbacks_[std::size_t(i)]);
    joints_.push_back(joint);
  }
}

JointFeedbacks::~JointFeedbacks() {
  for (btTypedConstraint* joint : joints_) joint->setJointFeedback(nullptr);
}

std::vector<JointMark> jointMarks(const World& world) {
  std::vector<JointMark> marks;
  const Vector3d gravity = toDouble(world.dynamics().getGravity());
  for (int i = 0; i < world.dynamics().getNumConstraints(); ++i) {
    const btTypedConstraint& joint = *world.dynamics().getConstraint(i);
    const std::optional<btVector3> place = anchor(joint);
    if (!joint.isEnabled() || !place || joint.getJointFeedback() == nullptr) continue;
    const Vector3d force = toDouble(joint.getJointFeedback()->m_appliedForceBodyA);
    marks.push_back(
        {toDouble(*place), carrying(force, joint.getRigidBodyA(), joint.getRigidBodyB(), gravity)});
  }
  return marks;
}

std::vector<Rope> ropes(const World& world) {
  std::vector<Rope> found;
  for (int i = 0; i < world.dynamics().getNumConstraints(); ++i) {
    const btTypedConstraint& joint = *world.dynamics().getConstraint(i);
    const std::optional<btVector3> end = anchor(joint);
    // A slide is a guide, not a string: its bodies are meant to be apart.
    if (!joint.isEnabled() || !end || joint.getConstraintType() == SLIDER_CONSTRAINT_TYPE) continue;
    for (const btRigidBody* body : {&joint.getRigidBodyA(), &joint.getRigidBodyB()}) {
      if (body->getInvMass() == 0) continue;
      btVector3 low, high;
      body->getAabb(low, high);
      const btVector3 slack = (high - low) / 4;
      if (!TestPointAgainstAabb2(low - slack, high + slack, *end))
        found.push_back({toDouble(body->getCenterOfMassPosition()), toDouble(*end)});
    }
  }
  return found;
}

}  // namespace demos::render
