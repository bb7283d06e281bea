/// Bodies that welds hold together count as one where contacts are held.

#include "bullet_ext/welded_bodies.h"

#include <BulletDynamics/ConstraintSolver/btFixedConstraint.h>
#include <BulletDynamics/ConstraintSolver/btHingeConstraint.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bullet_ext/convert.h"
#include "bullet_ext/gather.h"
#include "bullet_ext/group.h"
#include "tests/support/bullet_world.h"
#include "tests/support/welds.h"

namespace delassus::test {
namespace {

constexpr double g = BulletWorld::gravity;

/// Welds `count` small boxes on to each other and to `first`, from `at` on. Returns the last.
btRigidBody& addRow(DelassusWorld& world, btRigidBody& first, int count, const btVector3& at,
                    const btVector3& pitch) {
  btRigidBody* last = &first;
  for (int i = 0; i < count; ++i) {
    btRigidBody& box =
        world.addBox({btScalar(0.03), btScalar(0.05), btScalar(0.05)}, at + btScalar(i) * pitch, 2);
    addWeld(world, *last, box);
    last = &box;
  }
  return *last;
}

double fastestOf(BulletWorld& world) {
  double most = 0;
  for (int i = 0; i < world->getNumCollisionObjects(); ++i)
    if (const auto* body = btRigidBody::upcast(world->getCollisionObjectArray()[i]))
      most = std::max<double>(
          most, std::max(body->getLinearVelocity().length(), body->getAngularVelocity().length()));
  return most;
}

/// The welds of all joints of a world.
struct Gathered {
  bullet::Group group;
  bullet::WeldedBodies welded;

  explicit Gathered(DelassusWorld& world, std::vector<btCollisionObject*> bodies) {
    StepReport report;
    std::vector<btTypedConstraint*> joints;
    for (int i = 0; i < world->getNumConstraints(); ++i) joints.push_back(world->getConstraint(i));
    world.info().m_timeStep = BulletWorld::step;
    bullet::gatherGroup(group,
                        {bodies.data(), static_cast<int>(bodies.size()), nullptr, 0, joints.data(),
                         static_cast<int>(joints.size()), &world.info(), &world.dispatcher()},
                        report);
    welded.reset(group);
    for (const bullet::JointSource& joint : group.joints) welded.weld(group, joint);
    welded.close(group);
  }
};

// Two boxes of 1 kg and 3 kg, 2 m apart.
TEST(WeldedBodies, MassAndInertiaAreThoseOfBoth) {
  DelassusWorld world;
  btRigidBody &a = world.addCube({0, 0, 0}), &b = world.addCube({2, 0, 0}, 3);
  addWeld(world, a, b).setBreakingImpulseThreshold(100);
  const Gathered two(world, {&a, &b});
  ASSERT_EQ(two.welded.partOf(0), two.welded.partOf(1));
  EXPECT_TRUE(two.welded.areWelded(0, 1));
  EXPECT_FALSE(two.welded.areWeldedForGood(0, 1));
  EXPECT_FALSE(two.welded.isBolted(0));
  const Body& part = two.welded.parts()[two.welded.partOf(0)];
  EXPECT_NEAR(part.inverseMass[0], 0.25, precision);
  // A cube has m/6; the centre is 1.5 m from the one and 0.5 m from the other.
  const double own = 4 / 6.0, around = 1.5 * 1.5 + 3 * 0.5 * 0.5;
  const Mat3 inertia = Vec3(own, own + around, own + around).asDiagonal();
  EXPECT_LT((part.inverseInertia.inverse() - inertia).norm(), 100 * precision);
  // A push on one along y turns both about z.
  Vec6 push;
  push << 0, 1, 0, 0, 0, 0;
  const Vec6 ofA = two.welded.onPart(0, push), ofB = two.welded.onPart(1, push);
  EXPECT_NEAR(ofA[5], -1.5, 10 * precision);
  EXPECT_NEAR(ofB[5], 0.5, 10 * precision);
}

// What welds ask for brings their bodies to where they belong, from body to body; on a platform
// that moves they go along.
TEST(WeldedBodies, WeldsAskForWhatMendsThem) {
  DelassusWorld world;
  btRigidBody& platform = world.addCube({0, -1, 0}, 0);
  platform.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
  platform.setLinearVelocity({0, 0, 2});
  btRigidBody &a = world.addCube({0, 0, 0}), &b = world.addCube({2, 0, 0});
  addWeld(world, a, b);
  world.addJoint<btFixedConstraint>(platform, a, DelassusWorld::at({0, 1, 0}),
                                    btTransform::getIdentity());
  const btScalar errorA = btScalar(0.01), errorB = btScalar(0.02);
  a.translate({0, errorA, 0});
  b.translate({0, errorB, 0});
  a.setInterpolationWorldTransform(a.getWorldTransform());
  const Gathered three(world, {&platform, &a, &b});
  EXPECT_TRUE(three.welded.isBolted(1));
  EXPECT_TRUE(three.welded.isBolted(2));
  EXPECT_EQ(three.welded.partOf(1), bullet::WeldedBodies::none);
  EXPECT_TRUE(three.welded.areWeldedForGood(1, 2));
  EXPECT_FALSE(three.welded.areWelded(0, 1));
  const double perSecond = world.info().m_erp / BulletWorld::step;
  Vec6 up = Vec6::Zero(), along = Vec6::Zero();
  up[1] = along[2] = 1;
  const auto expectAsked = [&](int body, double error) {
    const bullet::ImpulseSpan::Wanted rise = three.welded.asked(body, up),
                                      drift = three.welded.asked(body, along);
    EXPECT_NEAR(rise.ofErrors, -perSecond * error, 1e-4) << body;
    EXPECT_NEAR(rise.ofMovers, 0, 1e-6) << body;
    EXPECT_NEAR(drift.ofErrors, 0, 1e-4) << body;
    EXPECT_NEAR(drift.ofMovers, 2, 1e-4) << body;
  };
  expectAsked(1, errorA);
  expectAsked(2, errorB);
}

// A row of welded boxes, bolted to the ground that all of them overlap. (Of more than 64 rows the
// ground lifted it out, step by step, in contradiction to the bolt.)
TEST(WeldedBodies, LargeMachinesRestWhereTheyAreBolted) {
  for (const double overlap : {1e-3, 0.1}) {
    SCOPED_TRACE(overlap);
    DelassusWorld world;
    world.addGround();
    const btScalar half = btScalar(0.2), pitch = btScalar(0.45);
    std::vector<btRigidBody*> row;
    for (int i = 0; i < 30; ++i) {
      row.push_back(&world.addBox({half, half, half}, {pitch * i, half - btScalar(overlap), 0}));
      if (i > 0) addWeld(world, *row[i - 1], *row[i]);
    }
    addBolt(world, *row.front());
    for (int step = 0; step < 30; ++step) {
      world.advance();
      ASSERT_EQ(notSolvedOf(world), 0) << step;
      ASSERT_LT(fastestOf(world), tolerance(1e-6, 1e-3)) << step;
    }
    EXPECT_GT(world.report().held, 0);
    world.clear();
  }
}

// A door that grazes the floor, on a post with parts welded to it, and one that fits a frame.
TEST(WeldedBodies, DoorsSwingInLargeFrames) {
  for (const int parts : {1, 30})
    for (const bool fits : {false, true}) {
      SCOPED_TRACE(testing::Message() << parts << " parts, " << (fits ? "fits" : "grazes"));
      const btScalar overlap = fits ? btScalar(0) : btScalar(0.01);
      DelassusWorld world;
      if (!fits) world.addGround();
      const btVector3 thin(btScalar(0.05), 1, btScalar(0.05)), up(0, 1, 0);
      btRigidBody& post = world.addBox(thin, {btScalar(-0.55), btScalar(1.1), 0}, 50);
      addBolt(world, post);
      const btScalar pitch = btScalar(1.1 / parts);
      btRigidBody& last = addRow(world, post, parts,
                                 {btScalar(-0.55) + pitch / 2, btScalar(2.5), 0}, {pitch, 0, 0});
      if (fits) {
        btRigidBody& lock = world.addBox(thin, {btScalar(0.55), btScalar(1.1), 0}, 50);
        addWeld(world, last, lock);
      }
      btRigidBody& door =
          world.addBox({0.5, 1, btScalar(0.05)}, {0, fits ? btScalar(1.1) : 1 - overlap, 0}, 20);
      world.addJoint<btHingeConstraint>(post, door, btVector3(btScalar(0.05), 0, 0),
                                        btVector3(-0.5, fits ? 0 : btScalar(0.1) + overlap, 0), up,
                                        up);
      door.setIgnoreCollisionCheck(&post, true);
      door.setAngularVelocity({0, 2, 0});
      door.setLinearVelocity({0, 0, -1});
      for (int step = 0; step < 30; ++step) {
        world.advance();
        ASSERT_EQ(notSolvedOf(world), 0) << step;
      }
      EXPECT_NEAR(door.getAngularVelocity().y(), 2, tolerance(0.03, 0.05));
      world.clear();
    }
}

// Its fender is welded to it, as are other parts, and just touches the wheel.
TEST(WeldedBodies, AWheelTurnsInTheFenderOfALargeCar) {
  for (const int parts : {12, 50})
    for (const double overlap : {0.0, 1e-5, 1e-3}) {
      SCOPED_TRACE(testing::Message() << parts << " parts, overlap " << overlap);
      DelassusWorld world;
      world->setGravity({0, 0, 0});
      btRigidBody& car = world.addBox({1, btScalar(0.1), btScalar(0.2)}, {0, 0, 0}, 10);
      btRigidBody& wheel = world.addBody(std::make_unique<btCylinderShapeZ>(btVector3(
                                             btScalar(0.4), btScalar(0.4), btScalar(0.1))),
                                         world.at({0, 0, 0.5}), 5);
      btRigidBody& fender = world.addBox({btScalar(0.3), btScalar(0.05), btScalar(0.2)},
                                         {0, btScalar(0.45 - overlap), 0.5});
      const btVector3 axis(0, 0, 1);
      world
          .addJoint<btHingeConstraint>(car, wheel, btVector3(0, 0, 0.5), btVector3(0, 0, 0), axis,
                                       axis)
          .enableAngularMotor(true, 3, 1);
      addWeld(world, car, fender);
      addRow(world, car, parts, {0, btScalar(0.15), 0}, {btScalar(0.06), 0, 0});
      for (int step = 0; step < 60; ++step) {
        world.advance();
        ASSERT_EQ(notSolvedOf(world), 0) << step;
      }
      EXPECT_NEAR((wheel.getAngularVelocity() - car.getAngularVelocity()).length(), 3, 5e-3);
      world.clear();
    }
}

/// The fastest that any brick gets within a second in a wall of bricks on the ground that are
/// welded in one line, row by row, each of which overlaps its neighbours.
double fastestInWall(BulletWorld& world) {
  world.addGround();
  constexpr int side = 4;
  btRigidBody* last = nullptr;
  for (int y = 0; y < side; ++y)
    for (int i = 0; i < side; ++i) {
      const int x = y % 2 == 0 ? i : side - 1 - i;
      const auto pitch = btScalar(0.498), half = btScalar(0.25);
      btRigidBody& brick = world.addBox({half, half, half}, {pitch * x, half + pitch * y, 0}, 5);
      if (last) addWeld(world, *last, brick);
      last = &brick;
    }
  double fastest = 0;
  for (int step = 0; step < 60; ++step) {
    world.advance();
    fastest = std::max(fastest, fastestOf(world));
  }
  return fastest;
}

// Few sweeps do not reach rest; ours are much nearer to it than Bullet's.
TEST(WeldedBodies, AWallOfOneLineStandsWithFewSweeps) {
  constexpr int sweeps = 10;
  DelassusWorld world(Options::bounded(sweeps));
  StockWorld stock(sweeps);
  EXPECT_LT(fastestInWall(world), 0.2 * fastestInWall(stock));
}

// A free wall of bricks that turns, each overlapping its neighbours, welded in one line by welds
// that may break: nothing loads them.
TEST(WeldedBodies, ContactsWithinATurningWallLoadNoWeld) {
  for (const double overlap : {1e-3, 0.02}) {
    SCOPED_TRACE(overlap);
    DelassusWorld world;
    world->setGravity({0, 0, 0});
    const auto pitch = btScalar(0.5 - overlap), half = btScalar(0.25);
    const btVector3 spin = btScalar(0.5) * btVector3(1, 2, 3).normalized(), centre(pitch, pitch, 0);
    std::vector<btFixedConstraint*> welds;
    btRigidBody* last = nullptr;
    for (int y = 0; y < 3; ++y)
      for (int i = 0; i < 3; ++i) {
        const int x = y % 2 == 0 ? i : 2 - i;
        const btVector3 at(pitch * x, pitch * y, 0);
        btRigidBody& brick = world.addBox({half, half, half}, at, 2);
        brick.setAngularVelocity(spin);
        brick.setLinearVelocity(spin.cross(at - centre));
        if (last) {
          welds.push_back(&addWeld(world, *last, brick));
          welds.back()->setBreakingImpulseThreshold(200);
          last->setIgnoreCollisionCheck(&brick, false);
        }
        last = &brick;
      }
    for (int step = 0; step < 120; ++step) {
      world.advance();
      ASSERT_EQ(notSolvedOf(world), 0) << step;
      for (const btFixedConstraint* weld : welds)
        ASSERT_LT(std::abs(weld->getAppliedImpulse()), 1) << step;
    }
    EXPECT_GT(world.report().contacts, 0);
    EXPECT_NEAR(last->getAngularVelocity().length(), 0.5, 5e-3);
    world.clear();
  }
}

// A wall of bricks, welded in one line by welds that break under a brick's weight on a long arm,
// rests on itself: contacts between its rows carry their part.
TEST(WeldedBodies, AWallOfOneLineRestsOnItself) {
  for (const double overlap : {1e-3, 0.01}) {
    SCOPED_TRACE(overlap);
    DelassusWorld world;
    world.addGround();
    constexpr int width = 8, height = 5;
    std::vector<btFixedConstraint*> welds;
    btRigidBody* last = nullptr;
    for (int y = 0; y < height; ++y)
      for (int i = 0; i < width; ++i) {
        const int x = y % 2 == 0 ? i : width - 1 - i;
        const auto half = btScalar(0.1);
        btRigidBody& brick = world.addBox(
            {2 * half, half, half},
            {btScalar((0.4 - overlap) * x), half + btScalar((0.2 - overlap) * y), 0}, 2);
        if (last) {
          welds.push_back(&addWeld(world, *last, brick));
          welds.back()->setBreakingImpulseThreshold(10);
        }
        last = &brick;
      }
    world.advance(60);
    for (const btFixedConstraint* weld : welds) EXPECT_TRUE(weld->isEnabled());
    world.clear();
  }
}

// A beam of bricks, each of which overlaps the next but one, holds a thousand times a brick's mass
// by welds that would break under far more.
TEST(WeldedBodies, WeldsThatBearMuchDoNotSag) {
  DelassusWorld world;
  btRigidBody* last = nullptr;
  for (int i = 0; i < 6; ++i) {
    const auto half = btScalar(0.25);
    btRigidBody& brick =
        world.addBox({half, half, half}, {btScalar(0.2 * i), 0, 0}, i < 5 ? 1 : 1000);
    btFixedConstraint& weld = last ? addWeld(world, *last, brick) : addBolt(world, brick);
    weld.setBreakingImpulseThreshold(btScalar(1e7));
    last = &brick;
  }
  for (int step = 0; step < 120; ++step) {
    world.advance();
    ASSERT_EQ(notSolvedOf(world), 0) << step;
  }
  EXPECT_GT(world.report().contacts, 0);
  EXPECT_NEAR(last->getWorldTransform().getOrigin().y(), 0, 1e-4);
}

// Two cubes on each other, welded to a third beside them by welds that may break: the contact
// carries its part. Where one weld links the two themselves, it carries all.
TEST(WeldedBodies, AWeldThatMayBreakLeavesContactsTheirPart) {
  enum Case { Lasting, Breaking, Direct };
  for (const Case weldIs : {Lasting, Breaking, Direct}) {
    SCOPED_TRACE(weldIs);
    DelassusWorld world;
    world.addGround();
    btRigidBody &low = world.addCube({0, 0.5, 0}), &high = world.addCube({0, 1.5, 0}),
                &third = world.addCube({1, 1, 0});
    std::vector<btFixedConstraint*> welds = {&addWeld(world, low, third),
                                             &addWeld(world, high, third)};
    if (weldIs == Direct) {
      welds.push_back(&addWeld(world, low, high));
      low.setIgnoreCollisionCheck(&high, false);
    }
    if (weldIs != Lasting)
      for (btFixedConstraint* weld : welds) weld->setBreakingImpulseThreshold(1000);
    world.advance(30);
    EXPECT_EQ(world.report().contacts, weldIs == Breaking ? 8 : 4);
    EXPECT_EQ(notSolvedOf(world), 0);
    EXPECT_NEAR(high.getWorldTransform().getOrigin().y(), 1.5, tolerance(1e-5, 1e-4));
    double onGround = 0;
    for (const btManifoldPoint* point : world.points())
      if (point->getPositionWorldOnB().y() < 0.5) onGround += point->getAppliedImpulse();
    EXPECT_NEAR(onGround / BulletWorld::step, 3 * g, 1e-3);
    world.clear();
  }
}

}  // namespace
}  // namespace delassus::test
