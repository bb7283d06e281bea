/// Worlds that begin anew with the same solver: nothing of the past comes back.

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "tests/support/bullet_world.h"
#include "tests/support/same_bits.h"

namespace delassus::test {
namespace {

std::vector<btScalar> impulsesOf(BulletWorld& world) {
  std::vector<btScalar> impulses;
  for (const btManifoldPoint* point : world.points())
    impulses.push_back(point->getAppliedImpulse());
  return impulses;
}

/// The impulses of a slab on four points after its first step. Steps of a world with the same
/// solver, whose slab bore a load at one corner, come before if there are any.
std::vector<btScalar> firstImpulses(int stepsBefore) {
  btDelassusConstraintSolver solver;
  std::vector<btScalar> impulses;
  for (const bool isLoaded : {true, false}) {
    if (isLoaded && stepsBefore == 0) continue;
    auto world = std::make_unique<DelassusWorld>();
    (*world)->setConstraintSolver(&solver);
    world->addGround();
    world->addBox({1, 0.5, 1}, {0, 0.5, 0});
    if (isLoaded) world->addBox({0.25, 0.25, 0.25}, {0.75, 1.25, 0.75}, 3);
    world->advance(isLoaded ? stepsBefore : 1);
    impulses = impulsesOf(*world);
    (*world)->setConstraintSolver(&world->delassus());
  }
  return impulses;
}

// Its bodies and contacts may lie where those of the world before lay.
TEST(Episodes, ANewWorldStartsAsWithANewSolver) {
  expectSameBits(firstImpulses(10), firstImpulses(0));
}

// Bullet gives a manifold that is gone to the next pair of bodies, with a companion id of 0 and
// points that have done nothing yet.
TEST(Episodes, ANewManifoldIsNotTakenForTheOneThatLayThere) {
  DelassusWorld world;
  world.addGround();
  world.addCube({0, 0.5, 0});
  world.advance(10);
  EXPECT_EQ(world.report().keptIslands, 1);
  world.advance();
  EXPECT_EQ(world.report().keptIslands, 1);
  for (int i = 0; i < world.dispatcher().getNumManifolds(); ++i)
    world.dispatcher().getManifoldByIndexInternal(i)->m_companionIdA = 0;
  for (btManifoldPoint* point : world.points()) {
    point->m_appliedImpulse = point->m_appliedImpulseLateral1 = point->m_appliedImpulseLateral2 = 0;
    point->m_lifeTime = 0;
  }
  world.advance();
  EXPECT_EQ(world.report().keptIslands, 0);
}

}  // namespace
}  // namespace delassus::test
