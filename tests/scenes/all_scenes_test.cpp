// Laws that hold on every scene, and on real Bullet worlds.
#include <algorithm>
#include <functional>

#include "demos/scenes/bullet_file.h"
#include "tests/scenes/run_scene.h"
#include "tests/support/shared_data.h"

namespace demos {
namespace {

/// The residual, of the law and of what single precision can say of positions, that 99 % of the
/// steps must keep.
constexpr double residualTolerance = 1e-6;  // m/s

using Build = std::function<std::unique_ptr<World>()>;

/// The number of bodies that end in or under immovable ones.
int throughInStock(const Build& build, int steps, double hz) {
  const auto world = build();
  Tunnelling tunnelling(*world);
  for (int i = 0; i < steps; ++i) {
    world->step(1 / hz);
    tunnelling.look();
  }
  return tunnelling.bodies();
}

/// Steps a world and checks that our solver alone solved the law, that the numbers stay finite, and
/// that no more bodies go through others than in stock (Bullet's narrow phase keeps one point of a
/// thin rod that lies on a plane). `ofSeconds`: the length of a run of which these are the first
/// steps. `unsolvable`: the share of steps in which a scene asks for what no motion gives.
void expectLawKept(const Build& build, double seconds, double hz = 60, double ofSeconds = 0,
                   double unsolvable = 0) {
  // The share of the steps of the whole run that may end above the tolerance. In float positions
  // are rounded until contacts contradict each other.
  constexpr double share = sizeof(btScalar) == sizeof(double) ? 0.01 : 0.02;
  const int steps = int(std::lround(seconds * hz));
  OnRegions run(build());
  int above = 0, obsolete = 0;
  long solved = 0;  // contacts and rows
  double worst = 0;
  Tunnelling tunnelling(*run.world);
  for (int i = 0; i < steps; ++i) {
    run.world->step(1 / hz);
    if (run.solver.report().residualMax > residualTolerance) {
      ++above;
      EXPECT_GT(run.solver.report().outOfBudget + run.solver.report().incompatible, 0)
          << "step " << i << " is silent";
    }
    worst = std::max(worst, run.solver.report().residualMax);
    solved += run.solver.report().contacts + run.solver.report().rows;
    obsolete += run.solver.report().obsoleteConstraints;
    ASSERT_TRUE(allFinite(stateOf(*run.world))) << "step " << i;
    tunnelling.look();
  }
  if (const int through = tunnelling.bodies(); through > 0) {
    SCOPED_TRACE("bodies ended in or under what cannot move");
    EXPECT_LE(through, throughInStock(build, steps, hz));
  }
  EXPECT_LE(above, (share + unsolvable) * std::max(seconds, ofSeconds) * hz)
      << "steps above the tolerance, of " << steps << "; the worst has " << worst << " m/s";
  EXPECT_EQ(obsolete, 0);
  EXPECT_GT(solved, 0) << "nothing touched: no law was tried";
}

class EveryScene : public testing::TestWithParam<std::string> {};

bool isLarge(const std::string& scene) {
  return scene == "pyramid_50" || scene == "pyramid_20" || scene == "spheres_bin" ||
         scene == "voronoi_cells" || scene.rfind("benchmark_", 0) == 0;
}

TEST_P(EveryScene, KeepsTheLawInItsFirstSteps) {
  const SceneDescription& scene = findScene(GetParam());
  // As the taut bridge begins to sag, one step asks for what no slow motion gives.
  const double ofSeconds = scene.name == "plank_bridge" ? scene.seconds : 0;
  expectLawKept(scene.build, isLarge(scene.name) ? 0.05 : 0.5, scene.hz, ofSeconds);
}

class WholeScene : public testing::TestWithParam<std::string> {};

TEST_P(WholeScene, KeepsTheLawToItsEndSlow) {
  const SceneDescription& scene = findScene(GetParam());
  expectLawKept(scene.build, scene.seconds, scene.hz, 0, scene.name == "compactor" ? 0.6 : 0);
}

std::vector<std::string> sceneNames() {
  std::vector<std::string> names;
  for (const SceneDescription& scene : catalogue()) names.push_back(scene.name);
  return names;
}

/// The slow tests take the scenes whose first steps alone take seconds, or in whose first steps
/// nothing touches yet.
std::vector<std::string> quickSceneNames() {
  std::vector<std::string> names = sceneNames();
  for (const char* slow : {"pyramid_100", "benchmark_boxes", "benchmark_hulls"})
    names.erase(std::find(names.begin(), names.end(), slow));
  return names;
}

std::string byName(const testing::TestParamInfo<std::string>& info) { return info.param; }

INSTANTIATE_TEST_SUITE_P(catalogue, EveryScene, testing::ValuesIn(quickSceneNames()), byName);
INSTANTIATE_TEST_SUITE_P(catalogue, WholeScene, testing::ValuesIn(sceneNames()), byName);

// Scenes that nothing drives and in which nothing bounces.
class PassiveScene : public testing::TestWithParam<std::string> {};

// The erp lifts bodies out of a penetration, and so they gain height. That is the only source of
// energy, and a small one.
TEST_P(PassiveScene, GainsNoEnergy) {
  OnRegions run(GetParam());
  double weight = 0;
  for (const btRigidBody* body : run.world->movableBodies())
    weight += double(body->getGravity().length()) / double(body->getInvMass());
  double lowest = totalEnergy(*run.world);
  double gained = 0;
  // Until just before the ladder and the ball land.
  for (int i = 0; i < 45; ++i) {
    run.world->step(1 / findScene(GetParam()).hz);
    const double energy = totalEnergy(*run.world);
    gained = std::max(gained, energy - lowest);
    lowest = std::min(lowest, energy);
  }
  constexpr double height = 1e-3;  // m
  EXPECT_LT(gained, height * weight);
}

INSTANTIATE_TEST_SUITE_P(catalogue, PassiveScene,
                         testing::Values("bead_under_plane", "bead_in_angle", "bead_in_angle_wide",
                                         "bead_in_trihedron", "ball_off_ball", "sliding_ladder",
                                         "incline", "box_headings", "rolling_balls", "one_box",
                                         "islands_100", "stack_10", "stack_40", "pyramid_20",
                                         "wall_20x10", "heavy_ball_chain", "stack_10_heavy_top",
                                         "pyramid_10", "arch", "arch_thin", "card_house",
                                         "domino_run"),
                         byName);

class EveryWorld : public testing::TestWithParam<std::string> {
 protected:
  static constexpr double seconds = 5;
  std::string path() const {
    return (delassus::test::sharedFolder() / "worlds" / (GetParam() + ".bullet")).string();
  }
  void SetUp() override {
    if (delassus::test::sharedFolder().empty()) GTEST_SKIP() << delassus::test::noSharedFolder;
  }
};

// The boxes of `slope` touch nothing for two seconds. The steps that may end above the tolerance
// are a share of all five seconds.
TEST_P(EveryWorld, KeepsTheLawInItsFirstSteps) {
  expectLawKept([this] { return loadBulletFile(path()).world; }, GetParam() == "slope" ? 2.25 : 0.5,
                60, seconds);
}

TEST_P(EveryWorld, KeepsTheLawForFiveSecondsSlow) {
  expectLawKept([this] { return loadBulletFile(path()).world; }, seconds);
}

INSTANTIATE_TEST_SUITE_P(worlds, EveryWorld, testing::Values("slope", "spider", "testFileFracture"),
                         byName);

}  // namespace
}  // namespace demos
