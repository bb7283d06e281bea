#include "bullet_ext/two_sided.h"

#include <algorithm>
#include <tuple>

#include "BulletCollision/CollisionDispatch/btCollisionObject.h"
#include "BulletCollision/CollisionShapes/btCollisionShape.h"
#include "BulletCollision/NarrowPhaseCollision/btPersistentManifold.h"
#include "bullet_ext/group.h"
#include "bullet_ext/response.h"

namespace delassus::bullet {
namespace {

bool isOfTriangles(const btCollisionObject& object) {
  const btCollisionShape& shape = *object.getCollisionShape();
  return shape.isConcave() && shape.getShapeType() != STATIC_PLANE_PROXYTYPE;
}

bool overlaps(const Group& group, int contact) {
  const PointSource& source = group.contactSources[contact];
  return source.manifold->getContactPoint(source.point).getDistance() < 0;
}

}  // namespace

void TwoSided::add(int body, const btCollisionObject& object, int first, int end) {
  const auto number = static_cast<int>(touches_.size());
  const int* known = objects_.find(&object);
  if (!known) objects_.insert(&object, number);
  touches_.push_back({body, known ? *known : number, first, end});
}

void TwoSided::note(const Group& group, const btCollisionObject& a, int indexA,
                    const btCollisionObject& b, int indexB, int first) {
  const auto end = static_cast<int>(group.contacts.size());
  if (first == end) return;
  if (!group.movable(indexB) && isOfTriangles(b))
    add(indexA, b, first, end);
  else if (!group.movable(indexA) && isOfTriangles(a))
    add(indexB, a, first, end);
}

/// Whether there are any among those that overlap; marks them.
bool TwoSided::findOpposed(const Group& group) {
  constexpr double cosOpposed = -0.5, cosHalf = 0.5;
  const auto cosine = [&](int i, int j) {
    return group.contacts[overlapping_[i]].frame.col(0).dot(
        group.contacts[overlapping_[j]].frame.col(0));
  };
  const auto count = static_cast<int>(overlapping_.size());
  int alike = 0;  // no two of them are opposed
  while (alike < count && cosine(0, alike) > cosHalf) ++alike;
  if (alike == count) return false;
  pushesBack_.assign(count, 0);
  bool any = false;
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < i; ++j) {
      if (cosine(i, j) >= cosOpposed) continue;
      pushesBack_[i] = pushesBack_[j] = 1;
      any = true;
    }
  return any;
}

void TwoSided::soften(Group& group, int body) {
  for (std::size_t k = 0; k < overlapping_.size(); ++k) {
    if (!pushesBack_[k]) continue;
    Contact& contact = group.contacts[overlapping_[k]];
    double& push = group.pushes[overlapping_[k]];
    const Vec3 normal = contact.frame.col(0);
    const bool isFirst = contact.a == body;
    const Vec3& arm = isFirst ? contact.armA : contact.armB;
    const bool isBehind = (isFirst ? 1 : -1) * normal.dot(arm) > 0;
    contact.compliance += (isBehind ? shareBehind : share) * responseOf(group, body, arm, normal);
    contact.target[0] += push;
    push = 0;
  }
}

void TwoSided::soften(Group& group) {
  std::sort(touches_.begin(), touches_.end(), [](const Touch& x, const Touch& y) {
    return std::tie(x.body, x.object, x.first) < std::tie(y.body, y.object, y.first);
  });
  for (auto touch = touches_.begin(); touch != touches_.end();) {
    const int body = touch->body, object = touch->object;
    overlapping_.clear();
    for (; touch != touches_.end() && touch->body == body && touch->object == object; ++touch)
      for (int contact = touch->first; contact < touch->end; ++contact)
        if (overlaps(group, contact)) overlapping_.push_back(contact);
    if (findOpposed(group)) soften(group, body);
  }
}

}  // namespace delassus::bullet
