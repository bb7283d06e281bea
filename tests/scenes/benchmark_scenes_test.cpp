// Bullet's benchmark scenes have as many bodies as there, and are set up soundly; and the vehicle.
#include "demos/scenes/benchmarks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "demos/scenes/builders.h"
#include "tests/scenes/run_scene.h"

namespace demos {
namespace {

/// The largest depth of bodies in each other at the start, m.
double firstOverlap(World& world) {
  world.dynamics().performDiscreteCollisionDetection();
  return deepestPenetration(world.dynamics());
}

TEST(BenchmarkScenes, HaveTheCountsOfBullets) {
  const std::pair<const char*, std::size_t> scenes[] = {{"benchmark_boxes", 3008},
                                                        {"benchmark_town", 1076},
                                                        {"benchmark_ragdolls", 136 * 11},
                                                        {"benchmark_hulls", 960},
                                                        {"voronoi_cells", 90}};
  for (const auto& [name, bodies] : scenes) {
    const auto world = findScene(name).build();
    EXPECT_EQ(world->movableBodies().size(), bodies) << name;
    EXPECT_LT(firstOverlap(*world), byPrecision(1e-9, 1e-4)) << name;
  }
}

TEST(BenchmarkScenes, DollsHangTogether) {
  const auto world = buildBenchmarkRagdolls();
  EXPECT_EQ(world->dynamics().getNumConstraints(), 136 * 10);
  EXPECT_LT(largestJointError(world->dynamics()), byPrecision(1e-9, 1e-4));
}

/// The cells are cut out of a cube of 6 m. Together they fill it, except for the gaps that Bullet's
/// margin fills.
TEST(VoronoiCells, FillTheirBlock) {
  constexpr double half = 3, height = 1, density = 100, allowed = 0.08;
  for (const int count : {1, 2, 90}) {
    const auto world = buildVoronoiCells(count, height);
    double volume = 0;
    for (const btRigidBody* cell : world->movableBodies()) {
      volume += 1 / double(cell->getInvMass()) / density;
      btVector3 low, high;
      cell->getAabb(low, high);
      for (const int axis : {0, 2}) {
        EXPECT_GT(low[axis], -half - allowed);
        EXPECT_LT(high[axis], half + allowed);
      }
      EXPECT_GT(low.y(), height - allowed);
    }
    const double whole = std::pow(2 * half, 3);
    EXPECT_LT(volume, whole) << count;
    // The gaps are twice the margin of 4 cm, between pieces of some 6/∛count m.
    EXPECT_GT(volume, whole * std::pow(1 - allowed * std::cbrt(count) / (2 * half), 3) * 0.95)
        << count;
  }
}

// The cells fall together and do not push each other: free flight to the ground.
TEST(VoronoiCells, FallAsOne) {
  OnRegions run(buildVoronoiCells(12, 1));
  const int steps = 20;  // at 0.45 s it would land
  const Drift drift(*run.world);
  for (int i = 0; i < steps; ++i) run.world->step(1 / hz);
  const double fallen = 9.81 / (hz * hz) * steps * (steps + 1) / 2;
  EXPECT_NEAR(drift.largest(), fallen, byPrecision(1e-6, 1e-3));
}

TEST(VoronoiCells, LandOnTheGroundAndStayOnIt) {
  OnRegions run(buildVoronoiCells(8, 0.2));
  for (int i = 0; i < 90; ++i) {
    run.world->step(1 / hz);
    ASSERT_TRUE(allFinite(stateOf(*run.world))) << i;
  }
  for (const btRigidBody* cell : run.world->movableBodies()) {
    btVector3 low, high;
    cell->getAabb(low, high);
    EXPECT_GT(low.y(), -0.2);
  }
  EXPECT_NEAR(reactionOverWeight(*run.world, 1 / hz), 1, 0.05);
}

/// Where the vehicle is after `seconds`, and how far the planks have moved.
struct Drive {
  btVector3 chassis;
  double planks = 0;
};
Drive drive(World& world, double seconds) {
  const std::vector<btRigidBody*> bodies = world.movableBodies();
  std::vector<btVector3> starts;
  for (const btRigidBody* body : bodies) starts.push_back(body->getWorldTransform().getOrigin());
  world.run(seconds, hz);
  Drive end{bodies.front()->getWorldTransform().getOrigin()};
  for (std::size_t i = 1; i < bodies.size(); ++i)
    end.planks = std::max(
        end.planks, double((bodies[i]->getWorldTransform().getOrigin() - starts[i]).length()));
  return end;
}

TEST(VehicleOnPlanks, CrossesAsInStock) {
  OnRegions run("vehicle_on_planks");
  const Drive ours = drive(*run.world, 10);
  EXPECT_LT(ours.chassis.x(), -10) << "it has crossed";
  // In single precision the sums in Bullet's vehicle steer it off by centimetres.
  EXPECT_NEAR(ours.chassis.z(), 0, byPrecision(1e-3, 0.2));
  EXPECT_LT(ours.planks, byPrecision(1e-6, 1e-4));

  const auto world = buildVehicleOnPlanks();
  world->dynamics().getSolverInfo().m_numIterations = 100;
  const Drive stock = drive(*world, 10);
  EXPECT_LT((ours.chassis - stock.chassis).length(), byPrecision(1e-3, 0.3));
}

}  // namespace
}  // namespace demos
