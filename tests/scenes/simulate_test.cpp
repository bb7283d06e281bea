/// What a run reports of the parts that it could not take or could not solve.

#include "demos/scenes/simulate.h"

#include <limits>
#include <stdexcept>

#include "demos/scenes/builders.h"
#include "tests/scenes/run_scene.h"

namespace demos {
namespace {

TEST(Simulate, TellsWhatWasLeftOutOnceWithTheNumberOfSteps) {
  const auto world = buildGridOfBoxes(2, 3);
  const btScalar notANumber = std::numeric_limits<btScalar>::quiet_NaN();
  world->movableBodies()[1]->setAngularVelocity(btVector3(0, notANumber, 0));
  const RunSummary run = runFor(*world, "delassus", 0.5);
  ASSERT_TRUE(run.regions.has_value());
  EXPECT_EQ(run.regions->leftOut, 30);
  ASSERT_EQ(run.regions->messages.size(), 1U);
  EXPECT_NE(run.regions->messages[0].text.find("left out: its"), std::string::npos);
  EXPECT_EQ(run.regions->solved, 3 * 30) << "the islands of the other boxes";
}

TEST(Simulate, TellsNothingOfASoundWorld) {
  const RunSummary run = runFor(*buildStack(3, 1), "delassus", 0.5);
  EXPECT_EQ(run.regions->leftOut, 0);
  EXPECT_EQ(run.regions->nonFinite, 0);
  EXPECT_TRUE(run.regions->messages.empty());
  EXPECT_EQ(run.stepsAbove, 0);
  EXPECT_EQ(run.stepsLost, 0);
  EXPECT_EQ(run.tunnelled, 0);
}

// Bullet leaves a body without a place out of all contacts: then the rest of the world looks
// perfect.
TEST(Simulate, CallsALostWorldLost) {
  for (const char* solver : {"si:10", "delassus"}) {
    const auto world = buildStack(3, 1);
    const btScalar notANumber = std::numeric_limits<btScalar>::quiet_NaN();
    world->movableBodies()[2]->setLinearVelocity(btVector3(0, notANumber, 0));
    const RunSummary run = runFor(*world, solver, 0.5);
    EXPECT_EQ(run.stepsLost, run.steps) << solver;
    EXPECT_EQ(run.stepsAbove, run.steps) << solver;
    for (const double measure : {run.residualMax, run.residualRms, run.driftMax, run.penetrationMax,
                                 run.jointErrorMax, run.kineticEnergy, run.reactionOverWeight})
      EXPECT_TRUE(std::isnan(measure)) << solver;
  }
}

TEST(Simulate, LosesAWorldFromTheStepInWhichItIsLost) {
  const auto world = buildStack(3, 1);
  world->setScript([&body = *world->movableBodies()[0]](double time) {
    const btScalar notANumber = std::numeric_limits<btScalar>::quiet_NaN();
    if (time > 0.4) body.setAngularVelocity(btVector3(0, 0, notANumber));
  });
  const RunSummary run = runFor(*world, "si:10", 0.5);
  EXPECT_GT(run.stepsLost, 0);
  EXPECT_LT(run.stepsLost, 6);
  EXPECT_TRUE(std::isnan(run.driftMax));
}

// Later users of the world must not meet the watching solver, nor the settings of another solver.
TEST(Simulate, GivesTheWorldItsOwnSolverBackWhateverEndsTheRun) {
  for (const char* solver : {"si2:37", "dantzig:1e-6", "delassus"}) {
    const auto world = buildStack(3, 1);
    btDiscreteDynamicsWorld& dynamics = world->dynamics();
    const btConstraintSolver* own = dynamics.getConstraintSolver();
    const btContactSolverInfo settings = dynamics.getSolverInfo();
    {
      NamedSolver named(solver);
      const auto stop = [](double fraction) {
        if (fraction > 0.5) throw std::runtime_error("enough");
      };
      EXPECT_THROW(simulate(*world, named, {0.1, 60}, stop), std::runtime_error);
    }
    EXPECT_EQ(dynamics.getConstraintSolver(), own);
    EXPECT_EQ(dynamics.getSolverInfo().m_numIterations, settings.m_numIterations);
    EXPECT_EQ(dynamics.getSolverInfo().m_solverMode, settings.m_solverMode);
    EXPECT_EQ(dynamics.getSolverInfo().m_globalCfm, settings.m_globalCfm);
    world->step(1.0 / 60);
  }
}

TEST(Tunnelling, CountsWhatIsBehindASurfaceOrFellOutBelow) {
  World world;
  addGround(world);
  world.add(0, world.plane(btVector3(-1, 0, 0), -20), at(0, 0, 0), {});  // x < 20
  btRigidBody& outside = addBox(world, vec3(0.5, 0.5, 0.5), 1, at(0, 0.1, 0));
  btRigidBody& sunk = addBox(world, vec3(0.5, 0.5, 0.5), 1, at(3, -0.1, 0));
  btRigidBody& behind = addBox(world, vec3(0.5, 0.5, 0.5), 1, at(20.1, 5, 0));
  Tunnelling tunnelling(world);
  EXPECT_EQ(tunnelling.bodies(), 0);
  tunnelling.look();
  EXPECT_EQ(tunnelling.bodies(), 2);
  sunk.setWorldTransform(at(3, -9, 0));
  behind.setWorldTransform(at(19.9, 5, 0));
  outside.setWorldTransform(at(0, -9, 60));
  tunnelling.look();
  EXPECT_EQ(tunnelling.bodies(), 1) << "fell through; came back; went over the edge";
  sunk.setWorldTransform(at(3, 0.1, 0));
  EXPECT_EQ(tunnelling.bodies(), 0);
}

// Boxes on a slab of 2 m: the first one lands, the second dips in and is pushed out, the third is
// nearer to the lower side.
TEST(Simulate, CountsWhatFallsThrough) {
  for (const double speed : {1.0, 100.0, 150.0}) {
    const auto world = buildGridOfBoxes(2, 3);
    btRigidBody& box = *world->movableBodies()[2];
    box.translate(btVector3(0, btScalar(0.8), 0));
    box.setLinearVelocity(vec3(0, -speed, 0));
    EXPECT_EQ(runFor(*world, "si:10", 0.2).tunnelled, speed > 120 ? 1 : 0);
  }
}

TEST(Simulate, NamesWhatIsNotSolved) {
  NamedSolver hasty("delassus/1");
  const auto world = buildStack(10, 1000);
  world->movableBodies()[9]->setLinearVelocity(btVector3(1, 0, 0));
  const RunSummary run = simulate(*world, hasty, {0.1, 60}, [](double) {});
  EXPECT_GT(run.regions->outOfBudget, 0);
  EXPECT_GT(run.stepsAbove, 0);
  EXPECT_LE(run.stepsAbove, run.steps);
  ASSERT_FALSE(run.regions->messages.empty());
  EXPECT_NE(run.regions->messages[0].text.find("budget"), std::string::npos);
}

}  // namespace
}  // namespace demos
