#include "bullet_ext/multi_body_rows.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "BulletDynamics/ConstraintSolver/btContactSolverInfo.h"
#include "BulletDynamics/Dynamics/btRigidBody.h"
#include "BulletDynamics/Featherstone/btMultiBody.h"
#include "BulletDynamics/Featherstone/btMultiBodyLinkCollider.h"
#include "bullet_ext/convert.h"
#include "bullet_ext/gather.h"
#include "bullet_ext/multi_body_trees.h"
#include "bullet_ext/names.h"
#include "bullet_ext/obsolete.h"
#include "bullet_ext/softness.h"
#include "bullet_ext/solve_group.h"

namespace delassus::bullet {
namespace {

/// The number of solver bodies before number 0. Bodies that are not passed (static ones, and
/// kinematic ones that touch nothing) carry the numbers −1 and −2, and constraints look these up
/// unchecked.
constexpr int unlent = 2;

/// The number that stands for all bodies left out; it follows that of the fixed world.
int absentId(int fixedId) { return fixedId + 1; }

/// Lends bodies the numbers by which constraints find their rigid partners among the solver bodies,
/// and note where in the data their trees are. Takes the numbers back at the end of its life.
class LentCompanionIds {
 public:
  /// Bodies of the group get their index; other bodies that were passed count as fixed, or as
  /// absent if they are left out. `rows`: the list to which the constraints add their rows
  /// meanwhile.
  LentCompanionIds(const Group& group, const GroupInput& input, int fixedId,
                   const btMultiBodyConstraintArray& rows)
      : group_(group), input_(input), rows_(rows) {
    for (int i = 0; i < input.bodyCount; ++i) {
      btCollisionObject& object = *input.bodies[i];
      if (const btMultiBodyLinkCollider* link = linkOf(&object))
        link->m_multiBody->setCompanionId(-1);
      if (!btRigidBody::upcast(&object)) continue;
      const int* index = group.indexOf.find(&object);
      object.setCompanionId(index && *index == leftOut ? absentId(fixedId) : fixedId);
    }
    for (std::size_t i = 0; i < group.bodies.size(); ++i)
      if (btRigidBody* rigid = group.bodySources[i].rigid)
        rigid->setCompanionId(static_cast<int>(i));
  }
  ~LentCompanionIds() {
    for (int i = 0; i < input_.bodyCount; ++i) input_.bodies[i]->setCompanionId(-1);
    for (const BodySource& source : group_.bodySources)
      if (source.rigid) source.rigid->setCompanionId(-1);
    for (int i = 0; i < rows_.size(); ++i)
      for (btMultiBody* body : {rows_[i].m_multiBodyA, rows_[i].m_multiBodyB})
        if (body) body->setCompanionId(-1);
  }
  LentCompanionIds(const LentCompanionIds&) = delete;
  LentCompanionIds& operator=(const LentCompanionIds&) = delete;

 private:
  const Group& group_;
  const GroupInput& input_;
  const btMultiBodyConstraintArray& rows_;
};

/// A row with a value for everything that a constraint may leave unset.
btMultiBodySolverConstraint blankRow() {
  btMultiBodySolverConstraint row;
  row.m_relpos1CrossNormal.setZero();
  row.m_relpos2CrossNormal.setZero();
  row.m_contactNormal1.setZero();
  row.m_contactNormal2.setZero();
  row.m_angularComponentA.setZero();
  row.m_angularComponentB.setZero();
  row.m_appliedImpulse = row.m_appliedPushImpulse = 0;
  row.m_deltaVelAindex = row.m_deltaVelBindex = row.m_jacAindex = row.m_jacBindex = 0;
  row.m_friction = row.m_jacDiagABInv = row.m_rhs = row.m_rhsPenetration = row.m_cfm = 0;
  row.m_lowerLimit = row.m_upperLimit = 0;
  row.m_originalContactPoint = nullptr;
  row.m_overrideNumSolverIterations = 0;
  row.m_frictionIndex = 0;
  return row;
}

/// Counts the impulses that a constraint has room for. A user's constraint may have room for fewer
/// than it has rows, and Bullet writes an impulse only if its row names the constraint.
class KeptImpulses : public btMultiBodyConstraint {
 public:
  static int countOf(const btMultiBodyConstraint& constraint) {
    return std::min(constraint.getNumRows(), (constraint.*&KeptImpulses::m_data).size());
  }
};

constexpr const char* brokenBody = "one of its bodies is left out";

/// The fault of an assembled row, or null. Its joint rows are those from `jointRowsBefore` on.
const char* faultOfOutput(const Group& group, const Row& row, std::size_t jointRowsBefore) {
  if (row.a == leftOut || row.b == leftOut) return brokenBody;
  if (const char* fault = faultOfRow(row)) return fault;
  const KeptList<Articulation::JointRow>& jointRows = group.articulation.jointRows;
  for (std::size_t i = jointRowsBefore; i < jointRows.size(); ++i)
    if (!(jointRows[i].effect.cwiseAbs().sum() <= largestNumber)) return "its axis is not finite";
  return nullptr;
}

/// The mass of the link, −1 for the base, kg.
double massOf(const btMultiBody& body, int link) {
  return link < 0 ? body.getBaseMass() : body.getLink(link).m_mass;
}

/// The radius of the arc along which the row is to be stated, m (arcs.h).
double arcOf(const Group& group, const Row& row, const btMultiBodySolverConstraint& asked) {
  if (!asked.m_contactNormal1.fuzzyZero() || !asked.m_contactNormal2.fuzzyZero()) return 1;
  double inverseMass = 0;
  const auto add = [&](const btMultiBody* body, int link, int rigid) {
    if (body) {
      const bool stands = link < 0 && body->hasFixedBase();
      if (const double mass = massOf(*body, link); mass > 0 && !stands) inverseMass += 1 / mass;
    } else if (group.movable(rigid)) {
      inverseMass += group.bodySources[rigid].rigid->getInvMass();
    }
  };
  add(asked.m_multiBodyA, asked.m_linkA, row.a);
  add(asked.m_multiBodyB, asked.m_linkB, row.b);
  return inverseMass > 0 ? std::sqrt(inverseMass * asked.m_jacDiagABInv) : 1;
}

}  // namespace

/// One side of a row as its constraint has made it.
struct MultiBodyRows::Side {
  btMultiBody* body;                  ///< null for a rigid partner or the world
  int jacobian;                       ///< index in the data of the articulated body's Jacobian
  int solverBody;                     ///< the rigid partner's number
  const btVector3 &linear, &angular;  ///< the rigid partner's Jacobian
};

void MultiBodyRows::gather(Group& group, const GroupInput& input, StepReport& report) {
  asked_.resizeNoInitialize(0);
  if (input.multiBodyConstraintCount == 0) return;
  data_.m_jacobians.resizeNoInitialize(0);
  data_.m_deltaVelocitiesUnitImpulse.resizeNoInitialize(0);
  data_.m_deltaVelocities.resizeNoInitialize(0);

  fillSolverBodies(group);
  const LentCompanionIds lent(group, input, data_.m_fixedBodyId, asked_);
  for (int i = 0; i < input.multiBodyConstraintCount; ++i)
    gatherConstraint(group, *input.multiBodyConstraints[i], *input.info, report);
}

void MultiBodyRows::fillSolverBodies(const Group& group) {
  const auto count = static_cast<int>(group.bodies.size());
  solverBodies_.resizeNoInitialize(0);
  for (int i = 0; i < unlent; ++i) solverBodies_.push_back(solverBody(group, fixedWorld));
  for (int i = 0; i < count; ++i) solverBodies_.push_back(solverBody(group, i));
  solverBodies_.push_back(solverBody(group, fixedWorld));
  solverBodies_.push_back(solverBody(group, fixedWorld));
  const int size = solverBodies_.size() - unlent;
  solverBodyPool_.initializeFromBuffer(&solverBodies_[unlent], size, size);
  data_.m_solverBodyPool = &solverBodyPool_;
  data_.m_fixedBodyId = count;
}

void MultiBodyRows::gatherConstraint(Group& group, btMultiBodyConstraint& constraint,
                                     const btContactSolverInfo& info, StepReport& report) {
  const int begin = asked_.size();
  askRows(constraint, info);
  const int kept = KeptImpulses::countOf(constraint);
  for (int k = begin; k < asked_.size(); ++k) {
    const int named = asked_[k].m_orgDofIndex;
    const int dof = named >= 0 ? named : k - begin;
    addRow(group, constraint, k, dof < kept ? dof : noDof, report);
  }
  // A limit that is not reached has no row; its impulse is zero.
  for (int dof = 0; dof < kept; ++dof) constraint.internalSetAppliedImpulse(dof, 0);
}

void MultiBodyRows::askRows(btMultiBodyConstraint& constraint, const btContactSolverInfo& info) {
  // Bullet's arrays hand out old contents, so blank rows are laid out first, and some more: a
  // constraint that makes more rows than it announced makes few more.
  constexpr int more = 6;
  const int begin = asked_.size();
  asked_.resize(begin + constraint.getNumRows() + more, blankRow());
  asked_.resizeNoInitialize(begin);
  constraint.createConstraintRows(asked_, data_, info);
}

void MultiBodyRows::addRow(Group& group, btMultiBodyConstraint& constraint, int asked, int dof,
                           StepReport& report) {
  const btMultiBodySolverConstraint& from = asked_[asked];
  const auto leaveOut = [&](const char* fault) {
    const std::string name = dof == noDof ? "a row" : "row " + std::to_string(dof);
    report.leaveOut(name + " of " + nameOf(constraint), fault);
  };
  if (!(from.m_jacDiagABInv > 0)) {
    // With d = 0 Bullet switches off a row whose response it cannot divide by. If the cause is a
    // number that is not finite, the row is reported.
    if (const char* fault = faultOfInput(group, from)) leaveOut(fault);
    return;
  }

  KeptList<Articulation::JointRow>& jointRows = group.articulation.jointRows;
  const std::size_t jointRowsBefore = jointRows.size();
  const Row row = toRow(group, from);
  const char* fault = faultOfOutput(group, row, jointRowsBefore);
  if (fault || (row.lower == 0 && row.upper == 0)) {
    while (jointRows.size() > jointRowsBefore) jointRows.pop_back();
    if (fault) leaveOut(fault);
    return;
  }
  const auto rowIndex = static_cast<int>(group.rows.size());
  group.rows.push_back(row);
  group.softRows += from.m_cfm > 0;
  group.multiBodyRows.push_back({rowIndex, &constraint, asked, dof,
                                 dof == noDof ? 0 : constraint.getAppliedImpulse(dof),
                                 arcOf(group, row, from)});
}

/// The fault of a row as Bullet made it, or null.
const char* MultiBodyRows::faultOfInput(Group& group, const btMultiBodySolverConstraint& row) {
  double sum = std::abs(row.m_rhs) + std::abs(row.m_rhsPenetration);
  for (const btVector3& axis : {row.m_contactNormal1, row.m_relpos1CrossNormal,
                                row.m_contactNormal2, row.m_relpos2CrossNormal})
    sum += axis.length2();
  const auto addTree = [&](btMultiBody* body, int jacobian) {
    if (!body) return true;
    const MultiBodyTrees::TreeSource& source = trees_.treeOf(group, *body);
    if (source.tree == leftOut) return false;
    const auto dofs = group.articulation.trees[source.tree].root.rows();
    for (int i = 0; i < dofs; ++i) sum += std::abs(data_.m_jacobians[jacobian + i]);
    return true;
  };
  if (!addTree(row.m_multiBodyA, row.m_jacAindex) || !addTree(row.m_multiBodyB, row.m_jacBindex))
    return brokenBody;
  return std::isfinite(sum) ? nullptr : "its axis or its target velocity is not finite";
}

/// Assembles the group's next row and its joint rows.
Row MultiBodyRows::toRow(Group& group, const btMultiBodySolverConstraint& asked) {
  const double response = 1 / static_cast<double>(asked.m_jacDiagABInv);
  Row row;
  row.target = (static_cast<double>(asked.m_rhs) + asked.m_rhsPenetration) * response;
  row.a = addSide(group,
                  {asked.m_multiBodyA, asked.m_jacAindex, asked.m_solverBodyIdA,
                   asked.m_contactNormal1, asked.m_relpos1CrossNormal},
                  row.jacobianA, row.target);
  row.b = addSide(group,
                  {asked.m_multiBodyB, asked.m_jacBindex, asked.m_solverBodyIdB,
                   asked.m_contactNormal2, asked.m_relpos2CrossNormal},
                  row.jacobianB, row.target);
  row.lower = toCoreBound(asked.m_lowerLimit);
  row.upper = toCoreBound(asked.m_upperLimit);
  row.compliance = complianceOf(asked.m_cfm, response);
  return row;
}

/// Returns the body on which this side of the row acts, fixedWorld, or leftOut. A rigid partner
/// adds its part of J v_before to the target.
int MultiBodyRows::addSide(Group& group, const Side& side, Row6& jacobian, double& target) {
  if (side.body) return addJointRow(group, *side.body, side.jacobian);
  const int fixed = data_.m_fixedBodyId;
  if (side.solverBody == absentId(fixed)) return leftOut;
  if (side.solverBody < 0 || side.solverBody >= fixed) return fixedWorld;
  jacobian = toCore(side.linear, side.angular).transpose();
  target += jacobian.dot(group.bodySources[side.solverBody].before);
  return side.solverBody;
}

/// Adds the joint row whose Jacobian begins at `jacobian` in the data. Returns the stem of the
/// body's tree, or leftOut.
int MultiBodyRows::addJointRow(Group& group, btMultiBody& body, int jacobian) {
  const MultiBodyTrees::TreeSource& source = trees_.treeOf(group, body);
  if (source.tree == leftOut) return leftOut;
  const MatrixXd& root = group.articulation.trees[source.tree].root;
  Articulation::JointRow& added = group.articulation.jointRows.add();
  added.row = static_cast<int>(group.rows.size());
  added.tree = source.tree;
  added.effect.setZero(root.cols());
  for (int i = 0; i < root.rows(); ++i)
    added.effect += root.row(i).transpose() * data_.m_jacobians[jacobian + i];
  return source.stem;
}

void MultiBodyRows::recall(Group& group) {
  group.rowGuess.resize(group.rows.size(), 0);
  for (const MultiBodyRowSource& source : group.multiBodyRows)
    if (std::isfinite(source.guess)) group.rowGuess[source.row] = source.guess / source.arc;
}

void MultiBodyRows::writeBack(const Group& group, const Answer& answer,
                              const btContactSolverInfo& info) const {
  for (const MultiBodyRowSource& source : group.multiBodyRows) {
    const btMultiBodySolverConstraint& row = asked_[source.asked];
    const auto r = static_cast<btScalar>(answer.rows[source.row] * source.arc);
    if (source.dof != noDof) source.constraint->internalSetAppliedImpulse(source.dof, r);
    const btScalar force = r / info.m_timeStep;
    if (row.m_multiBodyA)
      addForce(*row.m_multiBodyA, row.m_linkA, row.m_contactNormal1 * force,
               row.m_relpos1CrossNormal * force);
    if (row.m_multiBodyB)
      addForce(*row.m_multiBodyB, row.m_linkB, row.m_contactNormal2 * force,
               row.m_relpos2CrossNormal * force);
  }
}

void MultiBodyRows::release() {
  asked_.clear();
  solverBodyPool_.clear();
  solverBodies_.clear();
}

std::size_t MultiBodyRows::bytes() const {
  return asked_.capacity() * sizeof(asked_[0]) + solverBodies_.capacity() * sizeof(btSolverBody);
}

}  // namespace delassus::bullet
