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
#include "bullet_ext/response.h"
#include "bullet_ext/softness.h"
#include "delassus/contact_motion.h"

namespace delassus::bullet {
namespace {

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

/// Moves contacts, whose indices ascend, to the points that take no part.
void leaveOut(const std::vector<int>& contacts, Group& group) {
  if (contacts.empty()) return;
  auto next = contacts.begin();
  std::size_t kept = contacts.front();
  for (std::size_t i = kept; i < group.contacts.size(); ++i) {
    if (next != contacts.end() && *next == static_cast<int>(i)) {
      const PointSource& source = group.contactSources[i];
      group.idle.push_back({source.manifold, source.point});
      ++next;
      continue;
    }
    group.contacts[kept] = group.contacts[i];
    group.contactSources[kept] = group.contactSources[i];
    group.pushes[kept] = group.pushes[i];
    group.guess[kept] = group.guess[i];
    ++kept;
  }
  group.contacts.resize(kept);
  group.contactSources.resize(kept);
  group.pushes.resize(kept);
  group.guess.resize(kept);
}

/// The longer arm of those of its bodies that can move, m.
double longerArm(const Group& group, const Contact& contact) {
  return std::max(group.isRigid(contact.a) ? contact.armA.norm() : 0,
                  group.isRigid(contact.b) ? contact.armB.norm() : 0);
}

}  // namespace

std::size_t HeldContacts::bytes() const {
  std::size_t sum = welded_.bytes() + machines_.bytes() + links_.bytes() + paths_.bytes() +
                    bytesOf(holds_, mechanisms_, numberOf_, candidates_, spare_, shares_, spans_,
                            ofPush_, ofRow_, onLink_, firstOnLink_);
  for (const ImpulseSpan& span : spans_) sum += span.bytes();
  return sum;
}

HeldContacts::Impulse HeldContacts::impulseOf(const Contact& contact, int axis) const {
  const Vec3 n = contact.frame.col(axis);
  Vec6 onA, onB;
  onA << n, contact.armA.cross(n);
  onB << -n, -contact.armB.cross(n);
  return onParts(contact.a, contact.b, onA, onB);
}

/// The angular impulse about an axis of the contact's frame.
HeldContacts::Impulse HeldContacts::turnOf(const Contact& contact, int axis) const {
  const Vec3 about = contact.frame.col(axis);
  Vec6 onA, onB;
  onA << Vec3::Zero(), about;
  onB << Vec3::Zero(), -about;
  return onParts(contact.a, contact.b, onA, onB);
}

/// Whether the contact is between parts of one mechanism, between what stands or is part of a
/// mechanism that does, or between that and a body at rest.
bool HeldContacts::mayBeHeld(const Group& group, const Contact& contact) {
  if (group.isLimb(contact.a) || group.isLimb(contact.b)) return false;
  if (welded_.areWelded(contact.a, contact.b)) return true;
  const int a = welded_.partOf(contact.a), b = welded_.partOf(contact.b);
  if (a == none && b == none) return welded_.isBolted(contact.a) || welded_.isBolted(contact.b);
  if (a != none && b != none && mechanismOf(a) == mechanismOf(b)) return mechanismOf(a) != none;
  const auto stands = [&](int part) {
    if (part == none) return true;
    const int number = mechanismOf(part);
    return number != none && mechanisms_[number].stands() && !hasTooMany(number);
  };
  return stands(a) && stands(b);
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
      extend(group, holds_[k], impulseOf(group.rows[holds_[k].row], holds_[k].isDriven), span);
  }
  return spans_[mechanism.span];
}

/// Extends the span by one more row, whose coordinates are then in ofRow_. Returns the last of
/// them, that along the row itself; 0 if nothing can follow the row.
double HeldContacts::extend(const Group& group, const Hold& hold, const Impulse& impulse,
                            ImpulseSpan& span) {
  const double size = ImpulseSpan::product(welded_.parts(), impulse, impulse);
  span.coordinates(welded_.parts(), impulse, ofRow_);
  const double left = std::max(size - squaresOf(ofRow_), 0.0) + group.rows[hold.row].compliance;
  if (!(left > 0)) return 0;
  span.add(impulse, ofRow_, left);
  return std::sqrt(left);
}

/// The share of (push, push) that the mechanism takes up: by joints, or also by motors, or also by
/// limits that the push would cross and that `step` of it reaches in this step, each tried once, in
/// their order. Adds to `apart` the speed at which these ask the contact to part.
double HeldContacts::takenUp(const Group& group, const Impulse& push, Mechanism& mechanism, By by,
                             double step, Wanted& apart) {
  ImpulseSpan& span = spanOf(group, mechanism);
  span.coordinates(welded_.parts(), push, ofPush_);
  if (by == By::Joints) {
    apart.add(span.wantedAlong(ofPush_));
    return squaresOf(ofPush_);
  }
  const int size = span.size();
  for (int k = mechanism.begin; k < mechanism.end; ++k) {
    const Hold& hold = holds_[k];
    if (!(by == By::Limits ? hold.isWeak() : hold.isMotor)) continue;
    const Row& row = group.rows[hold.row];
    const Impulse impulse = impulseOf(row, hold.isDriven);
    double along = ImpulseSpan::product(welded_.parts(), impulse, push);
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

/// The share of (push, push) that the joints of its bodies leave.
double HeldContacts::leftOf(const Group& group, const Impulse& push, By by, double step,
                            Wanted& apart) {
  double left = ImpulseSpan::product(welded_.parts(), push, push);
  int first = none;
  for (const int part : {push.a, push.b}) {
    if (part == none) continue;
    const int number = narrowed_ != none ? narrowed_ : mechanismOf(part);
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
    Impulse push = impulseOf(contact, axis);
    (ofA ? push.b : push.a) = none;
    return leftOf(group, push, By::Joints, 0, apart);
  };
  const auto grazesAlone = [&](bool ofA) {
    const double along = left(ofA, 0);
    return along <= shareOfGrazing * (along + left(ofA, 1) + left(ofA, 2));
  };
  return (welded_.partOf(contact.a) == none || grazesAlone(true)) &&
         (welded_.partOf(contact.b) == none || grazesAlone(false));
}

/// What nothing can stop and holds the body, or the mechanism that holds it.
int HeldContacts::moverOf(int body) {
  const int part = welded_.partOf(body);
  if (part == none) return welded_.moverOf(body);
  return mechanisms_[narrowed_ != none ? narrowed_ : mechanismOf(part)].mover;
}

/// How fast such things move the two points apart, or in any direction where they do so by joints,
/// m/s.
double HeldContacts::movedApart(const Contact& contact) {
  const Vec3 ofA = welded_.movedAt(contact.a, contact.armA),
             ofB = welded_.movedAt(contact.b, contact.armB);
  double sum = (ofA - ofB).norm();
  for (const int body : {contact.a, contact.b})
    if (const int part = welded_.partOf(body); part != none)
      sum += mechanisms_[narrowed_ != none ? narrowed_ : mechanismOf(part)].moved;
  return sum;
}

/// Whether the motion of what nothing can stop is that of both bodies alike: at most one such thing
/// holds them, or several that move as one.
bool HeldContacts::haveOneMover(const Group& group, const Contact& contact) {
  const int ofA = moverOf(contact.a), ofB = moverOf(contact.b);
  if (ofA == manyMovers || ofB == manyMovers) return false;
  return ofA == noMover || ofB == noMover || welded_.moveAsOne(group, ofA, ofB);
}

/// Whether something drives the bodies together that asks for this speed, m/s: what is moved, a
/// joint's drive, or errors that are none of their fit.
bool HeldContacts::areDriven(const Group& group, const Contact& contact, const Wanted& wanted,
                             double overlap, const btContactSolverInfo& info) {
  if (welded_.areWelded(contact.a, contact.b)) return false;
  const bool standOnOne = haveOneMover(group, contact);
  if (standOnOne && welded_.areMoved(contact.a, contact.b)) return false;
  const double arm = longerArm(group, contact), harmless = still * arm / group.h;
  // What drives on lets the overlap grow.
  const double deep = std::max(1.0, overlap / (play * arm)), patience = 1 / (deep * deep);
  if (wanted.ofDrives < -harmless * patience) return true;
  const double moved = movedApart(contact);
  if (!standOnOne && wanted.ofMovers < -std::sqrt(share) * moved * patience)
    return true;  // normals lean
  // Joints mend their errors, which decays.
  const double mends = wanted.ofErrors + wanted.ofDrives;
  if (!areOfOne(group, contact)) return mends < -harmless;
  const double ahead = standOnOne ? group.h * moved : 0;
  const double error = -mends * group.h / info.m_erp - ahead;
  return error > play * arm && overlap + error > fit * arm;
}

/// `asked`: the speed at which the contact is to part, m/s. Sets `apart` to the speed at which its
/// joints ask it to.
HeldContacts::Held HeldContacts::judge(const Group& group, const Contact& contact, double asked,
                                       double overlap, const btContactSolverInfo& info,
                                       double& apart) {
  const Impulse push = impulseOf(contact);
  narrowed_ = none;
  if (push.a == push.b) {
    apart = push.wanted.all();
    return areDriven(group, contact, push.wanted, overlap, info) ? Held::No : Held::Wholly;
  }
  if (push.a != none && push.b != none && hasTooMany(mechanismOf(push.a))) {
    narrowed_ = wayBetween(push.a, push.b);
    if (narrowed_ == none) return Held::No;
  }
  const double size = ImpulseSpan::product(welded_.parts(), push, push);
  const double step = size > 0 ? std::max(asked, 0.0) / size : 0;
  for (const By by : {By::Joints, By::Motors, By::Limits}) {
    Wanted wanted = push.wanted;
    const bool isHeld = leftOf(group, push, by, step, wanted) <= share * size;
    if (!isHeld && (by != By::Joints || !grazes(group, contact))) continue;
    apart = wanted.all();
    if (areDriven(group, contact, wanted, overlap, info)) return Held::No;
    if (!isHeld) return Held::Grazing;
    if (by != By::Joints) return by == By::Limits ? Held::ByLimit : Held::ByMotor;
    return isWhollyHeld(group, contact) ? Held::Wholly : Held::Along;
  }
  return Held::No;
}

/// Whether the bodies are links of one mechanism. Links of two that stand on one welded frame are,
/// and so is a moved body on which the mechanism stands: that is ahead of the rest by a step.
bool HeldContacts::areOfOne(const Group& group, const Contact& contact) {
  if (contact.a < 0 || contact.b < 0) return false;
  if (group.isRigid(contact.a) && group.isRigid(contact.b) &&
      machines_.root(contact.a) == machines_.root(contact.b))
    return true;
  const int ofA = moverOf(contact.a), ofB = moverOf(contact.b);
  return ofA >= 0 && ofB >= 0 && welded_.moveAsOne(group, ofA, ofB);
}

/// Whether the joints leave the two bodies no relative motion at all.
bool HeldContacts::isWhollyHeld(const Group& group, const Contact& contact) {
  Wanted apart;
  const auto isHeld = [&](const Impulse& push) {
    return leftOf(group, push, By::Joints, 0, apart) <=
           share * ImpulseSpan::product(welded_.parts(), push, push);
  };
  for (const int axis : {1, 2})
    if (!isHeld(impulseOf(contact, axis))) return false;
  for (const int axis : {0, 1, 2})
    if (!isHeld(turnOf(contact, axis))) return false;
  return true;
}

/// Answers a contact as what it is. Returns whether it is held.
bool HeldContacts::answer(Group& group, int i, const btContactSolverInfo& info,
                          bool leavesOutWelded) {
  Contact& contact = group.contacts[i];
  double &asked = contact.target[0], &push = group.pushes[i], apart = 0;
  const PointSource& source = group.contactSources[i];
  const btManifoldPoint& point = source.manifold->getContactPoint(source.point);
  const Held held = judge(group, contact, std::max(asked, push), -point.getDistance(), info, apart);
  if (held == Held::No) return false;
  if (leavesOutWelded && (welded_.areWeldedForGood(contact.a, contact.b) ||
                          welded_.areOfOneWeld(contact.a, contact.b))) {
    spare_.push_back(i);
    return true;
  }
  if (held == Held::Grazing) {
    letOverlap(point, info, play * longerArm(group, contact), contact, push);
    return true;
  }
  if (held == Held::ByLimit)
    asked += push;
  else
    asked = std::min(asked, held == Held::Along ? 0 : apart);
  push = 0;
  if (held == Held::Wholly && !areOfOne(group, contact)) return true;
  const bool sharesLoad = leavesOutWelded && welded_.areWelded(contact.a, contact.b);
  if (sharesLoad) shares_[welded_.rootOf(contact.a)] = true;
  const double give = held == Held::Along     ? softness
                      : held == Held::ByLimit ? joinedSoftness
                                              : loopSoftness;
  const double response = lesserResponse(group, contact);
  contact.compliance =
      std::max(contact.compliance, sharesLoad ? shared(response, contact.a) : give * response);
  return true;
}

int HeldContacts::soften(Group& group, const btContactSolverInfo& info, bool leavesOutWelded) {
  if (group.contacts.empty() || group.joints.empty()) return 0;
  collect(group);
  if (holds_.empty() && welded_.empty()) return 0;
  candidates_.clear();
  spare_.clear();
  for (std::size_t i = 0; i < group.contacts.size(); ++i)
    if (mayBeHeld(group, group.contacts[i])) candidates_.push_back(static_cast<int>(i));
  if (candidates_.empty()) return 0;
  sortHolds();
  hasWays_ = false;
  shares_.assign(group.bodies.size(), false);
  int count = 0;
  for (const int i : candidates_) count += answer(group, i, info, leavesOutWelded);
  softenWelds(group);
  leaveOut(spare_, group);
  return count;
}

}  // namespace delassus::bullet
