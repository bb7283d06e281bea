// Corners of the stability map: what the map says holds.
#include "demos/scenes/builders.h"
#include "tests/scenes/run_scene.h"

namespace demos {
namespace {

double driftIn(World& world, int steps, double timeStep) {
  const Drift drift(world);
  double largest = 0;
  for (int i = 0; i < steps; ++i) {
    world.step(timeStep);
    largest = std::max(largest, drift.largest());
  }
  return allFinite(stateOf(world)) ? largest : INFINITY;
}

TEST(Stability, AStackUnderAMillionTimesItsWeightStandsSlow) {
  OnRegions run(buildStack(10, 1e6));
  EXPECT_LT(driftIn(*run.world, 600, 1.0 / 60), byPrecision(1e-6, 1e-4));
}

TEST(Stability, ATowerOfTwoHundredStandsSlow) {
  OnRegions run(buildStack(200, 1));
  EXPECT_LT(driftIn(*run.world, 300, 1.0 / 60), byPrecision(1e-6, 1e-3));
}

// W has a condition number of 1e12, and the demands of the two planes do not contradict each other.
TEST(Stability, ABallIsHeldInAWedgeOfAMicroradian) {
  constexpr double angle = 1e-6;
  const double c = std::cos(angle), s = std::sin(angle);
  OnRegions run(buildBead({vec3(c, s, 0), vec3(-c, s, 0)}, vec3(0, -beadForce, 0)));
  EXPECT_LT(driftIn(*run.world, 120, 1.0 / 60), 1e-4);
  EXPECT_EQ(run.solver.report().solved, 1);
}

TEST(Stability, AStackStandsInStepsOfAMicrosecondSlow) {
  constexpr int steps = 1000;
  constexpr double timeStep = 1e-6, fall = 0.5 * 9.81 * steps * timeStep * steps * timeStep;
  OnRegions run(buildStack(10, 1000));
  EXPECT_LT(driftIn(*run.world, steps, timeStep), 1e-3 * fall);
}

TEST(Stability, AStackStandsInStepsOfAFifthOfASecondSlow) {
  OnRegions run(buildStack(10, 1000));
  EXPECT_LT(driftIn(*run.world, 50, 0.2), 1e-3);
}

TEST(Stability, ACubeStaysWhereItIsForAnHourSlow) {
  OnRegions run(buildGridOfBoxes(1, 3));
  EXPECT_LT(driftIn(*run.world, 3600 * 60, 1.0 / 60), 1e-6);
}

/// Bullet's narrow phase does not use masses, and powers of four have exact roots: the same bits,
/// step after step.
TEST(Stability, MassesInOtherUnitsMoveTheSameSlow) {
  std::vector<btScalar> usual;
  for (const double unit : {1.0, std::ldexp(1, 20), std::ldexp(1, -20)}) {
    OnRegions run(buildPyramid(4));
    for (btRigidBody* body : run.world->movableBodies()) {
      const btVector3 inverse = body->getInvInertiaDiagLocal();
      body->setMassProps(body->getMass() * btScalar(unit),
                         btVector3(1, 1, 1) / inverse * btScalar(unit));
      body->updateInertiaTensor();
      body->setGravity(run.world->dynamics().getGravity());
      // Not only at rest: the top row is thrown about.
      if (body->getWorldTransform().getOrigin().y() > 3)
        body->setLinearVelocity(btVector3(1, 0, btScalar(0.5)));
    }
    run.world->run(2, 60);
    const std::vector<btScalar> state = stateOf(*run.world);
    ASSERT_TRUE(allFinite(state));
    if (usual.empty()) usual = state;
    EXPECT_EQ(state, usual) << unit;
  }
}

}  // namespace
}  // namespace demos
