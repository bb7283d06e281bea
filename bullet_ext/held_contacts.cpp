#include "bullet_ext/held_contacts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "BulletCollision/NarrowPhaseCollision/btPersistentManifold.h"
#include "BulletDynamics/ConstraintSolver/btContactSolverInfo.h"
#include "BulletDynamics/ConstraintSolver/btTypedConstraint.h"
#include "bullet_ext/arcs.h"
#include "bullet_ext/convert.h"
#include "bullet_ext/group.h"
#include "bullet_ext/joint_drives.h"
#include "bullet_ext/response.h"
#include "bullet_ext/softness.h"
#include "delassus/contact_motion.h"

namespace delassus::bullet {
namespace {

constexpr int none = -1;

bool isRigid(const Group& group, int body) { return group.movable(body) && !group.isLimb(body); }

/// The impulse with which the row alone turns its bodies within the step by a radian, or moves them
/// by their radius of gyration.
double impulseOfWelds(const Group& group, const Row& row, double h) {
  double way = 1;
  if (!turns(row)) {
    double linear = 0, angular = 0;
    for (const int body : {row.a, row.b}) {
      if (!isRigid(group, body)) continue;
      linear += group.bodies[body].inverseMass.mean();
      angular += group.bodies[body].inverseInertia.trace() / 3;
    }
    way = std::sqrt(linear / angular);
  }
  return way / (h * diagonal(group.bodies, row));
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

ImpulseSpan::Impulse impulseOf(const Group& group, const Row& row, bool isDriven) {
  ImpulseSpan::Impulse impulse;
  if (isRigid(group, row.a)) impulse.a = row.a, impulse.onA = row.jacobianA.transpose();
  if (isRigid(group, row.b)) impulse.b = row.b, impulse.onB = row.jacobianB.transpose();
  // Kinematic bodies drive.
  double driven = 0;
  if (impulse.a == none) driven -= along(group.bodies, row.a, row.jacobianA);
  if (impulse.b == none) driven -= along(group.bodies, row.b, row.jacobianB);
  impulse.wanted = {driven + row.target, isDriven ? driven + row.target : driven};
  return impulse;
}

/// The impulse along an axis of the contact's frame.
ImpulseSpan::Impulse impulseOf(const Group& group, const Contact& contact, int axis = 0) {
  ImpulseSpan::Impulse impulse;
  const Vec3 n = contact.frame.col(axis);
  if (isRigid(group, contact.a)) {
    impulse.a = contact.a;
    impulse.onA << n, contact.armA.cross(n);
  }
  if (isRigid(group, contact.b)) {
    impulse.b = contact.b;
    impulse.onB << -n, -contact.armB.cross(n);
  }
  return impulse;
}

/// The angular impulse about an axis of the contact's frame.
ImpulseSpan::Impulse turnOf(const Group& group, const Contact& contact, int axis) {
  ImpulseSpan::Impulse impulse = impulseOf(group, contact, axis);
  const Vec3 about = contact.frame.col(axis);
  if (impulse.a != none) impulse.onA << Vec3::Zero(), about;
  if (impulse.b != none) impulse.onB << Vec3::Zero(), -about;
  return impulse;
}

double squaresOf(const std::vector<double>& numbers) {
  double sum = 0;
  for (const double x : numbers) sum += x * x;
  return sum;
}

/// Lets the bodies overlap by so much more before the contact acts.
void letOverlap(const btManifoldPoint& point, const btContactSolverInfo& info, double slop,
                Contact& contact, double& push) {
  const double d = static_cast<double>(point.getDistance()) + info.m_linearSlop;
  double& asked = contact.target[0];
  if (d + slop >= 0) {
    asked = std::min(asked, -(d + slop) / info.m_timeStep);
    push = 0;
  } else {  // both are in proportion to the overlap
    asked *= (d + slop) / d;
    push *= (d + slop) / d;
  }
}

/// The longer arm of those of its bodies that can move, m.
double longerArm(const Group& group, const Contact& contact) {
  return std::max(isRigid(group, contact.a) ? contact.armA.norm() : 0,
                  isRigid(group, contact.b) ? contact.armB.norm() : 0);
}

}  // namespace

std::size_t HeldContacts::bytes() const {
  std::size_t sum = links_.bytes() + paths_.bytes() +
                    bytesOf(holds_, mechanisms_, numberOf_, candidates_, spans_, ofPush_, ofRow_,
                            onLink_, firstOnLink_);
  for (const ImpulseSpan& span : spans_) sum += span.bytes();
  return sum;
}

/// Collects the rows that hold, and the mechanisms that they make.
void HeldContacts::collect(const Group& group, double h) {
  const auto bodies = static_cast<int>(group.bodies.size());
  links_.reset(bodies);
  holds_.clear();
  const auto rigid = [&](int body) { return isRigid(group, body) ? body : none; };
  for (const JointSource& joint : group.joints) {
    const bool mayDrive = hasUnboundedMotor(*joint.constraint);
    const int fixedRows = rowsBesideAxis(*joint.constraint);
    for (int k = joint.firstRow; k < joint.firstRow + joint.rowCount; ++k) {
      const Row& row = group.rows[k];
      const Ways ways = waysOf(joint, row);
      const int a = rigid(row.a), b = rigid(row.b);
      if (!ways.any() || (a == none && b == none)) continue;
      // Limits may drive: hinges and sliders add the speed of a motor to what theirs asks for, and
      // limits may be moved.
      const bool isLimit = ways.up != ways.down || k - joint.firstRow >= fixedRows;
      holds_.push_back({k, a, b, ways.up, ways.down, mayDrive || isLimit});
      if (a != none && b != none) links_.join(a, b);
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
    if (hold.a == none || hold.b == none) mechanisms_[number].stands = true;
  }
  collectStrongMotors(group, h);
}

/// Adds the motors of mechanisms that do not stand which are as strong as welds.
void HeldContacts::collectStrongMotors(const Group& group, double h) {
  for (const JointSource& joint : group.joints)
    for (int k = joint.firstRow; k < joint.firstRow + joint.rowCount; ++k) {
      const Row& row = group.rows[k];
      if (!isRigid(group, row.a) || !isRigid(group, row.b) || waysOf(joint, row).any()) continue;
      const int number = numberOf_[links_.root(row.a)];
      if (number == none || links_.root(row.b) != links_.root(row.a) || mechanisms_[number].stands)
        continue;
      const Ways ways = Ways::of(joint, row, impulseOfWelds(group, row, h));
      if (!ways.any()) continue;
      holds_.push_back({k, row.a, row.b, ways.up, ways.down, true, true, number});
      ++mechanisms_[number].rows;
    }
}

/// The mechanism of a body that can move; none if nothing holds it.
int HeldContacts::mechanismOf(int body) { return numberOf_[links_.root(body)]; }

/// Whether the contact is between parts of one mechanism, between mechanisms that are both fixed to
/// bodies at rest, or between such a mechanism and a body at rest.
bool HeldContacts::mayBeHeld(const Group& group, const Contact& contact) {
  if (group.isLimb(contact.a) || group.isLimb(contact.b)) return false;
  const bool movesA = group.movable(contact.a), movesB = group.movable(contact.b);
  const int a = movesA ? mechanismOf(contact.a) : none, b = movesB ? mechanismOf(contact.b) : none;
  if ((movesA && a == none) || (movesB && b == none)) return false;
  if (movesA && a == b) return true;
  const auto stands = [&](int number) {
    return mechanisms_[number].stands && !hasMore(number, fewRows);
  };
  return (movesA || movesB) && (!movesA || stands(a)) && (!movesB || stands(b));
}

void HeldContacts::sortHolds() {
  const auto key = [](const Hold& hold) {
    return std::make_tuple(hold.mechanism, hold.isWeak(), hold.row);
  };
  std::sort(holds_.begin(), holds_.end(),
            [&](const Hold& x, const Hold& y) { return key(x) < key(y); });
  const auto count = static_cast<int>(holds_.size());
  for (int k = 0; k < count; ++k) {
    Mechanism& mechanism = mechanisms_[holds_[k].mechanism];
    if (mechanism.end == 0) mechanism.begin = k;
    mechanism.end = k + 1;
  }
  spansUsed_ = 0;
}

/// The span of the rows that are not weak.
ImpulseSpan& HeldContacts::spanOf(const Group& group, Mechanism& mechanism) {
  if (mechanism.span == none) {
    mechanism.span = spansUsed_++;
    if (spansUsed_ > static_cast<int>(spans_.size())) spans_.emplace_back();
    ImpulseSpan& span = spans_[mechanism.span];
    span.truncate(0);
    for (int k = mechanism.begin; k < mechanism.end && !holds_[k].isWeak(); ++k)
      extend(group, holds_[k], impulseOf(group, group.rows[holds_[k].row], holds_[k].isDriven),
             span);
  }
  return spans_[mechanism.span];
}

/// Extends the span by one more row, whose coordinates are then in ofRow_. Returns the last of
/// them, that along the row itself; 0 if nothing can follow the row.
double HeldContacts::extend(const Group& group, const Hold& hold, const Impulse& impulse,
                            ImpulseSpan& span) {
  const double size = ImpulseSpan::product(group.bodies, impulse, impulse);
  span.coordinates(group.bodies, impulse, ofRow_);
  const double left = std::max(size - squaresOf(ofRow_), 0.0) + group.rows[hold.row].compliance;
  if (!(left > 0)) return 0;
  span.add(impulse, ofRow_, left);
  return std::sqrt(left);
}

/// The part of (push, push) that the mechanism takes up: by joints, or also by motors, or also by
/// limits that the push would cross and that `step` of it reaches in this step, each tried once, in
/// their order. Adds to `apart` the speed at which these ask the contact to part.
double HeldContacts::takenUp(const Group& group, const Impulse& push, Mechanism& mechanism, By by,
                             double step, Wanted& apart) {
  ImpulseSpan& span = spanOf(group, mechanism);
  span.coordinates(group.bodies, push, ofPush_);
  if (by == By::Joints) {
    apart.add(span.wantedAlong(ofPush_));
    return squaresOf(ofPush_);
  }
  const int size = span.size();
  for (int k = mechanism.begin; k < mechanism.end; ++k) {
    const Hold& hold = holds_[k];
    if (!(by == By::Limits ? hold.isWeak() : hold.isMotor)) continue;
    const Row& row = group.rows[hold.row];
    const Impulse impulse = impulseOf(group, row, hold.isDriven);
    double along = ImpulseSpan::product(group.bodies, impulse, push);
    // Some joints have rows for limits that are far away.
    const double reached = relativeVelocity(group.bodies, row) + step * along;
    if (hold.isLimit() && (hold.up ? reached > 0 : reached < 0)) continue;
    const double itself = extend(group, hold, impulse, span);
    if (itself == 0) continue;
    for (std::size_t j = 0; j < ofRow_.size(); ++j) along -= ofRow_[j] * ofPush_[j];
    if (!hold.isLimit() || (hold.up ? along < 0 : along > 0))
      ofPush_.push_back(along / itself);
    else
      span.truncate(span.size() - 1);
  }
  apart.add(span.wantedAlong(ofPush_));
  span.truncate(size);
  return squaresOf(ofPush_);
}

/// The part of (push, push) that the joints of its bodies leave.
double HeldContacts::leftOf(const Group& group, const Impulse& push, By by, double step,
                            Wanted& apart) {
  double left = ImpulseSpan::product(group.bodies, push, push);
  int first = none;
  for (const int body : {push.a, push.b}) {
    if (body == none) continue;
    const int number = narrowed_ != none ? narrowed_ : mechanismOf(body);
    if (number != first) left -= takenUp(group, push, mechanisms_[number], by, step, apart);
    first = number;
  }
  return left;
}

/// Whether each of the two bodies grazes: what motion joints leave its point of the contact is
/// hardly along the normal.
bool HeldContacts::grazes(const Group& group, const Contact& contact) {
  Wanted apart;
  const auto left = [&](bool ofA, int axis) {
    Impulse push = impulseOf(group, contact, axis);
    (ofA ? push.b : push.a) = none;
    return leftOf(group, push, By::Joints, 0, apart);
  };
  const auto grazesAlone = [&](bool ofA) {
    const double along = left(ofA, 0);
    return along <= shareOfGrazing * (along + left(ofA, 1) + left(ofA, 2));
  };
  return (!isRigid(group, contact.a) || grazesAlone(true)) &&
         (!isRigid(group, contact.b) || grazesAlone(false));
}

/// `asked`: the speed at which the contact is to part, m/s. Sets `apart` to the speed at which its
/// joints ask it to.
HeldContacts::Held HeldContacts::judge(const Group& group, const Contact& contact, double asked,
                                       double overlap, double h, double& apart) {
  const Impulse push = impulseOf(group, contact);
  // Kinematic bodies stand, but may move.
  Vec3 standing = Vec3::Zero();
  if (push.a == none) standing += velocityAt(group.bodies, contact.a, contact.armA);
  if (push.b == none) standing -= velocityAt(group.bodies, contact.b, contact.armB);
  // Joints mend their errors, which decays. Normals lean. What drives on lets the overlap grow.
  const double arm = longerArm(group, contact);
  const bool isWithin = isWithinOne(group, contact);
  narrowed_ = none;
  if (isWithin) {
    const int number = mechanismOf(contact.a);
    if (hasMore(number, fewRows) && !(overlap > fits * arm)) return Held::No;
    if (hasMore(number, mostRows)) {
      narrowed_ = wayBetween(contact.a, contact.b);
      if (narrowed_ == none) return Held::No;
    }
  }
  const double harmless = standing.isZero(0) ? still * arm / h : std::sqrt(share) * standing.norm();
  const double deep = std::max(1.0, overlap / (play * arm));
  const double size = ImpulseSpan::product(group.bodies, push, push);
  const double step = size > 0 ? std::max(asked, 0.0) / size : 0;
  for (const By by : {By::Joints, By::Motors, By::Limits}) {
    const double driven = contact.frame.col(0).dot(standing);
    Wanted wanted{driven, driven};
    const bool isHeld = leftOf(group, push, by, step, wanted) <= share * size;
    if (!isHeld && (by != By::Joints || !grazes(group, contact))) continue;
    apart = wanted.all;
    if (wanted.ofDrives < -harmless / (deep * deep)) return Held::No;
    if (!isWithin && wanted.all < -harmless) return Held::No;
    if (!isHeld) return Held::Grazing;
    if (by != By::Joints) return by == By::Limits ? Held::ByLimit : Held::ByMotor;
    return isWhollyHeld(group, contact) ? Held::Wholly : Held::Along;
  }
  return Held::No;
}

bool HeldContacts::isWithinOne(const Group& group, const Contact& contact) {
  return isRigid(group, contact.a) && isRigid(group, contact.b) &&
         mechanismOf(contact.a) == mechanismOf(contact.b);
}

/// Whether the joints leave the two bodies no relative motion at all.
bool HeldContacts::isWhollyHeld(const Group& group, const Contact& contact) {
  Wanted apart;
  const auto isHeld = [&](const Impulse& push) {
    return leftOf(group, push, By::Joints, 0, apart) <=
           share * ImpulseSpan::product(group.bodies, push, push);
  };
  for (const int axis : {1, 2})
    if (!isHeld(impulseOf(group, contact, axis))) return false;
  for (const int axis : {0, 1, 2})
    if (!isHeld(turnOf(group, contact, axis))) return false;
  return true;
}

int HeldContacts::soften(Group& group, const btContactSolverInfo& info) {
  if (group.contacts.empty() || group.joints.empty()) return 0;
  collect(group, info.m_timeStep);
  if (holds_.empty()) return 0;
  candidates_.clear();
  for (std::size_t i = 0; i < group.contacts.size(); ++i)
    if (mayBeHeld(group, group.contacts[i])) candidates_.push_back(static_cast<int>(i));
  if (candidates_.empty()) return 0;
  sortHolds();
  hasWays_ = false;
  int count = 0;
  for (const int i : candidates_) {
    Contact& contact = group.contacts[i];
    double &asked = contact.target[0], &push = group.pushes[i], apart = 0;
    const PointSource& source = group.contactSources[i];
    const btManifoldPoint& point = source.manifold->getContactPoint(source.point);
    const Held held =
        judge(group, contact, std::max(asked, push), -point.getDistance(), info.m_timeStep, apart);
    if (held == Held::No) continue;
    ++count;
    if (held == Held::Grazing) {
      letOverlap(point, info, play * longerArm(group, contact), contact, push);
      continue;
    }
    if (held == Held::ByLimit)
      asked += push;
    else
      asked = std::min(asked, held == Held::Along ? 0 : apart);
    push = 0;
    if (held == Held::Wholly && !isWithinOne(group, contact)) continue;
    const double give = held == Held::Along     ? softness
                        : held == Held::ByLimit ? joinedSoftness
                                                : loopSoftness;
    contact.compliance = std::max(contact.compliance, give * lesserResponse(group, contact));
  }
  return count;
}

}  // namespace delassus::bullet
