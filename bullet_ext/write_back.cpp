#include "bullet_ext/write_back.h"

#include "BulletCollision/NarrowPhaseCollision/btPersistentManifold.h"
#include "BulletDynamics/ConstraintSolver/btContactSolverInfo.h"
#include "BulletDynamics/ConstraintSolver/btTypedConstraint.h"
#include "BulletDynamics/Dynamics/btRigidBody.h"
#include "LinearMath/btTransformUtil.h"
#include "bullet_ext/convert.h"

namespace delassus::bullet {
namespace {

void count(Mode mode, StepReport& report) {
  ++(mode == Mode::Open ? report.open : mode == Mode::Stick ? report.stick : report.slide);
}

/// Notes the mode of a point; a change is counted. Changes and troubles are told if somebody listens.
void changeMode(const PointSource& source, btManifoldPoint& point, Mode to, Trouble trouble,
                const Mat3& frame, const Vec3& r, StepReport& report,
                std::vector<ContactEvent>* events) {
  const Mode from = rememberedMode(point);
  if (from != to) {
    rememberMode(point, to);
    ++report.modeChanges;
  }
  if (events && (from != to || trouble != Trouble::None))
    events->push_back(
        {source.manifold, source.point, from, to, toBullet((frame * r).eval()), trouble});
}

}  // namespace

void writeVelocities(const Group& group, const Answer& answer) {
  for (std::size_t i = 0; i < answer.bodies.size(); ++i) {
    const Body& body = answer.bodies[i];
    if (!body.movable() || group.isLimb(static_cast<int>(i))) continue;
    group.bodySources[i].rigid->setLinearVelocity(toBullet(body.velocity.head<3>()));
    group.bodySources[i].rigid->setAngularVelocity(toBullet(body.velocity.tail<3>()));
  }
}

void writePushes(const Group& group, const Pushes& pushes, const btContactSolverInfo& info) {
  for (std::size_t i = 0; i < pushes.bodies.size(); ++i) {
    const Vec6& push = pushes.bodies[i].velocity;
    if (!push.any()) continue;
    btRigidBody& rigid = *group.bodySources[i].rigid;
    const Vec3 turn = info.m_splitImpulseTurnErp * push.tail<3>();
    btTransform pushed;
    btTransformUtil::integrateTransform(rigid.getWorldTransform(), toBullet(push.head<3>()),
                                        toBullet(turn), info.m_timeStep, pushed);
    rigid.setWorldTransform(pushed);
  }
}

void writeContacts(const Group& group, const Answer& answer, StepReport& report,
                   std::vector<ContactEvent>* events) {
  for (std::size_t i = 0; i < group.contacts.size(); ++i) {
    const PointSource& source = group.contactSources[i];
    const Mat3& frame = group.contacts[i].frame;
    const Vec3& r = answer.contacts[i];
    btManifoldPoint& point = source.manifold->getContactPoint(source.point);
    point.m_appliedImpulse = static_cast<btScalar>(r[0]);
    point.m_appliedImpulseLateral1 = static_cast<btScalar>(r[1]);
    point.m_appliedImpulseLateral2 = static_cast<btScalar>(r[2]);
    point.m_lateralFrictionDir1 = toBullet(frame.col(1));
    point.m_lateralFrictionDir2 = toBullet(frame.col(2));
    count(answer.modes[i], report);
    changeMode(source, point, answer.modes[i], answer.troubles[i], frame, r, report, events);
  }
  for (const PointSource& source : group.idle) {
    btManifoldPoint& point = source.manifold->getContactPoint(source.point);
    point.m_appliedImpulse = point.m_appliedImpulseLateral1 = point.m_appliedImpulseLateral2 = 0;
    changeMode(source, point, Mode::Open, source.trouble, Mat3::Identity(), Vec3::Zero(), report,
               events);
  }
}

btScalar writtenImpulse(const JointSource& joint, const Answer& answer) {
  const double last = joint.lastRow >= 0 ? answer.rows[joint.lastRow] : 0;
  return last == 0 ? -btScalar(0) : static_cast<btScalar>(last);
}

void writeJoints(const Group& group, const Answer& answer, const btContactSolverInfo& info) {
  // Reactions at a bound are equal to it up to rounding of the library's precision.
  constexpr double atBound = 1 - 4 * static_cast<double>(SIMD_EPSILON);
  for (const JointSource& source : group.joints) {
    btTypedConstraint& joint = *source.constraint;
    // Read before anything is disabled: a joint breaks as a whole, after its last feedback.
    const double breakingImpulse = joint.getBreakingImpulseThreshold();
    bool breaks = false;
    Vec6 onA = Vec6::Zero(), onB = Vec6::Zero();
    for (int row = source.firstRow; row < source.firstRow + source.rowCount; ++row) {
      const double r = answer.rows[row];
      onA += group.rows[row].jacobianA.transpose() * r;
      onB += group.rows[row].jacobianB.transpose() * r;
      breaks |= std::abs(r) >= breakingImpulse * atBound;
    }

    joint.internalSetAppliedImpulse(writtenImpulse(source, answer));
    if (btJointFeedback* feedback = joint.getJointFeedback()) {
      const btRigidBody &a = joint.getRigidBodyA(), &b = joint.getRigidBodyB();
      const double h = info.m_timeStep;
      feedback->m_appliedForceBodyA = toBullet(onA.head<3>() / h) * a.getLinearFactor();
      feedback->m_appliedTorqueBodyA = toBullet(onA.tail<3>() / h) * a.getAngularFactor();
      feedback->m_appliedForceBodyB = toBullet(onB.head<3>() / h) * b.getLinearFactor();
      feedback->m_appliedTorqueBodyB = toBullet(onB.tail<3>() / h) * b.getAngularFactor();
    }
    if (breaks) joint.setEnabled(false);
  }
}

}  // namespace delassus::bullet
