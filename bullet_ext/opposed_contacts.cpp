#include "bullet_ext/opposed_contacts.h"

#include <algorithm>
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

/// Whether one of the objects is a compound or made of triangles: Bullet numbers their parts, and
/// the number is at hand where the shape is not.
bool isOfAPart(const btManifoldPoint& point) { return point.m_index0 >= 0 || point.m_index1 >= 0; }

bool isOfTriangles(const btCollisionObject& object) {
  return object.getCollisionShape()->isConcave();
}

Vec3 placeOf(const Group& group, int body) {
  return toCore(group.bodySources[body].rigid->getWorldTransform().getOrigin());
}

}  // namespace

void OpposedContacts::add(int body, const btCollisionObject& object, bool isInTriangles, int first,
                          int end) {
  const auto number = static_cast<int>(touches_.size());
  const int* known = objects_.find(&object);
  if (!known) objects_.insert(&object, number);
  touches_.push_back({body, body, known ? *known : number, first, end, isInTriangles});
}

void OpposedContacts::note(const Group& group, const btCollisionObject& a, int indexA,
                           const btCollisionObject& b, int indexB, int first) {
  const auto end = static_cast<int>(group.contacts.size());
  if (first == end || !isOfAPart(pointOf(group, first))) return;
  // Both may move: then by the one that came first, whichever of them the manifold names first.
  const bool movesA = group.movable(indexA), movesB = group.movable(indexB);
  if (movesA && !(movesB && indexB < indexA))
    add(indexA, b, !movesB && isOfTriangles(b), first, end);
  else
    add(indexB, a, !movesA && isOfTriangles(a), first, end);
}

void OpposedContacts::findMechanisms(const Group& group) {
  const auto isRigid = [&](int body) { return group.movable(body) && !group.isLimb(body); };
  mechanisms_.reset(static_cast<int>(group.bodies.size()));
  group.joined.eachPair([&](const btCollisionObject& a, const btCollisionObject& b) {
    const int *indexA = group.indexOf.find(&a), *indexB = group.indexOf.find(&b);
    if (indexA && indexB && isRigid(*indexA) && isRigid(*indexB))
      mechanisms_.join(*indexA, *indexB);
  });
  for (Touch& touch : touches_)
    if (touch.isInTriangles) touch.mechanism = mechanisms_.root(touch.body);
}

/// Whether there are any among those that overlap; marks them.
bool OpposedContacts::findOpposed() {
  constexpr double cosOpposed = -0.5, cosHalf = 0.5;
  // As a rule no two of them are.
  if (std::all_of(overlapping_.begin(), overlapping_.end(), [&](const Overlap& overlap) {
        return overlap.push.dot(overlapping_.front().push) > cosHalf;
      }))
    return false;
  bool any = false;
  for (std::size_t i = 0; i < overlapping_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (overlapping_[i].push.dot(overlapping_[j].push) >= cosOpposed) continue;
      overlapping_[i].isOpposed = overlapping_[j].isOpposed = true;
      any = true;
    }
  return any;
}

Vec3 OpposedContacts::centreOf(const Group& group, int mechanism) {
  double mass = 0;
  Vec3 sum = Vec3::Zero();
  for (int body = 0; body < static_cast<int>(group.bodies.size()); ++body) {
    if (!group.movable(body) || group.isLimb(body) || mechanisms_.root(body) != mechanism) continue;
    const double inverse = group.bodySources[body].rigid->getInvMass();
    if (!(inverse > 0)) continue;
    mass += 1 / inverse;
    sum += placeOf(group, body) / inverse;
  }
  return mass > 0 ? Vec3(sum / mass) : placeOf(group, mechanism);
}

void OpposedContacts::soften(Group& group, const Touch& touch) {
  const bool isLinked = touch.isInTriangles && !group.joined.empty() && !group.isLimb(touch.body);
  const Vec3 centre = isLinked ? centreOf(group, touch.mechanism) : Vec3::Zero();
  for (const Overlap& overlap : overlapping_) {
    if (!overlap.isOpposed) continue;
    Contact& contact = group.contacts[overlap.contact];
    double& push = group.pushes[overlap.contact];
    Vec3 arm = contact.a == overlap.body ? contact.armA : contact.armB;
    if (isLinked) arm += placeOf(group, overlap.body) - centre;
    const bool isBehind = touch.isInTriangles && overlap.push.dot(arm) > 0;
    contact.compliance += (isBehind ? shareBehind : share) * lesserResponse(group, contact);
    contact.target[0] += push;
    push = 0;
  }
}

void OpposedContacts::soften(Group& group) {
  const auto isInTriangles = [](const Touch& touch) { return touch.isInTriangles; };
  if (!group.joined.empty() && std::any_of(touches_.begin(), touches_.end(), isInTriangles))
    findMechanisms(group);
  std::sort(touches_.begin(), touches_.end(), [](const Touch& x, const Touch& y) {
    return std::tie(x.mechanism, x.object, x.first) < std::tie(y.mechanism, y.object, y.first);
  });
  for (auto touch = touches_.begin(); touch != touches_.end();) {
    const Touch& first = *touch;
    overlapping_.clear();
    for (; touch != touches_.end() && touch->mechanism == first.mechanism &&
           touch->object == first.object;
         ++touch)
      for (int k = touch->first; k < touch->end; ++k) {
        if (pointOf(group, k).getDistance() >= 0) continue;
        const Contact& contact = group.contacts[k];
        const int sign = contact.a == touch->body ? 1 : -1;
        overlapping_.push_back({k, touch->body, sign * contact.frame.col(0), false});
      }
    if (findOpposed()) soften(group, first);
  }
}

}  // namespace delassus::bullet
