#include "bullet_ext/multi_body_trees.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "BulletCollision/NarrowPhaseCollision/btPersistentManifold.h"
#include "BulletDynamics/Featherstone/btMultiBody.h"
#include "BulletDynamics/Featherstone/btMultiBodyLinkCollider.h"
#include "bullet_ext/convert.h"
#include "bullet_ext/group.h"
#include "bullet_ext/group_input.h"
#include "bullet_ext/names.h"
#include "bullet_ext/solve_group.h"
#include "bullet_ext/step_report.h"
#include "delassus/bytes.h"

namespace delassus::bullet {
namespace {

int freedomsOf(const btMultiBody& body) { return 6 + body.getNumDofs(); }

bool isFinite(const btScalar* values, int count) {
  return std::all_of(values, values + count, [](btScalar value) { return std::isfinite(value); });
}

}  // namespace

const btMultiBodyLinkCollider* linkOf(const btCollisionObject* object) {
  const btMultiBodyLinkCollider* link = btMultiBodyLinkCollider::upcast(object);
  return link && link->m_multiBody ? link : nullptr;
}

void addForce(btMultiBody& body, int link, const btVector3& force, const btVector3& torque) {
  if (link < 0) {
    body.addBaseConstraintForce(force);
    body.addBaseConstraintTorque(torque);
  } else {
    body.addLinkConstraintForce(link, force);
    body.addLinkConstraintTorque(link, torque);
  }
}

void MultiBodyTrees::gather(Group& group, const GroupInput& input, StepReport& report) {
  trees_.clear();
  limbs_.clear();
  for (int i = 0; i < input.manifoldCount; ++i) {
    const btPersistentManifold& manifold = *input.manifolds[i];
    if (manifold.getNumContacts() == 0) continue;
    for (const btCollisionObject* object : {manifold.getBody0(), manifold.getBody1()})
      if (const btMultiBodyLinkCollider* link = linkOf(object)) addLink(group, *link, report);
  }
}

const MultiBodyTrees::TreeSource& MultiBodyTrees::treeOf(Group& group, btMultiBody& body) {
  // Backwards: the links of a tree follow each other, so their tree is likely the last one.
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

/// Index of the new tree, or leftOut.
int MultiBodyTrees::addTree(Group& group, TreeSource& source) {
  MatrixXd& inverseMass = source.inverseMass;
  findInverseMass(*source.body, inverseMass);
  const int n = freedomsOf(*source.body);
  if (!inverseMass.allFinite() || !isFinite(source.body->getVelocityVector(), n)) return leftOut;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < i; ++j)
      inverseMass(i, j) = inverseMass(j, i) = 0.5 * (inverseMass(i, j) + inverseMass(j, i));
  source.root.find(inverseMass, group.articulation.trees.add().root);
  return static_cast<int>(group.articulation.trees.size()) - 1;
}

/// M⁻¹ as Bullet computes it: symmetric up to rounding, and finite if the body is.
void MultiBodyTrees::findInverseMass(const btMultiBody& body, MatrixXd& inverseMass) {
  const int n = freedomsOf(body);
  inverseMass.setZero(n, n);
  unit_.resize(n);
  for (int i = 0; i < n; ++i) unit_[i] = 0;
  for (int i = body.hasFixedBase() ? 6 : 0; i < n; ++i) {
    // Bullet skips links that are kinematic together with all links down to the base. It writes
    // neither their entries here nor their accelerations, from which the next links start.
    response_.resizeNoInitialize(0);
    response_.resize(n, 0);
    data_.scratch_v.resizeNoInitialize(0);
    data_.scratch_v.resize(4 * (body.getNumLinks() + 1), btVector3(0, 0, 0));
    unit_[i] = 1;
    body.calcAccelerationDeltasMultiDof(&unit_[0], &response_[0], data_.scratch_r, data_.scratch_v);
    unit_[i] = 0;
    for (int j = 0; j < n; ++j) inverseMass(j, i) = response_[j];
  }
}

/// Index of the new body, which stands for `source` or (if that has no body) is a stem.
int MultiBodyTrees::addLimb(Group& group, int tree, const LimbSource& source) {
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

void MultiBodyTrees::addLink(Group& group, const btMultiBodyLinkCollider& collider,
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

/// L of a link about the place of its collider: three linear rows, three angular ones.
void MultiBodyTrees::findMotion(const btMultiBodyLinkCollider& collider, Matrix6X& L) {
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
  // Bullet leaves the turning of planar joints out of the angular rows.
  for (int link = collider.m_link; link >= 0; link = body.getLink(link).m_parent) {
    const btMultibodyLink& joint = body.getLink(link);
    if (joint.m_jointType == btMultibodyLink::ePlanar)
      L.col(6 + joint.m_dofOffset).tail<3>() +=
          toCore(body.localDirToWorld(link, joint.getAxisTop(0)));
  }
}

void MultiBodyTrees::writeForces(const Group& group, const Answer& answer, double timeStep) const {
  const double h = timeStep;
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
}

void MultiBodyTrees::writeGains(const TreeGains& gains) {
  for (const TreeSource& source : trees_) {
    if (source.tree == leftOut) continue;
    const VectorXd& gain = gains.of[source.tree];
    response_.resize(static_cast<int>(gain.size()));
    for (int i = 0; i < response_.size(); ++i) response_[i] = static_cast<btScalar>(gain[i]);
    source.body->applyDeltaVeeMultiDof2(&response_[0], 1);
    source.body->setPosUpdated(false);
  }
}

void MultiBodyTrees::release() {
  trees_ = {};
  limbs_ = {};
  unit_.clear();
  response_.clear();
}

std::size_t MultiBodyTrees::bytes() const {
  // RootFinder keeps two matrices of that size.
  return trees_.bytes([](const TreeSource& tree) { return 3 * bytesOf(tree.inverseMass); }) +
         limbs_.bytes([](const LimbSource& limb) { return sizeof(double) * limb.L.size(); }) +
         (unit_.capacity() + response_.capacity()) * sizeof(btScalar);
}

}  // namespace delassus::bullet
