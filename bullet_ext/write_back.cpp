#include "bullet_ext/write_back.h"

#include "BulletCollision/NarrowPhaseCollision/btManifoldPoint.h"
#include "BulletCollision/NarrowPhaseCollision/btPersistentManifold.h"
#include "BulletDynamics/ConstraintSolver/btContactSolverInfo.h"
#include "BulletDynamics/ConstraintSolver/btTypedConstraint.h"
#include "BulletDynamics/Dynamics/btRigidBody.h"
#include "LinearMath/btTransformUtil.h"
#include "bullet_ext/convert.h"
#include "bullet_ext/group.h"
#include "bullet_ext/prefetch.h"
#include "bullet_ext/push.h"
#include "bullet_ext/saturating_sum.h"
#include "bullet_ext/solve_group.h"
#include "bullet_ext/step_report.h"

namespace delassus::bullet {
namespace {

void count(Mode mode, StepReport& report) {
  addTo(mode == Mode::Open ? report.open : mode == Mode::Stick ? report.stick : report.slide, 1);
}

/// The mode a contact point had after the last solve.
///
/// It is kept in the point's m_prevRHS. Bullet carries that number along with the impulses when it
/// replaces, moves or saves a point, and clears it in a new point; only the articulated solver
/// reads it.
Mode rememberedMode(const btManifoldPoint& point) {
  if (point.m_prevRHS == static_cast<btScalar>(Mode::Stick)) return Mode::Stick;
  if (point.m_prevRHS == static_cast<btScalar>(Mode::Slide)) return Mode::Slide;
  return Mode::Open;
}

void rememberMode(btManifoldPoint& point, Mode mode) {
  point.m_prevRHS = static_cast<btScalar>(mode);
}

/// Notes the mode of a point and returns the one before; a change is counted.
Mode changeMode(btManifoldPoint& point, Mode to, StepReport& report) {
  const Mode from = rememberedMode(point);
  if (from != to) {
    rememberMode(point, to);
    addTo(report.modeChanges, 1);
  }
  return from;
}

void prefetchReaction(const PointSource& source) {
  const btManifoldPoint& point = source.manifold->getContactPoint(source.point);
  prefetch(&point.m_appliedImpulse, &point + 1);
}

/// The moments of contacts; call `of` in the order of the contacts.
class Moments {
 public:
  Moments(const Group& group, const Answer& answer)
      : group_(group), answer_(answer), next_(group.rows.size() - group.turningRows) {}

  /// Σ r_row axis over the rows of turning friction of contact `i`, N·m·s.
  Vec3 of(int i) {
    Vec3 sum = Vec3::Zero();
    while (next_ < group_.rows.size() && group_.rows[next_].governor < i) ++next_;
    for (; next_ < group_.rows.size() && group_.rows[next_].governor == i; ++next_)
      sum += answer_.rows[next_] * group_.rows[next_].jacobianA.tail<3>().transpose();
    return sum;
  }

 private:
  const Group& group_;
  const Answer& answer_;
  std::size_t next_;
};

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
                   std::vector<ContactEvent>* events, bool turning) {
  Moments moments(group, answer);
  constexpr std::size_t ahead = 6;
  for (std::size_t i = 0; i < group.contacts.size(); ++i) {
    const PointSource& source = group.contactSources[i];
    if (i + ahead < group.contacts.size()) prefetchReaction(group.contactSources[i + ahead]);
    const Mat3& frame = group.contacts[i].frame;
    const Vec3& r = answer.contacts[i];
    btManifoldPoint& point = source.manifold->getContactPoint(source.point);
    point.m_appliedImpulse = static_cast<btScalar>(r[0]);
    point.m_appliedImpulseLateral1 = static_cast<btScalar>(r[1]);
    point.m_appliedImpulseLateral2 = static_cast<btScalar>(r[2]);
    point.m_lateralFrictionDir1 = toBullet(frame.col(1));
    point.m_lateralFrictionDir2 = toBullet(frame.col(2));
    const Mode to = answer.modes[i], from = changeMode(point, to, report);
    const Trouble trouble = answer.troubles[i];
    count(to, report);
    if (!events || (from == to && trouble == Trouble::None && !turning)) continue;
    const Vec3 moment = moments.of(static_cast<int>(i));
    if (from != to || trouble != Trouble::None || moment.any())
      events->push_back({source.manifold, source.point, from, to, toBullet((frame * r).eval()),
                         toBullet(moment), trouble});
  }
  for (const PointSource& source : group.idle) {
    btManifoldPoint& point = source.manifold->getContactPoint(source.point);
    point.m_appliedImpulse = point.m_appliedImpulseLateral1 = point.m_appliedImpulseLateral2 = 0;
    const Mode from = changeMode(point, Mode::Open, report);
    const btVector3 none(0, 0, 0);
    if (events && (from != Mode::Open || source.trouble != Trouble::None))
      events->push_back(
          {source.manifold, source.point, from, Mode::Open, none, none, source.trouble});
  }
}

btScalar writtenImpulse(const Group& group, const JointSource& joint, const Answer& answer) {
  const int row = joint.lastRow;
  const double last = row >= 0 ? answer.rows[row] * group.arcOf(row) : 0;
  return last == 0 ? -btScalar(0) : static_cast<btScalar>(last);
}

void writeJoints(const Group& group, const Answer& answer, const btContactSolverInfo& info) {
  for (const JointSource& source : group.joints) {
    btTypedConstraint& joint = *source.constraint;
    // Read before anything is disabled: the joint breaks as a whole, after its last feedback. A
    // reaction at its bound may be a little below it.
    constexpr double rounding = 1e-9;
    const double breakingImpulse = (1 - rounding) * joint.getBreakingImpulseThreshold();
    bool breaks = breakingImpulse <= 0;  // then none of its rows takes part
    for (int row = source.firstRow; row < source.firstRow + source.rowCount; ++row)
      breaks |= std::abs(answer.rows[row]) >= breakingImpulse / group.arcOf(row);

    joint.internalSetAppliedImpulse(writtenImpulse(group, source, answer));
    if (btJointFeedback* feedback = joint.getJointFeedback()) {
      const btRigidBody &a = joint.getRigidBodyA(), &b = joint.getRigidBodyB();
      const double h = info.m_timeStep;
      const JointLoad load = loadOf(group, source, answer.rows);
      feedback->m_appliedForceBodyA = toBullet(load.onA.head<3>() / h) * a.getLinearFactor();
      feedback->m_appliedTorqueBodyA = toBullet(load.onA.tail<3>() / h) * a.getAngularFactor();
      feedback->m_appliedForceBodyB = toBullet(load.onB.head<3>() / h) * b.getLinearFactor();
      feedback->m_appliedTorqueBodyB = toBullet(load.onB.tail<3>() / h) * b.getAngularFactor();
    }
    if (breaks) joint.setEnabled(false);
  }
}

}  // namespace delassus::bullet
