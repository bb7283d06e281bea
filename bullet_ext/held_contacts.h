#pragma once

#include <cstddef>
#include <vector>

#include "LinearMath/btScalar.h"
#include "bullet_ext/body_paths.h"
#include "bullet_ext/impulse_span.h"
#include "bullet_ext/welded_bodies.h"
#include "delassus/contact.h"
#include "delassus/disjoint_sets.h"
#include "delassus/row.h"

struct btContactSolverInfo;

namespace delassus::bullet {

struct Group;

/// Contacts along which joints leave their bodies no motion: a door that grazes the floor, a
/// machine that is bolted to the ground it overlaps, a wheel and the fender of its own car.
/// Whatever such a contact asks for beyond rest, it asks of joints that are as rigid as it is: met
/// exactly, an overlap of a millimetre would press with 1e11 N, and friction would lock the door.
///
/// A contact is held if an impulse along it moves its jointed bodies by no more than `share` of
/// what it would move them without joints. Such a contact leans from the blocked direction by less
/// than half a degree (in float by little more than one), or acts on as small a part of the arm. By
/// what else its joints block it is answered as follows:
///
///   - Some motion is left (a door): the contact asks for no more than rest, and gives by
///     `softness` of the response of the body that responds less. The joints carry all.
///   - No motion at all is left (a welded post): the contact asks for no more than the joints do,
///     and shares the load with them. Between links of one mechanism it gives by loopSoftness, as
///     joints that close a loop: rigid ones would squeeze each other by what rounding asks for, and
///     friction, which acts on two surfaces that overlap, would spin the mechanism.
///   - Only motors block it that are as strong as welds, but may have to bear more than they can:
///     the contact asks for no more than the joints do, gives by loopSoftness, and bears the rest.
///   - Only a limit blocks it that the bodies reach in this step: they can go the other way. The
///     contact gives by joinedSoftness and is not split, as contacts of bodies that a joint links.
///
/// A contact grazes if what motion joints leave its point on either body leans from the contact's
/// plane by less than four degrees. Its bodies may overlap by `play` of the arm before it acts: the
/// corners of a door that fits its frame exactly pass the frame, as rigid ones would not.
///
/// A contact is not held where something drives the bodies together: anything kinematic, or the
/// joints themselves. As joints mend their errors, they may do so by `still` of the arm a step. The
/// deeper the bodies overlap, beyond `play`, the less may drives do so: so a servo does not press
/// its arm through a table, however slowly it moves, and a weld breaks in a press. Between links of
/// one mechanism errors do not count, as of links that a blow has pulled apart: they end where the
/// links fit together, and a contact that resisted would keep them apart for ever. Links that would
/// overlap by more than `fit` of the arm then are no such links, but drawn together by a hand.
///
/// Bodies that welds hold together (WeldedBodies) count as one, and as the world if they are welded
/// to it. Where no weld of such a body may break, contacts between its parts may be left out, and
/// so may those of two parts of one weld: the motion is the same without them, and the welds carry
/// their loads. All others stay, and the welds and they give by sharedSoftness.
///
/// What stands on one moved thing, or on several that move as one, goes along: that drives neither
/// its contacts with the thing nor those between its links. The thing counts as one of these, and
/// is ahead of the rest by a step.
///
/// The joints that count are those of the mechanisms of the two bodies, if both mechanisms are
/// fixed to the world or are the same one. A mechanism of more than `mostRows` rows counts only for
/// contacts between its own links, and then only those rows that are on a way between the two, if
/// these are no more and leave fewer than six motions. Springs hold nothing, nor do motors, unless
/// they may push without bounds. In a mechanism that is not fixed to the world, and so bears little
/// beside its own weight, a motor also holds that could turn its bodies within the step by a
/// radian, or move them by their radius of gyration.
class HeldContacts {
 public:
  /// Call it when contacts and joints are gathered. Returns the number of contacts held, those that
  /// graze or are left out included.
  int soften(Group& group, const btContactSolverInfo& info, bool leavesOutWelded);

  /// In float normals lean by more.
  static constexpr double share = sizeof(btScalar) == sizeof(double) ? 5e-5 : 5e-4;
  static constexpr double shareOfGrazing = 5e-3, play = 2.5e-3;
  static constexpr double softness = 1, still = 2e-4, fit = 0.1;
  static constexpr int mostRows = 256;

  std::size_t bytes() const;

 private:
  static constexpr int none = -1, noMover = -2, manyMovers = -3;
  using Impulse = ImpulseSpan::Impulse;
  using Wanted = ImpulseSpan::Wanted;
  enum class Held { No, Grazing, ByLimit, ByMotor, Along, Wholly };
  /// By what an impulse is taken up: joints, also motors, also limits.
  enum class By { Joints, Motors, Limits };
  /// A row that holds.
  struct Hold {
    int row, a, b;  ///< the row and the parts that it links; −1: none
    bool up, down;  ///< whether its reaction may be as large as need be, and as negative
    bool isDriven;  ///< what it asks for may be a drive's, and no error that it mends
    bool isMotor = false;
    int mechanism = -1;
    bool isLimit() const { return up != down; }
    bool isWeak() const { return isLimit() || isMotor; }
  };
  /// Parts that such rows link.
  struct Mechanism {
    int rows = 0;
    /// What has no part and holds these too: WeldedBodies::moverOf.
    int mover = noMover;
    double moved = 0;  ///< the largest speed that such things ask of its rows, m/s or rad/s
    bool stands() const { return mover != noMover; }
    int begin = 0, end = 0;  ///< among holds_, weak ones last
    int span = -1;           ///< among spans_: of rows that are not weak; −1: not computed
  };
  Impulse onParts(int bodyA, int bodyB, const Vec6& onA, const Vec6& onB) const;
  Impulse impulseOf(const Row& row, bool isDriven) const;
  Impulse impulseOf(const Contact& contact, int axis = 0) const;
  Impulse turnOf(const Contact& contact, int axis) const;
  void collectWelds(const Group& group);
  void softenWelds(Group& group) const;
  void collect(const Group& group);
  void collectStrongMotors(const Group& group);
  /// The mechanism of a part; −1 if nothing holds it.
  int mechanismOf(int part) { return numberOf_[links_.root(part)]; }
  bool hasTooMany(int mechanism) const { return mechanisms_[mechanism].rows > mostRows; }
  int wayBetween(int a, int b);
  void findWays();
  bool mayBeHeld(const Group& group, const Contact& contact);
  void standOn(const Group& group, int body, const Row6& jacobian, Mechanism& mechanism) const;
  double shared(double response, int body) const;
  int moverOf(int body);
  double movedApart(const Contact& contact);
  bool haveOneMover(const Group& group, const Contact& contact);
  bool areOfOne(const Group& group, const Contact& contact);
  void sortHolds();
  ImpulseSpan& spanOf(const Group& group, Mechanism& mechanism);
  double extend(const Group& group, const Hold& hold, const Impulse& impulse, ImpulseSpan& span);
  double takenUp(const Group& group, const Impulse& push, Mechanism& mechanism, By by, double step,
                 Wanted& apart);
  double leftOf(const Group& group, const Impulse& push, By by, double step, Wanted& apart);
  bool grazes(const Group& group, const Contact& contact);
  bool areDriven(const Group& group, const Contact& contact, const Wanted& wanted, double overlap,
                 const btContactSolverInfo& info);
  Held judge(const Group& group, const Contact& contact, double asked, double overlap,
             const btContactSolverInfo& info, double& apart);
  bool isWhollyHeld(const Group& group, const Contact& contact);
  bool answer(Group& group, int i, const btContactSolverInfo& info, bool leavesOutWelded);

  WeldedBodies welded_;
  DisjointSets machines_;  ///< bodies that anything but the world links
  DisjointSets links_;     ///< parts that rows link
  std::vector<Hold> holds_;
  std::vector<Mechanism> mechanisms_;
  std::vector<int> numberOf_;    ///< of the mechanism of each root; −1: none
  std::vector<int> candidates_;  ///< contacts
  std::vector<int> spare_;       ///< those that are left out
  std::vector<char> shares_;     ///< of the roots of welded bodies: welds and contacts share loads
  std::vector<ImpulseSpan> spans_;  ///< storage is used again
  int spansUsed_ = 0;
  std::vector<double> ofPush_, ofRow_;  ///< coordinates

  BodyPaths paths_;
  bool hasWays_ = false;
  /// The holds along the link from each body to the next one in paths_, one body after the other.
  std::vector<int> onLink_, firstOnLink_;
  /// The last way that was asked for: from body to body, as a mechanism of its own; none if too
  /// many rows are on it.
  int from_ = -1, to_ = -1, way_ = -1;
  int narrowed_ = -1;  ///< what takes the place of the mechanism of both bodies; −1: nothing
};

}  // namespace delassus::bullet
