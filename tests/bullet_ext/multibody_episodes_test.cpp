/// Articulated bodies that are put back to where they were.

#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <gtest/gtest.h>

#include <vector>

#include "tests/support/multibody_chain.h"
#include "tests/support/same_bits.h"

namespace delassus::test {
namespace {

// Bullet's constraints keep the impulses of their last step.
TEST(MultiBodyEpisodes, AfterResetTheMotionIsTheSameAgain) {
  constexpr int links = 4, steps = 40;
  DelassusMultiBodyWorld world;
  Chain chain(world, links);
  world.finish(*chain.tree);
  for (int i = 0; i < links; ++i)
    world.addConstraint<btMultiBodyJointMotor>(chain.tree, i, btScalar(0.3) * i, btScalar(50));
  const auto episode = [&] {
    for (int i = 0; i < links; ++i) {
      chain.tree->setJointPos(i, btScalar(0.2) * i);
      chain.tree->setJointVel(i, btScalar(0.1));
    }
    MultiBodyWorld::place(*chain.tree);
    world.solver().reset();
    world.advance(steps);
    std::vector<btScalar> motion;
    for (int i = 0; i < links; ++i) {
      motion.push_back(chain.tree->getJointPos(i));
      motion.push_back(chain.tree->getJointVel(i));
    }
    return motion;
  };
  const std::vector<btScalar> first = episode();
  expectSameBits(episode(), first);
}

}  // namespace
}  // namespace delassus::test
