#pragma once

#include <vector>

#include "bullet_ext/gather.h"

namespace delassus::bullet {

struct Answer;

/// Reactions of the last step, for those who cannot carry their own: rows of joints, and points that Bullet's narrow phase
/// has put in the place of others. Only guesses come from here; the answer does not depend on them.
///
/// A fresh point takes over the reaction of the nearest point of its manifold that is gone; then all points of the
/// manifold share the rest, so that together they push and turn as those of the last step did. Pointers serve to
/// recognise, in the order of the arrays; nothing is read through them.
class Memory {
 public:
  /// What was kept since the last call is what is recalled from now on.
  void nextStep();
  /// Fills the guesses that `group` lacks. Call once per group, before `keep`.
  void recall(Group& group);
  void keep(const Group& group, const Answer& answer);

  std::size_t bytes() const;

 private:
  struct Owner {
    const void* object;  ///< manifold or joint
    int begin, end;      ///< among points or rows
  };
  struct Point {
    Vec3 arm;       ///< from the centre of the body that moves, m
    Vec3 reaction;  ///< in the frame of the contact, N·s
    Vec3 impulse;   ///< the same in the world, N·s
    bool taken;     ///< by a point of this step
  };
  struct Step {
    std::vector<Owner> manifolds, joints;
    std::vector<Point> points;
    std::vector<double> rows;
    void clear();
  };

  void recallPoints(Group& group, int begin, int end);
  void claim(Group& group, int begin, int end, const Owner& owner, bool fresh);
  void keepWrench(Group& group, int begin, int end, const Owner& owner) const;

  Step last_, now_;
  std::size_t manifoldCursor_ = 0, jointCursor_ = 0;
};

}  // namespace delassus::bullet
