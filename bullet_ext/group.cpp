#include "bullet_ext/group.h"

#include <algorithm>
#include <iterator>

#include "delassus/bytes.h"

namespace delassus::bullet {

void Group::clear() {
  bodies.clear();
  bodySources.clear();
  slowed.clear();
  contacts.clear();
  contactSources.clear();
  pushes.clear();
  guess.clear();
  idle.clear();
  marks.clear();
  bouncing = turning = turningRows = softRows = 0;
  rows.clear();
  arcs.clear();
  rowGuess.clear();
  joints.clear();
  obsolete.clear();
  articulation.clear();
  multiBodyRows.clear();
  indexOf.clear();
  joined.clear();
  opposed.clear();
}

std::size_t Group::bytes() const {
  return bytesOf(bodies, bodySources, slowed, contacts, contactSources, pushes, guess, idle, marks,
                 rows, arcs, rowGuess, joints, multiBodyRows, asked) +
         obsolete.capacity() * sizeof(void*) + indexOf.bytes() + joined.bytes() + loops.bytes() +
         opposed.bytes() + held.bytes() + articulation.bytes();
}

const Mat3& Group::ownInverseInertia(int body) const {
  const auto found =
      std::lower_bound(slowed.begin(), slowed.end(), body,
                       [](const SlowedBody& candidate, int k) { return candidate.body < k; });
  return found != slowed.end() && found->body == body ? found->ownInverseInertia
                                                      : bodies[body].inverseInertia;
}

const JointSource* jointOf(const Group& group, int row) {
  const auto after =
      std::upper_bound(group.joints.begin(), group.joints.end(), row,
                       [](int k, const JointSource& joint) { return k < joint.firstRow; });
  if (after == group.joints.begin()) return nullptr;
  const JointSource& joint = *std::prev(after);
  return row < joint.firstRow + joint.rowCount ? &joint : nullptr;
}

}  // namespace delassus::bullet
