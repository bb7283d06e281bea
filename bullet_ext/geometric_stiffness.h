#pragma once

#include <vector>

#include "delassus/types.h"

struct btContactSolverInfo;

namespace delassus::bullet {

struct Group;

/// Slows light bodies in taut joints to what a step can follow. In a step a joint pulls along the
/// directions of the step's start. So a light body that a joint pulls with the force f at the arm a
/// turns to and fro too fast for steps of h once ω h > 2, and gains energy, whoever solves the
/// step. The torque a × f turns the body back with the geometric stiffness
///
///     K = (a·f) 1 − (a fᵀ + f aᵀ)/2
///
/// in the directions about which the joint lets its bodies turn against each other; a hinge does
/// about its axis. K is summed over the joints of a body: where they pull against each other, as
/// two hinges of a door do that are a little out of place, there is none about the line between
/// them. In the directions x with K x = ω² I x where ω h > 2, and in no others, the body turns in
/// this step as if it were held by implicit springs of that stiffness (Tournier, Nesme, Gilles,
/// Faure 2015; only where it is needed: Andrews, Teichmann, Kövecses 2017),
///
///     (I + h² K') ω' = (I + s h² K') ω + h T + moments of the reactions,
///
/// K' being the part of K in these directions. It reaches its full size once (ω h)² is an eighth
/// above its bound. Springs at rest, s = 0, would stop within a step or two all that turns with its
/// pulls: a load that whirls on a rod, the links of a track where they meet a wheel. So the springs
/// turn along with the body, all but a tenth: s = `along`. With less of a rest, taut chains would
/// tremble for ever, and ropes gain energy. So would those whose links spin: from 0.2 rad a step on
/// (`slowly`) ever less turns along, and from twice that on nothing.
///
/// If the length of the last step differed by more than a hundredth, ω h is bounded by 0.7 instead
/// of 2, and s = 0, since such steps can follow less. Other bodies stay as they are.
class GeometricStiffness {
 public:
  static constexpr double along = 0.9, slowly = 0.2;
  /// s, for a body that turns by so much in a step, rad.
  static double shareAlong(double turn);

  /// Changes the inertia and the free velocity of such bodies, and notes them in Group::slowed.
  /// Call it when all is gathered and recalled. The forces are those of the last step
  /// (JointSource::lastLoad). The arms are those of the joint's pivots or frames, so only Bullet's
  /// own kinds of joints count. `lastStep`: the length of the last step, s; 0 if it is not known.
  /// Returns the number of bodies changed.
  int stiffen(Group& group, const btContactSolverInfo& info, double lastStep);

  std::size_t bytes() const { return stiffness_.capacity() * sizeof(Mat3); }

 private:
  std::vector<Mat3> stiffness_;  ///< h² K of each body, kg m²
};

}  // namespace delassus::bullet
