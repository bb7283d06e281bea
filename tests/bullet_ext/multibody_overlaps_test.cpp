/// Overlaps beside articulated bodies, and of their own links.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "tests/support/multibody_world.h"

namespace delassus::test {
namespace {

// Boxes that overlap are pushed apart beside an articulated body, which no push moves.
TEST(MultiBodyContacts, NoPushMovesAnArticulatedBody) {
  constexpr int boxes = 4;
  const btVector3 half(0.5, 0.5, 0.5);
  DelassusMultiBodyWorld world;
  world.addGround();
  btMultiBody& base = world.addTree(0, 1, boxInertia(half, 1), false, {0, 0.5, 0});
  world.addCollider(base, -1, std::make_unique<btBoxShape>(half));
  world.finish(base);
  std::vector<btRigidBody*> column;
  for (int i = 0; i < boxes; ++i)
    column.push_back(&world.addCube({0, btScalar(1.5 - 0.05 + (i == 0 ? 0 : 0.8 * i)), 0}));
  world.advance();
  EXPECT_GT(world.report().pushIslands, 0);
  world.advance(120);
  EXPECT_NEAR(base.getBasePos().y(), 0.5, 1e-3);
  for (int i = 0; i < boxes; ++i)
    EXPECT_NEAR(column[i]->getWorldTransform().getOrigin().y(), 1.5 + i, 0.02 * (i + 1)) << i;
}

/// The height where a base ends up that falls, tilted. It carries two links on fixed joints, the
/// first of which lies 5 cm deep in the base.
double heightOfFixedLinks(MultiBodyWorld& world, double tilt, double& fastest) {
  const btVector3 half(0.5, 0.5, 0.5), halfLink(btScalar(0.1), btScalar(0.3), btScalar(0.1));
  world.addGround();
  btMultiBody& tree = world.addTree(2, 1, boxInertia(half, 1), false, {0, 1, 0});
  tree.setHasSelfCollision(true);
  tree.setWorldToBaseRot(
      btQuaternion(btVector3(1, btScalar(0.3), btScalar(0.2)).normalized(), -btScalar(tilt)));
  for (int link = 0; link < 2; ++link)
    tree.setupFixed(link, btScalar(0.3), boxInertia(halfLink, btScalar(0.3)), link - 1,
                    btQuaternion::getIdentity(), {0, btScalar(link == 0 ? 0.5 : -0.3), 0},
                    {0, btScalar(link == 0 ? 0.3 : 0.25), 0});
  world.addCollider(tree, -1, std::make_unique<btBoxShape>(half));
  for (int link = 0; link < 2; ++link)
    world.addCollider(tree, link, std::make_unique<btBoxShape>(halfLink));
  world.finish(tree);
  fastest = 0;
  for (int step = 0; step < 120; ++step) {
    world.advance();
    fastest = std::max<double>(fastest, tree.getBaseVel().length());
  }
  return tree.getBasePos().y();
}

// Bullet lets links collide that are not neighbours. What no joint lets part does not push.
TEST(MultiBodyContacts, LinksThatFixedJointsHoldDoNotPush) {
  for (const double tilt : {0.0, 0.3, 1.0})
    for (const bool isBounded : {false, true}) {
      SCOPED_TRACE(testing::Message() << tilt << (isBounded ? ", bounded" : ""));
      MultiBodyWorld ours(std::make_unique<btDelassusMultiBodyConstraintSolver>(
          isBounded ? Options::bounded(2) : Options()));
      StockMultiBodyWorld stock(200);
      double fastest, fastestOfStock;
      const double height = heightOfFixedLinks(ours, tilt, fastest);
      EXPECT_NEAR(height, heightOfFixedLinks(stock, tilt, fastestOfStock), 0.1);
      EXPECT_NEAR(fastest, fastestOfStock, 0.1 * fastestOfStock);
    }
}

}  // namespace
}  // namespace delassus::test
