#include "demos/scenes/measures.h"

#include <BulletDynamics/ConstraintSolver/btGeneric6DofSpring2Constraint.h>

#include <algorithm>
#include <cmath>

#include "demos/scenes/statistics.h"

namespace demos {

namespace {

template <class Visit>
void forEachPoint(const btDiscreteDynamicsWorld& world, const Visit& visit) {
  btDispatcher* dispatcher = const_cast<btDiscreteDynamicsWorld&>(world).getDispatcher();
  for (int i = 0; i < dispatcher->getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *dispatcher->getManifoldByIndexInternal(i);
    for (int j = 0; j < manifold.getNumContacts(); ++j)
      visit(manifold, manifold.getContactPoint(j));
  }
}

/// The joint's frames in the world.
struct JointFrames {
  btTransform a, b;
};

template <class Joint>
JointFrames worldFrames(const Joint& joint, const btTransform& a, const btTransform& b) {
  return {joint.getRigidBodyA().getWorldTransform() * a,
          joint.getRigidBodyB().getWorldTransform() * b};
}

double distance(const JointFrames& frames) {
  return (frames.b.getOrigin() - frames.a.getOrigin()).length();
}

/// Six-dof joints: how far the displacement, in the frame of `a`, is outside its limits. An axis
/// with lower > upper is free.
template <class Joint>
double sixDofError(const Joint& constJoint) {
  Joint& joint = const_cast<Joint&>(constJoint);
  const JointFrames frames = worldFrames(joint, joint.getFrameOffsetA(), joint.getFrameOffsetB());
  const btVector3 offset = (frames.b.getOrigin() - frames.a.getOrigin()) * frames.a.getBasis();
  btVector3 lower, upper;
  joint.getLinearLowerLimit(lower);
  joint.getLinearUpperLimit(upper);
  btVector3 outside(0, 0, 0);
  for (int i = 0; i < 3; ++i)
    if (lower[i] <= upper[i]) outside[i] = offset[i] - std::clamp(offset[i], lower[i], upper[i]);
  return outside.length();
}

/// Whether the point is in a box or behind a plane; no other shape has an inside here.
bool isInside(const btCollisionObject& object, const btVector3& point) {
  const btCollisionShape& shape = *object.getCollisionShape();
  const btVector3 local = object.getWorldTransform().invXform(point);
  if (shape.getShapeType() == BOX_SHAPE_PROXYTYPE) {
    const btVector3 room =
        static_cast<const btBoxShape&>(shape).getHalfExtentsWithMargin() - local.absolute();
    return room.x() > 0 && room.y() > 0 && room.z() > 0;
  }
  if (shape.getShapeType() != STATIC_PLANE_PROXYTYPE) return false;
  const auto& plane = static_cast<const btStaticPlaneShape&>(shape);
  return plane.getPlaneNormal().dot(local) < plane.getPlaneConstant();
}

}  // namespace

btVector3 writtenReaction(const btManifoldPoint& point) {
  return point.m_normalWorldOnB * point.m_appliedImpulse +
         point.m_lateralFrictionDir1 * point.m_appliedImpulseLateral1 +
         point.m_lateralFrictionDir2 * point.m_appliedImpulseLateral2;
}

double jointError(const btTypedConstraint& joint) {
  if (!joint.isEnabled()) return 0;
  switch (joint.getConstraintType()) {
    case POINT2POINT_CONSTRAINT_TYPE: {
      const auto& ball = static_cast<const btPoint2PointConstraint&>(joint);
      return (ball.getRigidBodyA().getWorldTransform() * ball.getPivotInA() -
              ball.getRigidBodyB().getWorldTransform() * ball.getPivotInB())
          .length();
    }
    case HINGE_CONSTRAINT_TYPE: {
      const auto& hinge = static_cast<const btHingeConstraint&>(joint);
      return distance(worldFrames(hinge, hinge.getAFrame(), hinge.getBFrame()));
    }
    case CONETWIST_CONSTRAINT_TYPE: {
      const auto& cone = static_cast<const btConeTwistConstraint&>(joint);
      return distance(worldFrames(cone, cone.getFrameOffsetA(), cone.getFrameOffsetB()));
    }
    case SLIDER_CONSTRAINT_TYPE: {
      const auto& slide = static_cast<const btSliderConstraint&>(joint);
      const JointFrames frames =
          worldFrames(slide, slide.getFrameOffsetA(), slide.getFrameOffsetB());
      const btVector3 offset = (frames.b.getOrigin() - frames.a.getOrigin()) * frames.a.getBasis();
      return std::hypot(offset.y(), offset.z());
    }
    case D6_CONSTRAINT_TYPE:
    case D6_SPRING_CONSTRAINT_TYPE:
      return sixDofError(static_cast<const btGeneric6DofConstraint&>(joint));
    case D6_SPRING_2_CONSTRAINT_TYPE:
    case FIXED_CONSTRAINT_TYPE:
      return sixDofError(static_cast<const btGeneric6DofSpring2Constraint&>(joint));
    default:
      return 0;
  }
}

double largestJointError(const btDiscreteDynamicsWorld& world) {
  double largest = 0;
  for (int i = 0; i < world.getNumConstraints(); ++i)
    largest = largerOf(largest, jointError(*world.getConstraint(i)));
  return largest;
}

double deepestPenetration(const btDiscreteDynamicsWorld& world) {
  double deepest = 0;
  forEachPoint(world, [&](const btPersistentManifold&, const btManifoldPoint& point) {
    deepest = largerOf(deepest, -double(point.getDistance()));
  });
  return deepest;
}

double kineticEnergy(const World& world) {
  double energy = 0;
  for (const btRigidBody* body : world.movableBodies()) {
    const btVector3 spin = body->getAngularVelocity() * body->getWorldTransform().getBasis();
    const btVector3& inverse = body->getInvInertiaDiagLocal();
    energy += 0.5 * double(body->getLinearVelocity().length2()) / double(body->getInvMass());
    for (int i = 0; i < 3; ++i)
      if (inverse[i] > 0) energy += 0.5 * double(spin[i]) * double(spin[i]) / double(inverse[i]);
  }
  return energy;
}

double potentialEnergy(const World& world) {
  double energy = 0;
  for (const btRigidBody* body : world.movableBodies())
    energy -= double(body->getGravity().dot(body->getWorldTransform().getOrigin())) /
              double(body->getInvMass());
  return energy;
}

double totalEnergy(const World& world) { return kineticEnergy(world) + potentialEnergy(world); }

bool isFinite(const World& world) {
  const auto finite = [](const btVector3& v) {
    return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
  };
  for (const btRigidBody* body : world.movableBodies()) {
    const btTransform& pose = body->getWorldTransform();
    if (!finite(pose.getOrigin()) || !finite(body->getLinearVelocity()) ||
        !finite(body->getAngularVelocity()))
      return false;
    for (int i = 0; i < 3; ++i)
      if (!finite(pose.getBasis()[i])) return false;
  }
  return true;
}

double reactionOverWeight(const World& world, double timeStep) {
  btVector3 weight(0, 0, 0);
  for (const btRigidBody* body : world.movableBodies())
    weight += body->getGravity() / body->getInvMass();
  if (weight.fuzzyZero()) return 0;

  btVector3 carried(0, 0, 0);
  forEachPoint(world.dynamics(),
               [&](const btPersistentManifold& manifold, const btManifoldPoint& point) {
                 const bool fixed0 = manifold.getBody0()->isStaticOrKinematicObject();
                 const bool fixed1 = manifold.getBody1()->isStaticOrKinematicObject();
                 if (fixed0 == fixed1) return;
                 const btVector3 reaction = writtenReaction(point);
                 carried += fixed1 ? reaction : -reaction;
               });
  return -double(carried.dot(weight)) / double(weight.length2()) / timeStep;
}

ModeCounts writtenModes(const btDiscreteDynamicsWorld& world) {
  // On the border of the cone, up to the rounding of the build.
  constexpr double nearly = 1 - 1e-5;
  ModeCounts counts;
  forEachPoint(world, [&](const btPersistentManifold&, const btManifoldPoint& point) {
    const double normal = point.m_appliedImpulse;
    const btVector3 lateral =
        writtenReaction(point) - point.m_normalWorldOnB * point.m_appliedImpulse;
    if (normal <= 0)
      ++counts.open;
    else if (double(lateral.length()) < nearly * double(point.m_combinedFriction) * normal)
      ++counts.stick;
    else
      ++counts.slide;
  });
  return counts;
}

Tunnelling::Tunnelling(const World& world)
    : world_(world), movable_(world.movableBodies()), entered_(movable_.size(), nullptr) {}

void Tunnelling::look() {
  const btCollisionObjectArray& objects = world_.dynamics().getCollisionObjectArray();
  for (int k = 0; k < objects.size(); ++k) {
    if (!objects[k]->isStaticOrKinematicObject()) continue;
    for (std::size_t i = 0; i < movable_.size(); ++i)
      if (isInside(*objects[k], movable_[i]->getWorldTransform().getOrigin()))
        entered_[i] = objects[k];
  }
}

int Tunnelling::bodies() const {
  int count = 0;
  for (std::size_t i = 0; i < movable_.size(); ++i) {
    if (entered_[i] == nullptr) continue;
    const btVector3& centre = movable_[i]->getWorldTransform().getOrigin();
    const bool box = entered_[i]->getCollisionShape()->getShapeType() == BOX_SHAPE_PROXYTYPE;
    const btVector3 fallen = centre - entered_[i]->getWorldTransform().getOrigin();
    count += isInside(*entered_[i], centre) || (box && fallen.dot(movable_[i]->getGravity()) > 0);
  }
  return count;
}

Drift::Drift(const World& world) : bodies_(world.movableBodies()) {
  for (const btRigidBody* body : bodies_) start_.push_back(body->getWorldTransform().getOrigin());
}

double Drift::largest() const {
  double largest = 0;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    largest = largerOf(largest,
                       double((bodies_[i]->getWorldTransform().getOrigin() - start_[i]).length()));
  return largest;
}

}  // namespace demos
