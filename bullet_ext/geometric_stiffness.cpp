#include "bullet_ext/geometric_stiffness.h"

#include <Eigen/Eigenvalues>
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

/// Where one of Bullet's joints holds its bodies, from their centres, in world axes, m; zero for
/// joints of the user's own classes.
struct Arms {
  btVector3 onA = btVector3(0, 0, 0), onB = btVector3(0, 0, 0);
};

template <class Joint>
Arms readFrames(const btTypedConstraint& any, const btTransform& (Joint::*frameA)() const,
                const btTransform& (Joint::*frameB)() const) {
  const auto* joint = dynamic_cast<const Joint*>(&any);
  return joint ? Arms{(joint->*frameA)().getOrigin(), (joint->*frameB)().getOrigin()} : Arms();
}

/// The arms in the frames of the bodies. The joint's type avoids casts that would fail; joints of
/// the user's own classes may report any type.
Arms localArmsOf(const btTypedConstraint& joint) {
  switch (joint.getConstraintType()) {
    case POINT2POINT_CONSTRAINT_TYPE: {
      const auto* point = dynamic_cast<const btPoint2PointConstraint*>(&joint);
      return point ? Arms{point->getPivotInA(), point->getPivotInB()} : Arms();
    }
    case HINGE_CONSTRAINT_TYPE:
      return readFrames<btHingeConstraint>(joint, &btHingeConstraint::getAFrame,
                                           &btHingeConstraint::getBFrame);
    case CONETWIST_CONSTRAINT_TYPE:
      return readFrames<btConeTwistConstraint>(joint, &btConeTwistConstraint::getAFrame,
                                               &btConeTwistConstraint::getBFrame);
    case SLIDER_CONSTRAINT_TYPE:
      return readFrames<btSliderConstraint>(joint, &btSliderConstraint::getFrameOffsetA,
                                            &btSliderConstraint::getFrameOffsetB);
    case D6_CONSTRAINT_TYPE:
    case D6_SPRING_CONSTRAINT_TYPE:
      return readFrames<btGeneric6DofConstraint>(joint, &btGeneric6DofConstraint::getFrameOffsetA,
                                                 &btGeneric6DofConstraint::getFrameOffsetB);
    case D6_SPRING_2_CONSTRAINT_TYPE:
    case FIXED_CONSTRAINT_TYPE:
      return readFrames<btGeneric6DofSpring2Constraint>(
          joint, &btGeneric6DofSpring2Constraint::getFrameOffsetA,
          &btGeneric6DofSpring2Constraint::getFrameOffsetB);
    default:
      return {};
  }
}

Arms armsOf(const btTypedConstraint& joint) {
  const Arms arms = localArmsOf(joint);
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

/// The largest eigenvalue of A B, both symmetric and without negative eigenvalues.
double largestEigenvalue(const Mat3& A, const Mat3& B) {
  Eigen::SelfAdjointEigenSolver<Mat3> solver;
  solver.compute(B);
  const Mat3 root =
      solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
  solver.compute(root.transpose() * A * root, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[2];
}

}  // namespace

int GeometricStiffness::stiffen(Group& group, const btContactSolverInfo& info, double lastStep) {
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
    add(first.a, joint.lastLoad.onA.head<3>(), arms.onA);
    add(first.b, joint.lastLoad.onB.head<3>(), arms.onB);
  }

  // Bounds of (ω h)².
  const double limit = lastStep == 0 || lastStep == h ? 4 : 0.5, beyond = 1.125 * limit;
  int changed = 0;
  for (std::size_t i = 0; i < group.bodies.size(); ++i) {
    Body& body = group.bodies[i];
    const Mat3 ratio = body.inverseInertia * stiffness_[i];
    if (!(ratio.trace() > limit)) continue;
    const double fastest = largestEigenvalue(body.inverseInertia, stiffness_[i]);
    const double share = std::min((fastest - limit) / (beyond - limit), 1.0);
    if (!(share > 0)) continue;
    const Mat3 slowed = (Mat3::Identity() + share * ratio).inverse();
    if (!slowed.allFinite()) continue;  // the forces are too large to compute with
    const Mat3 inverse = slowed * body.inverseInertia;
    body.inverseInertia = 0.5 * (inverse + inverse.transpose());
    body.velocity.tail<3>() = (slowed * body.velocity.tail<3>()).eval();
    ++changed;
  }
  return changed;
}

}  // namespace delassus::bullet
