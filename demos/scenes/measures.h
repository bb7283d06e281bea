#pragma once

#include <btBulletDynamicsCommon.h>

#include <vector>

#include "demos/scenes/world.h"

namespace demos {

/// How far a joint is pulled apart along the directions that it locks, m. Zero for joints that are
/// disabled or hold no points together.
double jointError(const btTypedConstraint& joint);
double largestJointError(const btDiscreteDynamicsWorld& world);

/// Deepest overlap of two bodies, m, as found by the narrow phase of the last step.
double deepestPenetration(const btDiscreteDynamicsWorld& world);

/// ½ m v² + ½ ω·I ω, all bodies, J.
double kineticEnergy(const World& world);
/// −m g·x of all bodies, J; forces of gravity are those of each body.
double potentialEnergy(const World& world);
/// The sum of both, J.
double totalEnergy(const World& world);

/// Whether poses and velocities of all movable bodies are finite. If not, the world is lost: no
/// contacts are found any more, and measures of the rest mean nothing.
bool isFinite(const World& world);

/// The share of the weight that the immovable bodies carried in the last step: Σ reactions along −G
/// over |G|, G the weight of all movable bodies. 1 at rest. Zero in a world without weight.
double reactionOverWeight(const World& world, double timeStep);

/// Contacts of the last step by the reaction that the solver wrote: none; inside their cone; on its
/// border.
struct ModeCounts {
  int open = 0, stick = 0, slide = 0;
};
ModeCounts writtenModes(const btDiscreteDynamicsWorld& world);

/// Where bodies were when this was made, and the largest distance of any of them from there, m.
class Drift {
 public:
  explicit Drift(const World& world);
  double largest() const;

 private:
  std::vector<btRigidBody*> bodies_;
  std::vector<btVector3> start_;
};

/// Movable bodies whose centre of mass has entered an immovable box or gone behind an immovable
/// plane and is still there, or has left the box on its lower side. (A thin and fast body may dip
/// in for some steps and be pushed out again.)
class Tunnelling {
 public:
  explicit Tunnelling(const World& world);
  /// Looks where the bodies are; call it after every step. A body that falls through a slab is seen
  /// inside it, unless one step takes it right across.
  void look();
  int bodies() const;

 private:
  const World& world_;
  std::vector<btRigidBody*> movable_;
  std::vector<const btCollisionObject*> entered_;  ///< the one that each body entered last; or null
};

/// The reaction on body 0 that a solver wrote into a point, N·s. A stock solver with one friction
/// direction leaves the second impulse as it was: zero, in a world that it alone has stepped.
btVector3 writtenReaction(const btManifoldPoint& point);

}  // namespace demos
