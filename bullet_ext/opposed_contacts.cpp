#include "bullet_ext/opposed_contacts.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "BulletCollision/CollisionDispatch/btCollisionObject.h"
#include "BulletCollision/CollisionShapes/btCollisionShape.h"
#include "BulletCollision/NarrowPhaseCollision/btPersistentManifold.h"
#include "bullet_ext/convert.h"
#include "bullet_ext/group.h"
#include "bullet_ext/response.h"

namespace delassus::bullet {
namespace {

const btManifoldPoint& pointOf(const Group& group, int contact) {
  const PointSource& source = group.contactSources[contact];
  return source.manifold->getContactPoint(source.point);
}

/// Whether one of the objects is a compound or made of triangles. Bullet numbers their parts in the
/// point, which is at hand; the shape is not.
bool isOfAPart(const btManifoldPoint& point) { return point.m_index0 >= 0 || point.m_index1 >= 0; }

bool isOfTriangles(const btCollisionObject& object) {
  return object.getCollisionShape()->isConcave();
}

/// Whether contacts of one manifold push against each other. Where two bodies are half way through
/// each other, Bullet may turn the normal, and keep points with the old one.
bool pushBothWays(const Group& group, int first, int end) {
  const auto normal = [&](int contact) { return group.contacts[contact].frame.col(0); };
  for (int k = first + 1; k < end; ++k)
    if (normal(k).dot(normal(first)) < 0) return true;
  return false;
}

double massOf(const btRigidBody& body) {
  return body.getInvMass() > 0 ? 1 / static_cast<double>(body.getInvMass()) : 0;
}

}  // namespace

void OpposedContacts::add(int body, const btCollisionObject& object, bool isInTriangles, int first,
                          int end) {
  const auto number = static_cast<int>(touches_.size());
  const int* known = objects_.find(&object);
  if (!known) objects_.insert(&object, number);
  touches_.push_back({body, known ? *known : number, first, end, isInTriangles});
}

void OpposedContacts::note(const Group& group, const btCollisionObject& a, int indexA,
                           const btCollisionObject& b, int indexB, int first) {
  const auto end = static_cast<int>(group.contacts.size());
  if (first == end) return;
  if (!isOfAPart(pointOf(group, first)) && !pushBothWays(group, first, end)) return;
  // If both may move, takes the body that came first, in whichever order the manifold names them.
  const bool movesA = group.movable(indexA), movesB = group.movable(indexB);
  if (movesA && !(movesB && indexB < indexA))
    add(indexA, b, !movesB && isOfTriangles(b), first, end);
  else
    add(indexB, a, !movesA && isOfTriangles(a), first, end);
}

/// Collects the spans, in the order of bodies and objects.
void OpposedContacts::collect(const Group& group) {
  std::sort(touches_.begin(), touches_.end(), [](const Touch& x, const Touch& y) {
    return std::tie(x.body, x.object, x.first) < std::tie(y.body, y.object, y.first);
  });
  spans_.clear();
  overlaps_.clear();
  for (const Touch& touch : touches_) {
    const auto before = static_cast<int>(overlaps_.size());
    for (int k = touch.first; k < touch.end; ++k) {
      const btManifoldPoint& point = pointOf(group, k);
      if (point.getDistance() >= 0) continue;
      const Contact& contact = group.contacts[k];
      const bool isFirst = contact.a == touch.body;
      Overlap overlap;
      overlap.contact = k;
      overlap.push = (isFirst ? 1 : -1) * contact.frame.col(0);
      overlap.place = toCore(isFirst ? point.getPositionWorldOnB() : point.getPositionWorldOnA());
      overlap.depth = -static_cast<double>(point.getDistance());
      overlaps_.push_back(overlap);
    }
    const auto end = static_cast<int>(overlaps_.size());
    if (end == before) continue;
    if (!spans_.empty() && spans_.back().body == touch.body && spans_.back().object == touch.object)
      spans_.back().end = end;
    else
      spans_.push_back({touch.body, touch.object, before, end, touch.isInTriangles});
  }
}

/// Marks the opposed contacts of two spans on one object, or of one span with itself.
void OpposedContacts::compare(const Group& group, const Span& a, const Span& b) {
  constexpr double cosOpposed = -0.5, cosContrary = -0.98;
  for (int i = a.first; i < a.end; ++i)
    for (int j = b.first; j < (a.first == b.first ? i : b.end); ++j) {
      Overlap &p = overlaps_[i], &q = overlaps_[j];
      const double cosine = p.push.dot(q.push);
      if (cosine >= cosOpposed) continue;
      const Vec3 apart = q.place - p.place;
      const double room = p.depth + q.depth;
      const bool isOneSheet =
          std::abs(apart.dot(p.push)) <= room || std::abs(apart.dot(q.push)) <= room;
      if (!isOneSheet && (a.isInTriangles || cosine >= cosContrary)) continue;
      p.isOpposed = q.isOpposed = true;
      if (a.body == b.body) continue;
      const btRigidBody &bodyA = *group.bodySources[a.body].rigid,
                        &bodyB = *group.bodySources[b.body].rigid;
      const Vec3 fromAToB =
          toCore(bodyB.getWorldTransform().getOrigin() - bodyA.getWorldTransform().getOrigin());
      p.mass += massOf(bodyA) + massOf(bodyB);
      p.moment += massOf(bodyB) * fromAToB;
      q.mass += massOf(bodyA) + massOf(bodyB);
      q.moment -= massOf(bodyA) * fromAToB;
    }
}

/// Compares the spans of bodies that a joint links, if they are in the same triangles.
void OpposedContacts::compareLinked(const Group& group) {
  const auto isBefore = [](const Span& x, const Span& y) {
    return std::tie(x.body, x.object) < std::tie(y.body, y.object);
  };
  const auto spanFrom = [&](int body, int object) {
    return std::lower_bound(spans_.begin(), spans_.end(), Span{body, object, 0, 0, true}, isBefore);
  };
  const auto isRigid = [&](const int* body) {
    return body && group.movable(*body) && !group.isLimb(*body);
  };
  group.joined.eachPair([&](const btCollisionObject& a, const btCollisionObject& b) {
    const int *bodyA = group.indexOf.find(&a), *bodyB = group.indexOf.find(&b);
    if (!isRigid(bodyA) || !isRigid(bodyB) || *bodyA == *bodyB) return;
    for (auto mine = spanFrom(*bodyA, 0); mine != spans_.end() && mine->body == *bodyA; ++mine) {
      if (!mine->isInTriangles) continue;
      const auto other = spanFrom(*bodyB, mine->object);
      if (other != spans_.end() && other->body == *bodyB && other->object == mine->object)
        compare(group, *mine, *other);
    }
  });
}

int OpposedContacts::soften(Group& group) {
  if (touches_.empty()) return 0;
  collect(group);
  for (const Span& span : spans_) compare(group, span, span);
  if (!group.joined.empty()) compareLinked(group);
  int count = 0;
  for (const Span& span : spans_)
    for (int k = span.first; k < span.end; ++k) {
      const Overlap& overlap = overlaps_[k];
      if (!overlap.isOpposed) continue;
      Contact& contact = group.contacts[overlap.contact];
      double& push = group.pushes[overlap.contact];
      Vec3 fromCentre = contact.a == span.body ? contact.armA : contact.armB;
      if (overlap.mass > 0) fromCentre -= overlap.moment / overlap.mass;
      const bool isBehind = span.isInTriangles && overlap.push.dot(fromCentre) > 0;
      contact.compliance = std::max(
          contact.compliance, (isBehind ? shareBehind : share) * lesserResponse(group, contact));
      if (push > 0 && group.joined.isHeld(*group.bodySources[span.body].rigid)) {
        contact.target[0] += push;
        push = 0;
      }
      ++count;
    }
  return count;
}

}  // namespace delassus::bullet
