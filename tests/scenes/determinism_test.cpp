// The same input gives the same bits, whatever the run, the batch size and the number of threads.
#include <thread>

#include "demos/scenes/builders.h"
#include "tests/scenes/run_scene.h"

namespace demos {
namespace {

using State = std::vector<btScalar>;

/// Several islands, with joints and contacts of all modes, small enough to be stepped often.
std::unique_ptr<World> buildMixture(int kind) {
  switch (kind) {
    case 0:
      return buildGridOfBoxes(4, 3);
    case 1:
      return buildPyramid(5);
    case 2:
      return buildRagdolls(3);
    default:
      return buildSpheresBin(3);
  }
}
constexpr int mixtures = 4;

State stateAfter(int kind, int steps, int batch = 128) {
  OnRegions run(buildMixture(kind));
  run.world->dynamics().getSolverInfo().m_minimumSolverBatchSize = batch;
  for (int i = 0; i < steps; ++i) run.world->step(1.0 / 60);
  return stateOf(*run.world);
}

TEST(Determinism, TwoRunsHaveTheSameBits) {
  for (int kind = 0; kind < mixtures; ++kind)
    EXPECT_EQ(stateAfter(kind, 45), stateAfter(kind, 45)) << "mixture " << kind;
}

TEST(Determinism, BatchSizesHaveTheSameBits) {
  for (int kind = 0; kind < mixtures; ++kind) {
    const State usual = stateAfter(kind, 45, 128);
    EXPECT_EQ(stateAfter(kind, 45, 0), usual) << "mixture " << kind;
    EXPECT_EQ(stateAfter(kind, 45, 1), usual) << "mixture " << kind;
  }
}

TEST(Determinism, FourThreadsHaveTheBitsOfOne) {
  State threaded[mixtures];
  std::vector<std::thread> threads;
  for (int kind = 0; kind < mixtures; ++kind)
    threads.emplace_back([kind, &threaded] { threaded[kind] = stateAfter(kind, 45); });
  for (std::thread& thread : threads) thread.join();
  for (int kind = 0; kind < mixtures; ++kind)
    EXPECT_EQ(threaded[kind], stateAfter(kind, 45)) << "mixture " << kind;
}

TEST(Determinism, FourThreadsOnTheSameSceneAgree) {
  State threaded[4];
  std::vector<std::thread> threads;
  for (State& state : threaded) threads.emplace_back([&state] { state = stateAfter(2, 30); });
  for (std::thread& thread : threads) thread.join();
  for (const State& state : threaded) EXPECT_EQ(state, threaded[0]);
}

}  // namespace
}  // namespace demos
