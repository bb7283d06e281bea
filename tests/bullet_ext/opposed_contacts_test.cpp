/// What is half way through a mesh, whose triangles push from both sides, and parts that interlock.

#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

/// How a plank is made.
enum class Plank { OneBox, TwoHalves, TwoHinged };

/// A plank that lies in a mesh of level squares of 1 m, its centre at `height`, one end up.
struct PlankInFloor {
  btTriangleMesh triangles;  // they outlive the world
  btBoxShape halfBox{btVector3(btScalar(0.24), btScalar(0.03), 0.1)};
  DelassusWorld world;

  PlankInFloor(double height, double lean, double heading, Plank kind = Plank::OneBox) {
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
    const btTransform pose(turn, btVector3(0.3, btScalar(height), 0.4));
    if (kind == Plank::OneBox)
      world.addBody(std::make_unique<btBoxShape>(btVector3(0.5, btScalar(0.03), 0.1)), pose, 1);
    else if (kind == Plank::TwoHalves)
      world.addBody(twoHalves(), pose, 1);
    else
      addHinged(pose);
  }

  /// Of the fastest of what moves.
  double speed() {
    double fastest = 0;
    for (int i = 1; i < world->getNumCollisionObjects(); ++i)
      fastest = std::max<double>(fastest, part(i).getLinearVelocity().length());
    return fastest;
  }
  double height() { return part(1).getWorldTransform().getOrigin().y(); }

 private:
  std::unique_ptr<btCollisionShape> twoHalves() {
    auto plank = std::make_unique<btCompoundShape>();
    for (const double side : {-0.25, 0.25}) plank->addChildShape(shifted(side), &halfBox);
    return plank;
  }
  void addHinged(const btTransform& pose) {
    const auto addHalf = [&](double side) -> btRigidBody& {
      return world.addBody(std::make_unique<btBoxShape>(halfBox), pose * shifted(side), 1);
    };
    btRigidBody &left = addHalf(-0.25), &right = addHalf(0.25);
    const btVector3 axis(0, 0, 1), ahead(0.25, 0, 0);
    world.addJoint<btHingeConstraint>(left, right, ahead, -ahead, axis, axis);
  }
  static btTransform shifted(double x) {
    return btTransform(btQuaternion::getIdentity(), btVector3(btScalar(x), 0, 0));
  }
  /// The floor is the first.
  btRigidBody& part(int i) {
    return static_cast<btRigidBody&>(*world->getCollisionObjectArray()[i]);
  }
};

// Held exactly, what pushes it up and what pushes it down would contradict each other step by step.
TEST(OpposedContacts, WhatTrianglesPushBothWaysIsSolved) {
  for (const Plank kind : {Plank::OneBox, Plank::TwoHalves, Plank::TwoHinged})
    for (const double height : {-0.01, 0.002, 0.02})
      for (const double lean : {0.03, 0.06, 0.1, 0.2})
        for (const double heading : {0.0, 0.5, 1.3}) {
          SCOPED_TRACE(testing::Message() << height << " m, " << lean << ", " << heading << " rad, "
                                          << static_cast<int>(kind));
          PlankInFloor in(height, lean, heading, kind);
          for (int step = 0; step < 60; ++step) {
            in.world.advance();
            const StepReport& report = in.world.report();
            ASSERT_EQ(report.incompatible + report.outOfBudget, 0) << step;
            ASSERT_EQ(report.pushUnsolved, 0) << step;
            ASSERT_LT(in.speed(), 10) << step;
          }
        }
}

TEST(OpposedContacts, WhatIsInTrianglesLeavesWhereItsCentreIs) {
  for (const double lean : {0.03, 0.06})
    for (const double heading : {0.0, 0.5, 1.3}) {
      SCOPED_TRACE(testing::Message() << lean << ", " << heading << " rad");
      PlankInFloor in(0.02, lean, heading);
      in.world.advance(120);
      EXPECT_GT(in.height(), 0.02);
    }
}

/// Two bars, one over the other, as one body.
std::unique_ptr<btCollisionShape> twoBars(btBoxShape& bar, double apart) {
  auto bars = std::make_unique<btCompoundShape>();
  for (const double side : {-0.5, 0.5})
    bars->addChildShape(
        btTransform(btQuaternion::getIdentity(), btVector3(0, btScalar(side * apart), 0)), &bar);
  return bars;
}

// A third, held between them, overlaps both by a centimetre.
TEST(OpposedContacts, PartsThatInterlockAreSolved) {
  constexpr double half = 0.05, overlap = 0.01, apart = 4 * half - 2 * overlap;
  btBoxShape bar(btVector3(1, btScalar(half), btScalar(half)));
  for (const double lean : {0.0, 0.01, 0.05}) {
    SCOPED_TRACE(lean);
    DelassusWorld world;
    world.addBox({10, 1, 10}, {0, -1, 0}, 0);
    world.addBody(twoBars(bar, apart),
                  btTransform(btQuaternion::getIdentity(), btVector3(0, 0.5, 0)), 1);
    btRigidBody& third = world.addBox({btScalar(half), btScalar(half), 1}, {0, 0.5, 0});
    third.setWorldTransform(btTransform(btQuaternion(btVector3(1, 0, 0), btScalar(lean)),
                                        third.getWorldTransform().getOrigin()));
    for (int step = 0; step < 120; ++step) {
      world.advance();
      ASSERT_EQ(world.report().incompatible + world.report().outOfBudget, 0) << step;
      ASSERT_LT(third.getLinearVelocity().length(), 10) << step;
    }
  }
}

}  // namespace
}  // namespace delassus::test
