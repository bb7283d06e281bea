/// What a step of articulated bodies reports: storage and Bullet's analytics.

#include <gtest/gtest.h>

#include <tuple>

#include "tests/support/multibody_world.h"

namespace delassus::test {
namespace {

/// Chains side by side, fixed at one end, whose last links lie on the ground.
void addChains(MultiBodyWorld& world, int count, int links = 3) {
  world.addGround();
  const btScalar I = btScalar(0.02), radius = btScalar(0.1);
  for (int chain = 0; chain < count; ++chain) {
    const btVector3 at(0, radius, btScalar(2 * chain)), zero(0, 0, 0);
    btMultiBody& tree = world.addTree(links, 0, zero, true, at);
    for (int link = 0; link < links; ++link)
      tree.setupRevolute(link, 1, btVector3(I, I, I), link - 1, btQuaternion::getIdentity(),
                         btVector3(0, 0, 1), link == 0 ? zero : btVector3(btScalar(0.2), 0, 0),
                         btVector3(btScalar(0.2), 0, 0), true);
    world.addCollider(tree, links - 1, std::make_unique<btSphereShape>(radius));
    world.finish(tree);
  }
}

TEST(MultiBodyReport, StorageCountsTheTrees) {
  constexpr int links = 40, freedoms = 6 + links;
  std::size_t shortChain = 0, longChain = 0, twoChains = 0;
  for (auto [bytes, chains, length] :
       {std::tuple(&shortChain, 1, 3), std::tuple(&longChain, 1, links),
        std::tuple(&twoChains, 2, links)}) {
    DelassusMultiBodyWorld world;
    world->setGravity({0, 0, 0});
    addChains(world, chains, length);
    world.advance(10);
    *bytes = world.report().workspaceBytes;
    world.advance(30);
    EXPECT_EQ(world.report().workspaceBytes, *bytes) << "once warm";
  }
  // The solver keeps M⁻¹ and what finds its root.
  constexpr std::size_t ofTree = 3 * freedoms * freedoms * sizeof(double);
  EXPECT_GE(longChain, shortChain + ofTree);
  EXPECT_GE(twoChains, longChain + ofTree);
}

TEST(MultiBodyReport, ResetAndUnkeptStorageLetGoOfAll) {
  for (const bool kept : {true, false}) {
    Options options = optionsOfPrecision();
    options.economies.storage = kept;
    MultiBodyWorld world(std::make_unique<btDelassusMultiBodyConstraintSolver>(options));
    world.advance();
    const std::size_t empty = world.report().workspaceBytes;
    world->setGravity({0, 0, 0});
    addChains(world, 8);
    const StepReport& report = world.report();
    world.advance(5);
    EXPECT_EQ(report.contacts, 8);
    const std::size_t full = report.workspaceBytes;
    EXPECT_GT(full, empty);

    // Nothing is passed to the solver any more; a step of it shows how much it holds.
    if (kept) world.solver().reset();
    EXPECT_EQ(report.contacts, kept ? 0 : 8) << "the report that was asked for is the solver's";
    btContactSolverInfo info;
    world.solver().prepareSolve(0, 0);
    world.solver().solveGroup(nullptr, 0, nullptr, 0, nullptr, 0, info, nullptr,
                              &world.dispatcher());
    EXPECT_LT(report.workspaceBytes, empty + (full - empty) / 4);
  }
}

TEST(MultiBodyReport, AnalyticsTellOfTheLastGroup) {
  DelassusMultiBodyWorld world;
  world.info().m_reportSolverAnalytics = 1;
  world.info().m_minimumSolverBatchSize = 1;
  addChains(world, 2);
  world.advance();
  const btSolverAnalyticsData& last = world.solver().m_analyticsData;
  const int calls = last.m_numSolverCalls;
  world.advance();
  EXPECT_GE(last.m_numSolverCalls, calls + 2);

  btAlignedObjectArray<btSolverAnalyticsData> islands;
  world->getAnalyticsData(islands);
  ASSERT_EQ(islands.size(), 2);
  int iterations = 0;
  double squares = 0;
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(islands[i].m_numBodies, 3) << "the links of a chain";
    EXPECT_EQ(islands[i].m_numContactManifolds, 3) << "with the ground, empty ones too";
    iterations += islands[i].m_numIterationsUsed;
    squares = std::max(squares, islands[i].m_remainingLeastSquaresResidual);
  }
  const StepReport& report = world.report();
  EXPECT_EQ(iterations, report.regions + report.sweeps);
  EXPECT_EQ(squares, report.residualMax * report.residualMax);

  // A step without length solves nothing.
  btContactSolverInfo info;
  info.m_timeStep = 0;
  world.solver().solveGroup(nullptr, 0, nullptr, 0, nullptr, 0, info, nullptr, &world.dispatcher());
  EXPECT_EQ(last.m_numIterationsUsed, 0);
  EXPECT_EQ(last.m_remainingLeastSquaresResidual, -1);
}

TEST(MultiBodyReport, ResetForgetsTheAnalytics) {
  DelassusMultiBodyWorld world;
  addChains(world, 2);
  world.advance(2);
  const btSolverAnalyticsData& last = world.solver().m_analyticsData;
  ASSERT_GT(last.m_numSolverCalls, 0);
  world.solver().reset();
  const btSolverAnalyticsData none;
  EXPECT_EQ(last.m_numSolverCalls, none.m_numSolverCalls);
  EXPECT_EQ(last.m_numIterationsUsed, none.m_numIterationsUsed);
  EXPECT_EQ(last.m_remainingLeastSquaresResidual, none.m_remainingLeastSquaresResidual);
  EXPECT_EQ(last.m_islandId, none.m_islandId);
}

}  // namespace
}  // namespace delassus::test
