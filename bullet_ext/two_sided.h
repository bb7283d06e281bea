#pragma once

#include <cstddef>
#include <vector>

#include "bullet_ext/address_table.h"
#include "delassus/bytes.h"

class btCollisionObject;

namespace delassus::bullet {

struct Group;

/// Triangles (a mesh, a heightfield) push from both sides. What is thin, as the leg of a chair or a
/// limb, and comes to be half way through them is pushed both ways by one face: held exactly, it
/// would be held there for ever.
class TwoSided {
 public:
  void clear() {
    objects_.clear();
    touches_.clear();
  }
  /// Notes the contacts of the group from `first` on, of one manifold, if one of its objects
  /// (`indexA`, `indexB` in the group) is of triangles and stands or goes its own way.
  void note(const Group& group, const btCollisionObject& a, int indexA, const btCollisionObject& b,
            int indexB, int first);
  /// Has what triangles push both ways leave them on the side where its centre of mass is: of its
  /// contacts with the same object that overlap, and push against each other by more than 120
  /// degrees, those that push there give by `share` of what they answer, the others by
  /// `shareBehind`. None of them is split: the pushes would contradict each other in the same way.
  void soften(Group& group);

  static constexpr double share = 0.1, shareBehind = 10;

  std::size_t bytes() const {
    return objects_.bytes() + bytesOf(touches_, overlapping_, pushesBack_);
  }

 private:
  struct Touch {
    int body;
    int object;  ///< number of the touch in which it came first
    int first, end;
  };
  void add(int body, const btCollisionObject& object, int first, int end);
  bool findOpposed(const Group& group);
  void soften(Group& group, int body);

  AddressTable objects_;
  std::vector<Touch> touches_;
  std::vector<int> overlapping_;  ///< contacts of one body with one object
  std::vector<char> pushesBack_;  ///< against another of these
};

}  // namespace delassus::bullet
