// Scenes whose bodies are held by joints, and one with a press.
#include <algorithm>
#include <cmath>

#include "demos/scenes/builders.h"
#include "tests/scenes/run_scene.h"

namespace demos {
namespace {

TEST(Gripper, LiftsTheBoxWithoutSlip) {
  OnRegions run("gripper");
  btRigidBody& box = run.body(0);
  btRigidBody& palm = run.body(1);
  run.world->run(1, hz);  // closed, and moving up
  const double below =
      palm.getWorldTransform().getOrigin().y() - box.getWorldTransform().getOrigin().y();
  run.world->run(3, hz);
  EXPECT_NEAR(box.getWorldTransform().getOrigin().y(), 0.5 + 1, 0.02);
  EXPECT_NEAR(palm.getWorldTransform().getOrigin().y() - box.getWorldTransform().getOrigin().y(),
              below, 1e-3);
}

// The shut bin has room for all boxes only if they climb onto each other.
TEST(Compactor, JamsAndThrowsNoBox) {
  // Of the open bin, m. At one step rate in three a jam presses the middle of a box into a side by
  // up to 0.17 m; no box is pressed through it.
  constexpr double half = 0.25, halfLength = 2 + half, halfWidth = 1.5 + half;
  constexpr double slowEnough = 20;  // m/s; the wall closes at 0.5
  OnRegions run(buildCompactor(24));
  int jams = 0;
  while (run.world->time() < 7) {
    run.world->step(1 / hz);
    jams += run.solver.report().softened > 0;
    for (const btRigidBody* box : run.world->movableBodies()) {
      ASSERT_LT(box->getLinearVelocity().length(), slowEnough) << run.world->time();
      const btVector3& place = box->getWorldTransform().getOrigin();
      ASSERT_TRUE(std::abs(place.x()) < halfLength && std::abs(place.z()) < halfWidth &&
                  place.y() > 0)
          << run.world->time();
    }
  }
  EXPECT_GT(jams, 0);
}

TEST(HeavyBallChain, KeepsItsLength) {
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

TEST(PlankBridge, CarriesItsCrateAtRest) {
  const SceneDescription& scene = findScene("plank_bridge");
  OnRegions run(scene.build());
  const btRigidBody& crate = *run.world->movableBodies().back();
  const double start = totalEnergy(*run.world), height = crate.getWorldTransform().getOrigin().y();
  while (run.world->time() < 4) {
    run.world->step(1 / scene.hz);
    ASSERT_LT(totalEnergy(*run.world), start) << run.world->time();
    ASSERT_LT(largestJointError(run.world->dynamics()), 2e-3) << run.world->time();
  }
  EXPECT_LT(crate.getLinearVelocity().length(), 1e-4);
  EXPECT_NEAR(crate.getWorldTransform().getOrigin().y(), height - 0.24, 0.02);
  EXPECT_LT(run.solver.report().residualMax, 1e-6);
}

/// Energy above that of the start, step by step, with `solver` (null: ours).
std::vector<double> energyOfCradle(double rate, std::unique_ptr<btConstraintSolver> solver) {
  OnRegions run("newton_cradle");
  if (solver != nullptr) run.world->setSolver(*solver);
  run.world->dynamics().getSolverInfo().m_numIterations = 2000;
  const double start = totalEnergy(*run.world);
  std::vector<double> energy;
  while (run.world->time() < 1.2) {
    run.world->step(1 / rate);
    energy.push_back(totalEnergy(*run.world) - start);
    EXPECT_LT(largestJointError(run.world->dynamics()), 1.5 / rate);
  }
  return energy;
}

constexpr double cradleSwing = 9.81 * 3 * (1 - 0.70710678);  // of one ball from 45 degrees, J

TEST(NewtonCradle, GainsNoEnergyButTheIntegrators) {
  const std::vector<double> energy = energyOfCradle(60, nullptr);
  EXPECT_LT(*std::max_element(energy.begin(), energy.end()), 0.02 * cradleSwing);
}

// At other rates, the first blow finds the balls a few millimetres inside each other, and the erp
// of Bullet's contact law pushes them apart. That energy comes from the law; stock run to
// convergence gains the same energy.
TEST(NewtonCradle, HasTheEnergyOfStockRunToConvergence) {
  for (const double rate : {60., 120., 240.}) {
    const std::vector<double> ours = energyOfCradle(rate, nullptr);
    const std::vector<double> stock =
        energyOfCradle(rate, std::make_unique<btSequentialImpulseConstraintSolver>());
    for (std::size_t i = 0; i < ours.size(); ++i)
      ASSERT_NEAR(ours[i], stock[i], byPrecision(1e-3, 2e-2) * cradleSwing)
          << "step " << i << " at " << rate << " Hz";
  }
}

TEST(Ragdolls, KeepTheirJointsWhileTheyFall) {
  OnRegions run(buildRagdolls(2));
  for (int i = 0; i < int(1.5 * hz); ++i) {
    run.world->step(1 / hz);
    EXPECT_LT(largestJointError(run.world->dynamics()), 0.05);
  }
}

TEST(DominoRun, FallsToTheLastSlow) {
  OnRegions run("domino_run");
  run.world->run(10, hz);
  for (const btRigidBody* domino : run.world->movableBodies()) {
    const double upright = domino->getWorldTransform().getBasis()[1][1];
    EXPECT_LT(upright, 0.9);
  }
}

}  // namespace
}  // namespace demos
