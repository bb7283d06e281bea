// What should stand stands, on the ground that carries it.
#include "demos/scenes/builders.h"
#include "tests/scenes/run_scene.h"

namespace demos {
namespace {

constexpr double hz = 60;

/// Half a millimetre in double precision, two in single.
const double stackTolerance = byPrecision(0.5e-3, 2e-3);

void expectStanding(std::unique_ptr<World> built, double seconds, double tolerance) {
  OnRegions run(std::move(built));
  const Drift drift(*run.world);
  double reaction = 0;
  const int steps = int(seconds * hz);
  for (int i = 0; i < steps; ++i) {
    run.world->step(1 / hz);
    if (i >= steps / 4) reaction += reactionOverWeight(*run.world, 1 / hz) / (steps - steps / 4);
  }
  EXPECT_LT(drift.largest(), tolerance);
  EXPECT_NEAR(reaction, 1, byPrecision(1e-6, 1e-3));
  testing::Test::RecordProperty("drift_um", int(1e6 * drift.largest()));
}

TEST(Stack, ofOneToTenBoxesStandsForASecond) {
  for (const int count : {1, 2, 3, 5, 10}) {
    SCOPED_TRACE(std::to_string(count) + " boxes");
    expectStanding(buildStack(count, 1), 1, stackTolerance);
    expectStanding(buildStack(count, 1000), 1, stackTolerance);
  }
}

TEST(Pyramid, ofTenStandsForASecond) { expectStanding(buildPyramid(10), 1, stackTolerance); }
TEST(Wall, ofFiveRowsStandsForASecond) { expectStanding(buildWall(5, 5), 1, stackTolerance); }

TEST(Stack, ofTenWithAHeavyTopStandsForTenSecondsSlow) {
  expectStanding(buildStack(10, 1000), 10, stackTolerance);
}
TEST(Stack, ofFortyStandsForTenSecondsSlow) {
  expectStanding(buildStack(40, 1), 10, stackTolerance);
}

/// Joints of an arch may open by what the erp of its contacts leaves: it stands if it comes to rest near where it was.
void expectResting(const std::string& scene, double seconds, double tolerance) {
  OnRegions run(scene);
  const Drift drift(*run.world);
  run.world->run(seconds, hz);
  EXPECT_LT(drift.largest(), tolerance);
  EXPECT_LT(kineticEnergy(*run.world), byPrecision(1e-3, 1e-2));
}

TEST(Arch, standsForASecond) { expectResting("arch", 1, 0.02); }
TEST(Arch, thinStandsForASecond) { expectResting("arch_thin", 1, 0.02); }
TEST(CardHouse, standsForASecond) { expectResting("card_house", 1, 0.01); }

TEST(Arch, standsForTenSecondsSlow) { expectResting("arch", 10, 0.02); }
TEST(Arch, thinStandsForTenSecondsSlow) { expectResting("arch_thin", 10, 0.02); }
TEST(CardHouse, standsForTenSecondsSlow) { expectResting("card_house", 10, 0.01); }

}  // namespace
}  // namespace demos
