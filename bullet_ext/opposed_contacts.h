#pragma once

#include <cstddef>
#include <vector>

#include "bullet_ext/address_table.h"
#include "delassus/bytes.h"
#include "delassus/types.h"

class btCollisionObject;

namespace delassus::bullet {

struct Group;

/// Contacts of the same two bodies that overlap and push against each other, where no motion could
/// meet both. Triangles (a mesh, a heightfield) push from both sides, so that what is thin, as the
/// leg of a chair or a limb, and comes to be half way through them is pushed both ways by one face;
/// and so are parts of compounds that interlock. Met exactly, such demands hold the two together,
/// or throw them apart. In triangles bodies that a joint links count as one: a limb may be above
/// them and the next one below.
///
/// Two contacts are opposed if they push by more than 120 degrees against each other, and at the
/// same place along either push but for their depths: on one sheet. What lies between two faces, as
/// in a wedge or a vice, is none; but compounds are, where they push by more than 169 degrees.
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
  /// Has opposed contacts give by no less than `share` of what the body answers that answers less;
  /// in triangles those that push away from the side where the centre of mass is, of the two bodies
  /// that are opposed, by `shareBehind`, so that they leave there. None of them is split: the
  /// pushes would contradict each other in the same way. Answers with how many there are.
  int soften(Group& group);

  static constexpr double share = 0.1, shareBehind = 10;

  std::size_t bytes() const { return objects_.bytes() + bytesOf(touches_, spans_, overlaps_); }

 private:
  struct Touch {
    int body;    ///< that can move
    int object;  ///< the other one: number of the touch in which it came first
    int first, end;
    bool isInTriangles;
  };
  /// A contact that overlaps.
  struct Overlap {
    int contact;
    Vec3 push;     ///< which way it pushes the body
    Vec3 place;    ///< on the other object
    double depth;  ///< m
    /// Of the bodies that are opposed here, this one counted every time: their masses, kg, and the
    /// moment of these about the centre of this one, kg m.
    double mass = 0;
    Vec3 moment = Vec3::Zero();
    bool isOpposed = false;
  };
  /// Those of one body with one object.
  struct Span {
    int body, object, first, end;
    bool isInTriangles;
  };
  void add(int body, const btCollisionObject& object, bool isInTriangles, int first, int end);
  void collect(const Group& group);
  void compare(const Group& group, const Span& a, const Span& b);
  void compareLinked(const Group& group);

  AddressTable objects_;
  std::vector<Touch> touches_;
  std::vector<Span> spans_;
  std::vector<Overlap> overlaps_;
};

}  // namespace delassus::bullet
