/// Bodies half way through a mesh, whose triangles push from both sides, parts that interlock, and
/// plates half way through each other.

#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

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

  /// The speed of the fastest part.
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
  /// The floor is the first object.
  btRigidBody& part(int i) {
    return static_cast<btRigidBody&>(*world->getCollisionObjectArray()[i]);
  }
};

// Held exactly, the triangles that push it up and those that push it down would contradict each
// other in every step.
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

// The plank leaves on the side where its centre is, or stays.
TEST(OpposedContacts, NothingIsPulledThroughTriangles) {
  for (const double lean : {0.03, 0.06})
    for (const double heading : {0.0, 0.5, 1.3}) {
      SCOPED_TRACE(testing::Message() << lean << ", " << heading << " rad");
      PlankInFloor in(0.02, lean, heading);
      in.world.advance(120);
      EXPECT_GT(in.height(), 0.018);
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

// A third bar, held between the two, overlaps both by a centimetre.
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

// Where one of two bars that hold a slab between them is deep in it, both are pushed apart, as with
// split impulse, and not thrown.
TEST(OpposedContacts, PartsThatInterlockDeeplyAreNotThrown) {
  for (const double deep : {0.4, 0.7}) {
    SCOPED_TRACE(testing::Message() << deep << " m");
    btBoxShape bar(btVector3(2, 0.5, 0.5));
    DelassusWorld world;
    world.addBox({10, 1, 10}, {0, -1, 0}, 0);
    btRigidBody& pair = world.addBody(
        twoBars(bar, 2.8),
        btTransform(btQuaternion::getIdentity(), btVector3(0, btScalar(-0.9 - deep), 0)), 1);
    const btScalar y = pair.getWorldTransform().getOrigin().y();
    for (int step = 0; step < 60; ++step) {
      world.advance();
      EXPECT_LT(pair.getLinearVelocity().length(), 0.5) << step;
    }
    EXPECT_GT(pair.getWorldTransform().getOrigin().y(), y + 0.3 * deep);
  }
}

// Plates that overlap by their thickness. Bullet turns the normal when one is more than half way
// through, and keeps the points that have the old one.
TEST(OpposedContacts, PlatesThatAreHalfWayThroughEachOtherAreSolved) {
  constexpr double thick = 0.012;
  btBoxShape shape(btVector3(btScalar(0.3), btScalar(thick / 2), btScalar(0.2)));
  btVector3 inertia;
  shape.calculateLocalInertia(1, inertia);
  btRigidBody above(1, nullptr, &shape, inertia), below(1, nullptr, &shape, inertia);
  btPersistentManifold manifold(&above, &below, 0, btScalar(0.02), 1);
  for (const int side : {-1, 1}) {
    const btVector3 place(btScalar(0.2 * side), 0, 0), up(0, btScalar(side), 0);
    manifold.addManifoldPoint(btManifoldPoint(place, place, up, -btScalar(thick)));
    btManifoldPoint& point = manifold.getContactPoint(manifold.getNumContacts() - 1);
    point.m_positionWorldOnA = point.m_positionWorldOnB = place;
    point.m_combinedFriction = btScalar(0.5);
  }
  btDelassusConstraintSolver solver;
  btCollisionObject* bodies[] = {&above, &below};
  btPersistentManifold* manifolds[] = {&manifold};
  for (int step = 0; step < 3; ++step) {
    solver.prepareSolve(2, 1);
    solver.solveGroup(bodies, 2, manifolds, 1, nullptr, 0, btContactSolverInfo(), nullptr, nullptr);
    EXPECT_EQ(solver.report().opposed, 2);
    EXPECT_EQ(solver.report().incompatible + solver.report().outOfBudget, 0);
    for (int k = 0; k < 2; ++k)
      EXPECT_LT(manifold.getContactPoint(k).m_appliedImpulse, 10)
          << "the weight of ten plates, 0.1 s";
  }
}

/// Two faces that lean by `half` rad against the vertical and meet at the origin, as one mesh or
/// one compound.
class Groove {
 public:
  Groove(DelassusWorld& world, double half, bool isMesh) {
    const btVector3 along(0, 0, 2);
    auto leaves = std::make_unique<btCompoundShape>();
    for (const int side : {-1, 1}) {
      const btVector3 up(btScalar(6 * side * std::sin(half)), btScalar(6 * std::cos(half)), 0);
      mesh_.addTriangle(-along, up - along, up + along);
      mesh_.addTriangle(-along, up + along, along);
      const btQuaternion turn(btVector3(0, 0, 1), btScalar(-side * half));
      leaves->addChildShape(btTransform(turn, quatRotate(turn, btVector3(btScalar(side), 0, 0))),
                            &leaf_);
    }
    std::unique_ptr<btCollisionShape> shape = std::move(leaves);
    if (isMesh) shape = std::make_unique<btBvhTriangleMeshShape>(&mesh_, true);
    world.addBody(std::move(shape), btTransform::getIdentity(), 0);
  }

 private:
  btTriangleMesh mesh_;
  btBoxShape leaf_{btVector3(1, 6, 2)};
};

// A body wedged between two faces of another can leave: no demands contradict each other there.
TEST(OpposedContacts, AWedgeCarriesItsLoadExactly) {
  constexpr double half = 15 * M_PI / 180, radius = 0.5, load = 100;
  for (const bool isMesh : {true, false}) {
    SCOPED_TRACE(isMesh);
    DelassusWorld world;
    const Groove groove(world, half, isMesh);
    const double height = radius / std::sin(half);
    for (const double mass : {1.0, load}) {
      const double above = mass == load ? 2 * radius : 0;
      btRigidBody& ball =
          world.addSphere(btScalar(radius), {0, btScalar(height + above), 0}, btScalar(mass));
      ball.setLinearFactor({btScalar(mass == load ? 0 : 1), 1, 0});
      ball.setAngularFactor(0);
    }
    world.advance(120);
    EXPECT_EQ(world.report().opposed, 0);
    for (const btManifoldPoint* point : world.points())
      EXPECT_GT(point->getDistance(), -tolerance(1e-6, 1e-4));
    world.clear();
  }
}

// Two fingers on one slide, on both sides of a bar, are drawn together by 100 N each. (With much
// less, the mesh may lose their points in float until they have slid off.)
TEST(OpposedContacts, WhatAViceHoldsIsHeldExactly) {
  constexpr double half = 0.1, finger = 0.05, force = 100;
  btTriangleMesh mesh;
  for (const int side : {-1, 1}) {
    const auto corner = [&](double y, double z) {
      return btVector3(btScalar(side * half), btScalar(y), btScalar(z));
    };
    mesh.addTriangle(corner(-1, -1), corner(1, -1), corner(1, 1));
    mesh.addTriangle(corner(-1, -1), corner(1, 1), corner(-1, 1));
  }
  DelassusWorld world;
  world.addBody(std::make_unique<btBvhTriangleMeshShape>(&mesh, true), btTransform::getIdentity(),
                0);
  const auto addFinger = [&](int side) -> btRigidBody& {
    return world.addBox({btScalar(finger), 0.2, 0.1}, {btScalar(side * (half + finger)), 0, 0});
  };
  btRigidBody &left = addFinger(-1), &right = addFinger(1);
  auto& slide = world.addJoint<btSliderConstraint>(left, right, btTransform::getIdentity(),
                                                   btTransform::getIdentity(), true);
  slide.setLowerLinLimit(-10);
  slide.setUpperLinLimit(10);
  slide.setLowerAngLimit(0);
  slide.setUpperAngLimit(0);
  for (int step = 0; step < 120; ++step) {
    left.applyCentralForce({btScalar(force), 0, 0});
    right.applyCentralForce({-btScalar(force), 0, 0});
    world.advance();
  }
  EXPECT_EQ(world.report().opposed, 0);
  EXPECT_GT(right.getWorldTransform().getOrigin().x() - left.getWorldTransform().getOrigin().x(),
            2 * (half + finger) - tolerance(1e-4, 1e-3));
}

}  // namespace
}  // namespace delassus::test
