#include "bullet_ext/memory.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <utility>

#include "BulletCollision/NarrowPhaseCollision/btPersistentManifold.h"
#include "BulletDynamics/ConstraintSolver/btTypedConstraint.h"
#include "bullet_ext/convert.h"
#include "bullet_ext/first_room.h"
#include "bullet_ext/solve_group.h"
#include "bullet_ext/write_back.h"
#include "delassus/bytes.h"
#include "delassus/cone.h"
#include "delassus/wrench_share.h"

namespace delassus::bullet {
namespace {

const Vec3& armOf(const Group& group, const Contact& contact) {
  return group.movable(contact.a) ? contact.armA : contact.armB;
}

/// End of the run of contacts that share the manifold of contact `begin`.
int endOfManifold(const Group& group, int begin) {
  const auto count = static_cast<int>(group.contactSources.size());
  int end = begin + 1;
  while (end < count && group.contactSources[end].manifold == group.contactSources[begin].manifold)
    ++end;
  return end;
}

int manifoldsOf(const Group& group) {
  const auto contacts = static_cast<int>(group.contactSources.size());
  int count = 0;
  for (int at = 0; at < contacts; at = endOfManifold(group, at)) ++count;
  return count;
}

int numberOf(const btCollisionObject* body) {
  const btBroadphaseProxy* proxy = body ? body->getBroadphaseHandle() : nullptr;
  return proxy ? proxy->m_uniqueId : 0;
}

/// The address that identifies a group if it comes again; null if it has neither contacts nor
/// joints.
const void* signOf(const Group& group) {
  if (!group.contactSources.empty()) return group.contactSources.front().manifold;
  if (!group.joints.empty()) return group.joints.front().constraint;
  return nullptr;
}

/// The place in a Turn of the reaction of a turning-friction row.
int placeOf(const std::vector<Row>& rows, std::size_t row) {
  if (rows[row].paired) return 1;
  return row > 0 && rows[row - 1].paired ? 2 : 0;
}

}  // namespace

void Memory::Step::clear() {
  length = 0;
  manifolds.clear();
  turners.clear();
  joints.clear();
  points.clear();
  turns.clear();
  rows.clear();
  loads.clear();
  marked.clear();
}

/// A number for the manifolds of this step, other than those of all other solvers; not 0, which
/// Bullet gives to new ones. (It uses the field for nothing else.)
int Memory::nextStamp() {
  static std::atomic<int> last{0};
  const int stamp = ++last;
  return stamp != 0 ? stamp : ++last;
}

Memory::Owner Memory::ownerOf(const PointSource& point) {
  return {point.manifold,        point.bodyA,           point.bodyB,
          numberOf(point.bodyA), numberOf(point.bodyB), point.manifold->m_companionIdA};
}

Memory::Owner Memory::ownerOf(const JointSource& joint, double impulse) {
  const btRigidBody *a = &joint.constraint->getRigidBodyA(),
                    *b = &joint.constraint->getRigidBodyB();
  return {joint.constraint, a, b, numberOf(a), numberOf(b), 0, impulse};
}

void Memory::Owners::clear() {
  list_.clear();
  indexOf_.clear();
  indexed_ = next_ = 0;
}

const Memory::Owner* Memory::Owners::find(const Owner& wanted) {
  if (next_ < list_.size() && list_[next_].isSame(wanted)) return &list_[next_++];
  for (; indexed_ < list_.size(); ++indexed_)
    indexOf_.insert(list_[indexed_].object, static_cast<int>(indexed_));
  const int* index = indexOf_.find(wanted.object);
  if (!index || !list_[*index].isSame(wanted)) return nullptr;
  next_ = *index + 1;
  return &list_[*index];
}

void Memory::nextStep() {
  announced_ = true;
  std::swap(last_, now_);
  now_.clear();
  now_.length = last_.length;  // stands if all bodies sleep in this step
  groups_.clear();
}

/// Gives each fresh point (or each other point, if not `fresh`) the nearest point of the last step
/// that is not taken yet.
void Memory::claim(Group& group, int begin, int end, const Owner& owner, bool fresh) {
  for (int i = begin; i < end; ++i) {
    if (group.contactSources[i].fresh != fresh) continue;
    const Vec3 arm = armOf(group, group.contacts[i]);
    int nearest = -1;
    double distance = std::numeric_limits<double>::max();
    for (int k = owner.begin; k < owner.end; ++k) {
      const double d = (last_.points[k].arm - arm).squaredNorm();
      if (last_.points[k].taken || !(d < distance)) continue;
      distance = d;
      nearest = k;
    }
    if (nearest < 0) return;
    if (fresh) group.guess[i] = last_.points[nearest].reaction;
    last_.points[nearest].taken = true;
  }
}

/// Changes the guesses so that they push and turn as the reactions of the last step did
/// (wrench_share.h).
void Memory::matchWrench(Group& group, int begin, int end, const Owner& owner) const {
  double length = 0;  // of the arms, m
  for (int k = owner.begin; k < owner.end; ++k)
    length = std::max(length, last_.points[k].arm.norm());
  for (int i = begin; i < end; ++i)
    length = std::max(length, armOf(group, group.contacts[i]).norm());
  if (!(length > 0)) return;

  Vec6 wanted = Vec6::Zero();
  for (int k = owner.begin; k < owner.end; ++k) {
    const Point& p = last_.points[k];
    wanted.head<3>() += p.impulse;
    wanted.tail<3>() += (p.arm / length).cross(p.impulse);
  }
  static_assert(MANIFOLD_CACHE_SIZE <= mostFeltPoints);
  std::array<FeltPoint, mostFeltPoints> points;
  for (int i = begin; i < end; ++i) {
    const Contact& c = group.contacts[i];
    points[i - begin] = {c.frame, armOf(group, c) / length, c.friction};
  }
  shareWrench(points.data(), end - begin, wanted, &group.guess[begin]);
}

/// Gives the force of the last step to a lone point, as spheres have; its moment follows from that.
void Memory::matchForce(Group& group, int contact, const Owner& owner) const {
  Vec3 impulse = Vec3::Zero();
  for (int k = owner.begin; k < owner.end; ++k) impulse += last_.points[k].impulse;
  const Contact& c = group.contacts[contact];
  Vec3 reaction = Vec3::Zero();
  for (int k = 0; k < 3; ++k) {
    // The length of a tangent tells how strong friction is along it.
    const double squares = c.frame.col(k).squaredNorm();
    if (squares > 0) reaction[k] = c.frame.col(k).dot(impulse) / squares;
  }
  group.guess[contact] = projectOnCone(reaction, c.friction);
}

/// Gives points that stayed the digits of their reactions that Bullet's float cannot hold. A
/// reaction that differs from the one written was set by somebody else, and stays.
void Memory::recallDigits(Group& group, int begin, int end, const Owner& owner) const {
  const auto isRoundedTo = [](const Vec3& r, const Vec3& rounded) {
    for (int k = 0; k < 3; ++k)
      if (static_cast<btScalar>(r[k]) != static_cast<btScalar>(rounded[k])) return false;
    return true;
  };
  const int count = owner.end - owner.begin;
  for (int i = begin; i < end; ++i) {
    if (group.contactSources[i].fresh) continue;
    // The point's own place is tried first: other points may have the same digits in float.
    for (int k = 0; k < count; ++k) {
      const Vec3& reaction = last_.points[owner.begin + (i - begin + k) % count].reaction;
      if (!isRoundedTo(reaction, group.guess[i])) continue;
      group.guess[i] = reaction;
      break;
    }
  }
}

void Memory::recallPoints(Group& group, int begin, int end) {
  constexpr bool losesDigits = sizeof(btScalar) < sizeof(double);
  int fresh = 0;
  for (int i = begin; i < end; ++i) fresh += group.contactSources[i].fresh;
  if (fresh == 0 && !losesDigits) return;
  const Owner* owner = last_.manifolds.find(ownerOf(group.contactSources[begin]));
  if (!owner) return;
  if (losesDigits) recallDigits(group, begin, end, *owner);
  if (fresh == 0) return;
  if (end - begin == 1) return matchForce(group, begin, *owner);
  // Points that stayed claim their own past reactions; the rest goes to the fresh points.
  claim(group, begin, end, *owner, false);
  claim(group, begin, end, *owner, true);
  matchWrench(group, begin, end, *owner);
}

/// Marks the contacts of the bodies that were marked. If a body is new at the address of an earlier
/// one, all its points are fresh.
void Memory::recallMarks(Group& group) {
  if (last_.marked.empty()) return;
  marked_.clear();
  for (std::size_t i = 0; i < last_.marked.size(); ++i)
    if (!marked_.find(last_.marked[i].body))
      marked_.insert(last_.marked[i].body, static_cast<int>(i));
  group.marks.assign(group.contacts.size(), {});
  for (std::size_t i = 0; i < group.contacts.size(); ++i) {
    const PointSource& source = group.contactSources[i];
    if (source.fresh) continue;
    for (const btCollisionObject* body : {source.bodyA, source.bodyB})
      if (const int* found = marked_.find(body)) group.marks[i].add(last_.marked[*found].marks);
  }
}

void Memory::recall(Group& group) {
  recallMarks(group);
  const auto contacts = static_cast<int>(group.contacts.size());
  for (int begin = 0, end; begin < contacts; begin = end) {
    end = endOfManifold(group, begin);
    recallPoints(group, begin, end);
  }

  group.rowGuess.assign(group.rows.size(), 0);
  recallJoints(group);
  recallTurns(group);
}

void Memory::recallJoints(Group& group) {
  for (JointSource& joint : group.joints) {
    const Owner* owner = last_.joints.find(ownerOf(joint, joint.lastImpulse));
    if (!owner) continue;
    joint.lastLoad = last_.loads[last_.joints.indexOf(*owner)];
    // A limit or motor that came or went shifts the rows, and Bullet turns those of some joints.
    const double* reactions = last_.rows.data() + owner->begin;
    double* guess = group.rowGuess.data() + joint.firstRow;
    if (owner->end - owner->begin == joint.rowCount &&
        makesLoad(group, joint, reactions, joint.lastLoad))
      std::copy_n(reactions, joint.rowCount, guess);
    else
      takeLoad(group, joint, joint.lastLoad, guess);
  }
}

void Memory::fitTimeStep(Group& group, double h) const {
  if (last_.length == h || last_.length == 0) return;
  const double ratio = h / last_.length;
  for (Vec3& guess : group.guess) guess *= ratio;
  for (double& guess : group.rowGuess) guess *= ratio;
  for (JointSource& joint : group.joints) {
    joint.lastLoad.onA *= ratio;
    joint.lastLoad.onB *= ratio;
  }
}

const Memory::Turn* Memory::nearestTurn(const Owner& owner, const Vec3& arm) const {
  const auto distance = [&](const Turn& turn) { return (turn.arm - arm).squaredNorm(); };
  return &*std::min_element(
      last_.turns.begin() + owner.begin, last_.turns.begin() + owner.end,
      [&](const Turn& a, const Turn& b) { return distance(a) < distance(b); });
}

/// Starts each contact that resists turning from the reaction of the nearest such contact of its
/// manifold.
void Memory::recallTurns(Group& group) {
  const btPersistentManifold* manifold = nullptr;
  const Owner* owner = nullptr;
  const Turn* turn = nullptr;
  int contact = -1;
  for (std::size_t row = group.rows.size() - group.turningRows; row < group.rows.size(); ++row) {
    if (group.rows[row].governor != contact) {
      contact = group.rows[row].governor;
      if (group.contactSources[contact].manifold != manifold) {
        manifold = group.contactSources[contact].manifold;
        owner = last_.turners.find(ownerOf(group.contactSources[contact]));
      }
      turn = owner ? nearestTurn(*owner, armOf(group, group.contacts[contact])) : nullptr;
    }
    if (turn) group.rowGuess[row] = turn->reaction[placeOf(group.rows, row)];
  }
}

void Memory::keepTurns(const Group& group, const Answer& answer) {
  const btPersistentManifold* manifold = nullptr;
  int contact = -1;
  for (std::size_t row = group.rows.size() - group.turningRows; row < group.rows.size(); ++row) {
    if (group.rows[row].governor != contact) {
      contact = group.rows[row].governor;
      if (group.contactSources[contact].manifold != manifold) {
        manifold = group.contactSources[contact].manifold;
        Owner& owner = now_.turners.add(ownerOf(group.contactSources[contact]));
        owner.begin = owner.end = static_cast<int>(now_.turns.size());
      }
      ++now_.turners.last().end;
      now_.turns.push_back({armOf(group, group.contacts[contact]), Vec3::Zero()});
    }
    now_.turns.back().reaction[placeOf(group.rows, row)] = answer.rows[row];
  }
}

void Memory::keep(const Group& group, const Answer& answer, double h) {
  if (!announced_) return;
  now_.length = h;
  const void* sign = signOf(group);
  if (!sign) return;  // no reactions to keep
  if (groups_.find(sign)) {
    announced_ = false;
    last_.clear();
    now_.clear();
    return;
  }
  groups_.insert(sign, 0);
  keepPoints(group, answer);
  keepMarks(group, answer);
  keepJoints(group, answer);
  keepTurns(group, answer);
}

void Memory::keepPoints(const Group& group, const Answer& answer) {
  const int stamp = nextStamp();
  const auto contacts = static_cast<int>(group.contacts.size());
  makeFirstRoom([&] { return contacts; }, now_.points);
  makeFirstRoom([&] { return manifoldsOf(group); }, now_.manifolds);
  for (int begin = 0, end; begin < contacts; begin = end) {
    end = endOfManifold(group, begin);
    group.contactSources[begin].manifold->m_companionIdA = stamp;
    Owner& owner = now_.manifolds.add(ownerOf(group.contactSources[begin]));
    owner.begin = static_cast<int>(now_.points.size());
    owner.end = owner.begin + end - begin;
    for (int i = begin; i < end; ++i) {
      const Contact& c = group.contacts[i];
      const Vec3& reaction = answer.contacts[i];
      now_.points.push_back({armOf(group, c), reaction, c.frame * reaction, false});
    }
  }
}

void Memory::keepMarks(const Group& group, const Answer& answer) {
  // Room for all islands, though few have marks, for the same reason as in Owners::add.
  now_.marked.reserve(now_.marked.size() + answer.results.size());
  for (const IslandResult& island : answer.results)
    if (island.marks.any() && group.bodySources[island.markedBody].rigid)
      now_.marked.push_back({group.bodySources[island.markedBody].rigid, island.marks});
}

void Memory::keepJoints(const Group& group, const Answer& answer) {
  for (const JointSource& joint : group.joints) {
    const auto first = static_cast<int>(now_.rows.size());
    for (int i = 0; i < joint.rowCount; ++i) now_.rows.push_back(answer.rows[joint.firstRow + i]);
    now_.loads.push_back(loadOf(group, joint, answer.rows));
    Owner& owner = now_.joints.add(ownerOf(joint, writtenImpulse(group, joint, answer)));
    owner.begin = first;
    owner.end = first + joint.rowCount;
  }
}

std::size_t Memory::bytes() const {
  std::size_t sum = marked_.bytes() + groups_.bytes();
  for (const Step* step : {&last_, &now_})
    sum += step->manifolds.bytes() + step->turners.bytes() + step->joints.bytes() +
           bytesOf(step->points, step->turns, step->rows, step->loads) +
           step->marked.capacity() * sizeof(MarkedBody);
  return sum;
}

}  // namespace delassus::bullet
