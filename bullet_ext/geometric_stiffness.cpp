#include "bullet_ext/geometric_stiffness.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "BulletDynamics/ConstraintSolver/btConeTwistConstraint.h"
#include "BulletDynamics/ConstraintSolver/btContactSolverInfo.h"
#include "BulletDynamics/ConstraintSolver/btGeneric6DofConstraint.h"
#include "BulletDynamics/ConstraintSolver/btGeneric6DofSpring2Constraint.h"
#include "BulletDynamics/ConstraintSolver/btHingeConstraint.h"
#include "BulletDynamics/ConstraintSolver/btPoint2PointConstraint.h"
#include "BulletDynamics/ConstraintSolver/btSliderConstraint.h"
#include "BulletDynamics/Dynamics/btRigidBody.h"
#include "bullet_ext/arcs.h"
#include "bullet_ext/convert.h"
#include "bullet_ext/group.h"
#include "bullet_ext/thrown_bodies.h"

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

/// The directions about which the joint lets its bodies turn against each other, as a projection.
Mat3 freeTurns(const Group& group, const JointSource& joint) {
  Mat3 free = Mat3::Identity();
  for (int k = joint.firstRow; k < joint.firstRow + joint.rowCount; ++k) {
    const Row& row = group.rows[k];
    if (!turns(row) || drives(group, k, true) || drives(group, k, false)) continue;
    const Row6& J = group.movable(row.a) ? row.jacobianA : row.jacobianB;
    const Vec3 axis = free * J.tail<3>().transpose();
    // An axis that lies among the others leaves only rounding.
    if (axis.squaredNorm() > 1e-6 * J.squaredNorm())
      free -= axis * axis.transpose() / axis.squaredNorm();
  }
  return free;
}

/// h² K of an impulse at an arm, kg m².
Mat3 stiffnessOf(const Vec3& impulse, const Vec3& arm, double h) {
  const Mat3 outer = arm * impulse.transpose();
  return h * (outer.trace() * Mat3::Identity() - 0.5 * (outer + outer.transpose()));
}

/// A body that turns more slowly.
struct Slowed {
  bool isChanged = false;
  Mat3 inverseInertia;  ///< (I + h² K')⁻¹
  Mat3 turn;            ///< (I + h² K')⁻¹ I
};

/// Slows a body in the directions x with h² K x = (ω h)² I x where (ω h)² is above `limit`: there
/// K' grows from nothing to K until it is above by an eighth. Changes nothing if there are none, or
/// if the forces are too large to compute with. In these directions all is diagonal, which leaves
/// the inertia positive, however large the forces are: searches that find no answer may end with
/// any.
Slowed slow(const Mat3& inverseInertia, const Mat3& K, double limit) {
  const double ramp = 0.125 * limit;
  Eigen::SelfAdjointEigenSolver<Mat3> solver(inverseInertia);
  const Vec3 root = solver.eigenvalues().cwiseMax(0).cwiseSqrt();
  const Mat3 axes = solver.eigenvectors(), scaled = axes * root.asDiagonal();
  const Mat3 inScale = scaled.transpose() * K * scaled;
  if (!inScale.allFinite()) return {};
  solver.compute(inScale);
  Vec3 left = Vec3::Ones(), perRoot = Vec3::Zero();  // left: I / (I + h² K')
  for (int i = 0; i < 3; ++i) {
    if (root[i] > 0) perRoot[i] = 1 / root[i];
    const double square = solver.eigenvalues()[i];
    if (square > limit) left[i] = 1 / (1 + std::min((square - limit) / ramp, 1.0) * square);
  }
  if (left == Vec3::Ones()) return {};
  const Mat3 directions = scaled * solver.eigenvectors();
  const Mat3 lost = directions * (Vec3::Ones() - left).asDiagonal() *
                    solver.eigenvectors().transpose() * perRoot.asDiagonal() * axes.transpose();
  return {true, directions * left.asDiagonal() * directions.transpose(), Mat3::Identity() - lost};
}

}  // namespace

double GeometricStiffness::shareAlong(double turn) {
  return along * std::clamp(2 - turn / slowly, 0.0, 1.0);
}

int GeometricStiffness::stiffen(Group& group, const btContactSolverInfo& info, double lastStep) {
  const double h = info.m_timeStep;
  if (group.joints.empty()) return 0;
  stiffness_.assign(group.bodies.size(), Mat3::Zero());
  for (const JointSource& joint : group.joints) {
    if (joint.rowCount == 0) continue;
    const Row& first = group.rows[joint.firstRow];
    const Arms arms = armsOf(*joint.constraint);
    const Mat3 free = freeTurns(group, joint);
    const auto add = [&](int body, const Vec3& pull, const btVector3& arm) {
      if (group.movable(body)) stiffness_[body] += free * stiffnessOf(pull, toCore(arm), h) * free;
    };
    add(first.a, joint.lastLoad.onA.head<3>(), arms.onA);
    add(first.b, joint.lastLoad.onB.head<3>(), arms.onB);
  }

  // Frames that are measured by a clock differ a little.
  constexpr double alike = 1e-2;
  const bool isSteady = lastStep == 0 || std::abs(lastStep - h) <= alike * h;
  const double limit = isSteady ? 4 : 0.5;  // of (ω h)²
  int changed = 0;
  for (std::size_t i = 0; i < group.bodies.size(); ++i) {
    Body& body = group.bodies[i];
    if (!(body.inverseInertia.trace() * stiffness_[i].norm() > limit)) continue;
    const Slowed slowed = slow(body.inverseInertia, stiffness_[i], limit);
    if (!slowed.isChanged) continue;
    group.slowed.push_back({static_cast<int>(i), body.inverseInertia});
    body.inverseInertia = slowed.inverseInertia;
    const Vec3 before = group.bodySources[i].before.tail<3>();
    const double share = isSteady ? shareAlong(before.norm() * h) : 0;
    body.velocity.tail<3>() =
        (share * before + slowed.turn * (body.velocity.tail<3>() - share * before)).eval();
    ++changed;
  }
  return changed;
}

}  // namespace delassus::bullet
