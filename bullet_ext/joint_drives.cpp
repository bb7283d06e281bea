#include "bullet_ext/joint_drives.h"

#include <algorithm>
#include <limits>

#include "BulletDynamics/ConstraintSolver/btConeTwistConstraint.h"
#include "BulletDynamics/ConstraintSolver/btGeneric6DofConstraint.h"
#include "BulletDynamics/ConstraintSolver/btGeneric6DofSpring2Constraint.h"
#include "BulletDynamics/ConstraintSolver/btHingeConstraint.h"
#include "BulletDynamics/ConstraintSolver/btSliderConstraint.h"
#include "BulletDynamics/ConstraintSolver/btTypedConstraint.h"

namespace delassus::bullet {
namespace {

/// Calls isUnbounded(the joint, the impulse that breaks it) if it is of this class, as its type
/// says. Impulses from BT_LARGE_FLOAT on are unbounded (toCoreBound).
template <class Joint, class Test>
bool askMotors(btTypedConstraint& joint, const Test& isUnbounded) {
  auto* known = dynamic_cast<Joint*>(&joint);
  const btScalar most = std::min(joint.getBreakingImpulseThreshold(), btScalar(BT_LARGE_FLOAT));
  return !known || isUnbounded(*known, most);
}

template <class Joint>
bool hasUnboundedMotorOfSix(btTypedConstraint& joint) {
  return askMotors<Joint>(joint, [](Joint& sixDof, btScalar most) {
    const auto& linear = *sixDof.getTranslationalLimitMotor();
    for (int i = 0; i < 3; ++i) {
      const auto& angular = *sixDof.getRotationalLimitMotor(i);
      if ((linear.m_enableMotor[i] && linear.m_maxMotorForce[i] >= most) ||
          (angular.m_enableMotor && angular.m_maxMotorForce >= most))
        return true;
    }
    return false;
  });
}

}  // namespace

bool hasUnboundedMotor(btTypedConstraint& joint) {
  // A force is compared with an impulse: in steps below a second it is the larger one.
  switch (joint.getConstraintType()) {
    case POINT2POINT_CONSTRAINT_TYPE:
    case GEAR_CONSTRAINT_TYPE:
      return false;
    case HINGE_CONSTRAINT_TYPE:
      return askMotors<btHingeConstraint>(joint, [](btHingeConstraint& hinge, btScalar most) {
        return hinge.getEnableAngularMotor() && hinge.getMaxMotorImpulse() >= most;
      });
    case SLIDER_CONSTRAINT_TYPE:
      return askMotors<btSliderConstraint>(joint, [](btSliderConstraint& slider, btScalar most) {
        return (slider.getPoweredLinMotor() && slider.getMaxLinMotorForce() >= most) ||
               (slider.getPoweredAngMotor() && slider.getMaxAngMotorForce() >= most);
      });
    case CONETWIST_CONSTRAINT_TYPE:  // a negative force is none that bounds it
      return askMotors<btConeTwistConstraint>(
          joint, [](btConeTwistConstraint& cone, btScalar most) {
            return cone.isMotorEnabled() &&
                   (cone.getMaxMotorImpulse() < 0 || cone.getMaxMotorImpulse() >= most);
          });
    case D6_CONSTRAINT_TYPE:
    case D6_SPRING_CONSTRAINT_TYPE:
      return hasUnboundedMotorOfSix<btGeneric6DofConstraint>(joint);
    case D6_SPRING_2_CONSTRAINT_TYPE:
    case FIXED_CONSTRAINT_TYPE:
      return hasUnboundedMotorOfSix<btGeneric6DofSpring2Constraint>(joint);
    default:
      return true;
  }
}

int rowsBesideAxis(const btTypedConstraint& joint) {
  constexpr int ofHinge = 5, ofSlider = 4;
  switch (joint.getConstraintType()) {
    case HINGE_CONSTRAINT_TYPE:
      return ofHinge;
    case SLIDER_CONSTRAINT_TYPE:
      return ofSlider;
    default:
      return std::numeric_limits<int>::max();
  }
}

}  // namespace delassus::bullet
