#include "bullet_ext/multi_body_parts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "BulletCollision/NarrowPhaseCollision/btPersistentManifold.h"
#include "BulletDynamics/Dynamics/btRigidBody.h"
#include "BulletDynamics/Featherstone/btMultiBody.h"
#include "BulletDynamics/Featherstone/btMultiBodyLinkCollider.h"
#include "bullet_ext/convert.h"
#include "bullet_ext/gather.h"
#include "bullet_ext/names.h"
#include "bullet_ext/obsolete.h"
#include "bullet_ext/softness.h"
#include "bullet_ext/solve_group.h"

namespace delassus::bullet {
namespace {

int freedomsOf(const btMultiBody& body) { return 6 + body.getNumDofs(); }

bool isFinite(const btScalar* values, int count) {
  return std::all_of(values, values + count, [](btScalar value) { return std::isfinite(value); });
}

/// Everything that a constraint may leave unset.
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

/// The object as a link of an articulated body; null if it is none, or has lost its body and is
/// ground.
const btMultiBodyLinkCollider* linkOf(const btCollisionObject* object) {
  const btMultiBodyLinkCollider* link = btMultiBodyLinkCollider::upcast(object);
  return link && link->m_multiBody ? link : nullptr;
}

/// Tells a link what acts on it, for the joint feedback.
void addForce(btMultiBody& body, int link, const btVector3& force, const btVector3& torque) {
  if (link < 0) {
    body.addBaseConstraintForce(force);
    body.addBaseConstraintTorque(torque);
  } else {
    body.addLinkConstraintForce(link, force);
    body.addLinkConstraintTorque(link, torque);
  }
}

/// Bodies that are not passed, static ones and kinematic ones that touch nothing, carry the numbers
/// −1 and −2, and constraints look them up as they are.
constexpr int unlent = 2;

constexpr const char* brokenBody = "one of its bodies is left out";

}  // namespace

/// Index of the new body, that of `source` or (if that has none) a stem.
int MultiBodyParts::addLimb(Group& group, int tree, const LimbSource& source) {
  const auto index = static_cast<int>(group.bodies.size());
  Articulation::Limb& limb = group.articulation.limbs.add();
  limb.body = index;
  limb.tree = tree;
  limb.motion.noalias() = source.L * group.articulation.trees[tree].root;
  Body& body = group.bodies.emplace_back();
  if (!source.body || !limb.motion.isZero(0)) {
    body.inverseMass.setOnes();
    body.inverseInertia.setIdentity();
  }
  if (source.body) {
    const btScalar* v = source.body->getVelocityVector();
    for (int i = 0; i < source.L.cols(); ++i) body.velocity += source.L.col(i) * v[i];
  }
  group.bodySources.push_back({nullptr, body.velocity});
  return index;
}

/// Index of the new tree, or leftOut.
int MultiBodyParts::addTree(Group& group, TreeSource& source) {
  const btMultiBody& body = *source.body;
  const int n = freedomsOf(body);
  MatrixXd& inverseMass = source.inverseMass;
  inverseMass.setZero(n, n);
  unit_.resize(n);
  for (int i = 0; i < n; ++i) unit_[i] = 0;
  for (int i = body.hasFixedBase() ? 6 : 0; i < n; ++i) {
    // Bullet passes over links that are kinematic down to the base: neither their entries here nor
    // their accelerations, which the next links start from, are written.
    response_.resizeNoInitialize(0);
    response_.resize(n, 0);
    data_.scratch_v.resizeNoInitialize(0);
    data_.scratch_v.resize(4 * (body.getNumLinks() + 1), btVector3(0, 0, 0));
    unit_[i] = 1;
    body.calcAccelerationDeltasMultiDof(&unit_[0], &response_[0], data_.scratch_r, data_.scratch_v);
    unit_[i] = 0;
    for (int j = 0; j < n; ++j) inverseMass(j, i) = response_[j];
  }
  if (!inverseMass.allFinite() || !isFinite(body.getVelocityVector(), n)) return leftOut;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < i; ++j)
      inverseMass(i, j) = inverseMass(j, i) = 0.5 * (inverseMass(i, j) + inverseMass(j, i));
  source.root.find(inverseMass, group.articulation.trees.add().root);
  return static_cast<int>(group.articulation.trees.size()) - 1;
}

const MultiBodyParts::TreeSource& MultiBodyParts::treeOf(Group& group, btMultiBody& body) {
  // From the end, since the links of a tree follow each other.
  for (std::size_t i = trees_.size(); i-- > 0;)
    if (trees_[i].body == &body) return trees_[i];
  TreeSource& added = trees_.add();
  added.body = &body;
  added.tree = addTree(group, added);
  added.stem = leftOut;
  if (added.tree != leftOut) {
    LimbSource& stem = limbs_.add();
    stem.body = nullptr;
    stem.link = -1;
    stem.L.setZero(6, freedomsOf(body));
    added.stem = addLimb(group, added.tree, stem);
  }
  return added;
}

/// L of a link about the place of its collider: three linear rows, three angular ones.
void MultiBodyParts::findMotion(const btMultiBodyLinkCollider& collider, Matrix6X& L) {
  const btMultiBody& body = *collider.m_multiBody;
  const int n = freedomsOf(body);
  L.resize(6, n);
  unit_.resize(n);
  const btVector3& centre = collider.getWorldTransform().getOrigin();
  const btVector3 zero(0, 0, 0);
  for (int i = 0; i < 6; ++i) {
    btVector3 axis(0, 0, 0);
    axis[i % 3] = 1;
    body.fillConstraintJacobianMultiDof(collider.m_link, centre, i < 3 ? zero : axis,
                                        i < 3 ? axis : zero, &unit_[0], data_.scratch_r,
                                        data_.scratch_v, data_.scratch_m);
    for (int j = 0; j < n; ++j) L(i, j) = unit_[j];
  }
  // Bullet leaves out of the angular rows how planar joints turn.
  for (int link = collider.m_link; link >= 0; link = body.getLink(link).m_parent) {
    const btMultibodyLink& joint = body.getLink(link);
    if (joint.m_jointType == btMultibodyLink::ePlanar)
      L.col(6 + joint.m_dofOffset).tail<3>() +=
          toCore(body.localDirToWorld(link, joint.getAxisTop(0)));
  }
}

void MultiBodyParts::addLink(Group& group, const btMultiBodyLinkCollider& collider,
                             StepReport& report) {
  if (group.indexOf.find(&collider)) return;
  const int tree = treeOf(group, *collider.m_multiBody).tree;
  LimbSource& limb = limbs_.add();
  limb.body = collider.m_multiBody;
  limb.link = collider.m_link;
  findMotion(collider, limb.L);
  if (tree == leftOut || !limb.L.allFinite()) {
    limbs_.pop_back();
    report.leaveOut(nameOf(collider), "the pose, velocity or mass of its tree is not finite");
    group.indexOf.insert(&collider, leftOut);
    return;
  }
  group.indexOf.insert(&collider, addLimb(group, tree, limb));
}

void MultiBodyParts::gatherBodies(Group& group, const GroupInput& input, StepReport& report) {
  trees_.clear();
  limbs_.clear();
  for (int i = 0; i < input.manifoldCount; ++i) {
    const btPersistentManifold& manifold = *input.manifolds[i];
    if (manifold.getNumContacts() == 0) continue;
    for (const btCollisionObject* object : {manifold.getBody0(), manifold.getBody1()})
      if (const btMultiBodyLinkCollider* link = linkOf(object)) addLink(group, *link, report);
  }
}

/// Constraints find their rigid partners among the solver bodies by these numbers.
void MultiBodyParts::lendCompanionIds(const Group& group, const GroupInput& input) {
  const auto count = static_cast<int>(group.bodies.size());
  const int fixed = count, absent = count + 1;
  solverBodies_.resizeNoInitialize(0);
  for (int i = 0; i < unlent; ++i) solverBodies_.push_back(solverBody(group, fixedWorld));
  for (int i = 0; i < count; ++i) solverBodies_.push_back(solverBody(group, i));
  solverBodies_.push_back(solverBody(group, fixedWorld));
  solverBodies_.push_back(solverBody(group, fixedWorld));
  const int size = solverBodies_.size() - unlent;
  solverBodyPool_.initializeFromBuffer(&solverBodies_[unlent], size, size);
  data_.m_solverBodyPool = &solverBodyPool_;
  data_.m_fixedBodyId = fixed;

  for (int i = 0; i < input.bodyCount; ++i) {
    btCollisionObject& object = *input.bodies[i];
    if (const btMultiBodyLinkCollider* link = linkOf(&object))
      link->m_multiBody->setCompanionId(-1);
    if (!btRigidBody::upcast(&object)) continue;
    const int* index = group.indexOf.find(&object);
    object.setCompanionId(index && *index == leftOut ? absent : fixed);
  }
  for (int i = 0; i < count; ++i)
    if (btRigidBody* rigid = group.bodySources[i].rigid) rigid->setCompanionId(i);
}

void MultiBodyParts::takeBackCompanionIds(const Group& group, const GroupInput& input) {
  for (int i = 0; i < input.bodyCount; ++i) input.bodies[i]->setCompanionId(-1);
  for (const BodySource& source : group.bodySources)
    if (source.rigid) source.rigid->setCompanionId(-1);
  for (int i = 0; i < rows_.size(); ++i)
    for (btMultiBody* body : {rows_[i].m_multiBodyA, rows_[i].m_multiBodyB})
      if (body) body->setCompanionId(-1);
}

void MultiBodyParts::askRows(btMultiBodyConstraint& constraint, const btContactSolverInfo& info) {
  // Bullet's arrays hand out what was there before.
  const int begin = rows_.size();
  rows_.resize(begin + constraint.getNumRows(), blankRow());
  rows_.resizeNoInitialize(begin);
  constraint.createConstraintRows(rows_, data_, info);
}

/// What is wrong with a row as Bullet made it, or null.
const char* MultiBodyParts::faultOfInput(Group& group, const btMultiBodySolverConstraint& row) {
  double sum = std::abs(row.m_rhs) + std::abs(row.m_rhsPenetration);
  for (const btVector3& axis : {row.m_contactNormal1, row.m_relpos1CrossNormal,
                                row.m_contactNormal2, row.m_relpos2CrossNormal})
    sum += axis.length2();
  const auto addTree = [&](btMultiBody* body, int jacobian) {
    if (!body) return true;
    const TreeSource& source = treeOf(group, *body);
    if (source.tree == leftOut) return false;
    const auto dofs = group.articulation.trees[source.tree].root.rows();
    for (int i = 0; i < dofs; ++i) sum += std::abs(data_.m_jacobians[jacobian + i]);
    return true;
  };
  if (!addTree(row.m_multiBodyA, row.m_jacAindex) || !addTree(row.m_multiBodyB, row.m_jacBindex))
    return brokenBody;
  return std::isfinite(sum) ? nullptr : "its axis or its target velocity is not finite";
}

void MultiBodyParts::addRow(Group& group, btMultiBodyConstraint& constraint, int asked, int dof,
                            StepReport& report) {
  const btMultiBodySolverConstraint& from = rows_[asked];
  if (!(from.m_jacDiagABInv > 0)) {
    // Bullet switches off, by d = 0, what it cannot divide by: also what is no number.
    if (const char* fault = faultOfInput(group, from))
      report.leaveOut("row " + std::to_string(dof) + " of " + nameOf(constraint), fault);
    return;
  }
  const double response = 1 / static_cast<double>(from.m_jacDiagABInv);

  const auto rowIndex = static_cast<int>(group.rows.size());
  const int absent = data_.m_fixedBodyId + 1;
  Row row;
  KeptList<Articulation::JointRow>& jointRows = group.articulation.jointRows;
  const std::size_t jointRowsBefore = jointRows.size();
  /// One side: the body it acts on, or leftOut.
  const auto sideOf = [&](btMultiBody* body, int jacobian, int solverBodyId,
                          const btVector3& linear, const btVector3& angular, Row6& J) {
    if (body) {
      const TreeSource& source = treeOf(group, *body);
      if (source.tree == leftOut) return leftOut;
      const MatrixXd& root = group.articulation.trees[source.tree].root;
      Articulation::JointRow& added = jointRows.add();
      added.row = rowIndex;
      added.tree = source.tree;
      added.effect.setZero(root.cols());
      for (int i = 0; i < root.rows(); ++i)
        added.effect += root.row(i).transpose() * data_.m_jacobians[jacobian + i];
      return source.stem;
    }
    if (solverBodyId == absent) return leftOut;
    if (solverBodyId < 0 || solverBodyId >= data_.m_fixedBodyId) return fixedWorld;
    J = bullet::toCore(linear, angular).transpose();
    row.target += J.dot(group.bodySources[solverBodyId].before);
    return solverBodyId;
  };
  row.target = (static_cast<double>(from.m_rhs) + from.m_rhsPenetration) * response;
  row.a = sideOf(from.m_multiBodyA, from.m_jacAindex, from.m_solverBodyIdA, from.m_contactNormal1,
                 from.m_relpos1CrossNormal, row.jacobianA);
  row.b = sideOf(from.m_multiBodyB, from.m_jacBindex, from.m_solverBodyIdB, from.m_contactNormal2,
                 from.m_relpos2CrossNormal, row.jacobianB);
  row.lower = toCoreBound(from.m_lowerLimit);
  row.upper = toCoreBound(from.m_upperLimit);
  row.compliance = complianceOf(from.m_cfm, response);

  const char* fault = row.a == leftOut || row.b == leftOut ? brokenBody : faultOfRow(row);
  for (std::size_t i = jointRowsBefore; i < jointRows.size() && !fault; ++i)
    if (!(jointRows[i].effect.cwiseAbs().sum() <= largestNumber)) fault = "its axis is not finite";
  if (fault || (row.lower == 0 && row.upper == 0)) {
    while (jointRows.size() > jointRowsBefore) jointRows.pop_back();
    if (fault) report.leaveOut("row " + std::to_string(dof) + " of " + nameOf(constraint), fault);
    return;
  }
  group.rows.push_back(row);
  group.softRows += from.m_cfm > 0;
  group.multiBodyRows.push_back(
      {rowIndex, &constraint, asked, dof, constraint.getAppliedImpulse(dof)});
}

void MultiBodyParts::gatherRows(Group& group, const GroupInput& input, StepReport& report) {
  rows_.resizeNoInitialize(0);
  if (constraintCount_ == 0) return;
  data_.m_jacobians.resizeNoInitialize(0);
  data_.m_deltaVelocitiesUnitImpulse.resizeNoInitialize(0);
  data_.m_deltaVelocities.resizeNoInitialize(0);

  lendCompanionIds(group, input);
  for (int i = 0; i < constraintCount_; ++i) {
    btMultiBodyConstraint& constraint = *constraints_[i];
    const int begin = rows_.size();
    askRows(constraint, *input.info);
    for (int k = begin; k < rows_.size(); ++k) {
      const int named = rows_[k].m_orgDofIndex;
      const int dof = named >= 0 ? named : k - begin;
      if (dof < constraint.getNumRows()) addRow(group, constraint, k, dof, report);
    }
    // A limit that is not reached has no row; its impulse is none.
    for (int dof = 0; dof < constraint.getNumRows(); ++dof)
      constraint.internalSetAppliedImpulse(dof, 0);
  }
  takeBackCompanionIds(group, input);
}

void MultiBodyParts::recall(Group& group) const {
  group.rowGuess.resize(group.rows.size(), 0);
  for (const MultiBodyRowSource& source : group.multiBodyRows)
    if (std::isfinite(source.guess)) group.rowGuess[source.row] = source.guess;
}

void MultiBodyParts::writeBack(const Group& group, const Answer& answer,
                               const btContactSolverInfo& info) {
  const double h = info.m_timeStep;
  const auto addToLimb = [&](int body, const Vec3& force, const Vec3& torque) {
    const Articulation::Limb* limb = group.articulation.limbOf(body);
    if (!limb) return;
    const LimbSource& source = limbs_[limb - group.articulation.limbs.data()];
    addForce(*source.body, source.link, toBullet(force), toBullet(torque));
  };
  for (std::size_t i = 0; i < group.contacts.size(); ++i) {
    const Contact& contact = group.contacts[i];
    const Vec3 force = contact.frame * answer.contacts[i] / h;
    addToLimb(contact.a, force, contact.armA.cross(force));
    addToLimb(contact.b, -force, -contact.armB.cross(force));
  }
  for (std::size_t i = group.rows.size() - group.turningRows; i < group.rows.size(); ++i) {
    const Row& row = group.rows[i];
    addToLimb(row.a, Vec3::Zero(), row.jacobianA.tail<3>().transpose() * (answer.rows[i] / h));
    addToLimb(row.b, Vec3::Zero(), row.jacobianB.tail<3>().transpose() * (answer.rows[i] / h));
  }

  for (const MultiBodyRowSource& source : group.multiBodyRows) {
    const btMultiBodySolverConstraint& row = rows_[source.asked];
    const auto r = static_cast<btScalar>(answer.rows[source.row]);
    source.constraint->internalSetAppliedImpulse(source.dof, r);
    const btScalar force = r / info.m_timeStep;
    if (row.m_multiBodyA)
      addForce(*row.m_multiBodyA, row.m_linkA, row.m_contactNormal1 * force,
               row.m_relpos1CrossNormal * force);
    if (row.m_multiBodyB)
      addForce(*row.m_multiBodyB, row.m_linkB, row.m_contactNormal2 * force,
               row.m_relpos2CrossNormal * force);
  }

  for (const TreeSource& source : trees_) {
    if (source.tree == leftOut) continue;
    const VectorXd& gain = answer.gains.of[source.tree];
    response_.resize(static_cast<int>(gain.size()));
    for (int i = 0; i < response_.size(); ++i) response_[i] = static_cast<btScalar>(gain[i]);
    source.body->applyDeltaVeeMultiDof2(&response_[0], 1);
    source.body->setPosUpdated(false);
  }
}

void MultiBodyParts::release() {
  trees_ = {};
  limbs_ = {};
  rows_.clear();
  data_.m_jacobians.clear();
  data_.m_deltaVelocitiesUnitImpulse.clear();
  data_.m_deltaVelocities.clear();
  data_.scratch_r.clear();
  data_.scratch_v.clear();
  data_.scratch_m.clear();
  solverBodyPool_.clear();
  solverBodies_.clear();
  unit_.clear();
  response_.clear();
}

std::size_t MultiBodyParts::bytes() const {
  const auto of = [](const auto&... lists) {
    return (std::size_t{0} + ... + (lists.capacity() * sizeof(lists[0])));
  };
  // What finds the root keeps two matrices of that size.
  return trees_.bytes([](const TreeSource& tree) { return 3 * bytesOf(tree.inverseMass); }) +
         limbs_.bytes([](const LimbSource& limb) { return sizeof(double) * limb.L.size(); }) +
         of(rows_, data_.m_jacobians, data_.m_deltaVelocitiesUnitImpulse, data_.m_deltaVelocities,
            data_.scratch_r, data_.scratch_v, data_.scratch_m, solverBodies_, unit_, response_);
}

}  // namespace delassus::bullet
