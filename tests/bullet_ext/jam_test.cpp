/// Bodies that an unyielding wall squeezes give a little: soon found, reported, and not thrown.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "bullet_ext/group.h"
#include "bullet_ext/thrown_bodies.h"
#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

/// A bin of 4 m by 3 m, one wall of which can be driven in, and boxes and balls in two layers.
struct Compactor {
  static constexpr double speed = 0.5;  // m/s
  double friction;
  DelassusWorld world;
  std::vector<btRigidBody*> bodies;
  btRigidBody* wall;
  double place = 3;

  Compactor(bool areBoxes, double mu) : friction(mu) {
    world.addGround().setFriction(btScalar(friction));
    addWall({1, 5, 10}, -3, 0);
    addWall({10, 5, 1}, 0, -2.5);
    addWall({10, 5, 1}, 0, 2.5);
    wall = &addWall({1, 5, 10}, place, 0);
    wall->setCollisionFlags(wall->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    for (int i = 0; i < 24; ++i) {
      const double off = 0.004 * (i * 7 % 5);
      const btVector3 at(btScalar(-1.5 + 0.6 * (i % 6) + off), btScalar(0.3 + 0.6 * (i / 12)),
                         btScalar(-0.9 + 1.2 * (i / 6 % 2) - off));
      bodies.push_back(areBoxes ? &world.addBox({0.25, 0.25, 0.25}, at)
                                : &world.addSphere(btScalar(0.27), at));
      bodies.back()->setFriction(btScalar(friction));
    }
    world.advance(60);
  }
  btRigidBody& addWall(const btVector3& half, double x, double z) {
    btRigidBody& added = world.addBox(half, {btScalar(x), 5, btScalar(z)}, 0);
    added.setFriction(btScalar(friction));
    return added;
  }
  void drive(double velocity) {
    place += velocity / 60;
    wall->setWorldTransform(world.at({btScalar(place), 5, 0}));
    world.advance();
  }
  /// The largest speed at which points that touched before this step approach after it, m/s.
  double driveAndSeeApproach(double velocity) {
    std::map<const btCollisionObject*, btVector3> centres;
    for (const btRigidBody* body : bodies) centres[body] = body->getCenterOfMassPosition();
    drive(velocity);
    const auto velocityAt = [&](const btCollisionObject* object, const btVector3& point) {
      const btRigidBody& body = *btRigidBody::upcast(object);
      const auto centre = centres.find(object);
      return centre == centres.end() ? body.getLinearVelocity()
                                     : body.getVelocityInLocalPoint(point - centre->second);
    };
    double most = 0;
    for (int i = 0; i < world.dispatcher().getNumManifolds(); ++i) {
      const btPersistentManifold& manifold = *world.dispatcher().getManifoldByIndexInternal(i);
      for (int k = 0; k < manifold.getNumContacts(); ++k) {
        const btManifoldPoint& point = manifold.getContactPoint(k);
        if (point.getDistance() > 0) continue;
        const btVector3 u = velocityAt(manifold.getBody0(), point.getPositionWorldOnA()) -
                            velocityAt(manifold.getBody1(), point.getPositionWorldOnB());
        most = std::max(most, double(-u.dot(point.m_normalWorldOnB)));
      }
    }
    return most;
  }
  double fastest() const {
    double most = 0;
    for (const btRigidBody* body : bodies)
      most = std::max(most, double(body->getLinearVelocity().length()));
    return most;
  }
};

TEST(Jam, ACompactorThrowsNothingAndLosesNoTime) {
  for (const bool areBoxes : {true, false})
    for (const double friction : {0.5, 0.7}) {
      SCOPED_TRACE(testing::Message() << (areBoxes ? "boxes " : "balls ") << friction);
      Compactor compactor(areBoxes, friction);
      const StepReport& report = compactor.world.report();
      int softened = 0, regions = 0, lost = 0;
      constexpr int steps = 180;
      for (int step = 0; step < steps; ++step) {
        const double approach = compactor.driveAndSeeApproach(-Compactor::speed);
        if (report.incompatible + report.outOfBudget == 0) {
          EXPECT_LT(approach, tolerance(1e-5, 1e-3)) << step;
        }
        EXPECT_LT(compactor.fastest(), 40 * Compactor::speed) << step;
        softened += report.softened;
        lost += report.outOfBudget;
        regions += report.regions;
      }
      EXPECT_GT(softened, 0);
      EXPECT_LE(lost, steps / 20);
      EXPECT_LT(regions, 300 * steps);
      for (const btRigidBody* body : compactor.bodies) {
        const btVector3 at = body->getWorldTransform().getOrigin();
        EXPECT_GT(at.y(), 0);
        EXPECT_LT(std::abs(at.z()), 1.6);
      }
      // As soon as there is room, all is solved exactly again.
      for (int step = 0; step < 60; ++step) compactor.drive(Compactor::speed);
      compactor.world.advance(60);
      EXPECT_EQ(report.softened, 0);
      EXPECT_EQ(report.outOfBudget, 0);
      EXPECT_LT(report.residualMax, tolerance(1e-6, 1e-4));
    }
}

/// A cube on a floor and under a ceiling, both of which may be driven.
struct Press {
  enum { cube, floor, ceiling };
  bullet::Group group;
  Island island;

  Press(const Vec6& ofFloor, const Vec6& ofCeiling) {
    group.bodies.resize(3);
    group.bodies[cube].inverseMass.setOnes();
    group.bodies[cube].inverseInertia.setIdentity();
    group.bodies[floor].velocity = ofFloor;
    group.bodies[ceiling].velocity = ofCeiling;
    for (const int other : {floor, ceiling}) {
      Contact& contact = group.contacts.emplace_back();
      contact.a = cube;
      contact.b = other;
      contact.armB = Vec3::Ones();
    }
    island.bodies = {cube};
    island.frictional = {0, 1};
  }
  bool mayJam() const { return bullet::mayBeSqueezed(group, island); }
};

TEST(Jam, NeedsBodiesThatGoDifferentWays) {
  const Vec6 still = Vec6::Zero(), there = Vec6::Unit(0), back = -there, turning = Vec6::Unit(4);
  EXPECT_FALSE(Press(still, still).mayJam());
  EXPECT_TRUE(Press(there, still).mayJam());
  EXPECT_TRUE(Press(still, there).mayJam());
  EXPECT_TRUE(Press(there, back).mayJam());
  EXPECT_FALSE(Press(there, there).mayJam());
  EXPECT_FALSE(Press(there, there + 1e-4 * turning).mayJam()) << "poses are rounded";
  EXPECT_TRUE(Press(there, there + 0.1 * turning).mayJam());
  EXPECT_TRUE(Press(turning, turning).mayJam()) << "about axes that may differ";

  Press alone(turning, still);
  alone.island.frictional = {0};
  EXPECT_TRUE(Press(turning, still).mayJam());
  EXPECT_FALSE(alone.mayJam()) << "the floor carries the cube along";
  alone.group.bodies[Press::cube].inverseMass[1] = 0;
  EXPECT_TRUE(alone.mayJam()) << "what locks the axis does not go along";
  Press inPlane(there, there);
  inPlane.group.bodies[Press::cube].inverseMass[2] = 0;
  inPlane.group.bodies[Press::cube].inverseInertia.topLeftCorner<2, 2>().setZero();
  EXPECT_FALSE(inPlane.mayJam()) << "all go along in the plane";
  inPlane.group.bodies[Press::cube].inverseMass[0] = 0;
  EXPECT_TRUE(inPlane.mayJam());

  Press jointed(there, there);
  jointed.island.rows = {0};
  jointed.group.rows.emplace_back().a = Press::cube;
  EXPECT_TRUE(jointed.mayJam()) << "the joint's other body is the world";
}

void addPyramid(DelassusWorld& world, int base) {
  for (int layer = 0; layer < base; ++layer)
    for (int i = 0; i < base - layer; ++i)
      world.addCube({btScalar(i - 0.5 * (base - layer - 1)), btScalar(0.5 + layer), 0});
}

// What a floor alone shakes can go along, be the floor of one piece or of two: no time is lost on
// the search for a jam, which takes as many sweeps as the answer.
TEST(Jam, IsNotLookedForOnAShakenFloor) {
  constexpr int base = 6, steps = 60, mostSweeps = 300;
  int sweeps = 0;
  for (const bool isWhole : {true, false}) {
    DelassusWorld world;
    std::vector<std::pair<btRigidBody*, double>> floor;
    for (const double x : isWhole ? std::vector<double>{0} : std::vector<double>{-10, 10}) {
      floor.emplace_back(&world.addBox({10, 1, 10}, {btScalar(x), -1, 0}, 0), x);
      floor.back().first->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
    }
    addPyramid(world, base);
    for (int step = 1; step <= steps; ++step) {
      const double swing = std::sin(0.2 * step);
      for (const auto& [piece, x] : floor)
        piece->setWorldTransform(
            world.at({btScalar(x + 0.1 * swing), btScalar(0.03 * swing - 1), 0}));
      world.advance();
      EXPECT_LT(world.report().residualMax, tolerance(1e-6, 1e-4)) << step;
      EXPECT_EQ(world.report().softened, 0) << step;
      sweeps += world.report().sweeps;
    }
  }
  EXPECT_LT(sweeps, 2 * steps * mostSweeps);
}

// One who walks into a pile pushes it out of his way. Each step might jam, but none does: a search
// that comes near an answer goes on from there, and does not begin anew.
TEST(Jam, OfWhatGivesWayIsSoonRuledOut) {
  constexpr int base = 8, steps = 150, mostSweeps = 350;
  DelassusWorld world;
  world.addGround();
  addPyramid(world, base);
  double place = -5;
  btRigidBody& walker = world.addBox({btScalar(0.4), btScalar(0.9), btScalar(0.4)},
                                     {btScalar(place), btScalar(0.95), btScalar(0.1)}, 0);
  walker.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
  int sweeps = 0;
  for (int step = 0; step < steps; ++step) {
    place += 1.5 / 60;
    walker.setWorldTransform(world.at({btScalar(place), btScalar(0.95), btScalar(0.1)}));
    world.advance();
    EXPECT_LT(world.report().residualMax, tolerance(1e-6, 1e-4)) << step;
    EXPECT_EQ(world.report().softened, 0) << step;
    sweeps += world.report().sweeps;
  }
  EXPECT_LT(sweeps, steps * mostSweeps);
}

// Jaws close on a box, each by 3 mm more than there is room, and lift it: also with few sweeps,
// which get no nearer to what they ask for than no reactions at all.
TEST(Jam, FewSweepsGiveJawsAGrip) {
  for (const int sweeps : {3, 10}) {
    SCOPED_TRACE(sweeps);
    constexpr double halfSize = 0.04, overlap = 3e-3, step = 1.0 / 240;
    OwningWorld<btDiscreteDynamicsWorld, btDelassusConstraintSolver> world(
        std::make_unique<btDelassusConstraintSolver>(Options::bounded(sweeps)));
    world.addGround();
    const auto half = btScalar(halfSize);
    btRigidBody& box = world.addBox({half, half, half}, {0, half, 0}, btScalar(0.2));
    box.setFriction(1);
    std::vector<btRigidBody*> jaws;
    for (const int side : {-1, 1}) {
      jaws.push_back(&world.addBox({btScalar(0.01), btScalar(0.05), btScalar(0.03)},
                                   {btScalar(0.08 * side), btScalar(0.06), 0}, 0));
      jaws.back()->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
      jaws.back()->setFriction(1);
    }
    for (int k = 0; k < 480; ++k) {
      const double time = k * step;
      const double apart = std::max(halfSize + 0.01 - overlap, 0.08 - 0.1 * time);
      const double height = 0.06 + 0.2 * std::max(time - 1, 0.0);
      for (const int j : {0, 1})
        jaws[j]->setWorldTransform(
            world.at({btScalar(j == 0 ? -apart : apart), btScalar(height), 0}));
      world->stepSimulation(btScalar(step), 0);
    }
    EXPECT_NEAR(box.getWorldTransform().getOrigin().y(), halfSize + 0.2, 0.01);
  }
}

// Jaws that stand and overlap what they hold ask for what no motion gives. Their grip is that of
// contacts that give a little, and friction holds.
TEST(Jam, JawsThatStandHoldWhatTheyGrip) {
  constexpr double mass = 0.2, halfSize = 0.04;
  for (const bool isRound : {false, true})
    for (const double overlap : {1e-6, 1e-4, 1e-3, 1e-2}) {
      SCOPED_TRACE(testing::Message() << (isRound ? "ball, " : "box, ") << overlap);
      DelassusWorld world;
      const auto radius = btScalar(halfSize);
      btRigidBody& held = isRound ? world.addSphere(radius, {0, 1, 0}, btScalar(mass))
                                  : world.addBox({radius, radius, radius}, {0, 1, 0}, mass);
      held.setFriction(1);
      for (const int side : {-1, 1})
        world
            .addBox({btScalar(0.01), btScalar(0.05), btScalar(0.03)},
                    {btScalar(side * (halfSize + 0.01 - overlap)), 1, 0}, 0)
            .setFriction(1);
      world.advance(60);
      EXPECT_NEAR(held.getWorldTransform().getOrigin().y(), 1, 1e-4);
    }
}

}  // namespace
}  // namespace delassus::test
