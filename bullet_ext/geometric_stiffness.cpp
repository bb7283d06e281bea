#include "bullet_ext/geometric_stiffness.h"

#include <Eigen/LU>
#include <algorithm>

#include "BulletDynamics/ConstraintSolver/btConeTwistConstraint.h"
#include "BulletDynamics/ConstraintSolver/btContactSolverInfo.h"
#include "BulletDynamics/ConstraintSolver/btGeneric6DofConstraint.h"
#include "BulletDynamics/ConstraintSolver/btGeneric6DofSpring2Constraint.h"
#include "BulletDynamics/ConstraintSolver/btHingeConstraint.h"
#include "BulletDynamics/ConstraintSolver/btPoint2PointConstraint.h"
#include "BulletDynamics/ConstraintSolver/btSliderConstraint.h"
#include "BulletDynamics/Dynamics/btRigidBody.h"
#include "bullet_ext/convert.h"
#include "bullet_ext/group.h"

namespace delassus::bullet {
namespace {

/// Where a joint of Bullet's holds its bodies, from their centres, in world axes, m; nowhere if it
/// is one of the user's.
struct Arms {
  btVector3 onA = btVector3(0, 0, 0), onB = btVector3(0, 0, 0);
};

template <class Joint>
bool readFrames(const btTypedConstraint& any, Arms& arms,
                const btTransform& (Joint::*frameA)() const,
                const btTransform& (Joint::*frameB)() const) {
  const auto* joint = dynamic_cast<const Joint*>(&any);
  if (!joint) return false;
  arms = {(joint->*frameA)().getOrigin(), (joint->*frameB)().getOrigin()};
  return true;
}

Arms armsOf(const btTypedConstraint& joint) {
  Arms arms;
  if (const auto* point = dynamic_cast<const btPoint2PointConstraint*>(&joint))
    arms = {point->getPivotInA(), point->getPivotInB()};
  else
    readFrames<btHingeConstraint>(joint, arms, &btHingeConstraint::getAFrame,
                                  &btHingeConstraint::getBFrame) ||
        readFrames<btConeTwistConstraint>(joint, arms, &btConeTwistConstraint::getAFrame,
                                          &btConeTwistConstraint::getBFrame) ||
        readFrames<btSliderConstraint>(joint, arms, &btSliderConstraint::getFrameOffsetA,
                                       &btSliderConstraint::getFrameOffsetB) ||
        readFrames<btGeneric6DofConstraint>(joint, arms, &btGeneric6DofConstraint::getFrameOffsetA,
                                            &btGeneric6DofConstraint::getFrameOffsetB) ||
        readFrames<btGeneric6DofSpring2Constraint>(
            joint, arms, &btGeneric6DofSpring2Constraint::getFrameOffsetA,
            &btGeneric6DofSpring2Constraint::getFrameOffsetB);
  const btTransform &a = joint.getRigidBodyA().getWorldTransform(),
                    &b = joint.getRigidBodyB().getWorldTransform();
  return {a.getBasis() * arms.onA, b.getBasis() * arms.onB};
}

/// h² K of an impulse at an arm, kg m².
Mat3 stiffnessOf(const Vec3& impulse, const Vec3& arm, double h) {
  const double size = impulse.norm(), length = arm.norm();
  if (!(size > 0 && length > 0)) return Mat3::Zero();
  const Vec3 s = arm / length + impulse / size;
  return 0.25 * h * size * length * (s.squaredNorm() * Mat3::Identity() - s * s.transpose());
}

}  // namespace

int GeometricStiffness::stiffen(Group& group, const btContactSolverInfo& info) {
  const double h = info.m_timeStep;
  if (group.joints.empty()) return 0;
  stiffness_.assign(group.bodies.size(), Mat3::Zero());
  for (const JointSource& joint : group.joints) {
    if (joint.rowCount == 0) continue;
    const Row& first = group.rows[joint.firstRow];
    const Arms arms = armsOf(*joint.constraint);
    const auto add = [&](int body, const Vec3& pull, const btVector3& arm) {
      if (group.movable(body)) stiffness_[body] += stiffnessOf(pull, toCore(arm), h);
    };
    add(first.a, joint.lastPullOnA, arms.onA);
    add(first.b, joint.lastPullOnB, arms.onB);
  }

  constexpr double slow = 1, fast = 2;
  int changed = 0;
  for (std::size_t i = 0; i < group.bodies.size(); ++i) {
    Body& body = group.bodies[i];
    const Mat3 ratio = body.inverseInertia * stiffness_[i];
    const double share = std::min((ratio.trace() - slow) / (fast - slow), 1.0);
    if (!(share > 0)) continue;
    const Mat3 slowed = (Mat3::Identity() + share * ratio).inverse();
    if (!slowed.allFinite()) continue;  // forces beyond all numbers
    const Mat3 inverse = slowed * body.inverseInertia;
    body.inverseInertia = 0.5 * (inverse + inverse.transpose());
    body.velocity.tail<3>() = (slowed * body.velocity.tail<3>()).eval();
    ++changed;
  }
  return changed;
}

}  // namespace delassus::bullet
