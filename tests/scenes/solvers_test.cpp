#include "demos/scenes/solvers.h"

#include "bullet_ext/softness.h"
#include "demos/scenes/builders.h"
#include "demos/scenes/catalogue.h"
#include "demos/scenes/judge.h"
#include "demos/scenes/simulate.h"
#include "tests/scenes/run_scene.h"

namespace demos {
namespace {

class EveryName : public testing::TestWithParam<std::string> {};

TEST_P(EveryName, HoldsABox) {
  const RunSummary run = runFor(buildGridOfBoxes(1, 3), GetParam(), 0.5);
  EXPECT_EQ(run.solver, GetParam());
  EXPECT_EQ(run.steps, 30);
  EXPECT_EQ(run.bodies, 1);
  EXPECT_EQ(run.contactsMax, 4);
  // For redundant contacts Lemke's method gives wrong answers as if they were right.
  if (GetParam() != "lemke") {
    EXPECT_LT(run.driftMax, 1e-3);
    EXPECT_NEAR(run.reactionOverWeight, 1, 0.05);
  }
  EXPECT_EQ(run.regions.has_value(), GetParam().rfind("delassus", 0) == 0);
}

INSTANTIATE_TEST_SUITE_P(names, EveryName,
                         testing::Values("delassus", "delassus:1e-4", "si:10", "si2:10", "nncg:10",
                                         "dantzig", "dantzig:1e-6", "lemke", "pgs:50"));

TEST(NamedSolver, RefusesWhatIsNoName) {
  for (const char* name :
       {"",           "si",           "si:",       "si:0",       "si:-3",        "si:ten",
        "si:10x",     "si:1e9",       "delassus:", "delassus:0", "delassus:nan", "delassus/",
        "delassus/0", "delassus/1e3", "si/10",     "dantzig:-1", "lemke:3",      "pgs",
        "bullet",     "Delassus"}) {
    SCOPED_TRACE(name);
    EXPECT_THROW(NamedSolver{name}, UnknownSolver);
  }
  try {
    NamedSolver("sj:10");
  } catch (const UnknownSolver& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("sj:10"), std::string::npos);
    for (const char* known :
         {"delassus:TOL", "delassus/N", "si:N", "si2:N", "nncg:N", "dantzig:CFM", "lemke", "pgs:N"})
      EXPECT_NE(message.find(known), std::string::npos) << known;
  }
}

TEST(SolverInWords, KnowsEveryForm) {
  const std::pair<const char*, const char*> words[] = {
      {"delassus", "Delassus' regions"},
      {"delassus:1e-4", "Delassus' regions to 1e-4"},
      {"delassus/10", "Delassus' regions, budget of 10 sweeps an island"},
      {"si:10", "stock Bullet, sequential impulses, 10 sweeps"},
      {"si2:20", "stock Bullet, sequential impulses, two friction directions, 20 sweeps"},
      {"nncg:30", "stock Bullet, NNCG, 30 sweeps"},
      {"dantzig", "stock Bullet, MLCP by Dantzig"},
      {"dantzig:1e-6", "stock Bullet, MLCP by Dantzig, CFM 1e-6"},
      {"lemke", "stock Bullet, MLCP by Lemke"},
      {"pgs:40", "stock Bullet, projected Gauss-Seidel, 40 sweeps"}};
  for (const auto& [name, expected] : words) {
    EXPECT_EQ(NamedSolver(name).name(), name);
    EXPECT_EQ(solverInWords(name), expected);
  }
  EXPECT_EQ(std::size(words), solverForms().size());
  EXPECT_EQ(solverInWords("bullet"), "");
}

TEST(NamedSolver, AsksForWhatItsNameSays) {
  btContactSolverInfo info;
  NamedSolver("si2:37").configure(info);
  EXPECT_EQ(info.m_numIterations, 37);
  EXPECT_EQ(info.m_leastSquaresResidualThreshold, 0);
  EXPECT_NE(info.m_solverMode & SOLVER_USE_2_FRICTION_DIRECTIONS, 0);

  btContactSolverInfo untouched, other;
  NamedSolver("delassus").configure(other);
  EXPECT_EQ(other.m_numIterations, untouched.m_numIterations);
  EXPECT_EQ(other.m_solverMode, untouched.m_solverMode);

  NamedSolver("dantzig:1e-6").configure(other);
  EXPECT_EQ(other.m_globalCfm, btScalar(1e-6));
}

TEST(NamedSolver, KeepsToItsBudget) {
  NamedSolver named("delassus/30");
  const auto world = buildStack(10, 1000);
  world->movableBodies()[9]->setLinearVelocity(btVector3(1, 0, 0));
  world->setSolver(named.solver());
  world->step(1.0 / 60);
  const auto& report = named.delassus()->report();
  EXPECT_GT(report.sweeps, 0);
  EXPECT_LE(report.sweeps, 30 * report.islands);
  EXPECT_LE(report.regions, report.islands);
}

TEST(NamedSolver, CountsFallbacks) {
  // Without CFM, Dantzig's method cannot take redundant contacts.
  EXPECT_GT(runFor(buildStack(10, 1), "dantzig", 1).fallbacks, 0);
  EXPECT_EQ(runFor(buildStack(10, 1), "si:10", 0.1).fallbacks, 0);
}

TEST(SplitNames, SplitsAtCommas) {
  EXPECT_EQ(splitNames("delassus,si:10"), (std::vector<std::string>{"delassus", "si:10"}));
  EXPECT_EQ(splitNames("delassus"), (std::vector<std::string>{"delassus"}));
  EXPECT_EQ(splitNames(",,a,"), (std::vector<std::string>{"", "", "a", ""}));
  EXPECT_EQ(splitNames(""), (std::vector<std::string>{""}));
}

// A large pile whose boxes slide in many places. There the path of compliance would take thousands
// of factorisations in vain.
TEST(PileFromStock, ComesNearTheLawAndTakesNoPath) {
  NamedSolver stock("si:10");
  OnRegions run(buildPyramid(8));
  stock.configure(run.world->dynamics().getSolverInfo());
  run.world->setSolver(stock.solver());
  for (int i = 0; i < 3; ++i) run.world->step(h);
  run.world->setSolver(run.solver);
  run.world->step(h);
  const auto& report = run.solver.report();
  constexpr int otherFactors = 50;
  EXPECT_EQ(report.contacts, 256);
  EXPECT_LE(report.residualMax, 1e-6);
  EXPECT_LE(report.factorisations, report.regions + otherFactors);
}

// The judge: a stock solver comes to the same law in a long run, but not in a short one.
TEST(Judge, SeesSequentialImpulsesConverge) {
  const double few = runFor(buildStack(5, 1), "si2:2", 0.5).residualMax;
  const double many = runFor(buildStack(5, 1), "si2:2000", 0.5).residualMax;
  EXPECT_GT(few, 1e-3);
  EXPECT_LT(many, byPrecision(1e-6, 1e-4));
}

TEST(Judge, TellsTheRowsOfJointsApart) {
  // Frictionless and free: only the rows of point joints and of hinges, warm from nothing.
  const double few = runFor(buildNewtonCradle(1), "si:2", 0.5).residualMax;
  const double many = runFor(buildNewtonCradle(1), "si:3000", 0.5).residualMax;
  EXPECT_GT(few, 100 * many);
  // Two strings for each ball are a loop: the judge's law has them give by bullet::loopSoftness.
  EXPECT_LT(many, byPrecision(10 * delassus::bullet::loopSoftness, 1e-2));
}

TEST(Judge, AgreesWithOurOwnReport) {
  // Budgets leave residuals far above the rounding of what is written into Bullet in single
  // precision.
  for (const char* name : {"delassus", "delassus/1"}) {
    NamedSolver named(name);
    const auto world = buildStack(10, 1000);
    world->movableBodies()[9]->setLinearVelocity(btVector3(1, 0, 0));
    JudgedSolver judged(named.solver(), 0);
    world->setSolver(judged);
    double largest = 0;
    for (int i = 0; i < 30; ++i) {
      world->step(1.0 / 60);
      const StepResidual residual = judged.takeResidual();
      const delassus::StepReport& report = named.delassus()->report();
      ASSERT_GT(report.contacts, 0);
      EXPECT_EQ(residual.count, report.contacts + report.rows);
      const double tolerance = byPrecision(1e-8, 1e-4);
      EXPECT_NEAR(residual.max, report.residualMax, tolerance + 1e-3 * report.residualMax) << name;
      EXPECT_NEAR(residual.rms(), report.residualRms, tolerance + 1e-3 * report.residualRms)
          << name;
      largest = std::max(largest, report.residualMax);
    }
    EXPECT_EQ(largest > 1e-3, std::string(name) == "delassus/1");
    world->setSolver(named.solver());
  }
}

// Where a ball touches in several points, Bullet does not say how these share its rolling friction.
TEST(Judge, FindsTheShareOfRollingFrictionThatKeepsTheLaw) {
  NamedSolver named("delassus");
  const auto world = findScene("rolling_balls").build();
  JudgedSolver judged(named.solver(), 0);
  world->setSolver(judged);
  for (int i = 0; i < 80; ++i) {
    world->step(1.0 / 60);
    EXPECT_LE(judged.takeResidual().max, byPrecision(1e-8, 1e-4)) << i;
  }
  world->setSolver(named.solver());
}

TEST(Judge, ChangesNothing) {
  // Joints begin with their last reactions only if they are recognised.
  NamedSolver alone("delassus"), watched("delassus");
  const auto first = findScene("ragdolls").build(), second = findScene("ragdolls").build();
  JudgedSolver judged(watched.solver(), second->dynamics().getSolverInfo().m_globalCfm);
  first->setSolver(alone.solver());
  second->setSolver(judged);
  for (int i = 0; i < 40; ++i) {
    first->step(1.0 / 60);
    second->step(1.0 / 60);
  }
  const auto bodies = first->movableBodies(), others = second->movableBodies();
  ASSERT_EQ(bodies.size(), others.size());
  for (std::size_t i = 0; i < bodies.size(); ++i)
    EXPECT_TRUE(bodies[i]->getWorldTransform() == others[i]->getWorldTransform()) << i;
  second->setSolver(watched.solver());
}

TEST(Simulate, TimesEveryStep) {
  const RunSummary run = runFor(buildStack(3, 1), "si:1000", 0.2);
  EXPECT_GT(run.msFirst, 0);
  EXPECT_GT(run.msMedian, 0);
  EXPECT_GT(run.msMean, 0);
  EXPECT_GE(run.msP95, run.msMedian);
}

}  // namespace
}  // namespace demos
