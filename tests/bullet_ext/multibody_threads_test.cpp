/// Islands with articulated bodies that are solved side by side.

#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "tests/support/multibody_world.h"

namespace delassus::test {
namespace {

struct Swing {
  std::vector<btScalar> motion;
  int mostContacts = 0;
};

/// Arms that swing, each of which meets a box.
Swing swing(int threads) {
  constexpr int arms = 8, links = 3;
  MultiBodyWorld world(std::make_unique<btDelassusMultiBodyConstraintSolver>());
  dynamic_cast<btDelassusMultiBodyConstraintSolver&>(world.solver()).setThreads(threads);
  world.addGround();
  const btScalar length = btScalar(0.4), I = btScalar(0.02);
  for (int arm = 0; arm < arms; ++arm) {
    const btVector3 at(btScalar(4 * arm), btScalar(0.6), 0);
    btMultiBody& tree = world.addTree(links, 0, btVector3(0, 0, 0), true, at);
    for (int link = 0; link < links; ++link)
      tree.setupRevolute(link, 1, btVector3(I, I, I), link - 1, btQuaternion::getIdentity(),
                         link == 1 ? btVector3(0, 0, 1) : btVector3(0, 1, 0),
                         btVector3(link == 0 ? 0 : length / 2, 0, 0), btVector3(length / 2, 0, 0),
                         true);
    world.addCollider(tree, links - 1, std::make_unique<btSphereShape>(btScalar(0.15)));
    world.finish(tree);
    for (int link = 0; link < links; ++link)
      world.addConstraint<btMultiBodyJointMotor>(&tree, link, btScalar(link == 0 ? 1 + arm : 0),
                                                 btScalar(20));
    world.addCube(at + btVector3(1, btScalar(-0.1), btScalar(-0.9)), btScalar(0.5));
  }

  Swing seen;
  for (int step = 0; step < 60; ++step) {
    world.advance();
    seen.mostContacts = std::max(seen.mostContacts, world.report().contacts);
    for (int i = 0; i < world->getNumCollisionObjects(); ++i) {
      const btTransform& pose = world->getCollisionObjectArray()[i]->getWorldTransform();
      for (int j = 0; j < 3; ++j) {
        seen.motion.push_back(pose.getOrigin()[j]);
        for (int k = 0; k < 3; ++k) seen.motion.push_back(pose.getBasis()[j][k]);
      }
    }
  }
  return seen;
}

TEST(MultiBodyThreads, TheMotionIsTheSame) {
  const Swing serial = swing(1);
  EXPECT_GT(serial.mostContacts, 4 * 8) << "the arms touch their boxes";
  for (int threads : {2, 4}) {
    const Swing parallel = swing(threads);
    ASSERT_EQ(parallel.motion.size(), serial.motion.size());
    EXPECT_EQ(std::memcmp(parallel.motion.data(), serial.motion.data(),
                          serial.motion.size() * sizeof(btScalar)),
              0);
  }
}

}  // namespace
}  // namespace delassus::test
