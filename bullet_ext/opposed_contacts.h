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
/// meet both. Triangles (a mesh, a heightfield) push from both sides. So a thin body, such as the
/// leg of a chair or a limb, that is half way through them is pushed both ways by one face; and so
/// are parts of compounds that interlock, and two plates that overlap by as much as they are thick:
/// of these, one manifold may hold points with either normal. Met exactly, such demands hold the
/// two bodies together, or throw them apart. In triangles, bodies that a joint links count as one:
/// a limb may be above the triangles and the next one below.
///
/// Two contacts are opposed if their pushes differ by more than 120 degrees, and if both lie on one
/// sheet: along either push their places differ by no more than their depths. A body between two
/// faces, as in a wedge or a vice, has no opposed contacts. But contacts of compounds that are not
/// on one sheet are opposed, too, if their pushes differ by more than 169 degrees.
class OpposedContacts {
 public:
  void clear() {
    objects_.clear();
    touches_.clear();
  }
  /// Notes the contacts of the group from `first` on if one of their objects (`indexA`, `indexB` in
  /// the group) has several parts, or if they push both ways. These contacts are all of one
  /// manifold.
  void note(const Group& group, const btCollisionObject& a, int indexA, const btCollisionObject& b,
            int indexB, int first);
  /// Makes opposed contacts give by at least `share` of the response of the body that responds
  /// less. In triangles, contacts give by `shareBehind` if they push away from the side of the
  /// centre of mass of the two opposed bodies, so that the bodies leave on that side. Pushes, too,
  /// feel that contacts give, but no joints: where a joint holds the body they would tear it off,
  /// and its contacts are not split. Returns the number of opposed contacts.
  int soften(Group& group);

  static constexpr double share = 0.1, shareBehind = 10;

  std::size_t bytes() const { return objects_.bytes() + bytesOf(touches_, spans_, overlaps_); }

 private:
  struct Touch {
    int body;    ///< the body that can move
    int object;  ///< the other object: the number of the touch in which it first appeared
    int first, end;
    bool isInTriangles;
  };
  /// A contact that overlaps.
  struct Overlap {
    int contact;
    Vec3 push;     ///< direction in which it pushes the body
    Vec3 place;    ///< on the other object
    double depth;  ///< m
    /// Sums over the bodies that are opposed here, this body counted every time: masses, kg, and
    /// their moments about the centre of this body, kg m.
    double mass = 0;
    Vec3 moment = Vec3::Zero();
    bool isOpposed = false;
  };
  /// The overlaps of one body with one object.
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
