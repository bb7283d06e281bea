#pragma once

#include <cmath>
#include <vector>

#include "bullet_ext/address_table.h"
#include "bullet_ext/group.h"
#include "bullet_ext/joint_load.h"

namespace delassus::bullet {

struct Answer;

/// Reactions of the last step, for parts that cannot carry their own: rows of joints and of turning
/// friction; points that Bullet's narrow phase has put in the place of others; and in single
/// precision all points, since these round their reactions by more than the tolerance, and no
/// island would be kept. The reactions serve as guesses only, on which the answer does not depend.
/// What joints did is kept, too, for GeometricStiffness.
///
/// A fresh point takes over the reaction of the nearest point of its manifold that is gone. Then
/// all points of the manifold share the rest, so that together they push and turn as those of the
/// last step did (a lone point: only push). So do the rows of a joint where a limit or motor has
/// come or gone, or Bullet has turned their axes (joint_load.h).
///
/// Pointers serve to recognise objects, in the order of the arrays; nothing is read through them.
/// An object that a user makes anew may lie where a deleted one lay. So an object is recognised
/// only if the bodies, the numbers that their world gave them, and the impulse that a joint carries
/// are the same, too.
class Memory {
 public:
  /// Begins a step: everything kept since the last call is recalled from now on. Nothing is kept
  /// before the first call, nor after a group has come again without a new call: a caller that does
  /// not announce steps (a solver pool) would let the memory grow without end.
  void nextStep();
  /// Fills the guesses, and the digits of guesses, that `group` lacks. Call once per group, before
  /// `keep`.
  void recall(Group& group);
  /// Scales all guesses of `group`, whatever their source, to a step of h, s: forces go on from
  /// step to step, and impulses are these forces times h.
  void fitTimeStep(Group& group, double h) const;
  /// The length of the last step, s; 0: not known.
  double lastStep() const { return last_.length; }
  /// h: the length of this step, s.
  void keep(const Group& group, const Answer& answer, double h);

  std::size_t bytes() const;

 private:
  struct Owner {
    const void *object, *bodyA, *bodyB;  ///< object: manifold or joint
    int numberOfA, numberOfB;            ///< of the bodies, in the broadphase; 0 if in none
    /// What the step wrote into the manifold. A new one that lies at its address has none, and
    /// those of another world have others.
    int stamp = 0;
    /// What the step left as the joint's applied impulse: N·s, or N·m·s of a row about an axis.
    double impulse = 0;
    int begin = 0, end = 0;  ///< among points or rows
    bool isSame(const Owner& other) const {
      return object == other.object && bodyA == other.bodyA && bodyB == other.bodyB &&
             numberOfA == other.numberOfA && numberOfB == other.numberOfB && stamp == other.stamp &&
             impulse == other.impulse && std::signbit(impulse) == std::signbit(other.impulse);
    }
  };
  struct Point {
    Vec3 arm;       ///< from the centre of the body that moves, m
    Vec3 reaction;  ///< in the frame of the contact, N·s
    Vec3 impulse;   ///< the same in the world, N·s
    bool taken;     ///< a point of this step has claimed it
  };
  /// The owners of one kind.
  class Owners {
   public:
    void clear();
    /// Adds the owner, and makes room in the index, so that no later step is the first to allocate
    /// it.
    Owner& add(const Owner& owner) {
      indexOf_.makeRoom(list_.size() + 1);
      return list_.emplace_back(owner);
    }
    Owner& last() { return list_.back(); }
    /// The owner that is the same as `wanted`, or null.
    const Owner* find(const Owner& wanted);
    std::size_t indexOf(const Owner& found) const { return &found - list_.data(); }
    std::size_t capacity() const { return list_.capacity(); }
    void reserve(std::size_t owners) {
      list_.reserve(owners);
      indexOf_.makeRoom(owners);
    }
    std::size_t bytes() const { return list_.capacity() * sizeof(Owner) + indexOf_.bytes(); }

   private:
    std::vector<Owner> list_;
    AddressTable indexOf_;  ///< of the first `indexed_`, by object; at rest next_ suffices
    std::size_t indexed_ = 0;
    /// The place after the owner found last: most owners come in the same order again.
    std::size_t next_ = 0;
  };
  /// The reactions of a contact that resists turning.
  struct Turn {
    Vec3 arm;       ///< as above
    Vec3 reaction;  ///< spinning, then rolling about its two axes, N·s along arcs (arcs.h)
  };
  struct MarkedBody {
    const btCollisionObject* body;
    IslandMarks marks;
  };
  struct Step {
    double length = 0;  ///< s; 0: not known
    Owners manifolds, turners, joints;
    std::vector<Point> points;
    std::vector<Turn> turns;
    std::vector<double> rows;
    std::vector<JointLoad> loads;  ///< of each joint
    /// One body of each island that has marks, with a contact if the island has any.
    std::vector<MarkedBody> marked;
    void clear();
  };

  static int nextStamp();
  static Owner ownerOf(const PointSource& point);
  static Owner ownerOf(const JointSource& joint, double impulse);

  // `recall`, part by part; begin, end: the contacts of one manifold.
  void recallMarks(Group& group);
  void recallPoints(Group& group, int begin, int end);
  void recallDigits(Group& group, int begin, int end, const Owner& owner) const;
  void claim(Group& group, int begin, int end, const Owner& owner, bool fresh);
  void matchWrench(Group& group, int begin, int end, const Owner& owner) const;
  void matchForce(Group& group, int contact, const Owner& owner) const;
  void recallJoints(Group& group);
  void recallTurns(Group& group);
  const Turn* nearestTurn(const Owner& owner, const Vec3& arm) const;

  // `keep`, part by part.
  void keepPoints(const Group& group, const Answer& answer);
  void keepMarks(const Group& group, const Answer& answer);
  void keepJoints(const Group& group, const Answer& answer);
  void keepTurns(const Group& group, const Answer& answer);

  bool announced_ = false;
  Step last_, now_;
  AddressTable marked_;  ///< the bodies of last_.marked, while a group is recalled
  AddressTable groups_;  ///< kept in this step, each by its first manifold or joint
};

}  // namespace delassus::bullet
