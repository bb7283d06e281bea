/// What holds: rows that hold their bodies rigidly, and the mechanisms that they make.
#include <algorithm>
#include <cmath>

#include "BulletDynamics/ConstraintSolver/btTypedConstraint.h"
#include "bullet_ext/arcs.h"
#include "bullet_ext/convert.h"
#include "bullet_ext/group.h"
#include "bullet_ext/held_contacts.h"
#include "bullet_ext/joint_drives.h"
#include "bullet_ext/softness.h"
#include "delassus/contact_motion.h"

namespace delassus::bullet {
namespace {

/// The impulse with which the row alone turns its bodies within the step by a radian, or moves them
/// by their radius of gyration.
double impulseOfWelds(const Group& group, const Row& row) {
  double way = 1;
  if (!turns(row)) {
    double linear = 0, angular = 0;
    for (const int body : {row.a, row.b}) {
      if (!group.isRigid(body)) continue;
      linear += group.bodies[body].inverseMass.mean();
      angular += group.bodies[body].inverseInertia.trace() / 3;
    }
    way = std::sqrt(linear / angular);
  }
  return way / (group.h * diagonal(group.bodies, row));
}

/// In which directions the row holds its bodies rigidly, not as springs or motors do.
struct Ways {
  bool up, down;

  /// Those in which it may push with `enough`.
  static Ways of(const JointSource& joint, const Row& row, double enough) {
    if (joint.isSoft || row.lower == row.upper) return {false, false};
    return {row.upper >= enough, row.lower <= -enough};
  }
  bool any() const { return up || down; }
};
/// A row is a motor if it may push less than what breaks the joint.
Ways waysOf(const JointSource& joint, const Row& row) {
  return Ways::of(joint, row, toCoreBound(joint.constraint->getBreakingImpulseThreshold()));
}

bool isWeld(const Group& group, const JointSource& joint) {
  constexpr int motions = 6;
  if (joint.rowCount != motions || rowsBesideAxis(*joint.constraint) < motions ||
      hasUnboundedMotor(*joint.constraint))
    return false;
  for (int k = joint.firstRow; k < joint.firstRow + motions; ++k) {
    const Ways ways = waysOf(joint, group.rows[k]);
    if (!ways.up || !ways.down) return false;
  }
  return true;
}

}  // namespace

/// An impulse on the bodies of a contact or row as one on their parts. `wanted` is what these ask
/// of each other along it.
HeldContacts::Impulse HeldContacts::onParts(int bodyA, int bodyB, const Vec6& onA,
                                            const Vec6& onB) const {
  Impulse impulse;
  impulse.a = welded_.partOf(bodyA);
  impulse.b = welded_.partOf(bodyB);
  if (impulse.a != none) impulse.onA = welded_.onPart(bodyA, onA);
  if (impulse.b != none) impulse.onB = welded_.onPart(bodyB, onB);
  impulse.wanted = welded_.asked(bodyA, onA);
  impulse.wanted.add(welded_.asked(bodyB, onB));
  return impulse;
}

HeldContacts::Impulse HeldContacts::impulseOf(const Row& row, bool isDriven) const {
  Impulse impulse = onParts(row.a, row.b, row.jacobianA.transpose(), row.jacobianB.transpose());
  Wanted wanted;
  (isDriven ? wanted.ofDrives : wanted.ofErrors) = row.target;
  wanted.add(impulse.wanted, -1);
  impulse.wanted = wanted;
  return impulse;
}

/// Joins what welds hold.
void HeldContacts::collectWelds(const Group& group) {
  machines_.reset(static_cast<int>(group.bodies.size()));
  welded_.reset(group);
  for (const JointSource& joint : group.joints) {
    if (!isWeld(group, joint)) continue;
    const Row& row = group.rows[joint.firstRow];
    welded_.weld(group, joint);
    if (group.isRigid(row.a) && group.isRigid(row.b)) machines_.join(row.a, row.b);
  }
  welded_.close(group);
}

/// Softens the welds of bodies that share loads with their contacts.
void HeldContacts::softenWelds(Group& group) const {
  for (const JointSource& joint : group.joints) {
    if (!isWeld(group, joint)) continue;
    const Row& first = group.rows[joint.firstRow];
    const int root = welded_.rootOf(welded_.rootOf(first.a) != none ? first.a : first.b);
    if (root == none || !shares_[root]) continue;
    for (int k = joint.firstRow; k < joint.firstRow + joint.rowCount; ++k) {
      Row& row = group.rows[k];
      row.compliance = std::max(row.compliance, shared(diagonal(group.bodies, row), root));
    }
  }
}

/// A row with this Jacobian holds the mechanism to a body that has no part.
void HeldContacts::standOn(const Group& group, int body, const Row6& jacobian,
                           Mechanism& mechanism) const {
  const int mover = welded_.moverOf(body);
  if (mechanism.mover == noMover)
    mechanism.mover = mover;
  else if (mechanism.mover == manyMovers || !welded_.moveAsOne(group, mechanism.mover, mover))
    mechanism.mover = manyMovers;
  const double asked = welded_.asked(body, jacobian.transpose()).ofMovers;
  mechanism.moved = std::max(mechanism.moved, std::abs(asked));
}

/// The compliance with which welds and contacts share loads, of what has this response, 1/kg.
double HeldContacts::shared(double response, int body) const {
  return std::min(sharedSoftness * response, sharedSlip / welded_.leastThresholdOf(body));
}

/// Collects the rows that hold, and the mechanisms that they make.
void HeldContacts::collect(const Group& group) {
  collectWelds(group);
  const auto bodies = static_cast<int>(group.bodies.size());
  links_.reset(bodies);
  holds_.clear();
  for (const JointSource& joint : group.joints) {
    const bool mayDrive = hasUnboundedMotor(*joint.constraint);
    const int fixedRows = rowsBesideAxis(*joint.constraint);
    for (int k = joint.firstRow; k < joint.firstRow + joint.rowCount; ++k) {
      const Row& row = group.rows[k];
      const Ways ways = waysOf(joint, row);
      const int a = welded_.partOf(row.a), b = welded_.partOf(row.b);
      if (!ways.any() || a == b) continue;
      // Limits may drive: hinges and sliders add the speed of a motor to what theirs asks for, and
      // limits may be moved.
      const bool isLimit = ways.up != ways.down || k - joint.firstRow >= fixedRows;
      holds_.push_back({k, a, b, ways.up, ways.down, mayDrive || isLimit});
      if (a != none && b != none) links_.join(a, b);
      if (group.isRigid(row.a) && group.isRigid(row.b)) machines_.join(row.a, row.b);
    }
  }
  mechanisms_.clear();
  numberOf_.assign(bodies, none);
  for (Hold& hold : holds_) {
    int& number = numberOf_[links_.root(hold.a != none ? hold.a : hold.b)];
    if (number == none) {
      number = static_cast<int>(mechanisms_.size());
      mechanisms_.emplace_back();
    }
    hold.mechanism = number;
    ++mechanisms_[number].rows;
    const Row& row = group.rows[hold.row];
    if (hold.a == none) standOn(group, row.a, row.jacobianA, mechanisms_[number]);
    if (hold.b == none) standOn(group, row.b, row.jacobianB, mechanisms_[number]);
  }
  collectStrongMotors(group);
}

/// Adds the motors of mechanisms that do not stand which are as strong as welds.
void HeldContacts::collectStrongMotors(const Group& group) {
  for (const JointSource& joint : group.joints)
    for (int k = joint.firstRow; k < joint.firstRow + joint.rowCount; ++k) {
      const Row& row = group.rows[k];
      const int a = welded_.partOf(row.a), b = welded_.partOf(row.b);
      if (a == none || b == none || a == b || waysOf(joint, row).any()) continue;
      const int number = mechanismOf(a);
      if (number == none || number != mechanismOf(b) || mechanisms_[number].stands()) continue;
      const Ways ways = Ways::of(joint, row, impulseOfWelds(group, row));
      if (!ways.any()) continue;
      holds_.push_back({k, a, b, ways.up, ways.down, true, true, number});
      ++mechanisms_[number].rows;
    }
}

}  // namespace delassus::bullet
