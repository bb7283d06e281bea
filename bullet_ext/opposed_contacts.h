#pragma once

#include <cstddef>
#include <vector>

#include "bullet_ext/address_table.h"
#include "delassus/bytes.h"
#include "delassus/disjoint_sets.h"
#include "delassus/types.h"

class btCollisionObject;

namespace delassus::bullet {

struct Group;

/// Contacts of the same two bodies that overlap and push against each other. Triangles (a mesh, a
/// heightfield) push from both sides, so that what is thin, as the leg of a chair or a limb, and
/// comes to be half way through them is pushed both ways by one face; and so are parts of compounds
/// that interlock. Met exactly, such demands hold the two together, or throw them apart. What
/// joints link is one body in triangles: a limb may be above them and the next one below.
class OpposedContacts {
 public:
  void clear() {
    objects_.clear();
    touches_.clear();
  }
  /// Notes the contacts of the group from `first` on, which are of one manifold, if one of its
  /// objects (`indexA`, `indexB` in the group) has several parts.
  void note(const Group& group, const btCollisionObject& a, int indexA, const btCollisionObject& b,
            int indexB, int first);
  /// Has those that push against each other, by more than 120 degrees, give by `share` of what the
  /// body answers that answers less; in triangles those that push away from the side where the
  /// centre of mass is, of all that joints link, by `shareBehind`, so that it leaves there. None of
  /// them is split: the pushes would contradict each other in the same way.
  void soften(Group& group);

  static constexpr double share = 0.1, shareBehind = 10;

  std::size_t bytes() const {
    return objects_.bytes() + mechanisms_.bytes() + bytesOf(touches_, overlapping_);
  }

 private:
  struct Touch {
    int body;       ///< that can move
    int mechanism;  ///< one of the bodies that joints link to it, the same for all of them; itself
    int object;     ///< the other one: number of the touch in which it came first
    int first, end;
    bool isInTriangles;
  };
  /// A contact of one mechanism with one object.
  struct Overlap {
    int contact, body;
    Vec3 push;  ///< which way it pushes the body
    bool isOpposed;
  };
  void add(int body, const btCollisionObject& object, bool isInTriangles, int first, int end);
  void findMechanisms(const Group& group);
  bool findOpposed();
  Vec3 centreOf(const Group& group, int mechanism);
  void soften(Group& group, const Touch& touch);

  AddressTable objects_;
  DisjointSets mechanisms_;
  std::vector<Touch> touches_;
  std::vector<Overlap> overlapping_;
};

}  // namespace delassus::bullet
