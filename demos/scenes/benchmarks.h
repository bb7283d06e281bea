#pragma once

#include <memory>

#include "demos/scenes/world.h"

namespace demos {

/// 3008 boxes of 2 kg and 2 m in 47 layers of 8 x 8 that fall on each other.
std::unique_ptr<World> buildBenchmarkBoxes();
/// 1076 boxes of 1 kg and 2 m: a square pyramid of 650, three triangular walls of 78, a round tower
/// of 192.
std::unique_ptr<World> buildBenchmarkTown();
/// 136 dolls of 11 limbs, 6.6 m tall, a row of 16 below and a row of one on top.
std::unique_ptr<World> buildBenchmarkRagdolls();
/// 960 barrels of 42 corners and 1 kg in 15 layers of 8 x 8.
std::unique_ptr<World> buildBenchmarkHulls();

/// `count` pieces of a cube of stone of 6 m, let fall from `height` m: the Voronoi cells of
/// Halton's points in it.
std::unique_ptr<World> buildVoronoiCells(int count, double height);

/// A btRaycastVehicle of 800 kg that drives over a mound of three layers of planks and brakes.
std::unique_ptr<World> buildVehicleOnPlanks();

}  // namespace demos
