#pragma once

#include <memory>

#include "demos/scenes/world.h"

namespace demos {

/// A ball thrown at the middle of the wall of `buildWall`.
struct Throw {
  double radius = 0.8;        ///< m
  double mass = 50;           ///< kg
  double distance = 4;        ///< from the ball's centre to the middle plane of the wall, m
  double height = 2.6;        ///< where its centre would cross that plane without the wall, m
  double timeOfFlight = 0.4;  ///< until then, s
};

/// The velocity with which the ball starts from (0, height, distance), m/s: v_y = g t/2 brings it
/// back to its height, v_z = -distance/t.
btVector3 throwVelocity(const Throw& thrown);

/// `columns` x `rows` bricks of 2 kg and the ball; the ball is the last body.
std::unique_ptr<World> buildWallAndBall(int columns, int rows, const Throw& thrown);

}  // namespace demos
