#pragma once

#include <cstddef>
#include <vector>

#include "LinearMath/btScalar.h"
#include "delassus/bytes.h"
#include "delassus/disjoint_sets.h"
#include "delassus/types.h"

namespace delassus {
struct Body;
struct Contact;
}  // namespace delassus

namespace delassus::bullet {

struct Group;

/// Impulses along rows or contacts, each on one or two bodies, and what they span. What two of them
/// do together is measured as
///
///     (p, p') = pᵀ M⁻¹ p',   (p, p) of rows with their compliance
class ImpulseSpan {
 public:
  /// On bodies that can move; −1: on none.
  struct Impulse {
    int a = -1, b = -1;
    Vec6 onA = Vec6::Zero(), onB = Vec6::Zero();
    double wanted = 0;  ///< of a row: the velocity that it asks of these bodies, m/s
  };
  static double product(const std::vector<Body>& bodies, const Impulse& p, const Impulse& q);

  int size() const { return static_cast<int>(impulses_.size()); }
  void truncate(int size);
  /// Coordinates of p in the orthonormal basis that the impulses make, in the order in which they
  /// were added: y = L⁻¹ (p_i, p) with L Lᵀ = (p_i, p_j).
  void coordinates(const std::vector<Body>& bodies, const Impulse& p,
                   std::vector<double>& of) const;
  /// Adds p, whose coordinates and (p, p) less their squares these are.
  void add(const Impulse& p, const std::vector<double>& coordinates, double left);
  /// The velocity that the rows ask for along what has these coordinates, as far as it lies in
  /// their span, m/s: y·L⁻¹ w, w what each of them asks for.
  double wantedAlong(const std::vector<double>& of) const {
    double sum = 0;
    for (std::size_t k = 0; k < of.size(); ++k) sum += of[k] * impulses_[k].wanted;
    return sum;
  }
  std::size_t bytes() const { return bytesOf(impulses_, begins_, factor_); }

 private:
  std::vector<Impulse> impulses_;
  std::vector<int> begins_;     ///< which coordinate of each is the first that is not zero
  std::vector<double> factor_;  ///< L by rows: the coordinates of each
};

/// Contacts along which joints leave their bodies no motion: a door that grazes the floor, a
/// machine that is bolted to the ground it overlaps, a wheel and the fender of its own car. What
/// such a contact asks for beyond rest is asked of joints as rigid as it is: taken at its word, an
/// overlap of a millimetre would press with 1e11 N, and friction lock the door.
///
/// A contact is held if an impulse along it moves its bodies, as their joints leave them, by no
/// more than `share` of what it would move them without: what leans by less than half a degree, in
/// float by little more than one, or acts on as small a part of the arm. It asks for no more than
/// rest, and gives by `softness` of what the body answers that answers less: the joints carry all.
/// Where only a limit holds, which lets the bodies go the other way, it gives by joinedSoftness and
/// is not split, as contacts of bodies that a joint links.
///
/// Not where the joints themselves, or what they hang on, drive the bodies together, by more than
/// `still` of the arm a step, or what is kinematic does: a servo does not press its arm through a
/// table, and a weld breaks in a press.
///
/// Joints are those of the mechanisms of the two bodies, if these stand, or are one; none of more
/// than `mostRows` rows. Springs hold nothing, nor do motors, unless they may push without bounds.
class HeldContacts {
 public:
  /// Call it when contacts and joints are gathered. h: the step, s.
  void soften(Group& group, double h);

  /// In float normals lean by more.
  static constexpr double share = sizeof(btScalar) == sizeof(double) ? 5e-5 : 5e-4;
  static constexpr double softness = 1, still = 2e-4;
  static constexpr int mostRows = 64;

  std::size_t bytes() const;

 private:
  using Impulse = ImpulseSpan::Impulse;
  enum class Held { No, ByLimit, Always };
  /// A row that holds.
  struct Hold {
    int row, a, b;  ///< and its bodies that can move; −1: none
    bool up, down;  ///< whether its reaction may be as large as need be, and as negative
    int mechanism = -1;
    bool isLimit() const { return up != down; }
  };
  /// Bodies that such rows link.
  struct Mechanism {
    int rows = 0;
    bool stands = false;     ///< held to what stands, too
    int begin = 0, end = 0;  ///< among holds_, limits last
    int span = -1;           ///< among spans_: of what holds both ways; −1: not worked out
  };
  void collect(const Group& group);
  int mechanismOf(int body);
  bool mayBeHeld(const Group& group, const Contact& contact);
  void sortHolds();
  ImpulseSpan& spanOf(const Group& group, Mechanism& mechanism);
  double extend(const Group& group, const Hold& hold, const Impulse& impulse, ImpulseSpan& span);
  double takenUp(const Group& group, const Impulse& push, Mechanism& mechanism, bool withLimits,
                 double& apart);
  Held judge(const Group& group, const Contact& contact, double h);

  DisjointSets links_;
  std::vector<Hold> holds_;
  std::vector<Mechanism> mechanisms_;
  std::vector<int> numberOf_;       ///< of the mechanism of each root; −1: none
  std::vector<int> candidates_;     ///< contacts
  std::vector<ImpulseSpan> spans_;  ///< storage is used again
  int spansUsed_ = 0;
  std::vector<double> ofPush_, ofRow_;  ///< coordinates
};

}  // namespace delassus::bullet
