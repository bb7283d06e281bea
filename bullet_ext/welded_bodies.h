#pragma once

#include <cstddef>
#include <vector>

#include "bullet_ext/impulse_span.h"
#include "delassus/body.h"

namespace delassus::bullet {

struct Group;
struct JointSource;

/// Bodies that welds hold together, each such part taken for one rigid body. A weld is a joint with
/// six rows that hold both ways. What it asks for, to mend its errors, moves its bodies within
/// their part.
class WeldedBodies {
 public:
  static constexpr int none = -1;

  /// Starts with the bodies of a group, none of them welded. Call `weld` for each weld, and then
  /// `close`.
  void reset(const Group& group);
  /// `joint` has six rows. Does nothing if these are between several pairs of bodies or do not hold
  /// all six motions, or if a body lacks mass along some axis.
  void weld(const Group& group, const JointSource& joint);
  void close(const Group& group);

  bool empty() const { return welds_.empty() && bolts_.empty(); }
  /// One body of each part stands for it; the others are not used.
  const std::vector<Body>& parts() const { return parts_; }
  /// Which body that is; none for the world, what is welded to it, and limbs.
  int partOf(int body) const { return body >= 0 ? partOf_[body] : none; }
  /// Whether welds hold two bodies together, and not only by the world.
  bool areWelded(int a, int b) const { return rootOf(a) != none && rootOf(a) == rootOf(b); }
  /// One of the bodies that welds hold together with this one, the same for all of them; none if no
  /// weld holds it.
  int rootOf(int body) const { return body >= 0 ? rootOf_[body] : none; }
  /// Whether one weld links the two.
  bool areOfOneWeld(int a, int b) const;
  /// Whether welds hold them together whatever load these must carry.
  bool areWeldedForGood(int a, int b) const {
    return areWelded(a, b) && leastThresholdOf(a) == infinity;
  }
  /// The impulse that breaks the weakest of the welds that hold a welded body, N·s.
  double leastThresholdOf(int body) const { return leastThreshold_[rootOf_[body]]; }
  /// Whether welds hold the body to the world, or to something that is moved.
  bool isBolted(int body) const {
    return body >= 0 && rootOf_[body] != none && partOf_[body] == none;
  }
  /// An impulse on a body that has a part, about the body's centre, as one about the part's.
  Vec6 onPart(int body, const Vec6& impulse) const;
  /// The velocity of the body beside that of its part, along `impulse`: what welds ask for. Without
  /// a part, all of its velocity.
  ImpulseSpan::Wanted asked(int body, const Vec6& impulse) const {
    if (body < 0) return {};
    return {impulse.dot(ofErrors_[body]), 0, impulse.dot(ofMovers_[body])};
  }
  /// For a body without a part, what nothing can stop and holds it: itself, or what it is welded
  /// to; none for the fixed world.
  int moverOf(int body) const { return body >= 0 ? moverOf_[body] : none; }
  /// Whether two such things are one, or move as one rigid body, as far as velocities tell that are
  /// differences over a step.
  bool moveAsOne(const Group& group, int a, int b) const;
  /// Whether both are, or are welded to, such things other than the world.
  bool areMoved(int a, int b) const { return moverOf(a) >= 0 && moverOf(b) >= 0; }
  /// The velocity that this gives to a point of the body, m/s.
  Vec3 movedAt(int body, const Vec3& arm) const {
    if (body < 0) return Vec3::Zero();
    return ofMovers_[body].head<3>() + ofMovers_[body].tail<3>().cross(arm);
  }
  std::size_t bytes() const;

 private:
  /// What one body is to do beside going along with another, as a velocity.
  struct Weld {
    int from, to;
    double threshold;
    Vec6 target;
  };
  /// What a body does that is welded to something without a part.
  struct Bolt {
    int body, mover;
    double threshold;
    Vec6 ofErrors, ofMovers;
  };
  void spread(const Group& group, int root);
  void unite(const Group& group, int root);

  std::vector<Body> parts_;
  std::vector<int> partOf_, rootOf_, moverOf_;
  std::vector<double> leastThreshold_;  ///< of the roots: which impulse breaks the weakest weld
  std::vector<Vec3> fromCentre_;        ///< of the part to that of the body, m
  std::vector<Vec6> ofErrors_, ofMovers_;

  std::vector<Weld> welds_;  ///< each from both of its bodies
  std::vector<Bolt> bolts_;
  std::vector<int> weldsFrom_, firstFrom_;  ///< by body
  std::vector<int> found_;                  ///< the bodies of one part
};

}  // namespace delassus::bullet
