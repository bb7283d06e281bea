#include <algorithm>
#include <cmath>

#include "BulletDynamics/ConstraintSolver/btContactSolverInfo.h"
#include "BulletDynamics/ConstraintSolver/btGeneric6DofConstraint.h"
#include "BulletDynamics/ConstraintSolver/btGeneric6DofSpring2Constraint.h"
#include "BulletDynamics/ConstraintSolver/btHingeConstraint.h"
#include "BulletDynamics/ConstraintSolver/btSliderConstraint.h"
#include "BulletDynamics/ConstraintSolver/btTypedConstraint.h"
#include "bullet_ext/arcs.h"
#include "bullet_ext/convert.h"
#include "bullet_ext/gather.h"
#include "bullet_ext/names.h"
#include "bullet_ext/softness.h"
#include "delassus/contact_motion.h"

namespace delassus::bullet {
namespace {

/// Asks the joint for its rows. Everything is set beforehand as Bullet's solvers set it. Returns
/// the joint's damping.
double askRows(btTypedConstraint& joint, int count, const btContactSolverInfo& info,
               std::vector<InfoRow>& rows) {
  InfoRow blank{};
  blank.lower = -SIMD_INFINITY;
  blank.upper = SIMD_INFINITY;
  rows.assign(count, blank);
  InfoRow& first = rows.front();
  first.cfm = info.m_globalCfm;  // in the first row only, where Bullet's joints inherit it

  btTypedConstraint::btConstraintInfo2 ask;
  ask.fps = 1 / info.m_timeStep;
  ask.erp = info.m_erp;
  ask.m_J1linearAxis = first.linearA;
  ask.m_J1angularAxis = first.angularA;
  ask.m_J2linearAxis = first.linearB;
  ask.m_J2angularAxis = first.angularB;
  ask.rowskip = sizeof(InfoRow) / sizeof(btScalar);
  ask.m_constraintError = &first.error;
  ask.cfm = &first.cfm;
  ask.m_lowerLimit = &first.lower;
  ask.m_upperLimit = &first.upper;
  ask.m_numIterations = info.m_numIterations;  // spring joints divide by it
  ask.m_damping = info.m_damping;
  joint.getInfo2(&ask);
  return ask.m_damping;  // the joint may have set its own
}

Row6 jacobian(const btScalar* linear, const btScalar* angular) {
  Row6 J;
  J << linear[0], linear[1], linear[2], angular[0], angular[1], angular[2];
  return J;
}

/// J M⁻¹ Jᵀ of one body, without linear and angular factors.
double unfactoredResponse(const Group& group, int body, const Row6& J) {
  if (!group.movable(body)) return 0;
  const btRigidBody& rigid = *group.bodySources[body].rigid;
  const Vec3 linear = J.head<3>().transpose(), angular = J.tail<3>().transpose();
  return rigid.getInvMass() * linear.squaredNorm() +
         angular.dot(toCore(rigid.getInvInertiaTensorWorld()) * angular);
}

double unfactoredResponse(const Group& group, const Row& row) {
  return unfactoredResponse(group, row.a, row.jacobianA) +
         unfactoredResponse(group, row.b, row.jacobianB);
}

/// Whether what the joint gives as an axis is rounding, as cone-twist joints do that hardly swing.
bool hasNoAxis(const Row& row) {
  return row.jacobianA.squaredNorm() <= SIMD_EPSILON && row.jacobianB.squaredNorm() <= SIMD_EPSILON;
}

/// Whether an impulse along the row moves nothing: its bodies are locked along it, or have no
/// inertia about it.
bool movesNothing(const Group& group, const Row& row) {
  const auto isDeaf = [&](int body, const Row6& J) {
    return diagonalShare(group.bodies, body, J) <= inVain * unfactoredResponse(group, body, J);
  };
  return isDeaf(row.a, row.jacobianA) && isDeaf(row.b, row.jacobianB);
}

/// Bullet asks for the row of a limit only while the limit is passed. Were the last of that mended,
/// other motions of the joint, or rounding, would take the row away every now and then, and what
/// leans on the limit would fall into it anew: ragdolls would never come to rest. So this much
/// counts as none, radians. (Limits along an axis are not taken away so.)
constexpr double negligiblePassing = 2e-5;

/// Whether a motor turns the joint. Hinges and sliders add its speed to what their limit asks for.
bool isTurned(const btTypedConstraint& joint) {
  // Getters of old classes are not const.
  auto& motor = const_cast<btTypedConstraint&>(joint);
  switch (joint.getConstraintType()) {
    case HINGE_CONSTRAINT_TYPE: {
      auto* hinge = dynamic_cast<btHingeConstraint*>(&motor);
      return hinge && hinge->getEnableAngularMotor() && hinge->getMotorTargetVelocity() != 0;
    }
    case SLIDER_CONSTRAINT_TYPE: {
      auto* slider = dynamic_cast<btSliderConstraint*>(&motor);
      return slider && slider->getPoweredAngMotor() && slider->getTargetAngMotorVelocity() != 0;
    }
    default:
      return false;
  }
}

/// Whether the row is that of a limit of a turn that is passed by next to nothing.
bool isAtLimit(const Row& row, const InfoRow& info, const btContactSolverInfo& step) {
  const bool holdsOneWay = (info.lower == 0) != (info.upper == 0);
  return holdsOneWay && info.cfm == 0 && turns(row) &&
         std::abs(info.error) * step.m_timeStep <= negligiblePassing * step.m_erp;
}

Row toRow(const Group& group, int a, int b, const InfoRow& info, double damping,
          const btTypedConstraint& joint, const btContactSolverInfo& step) {
  const btScalar breakingImpulse = joint.getBreakingImpulseThreshold();
  Row row;
  row.a = a;
  row.b = b;
  row.jacobianA = jacobian(info.linearA, info.angularA);
  row.jacobianB = jacobian(info.linearB, info.angularB);
  const double q = along(group.bodies, a, row.jacobianA) + along(group.bodies, b, row.jacobianB);
  row.target =
      (isAtLimit(row, info, step) && !isTurned(joint) ? 0 : info.error) + (1 - damping) * q;
  row.lower = toCoreBound(info.lower <= -breakingImpulse ? -breakingImpulse : info.lower);
  row.upper = toCoreBound(info.upper >= breakingImpulse ? breakingImpulse : info.upper);
  row.compliance = complianceOf(info.cfm, unfactoredResponse(group, row));

  // An infinite error (six-dof spring 2) means "as hard as allowed": the row stays at its bound.
  if (std::abs(info.error) >= SIMD_INFINITY) {
    row.lower = row.upper = info.error > 0 ? row.upper : row.lower;
    row.target = 0;
  }
  return row;
}

void clearResult(btTypedConstraint& joint) {
  joint.internalSetAppliedImpulse(0);
  if (btJointFeedback* feedback = joint.getJointFeedback()) {
    feedback->m_appliedForceBodyA.setZero();
    feedback->m_appliedTorqueBodyA.setZero();
    feedback->m_appliedForceBodyB.setZero();
    feedback->m_appliedTorqueBodyB.setZero();
  }
}

void gatherRows(Group& group, btTypedConstraint& joint, double lastImpulse, double damping,
                const btContactSolverInfo& info, StepReport& report) {
  const int a = bodyIndex(group, joint.getRigidBodyA(), info, report);
  const int b = bodyIndex(group, joint.getRigidBodyB(), info, report);
  if (a == leftOut || b == leftOut || (!group.movable(a) && !group.movable(b))) return;
  if (a == b) {
    report.leaveOut(nameOf(joint), "it joins a body with itself");
    return;
  }

  JointSource source{&joint, static_cast<int>(group.rows.size()), 0, -1, lastImpulse};
  for (std::size_t i = 0; i < group.asked.size(); ++i) {
    const Row row = toRow(group, a, b, group.asked[i], damping, joint, info);
    source.lastRow = -1;
    if (const char* fault = faultOfRow(row)) {
      report.leaveOut("row " + std::to_string(i) + " of " + nameOf(joint), fault);
      continue;
    }
    // Skips a motor or spring that may not push, and rows that push nowhere or in vain.
    if ((row.lower == 0 && row.upper == 0) || hasNoAxis(row) || movesNothing(group, row)) continue;
    source.lastRow = static_cast<int>(group.rows.size());
    group.rows.push_back(row);
    if (group.asked[i].cfm > 0) {
      ++group.softRows;
      source.isSoft = true;
    }
  }
  source.rowCount = static_cast<int>(group.rows.size()) - source.firstRow;
  group.joints.push_back(source);
}

/// Gives the joints of mechanisms with loops a softness of at least loopSoftness.
void softenLoops(Group& group) {
  if (group.joints.size() < 2) return;
  const auto bodyOf = [&](int body) { return group.movable(body) ? body : JointLoops::standing; };
  group.loops.reset(static_cast<int>(group.bodies.size()));
  for (const JointSource& joint : group.joints) {
    if (joint.rowCount == 0) continue;
    const Row& row = group.rows[joint.firstRow];
    group.loops.add(bodyOf(row.a), bodyOf(row.b));
  }
  group.loops.close();
  if (!group.loops.hasLoops()) return;
  for (Row& row : group.rows)
    if (group.loops.isLooped(group.movable(row.a) ? row.a : row.b))
      row.compliance = std::max(row.compliance, loopSoftness * unfactoredResponse(group, row));
}

/// Whether a six-dof joint leaves no play along some axis.
template <class Joint>
bool locksAnAxis(btTypedConstraint& joint) {
  auto* sixDof = dynamic_cast<Joint*>(&joint);
  if (!sixDof) return true;  // a class of the user's own that reports this type
  btVector3 lower, upper;
  sixDof->getLinearLowerLimit(lower);
  sixDof->getLinearUpperLimit(upper);
  return lower.x() == upper.x() || lower.y() == upper.y() || lower.z() == upper.z();
}

/// Whether the joint fixes the relative place of its bodies in at least one direction.
bool holds(btTypedConstraint& joint) {
  switch (joint.getConstraintType()) {
    case POINT2POINT_CONSTRAINT_TYPE:
    case HINGE_CONSTRAINT_TYPE:
    case CONETWIST_CONSTRAINT_TYPE:
    case SLIDER_CONSTRAINT_TYPE:
    case FIXED_CONSTRAINT_TYPE:
      return true;
    case D6_CONSTRAINT_TYPE:
    case D6_SPRING_CONSTRAINT_TYPE:
      return locksAnAxis<btGeneric6DofConstraint>(joint);
    case D6_SPRING_2_CONSTRAINT_TYPE:
      return locksAnAxis<btGeneric6DofSpring2Constraint>(joint);
    default:
      return false;
  }
}

}  // namespace

void gatherJoined(Group& group, const GroupInput& input) {
  const btRigidBody& world = fixedBody();
  for (int i = 0; i < input.constraintCount; ++i) {
    btTypedConstraint& joint = *input.constraints[i];
    const btRigidBody &a = joint.getRigidBodyA(), &b = joint.getRigidBodyB();
    if (!joint.isEnabled() || !holds(joint)) continue;
    group.joined.addHeld(a);
    group.joined.addHeld(b);
    if (&a != &world && &b != &world) group.joined.add(a, b);
  }
}

void gatherJoints(Group& group, const GroupInput& input, StepReport& report) {
  const btContactSolverInfo& info = *input.info;
  for (int i = 0; i < input.constraintCount; ++i) {
    btTypedConstraint& joint = *input.constraints[i];
    // Some joints clear their impulse in buildJacobian.
    const double lastImpulse = joint.internalGetAppliedImpulse();
    joint.buildJacobian();
    clearResult(joint);
    if (!joint.isEnabled()) continue;

    btTypedConstraint::btConstraintInfo1 size{};  // btContactConstraint does not fill it
    joint.getInfo1(&size);
    if (size.m_numConstraintRows > 0) {
      const double damping = askRows(joint, size.m_numConstraintRows, info, group.asked);
      gatherRows(group, joint, lastImpulse, damping, info, report);
    } else {
      // The constraint is shown its bodies, even kinematic ones that nothing touches.
      bodyIndex(group, joint.getRigidBodyA(), info, report);
      bodyIndex(group, joint.getRigidBodyB(), info, report);
      group.obsolete.push_back(&joint);
    }
  }
  softenLoops(group);
}

}  // namespace delassus::bullet
