/// What is half way through a mesh, whose triangles push from both sides.

#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>
#include <gtest/gtest.h>

#include <memory>

#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

/// A plank, as one box or as two halves, that lies in a mesh of level squares of 1 m, its centre at
/// `height`, one end up.
struct PlankInFloor {
  btTriangleMesh triangles;  // they outlive the world
  btBoxShape halfBox{btVector3(0.25, btScalar(0.03), 0.1)};
  DelassusWorld world;
  btRigidBody* plank;

  PlankInFloor(double height, double lean, double heading, bool inHalves = false) {
    constexpr int half = 3;
    for (int x = -half; x < half; ++x)
      for (int z = -half; z < half; ++z) {
        const auto corner = [&](int dx, int dz) {
          return btVector3(btScalar(x + dx), 0, btScalar(z + dz));
        };
        triangles.addTriangle(corner(0, 0), corner(0, 1), corner(1, 1));
        triangles.addTriangle(corner(0, 0), corner(1, 1), corner(1, 0));
      }
    world.addBody(std::make_unique<btBvhTriangleMeshShape>(&triangles, true),
                  btTransform::getIdentity(), 0);

    const btQuaternion turn = btQuaternion(btVector3(0, 1, 0), btScalar(heading)) *
                              btQuaternion(btVector3(0, 0, 1), btScalar(lean));
    plank = &world.addBody(inHalves ? twoHalves() : oneBox(),
                           btTransform(turn, btVector3(0.3, btScalar(height), 0.4)), 1);
  }

 private:
  std::unique_ptr<btCollisionShape> oneBox() const {
    return std::make_unique<btBoxShape>(btVector3(0.5, btScalar(0.03), 0.1));
  }
  std::unique_ptr<btCollisionShape> twoHalves() {
    auto plankShape = std::make_unique<btCompoundShape>();
    for (const double side : {-0.25, 0.25})
      plankShape->addChildShape(
          btTransform(btQuaternion::getIdentity(), btVector3(btScalar(side), 0, 0)), &halfBox);
    return plankShape;
  }
};

// Held exactly, what pushes it up and what pushes it down would contradict each other step by step.
TEST(TwoSided, WhatTrianglesPushBothWaysIsSolved) {
  for (const bool inHalves : {false, true})
    for (const double height : {-0.01, 0.002, 0.02})
      for (const double lean : {0.03, 0.06, 0.1, 0.2})
        for (const double heading : {0.0, 0.5, 1.3}) {
          SCOPED_TRACE(testing::Message() << height << " m, " << lean << ", " << heading << " rad"
                                          << (inHalves ? ", in halves" : ""));
          PlankInFloor in(height, lean, heading, inHalves);
          for (int step = 0; step < 60; ++step) {
            in.world.advance();
            const StepReport& report = in.world.report();
            ASSERT_EQ(report.incompatible + report.outOfBudget, 0) << step;
            ASSERT_EQ(report.pushUnsolved, 0) << step;
            ASSERT_LT(in.plank->getLinearVelocity().length(), 10) << step;
          }
        }
}

TEST(TwoSided, ItComesOutWhereItsCentreIs) {
  for (const double lean : {0.03, 0.06})
    for (const double heading : {0.0, 0.5, 1.3}) {
      SCOPED_TRACE(testing::Message() << lean << ", " << heading << " rad");
      PlankInFloor in(0.02, lean, heading);
      in.world.advance(120);
      EXPECT_GT(in.plank->getWorldTransform().getOrigin().y(), 0.02);
    }
}

}  // namespace
}  // namespace delassus::test
