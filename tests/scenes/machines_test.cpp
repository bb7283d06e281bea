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
  OnRegions run(buildHeavyBallChain(20, 100));
  constexpr double length = 20 * 0.5;
  double error = 0;
  for (int i = 0; i < int(1.5 * hz); ++i) {
    run.world->step(1 / hz);
    error = std::max(error, largestJointError(run.world->dynamics()));
  }
  EXPECT_LT(error, 1e-3 * length);
}

TEST(NewtonCradle, gainsNoEnergyAndKeepsItsStrings) {
  OnRegions run("newton_cradle");
  const double start = totalEnergy(*run.world);
  const double swing = start - (-9.81 * 5 * (3 - 4));  // above that of all balls hanging, J
  for (int i = 0; i < int(3 * hz); ++i) {
    run.world->step(1 / hz);
    EXPECT_LT(totalEnergy(*run.world), start + 0.01 * swing);
    EXPECT_LT(largestJointError(run.world->dynamics()), 0.02);
  }
}

TEST(Ragdolls, keepTheirJointsWhileTheyFall) {
  OnRegions run(buildRagdolls(2));
  for (int i = 0; i < int(1.5 * hz); ++i) {
    run.world->step(1 / hz);
    EXPECT_LT(largestJointError(run.world->dynamics()), 0.03);
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
