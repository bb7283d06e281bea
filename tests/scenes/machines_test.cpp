// Scenes with joints: what they hold, they hold.
#include "demos/scenes/builders.h"
#include "tests/scenes/run_scene.h"

namespace demos {
namespace {

constexpr double hz = 60;

TEST(Gripper, liftsTheBoxWithoutSlip) {
  OnRegions run("gripper");
  btRigidBody& box = run.body(0);
  btRigidBody& palm = run.body(1);
  run.world->run(1, hz);  // closed, and on the way up
  const double below =
      palm.getWorldTransform().getOrigin().y() - box.getWorldTransform().getOrigin().y();
  run.world->run(3, hz);
  EXPECT_NEAR(box.getWorldTransform().getOrigin().y(), 0.5 + 1, 0.02);
  EXPECT_NEAR(palm.getWorldTransform().getOrigin().y() - box.getWorldTransform().getOrigin().y(),
              below, 1e-3);
}

TEST(HeavyBallChain, keepsItsLength) {
  const SceneDescription& scene = findScene("heavy_ball_chain");
  OnRegions run(scene.build());
  constexpr double length = 20 * 0.5;
  double error = 0;
  while (run.world->time() < 1.6) {  // to just before the ball meets the wall
    run.world->step(1 / scene.hz);
    error = std::max(error, largestJointError(run.world->dynamics()));
  }
  EXPECT_LT(error, 1e-3 * length);
}

/// Largest energy above that of the start while the cradle swings to and fro, J.
double energyGainedByCradle(double rate) {
  OnRegions run("newton_cradle");
  const double start = totalEnergy(*run.world);
  double gained = 0;
  while (run.world->time() < 2) {
    run.world->step(1 / rate);
    gained = std::max(gained, totalEnergy(*run.world) - start);
    EXPECT_LT(largestJointError(run.world->dynamics()), 1.5 / rate);
  }
  return gained;
}

// Restitution 1 and rigid strings keep the energy; the steps along the tangents of the circle add a share of h to it.
TEST(NewtonCradle, gainsEnergyInProportionToTheStepOnly) {
  const double coarse = energyGainedByCradle(60), fine = energyGainedByCradle(240);
  constexpr double swing = 9.81 * 3 * (1 - 0.70710678);  // of one ball from 45 degrees, J
  EXPECT_LT(coarse, 0.1 * swing);
  EXPECT_LT(fine, 0.4 * coarse);
}

TEST(Ragdolls, keepTheirJointsWhileTheyFall) {
  OnRegions run(buildRagdolls(2));
  for (int i = 0; i < int(1.5 * hz); ++i) {
    run.world->step(1 / hz);
    EXPECT_LT(largestJointError(run.world->dynamics()), 0.05);
  }
}

TEST(DominoRun, fallsToTheLastSlow) {
  OnRegions run("domino_run");
  run.world->run(10, hz);
  for (const btRigidBody* domino : run.world->movableBodies()) {
    const double upright = domino->getWorldTransform().getBasis()[1][1];
    EXPECT_LT(upright, 0.9);
  }
}

}  // namespace
}  // namespace demos
