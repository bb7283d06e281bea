// The readings of force plates under the feet of a table, compared with statics.
#include "demos/scenes/force_plate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "demos/scenes/simulate.h"
#include "tests/scenes/run_scene.h"

namespace demos {
namespace {

TEST(ForcePlate, ReadsForceAndMomentsOfStatics) {
  OnRegions run("force_plate");
  for (int step = 0; step < 300; ++step) {
    run.world->step(h);
    ASSERT_LT(footForceError(*run.world, h), byPrecision(1e-6, 1e-3)) << step;
    // Four rigid feet: in single precision the rounding of their heights decides which of them
    // carry.
    if (!doublePrecision) continue;
    for (const double force : measuredFootForces(*run.world, h)) ASSERT_GT(force, 0) << step;
  }
  // The load has moved from one side to the other.
  EXPECT_NEAR(run.body(1).getWorldTransform().getOrigin().x(), 0.5, byPrecision(1e-9, 1e-3));
}

// Statics leaves the share between four feet open. Where no reactions are remembered it is that of
// least norm, so none of it is self-stress.
TEST(ForcePlate, SharesByLeastNormAtFirst) {
  OnRegions run("force_plate");
  run.world->step(h);
  ASSERT_LT(footForceError(*run.world, h), byPrecision(1e-6, 1e-3));
  const FootForces feet = measuredFootForces(*run.world, h);
  const double selfStress = feet[0] - feet[1] - feet[2] + feet[3];
  EXPECT_NEAR(selfStress, 0, byPrecision(1e-6, 1e-3) * staticsOf(feet).force);
}

TEST(ForcePlate, StockReadsPerCentsOff) {
  for (const std::string name : {"si:10", "si2:10"}) {
    NamedSolver stock(name);  // outlives the world
    const SceneDescription& scene = findScene("force_plate");
    const auto world = scene.build();
    const RunSummary summary =
        simulate(*world, stock, {scene.seconds, scene.hz, scene.law}, [](double) {});
    EXPECT_GT(summary.lawError.value(), 0.01) << name;
  }
}

}  // namespace
}  // namespace demos
