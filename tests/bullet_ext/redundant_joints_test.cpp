/// Joints that hold the same motion twice, as two hinges of a door do. The rounding of their poses
/// makes them contradict each other; the motions that they leave free must stay free.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <vector>

#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

/// Poses that stand askew, so that no axis is one of the world's.
class Poses {
 public:
  btTransform next() {
    const btVector3 axis(number(), number(), number());
    const btQuaternion turn(axis.normalized(), btScalar(3) * number());
    return btTransform(turn, btScalar(5) * btVector3(number(), number(), number()));
  }

 private:
  btScalar number() { return btScalar(2 * double(random_() >> 11) / double(1ULL << 53) - 1); }
  std::mt19937_64 random_{1};
};

/// Tolerances are the users' defaults.
struct OurWorld : BulletWorld {
  OurWorld() : BulletWorld(std::make_unique<btDelassusConstraintSolver>()) {}
};

btRigidBody& addPanel(BulletWorld& world, const btTransform& pose) {
  const btVector3 half(btScalar(0.5), 1, btScalar(0.03));
  return world.addBody(std::make_unique<btBoxShape>(half),
                       pose * BulletWorld::at({btScalar(0.5), btScalar(1.1), 0}), 20);
}

/// Checks that every step is one short walk.
void advanceCheaply(OurWorld& world, int steps) {
  for (int i = 0; i < steps; ++i) {
    world.advance();
    ASSERT_EQ(world.report().outOfBudget + world.report().incompatible, 0) << i;
    ASSERT_LE(world.report().regions, 30) << i;
  }
}

/// Two joints of one type between the panel and a wall, one above the other. `skew` turns the lower
/// one's frame on the wall, rad.
template <class Joint>
void addTwo(BulletWorld& world, btRigidBody& panel, btScalar skew,
            std::function<void(Joint&)> set) {
  btRigidBody& wall = world.addCube({-30, 0, 0}, 0);
  for (const btScalar side : {btScalar(0.7), btScalar(-0.7)}) {
    // The third axis, about which hinges turn, is the upright one of the panel; the first is the
    // axis of sliders.
    const btTransform inPanel(btQuaternion({1, 0, 0}, -SIMD_HALF_PI), {btScalar(-0.5), side, 0});
    btTransform inWall = wall.getWorldTransform().inverse() * panel.getWorldTransform() * inPanel;
    if (side < 0) inWall.setBasis(inWall.getBasis() * btMatrix3x3(btQuaternion({1, 0, 0}, skew)));
    set(world.addJoint<Joint>(panel, wall, inPanel, inWall, true));
  }
}

TEST(RedundantJoints, TwoParallelRailsLeaveTheFallAlongThem) {
  Poses poses;
  for (int k = 0; k < 16; ++k) {
    const btTransform pose = poses.next();
    OurWorld world;
    btRigidBody& panel = addPanel(world, pose);
    addTwo<btSliderConstraint>(world, panel, 0, [](btSliderConstraint& rail) {
      rail.setLowerLinLimit(1);  // above the upper one: none
      rail.setUpperLinLimit(-1);
      rail.setLowerAngLimit(0);
      rail.setUpperAngLimit(0);
    });
    constexpr int steps = 120;
    advanceCheaply(world, steps);
    const btVector3 along = pose.getBasis().getColumn(0);
    constexpr double free = g * steps * h;
    EXPECT_NEAR(panel.getLinearVelocity().dot(along), -free * along.y(),
                tolerance(1e-7, 2e-3) * free)
        << k;
  }
}

/// A door that has been pushed.
btRigidBody& addDoor(BulletWorld& world, const btTransform& pose, double skew) {
  btRigidBody& door = addPanel(world, pose);
  addTwo<btHingeConstraint>(world, door, btScalar(skew), [](btHingeConstraint&) {});
  door.applyImpulse(pose.getBasis() * btVector3(0, 0, 20),
                    pose.getBasis() * btVector3(btScalar(0.4), 0, 0));
  return door;
}

TEST(RedundantJoints, ADoorOnTwoHingesSwingsAsInConvergedStock) {
  for (const double skew : {0.0, 1e-9, 1e-7, 1e-5}) {
    Poses poses;
    for (int k = 0; k < 8; ++k) {
      const btTransform pose = poses.next();
      OurWorld ours;
      StockWorld stock;
      btRigidBody &door = addDoor(ours, pose, skew), &other = addDoor(stock, pose, skew);
      advanceCheaply(ours, 60);
      stock.advance(60);
      EXPECT_NEAR(door.getAngularVelocity().length(), other.getAngularVelocity().length(),
                  skew > 1e-8 ? 0.02 : tolerance(1e-4, 0.02))
          << "skew " << skew << ", pose " << k;
    }
  }
}

/// Two cubes that are welded together twice, and turn about the place where they touch.
class SpinningPair {
 public:
  SpinningPair(BulletWorld& world, const btVector3& place) {
    world->setGravity({0, 0, 0});
    const btTransform pose(btQuaternion({btScalar(1), btScalar(0.5), btScalar(0.3)}, 1), place);
    for (const btScalar side : {btScalar(-0.5), btScalar(0.5)}) {
      const btVector3 arm = pose.getBasis() * btVector3(side, 0, 0);
      btRigidBody& cube = world.addBody(std::make_unique<btBoxShape>(btVector3(0.5, 0.5, 0.5)),
                                        btTransform(pose.getBasis(), place + arm), btScalar(mass));
      cube.setAngularVelocity(spin);
      cube.setLinearVelocity(spin.cross(arm));
      cubes_.push_back(&cube);
    }
    for (const btScalar height : {btScalar(0.4), btScalar(-0.4)}) {
      const btTransform weld = pose * BulletWorld::at({0, height, 0});
      const auto from = [&](const btRigidBody& cube) {
        return cube.getWorldTransform().inverse() * weld;
      };
      welds_.push_back(&world.addJoint<btFixedConstraint>(*cubes_[0], *cubes_[1], from(*cubes_[0]),
                                                          from(*cubes_[1])));
    }
  }
  /// The impulse that holds one cube on its circle for a step, N·s.
  double load() const { return mass * spin.length2() * 0.5 * h; }
  double largestImpulse() const {
    double largest = 0;
    for (const btTypedConstraint* weld : welds_)
      largest = std::max(largest, std::abs(double(weld->getAppliedImpulse())));
    return largest;
  }

 private:
  static constexpr double mass = 1;
  const btVector3 spin{2, 4, 1};
  std::vector<btRigidBody*> cubes_;
  std::vector<btTypedConstraint*> welds_;
};

// A box that is welded to the world, and drawn at with a force that has a bound.
TEST(RedundantJoints, AWeldThatHoldsAgainstADriveContradictsNothing) {
  for (const double grip : {0.03, 30.0}) {
    OurWorld world;
    world->setGravity({0, 0, 0});
    btRigidBody& box = world.addBox({0.5, 0.5, 0.5}, {4, 0, 0});
    world.addJoint<btFixedConstraint>(box, btTypedConstraint::getFixedBody(),
                                      BulletWorld::at({0, 0, 0}), BulletWorld::at({4, 0, 0}));
    auto& drag = world.addJoint<btPoint2PointConstraint>(
        box, btVector3(btScalar(0.2), btScalar(0.1), btScalar(0.5)));
    drag.m_setting.m_impulseClamp = btScalar(grip);
    for (int step = 0; step < 30; ++step) {
      drag.setPivotB(btVector3(btScalar(4.2 + 0.1 * step), btScalar(0.1 * step), 0.5));
      world.advance();
      EXPECT_EQ(world.report().incompatible, 0) << grip << " at step " << step;
    }
    EXPECT_LT((box.getWorldTransform().getOrigin() - btVector3(4, 0, 0)).length(), 1e-3);
  }
}

// What rounding makes the welds ask of each other must be no load, or thresholds would break them.
TEST(RedundantJoints, WeldsThatSpinCarryWhatTurnsThemAndLittleMore) {
  for (const btScalar far : {btScalar(0), btScalar(30)}) {
    OurWorld world;
    const SpinningPair pair(world, {far, far, 0});
    for (int i = 0; i < 120; ++i) {
      world.advance();
      ASSERT_LE(pair.largestImpulse(), 2 * pair.load()) << "step " << i << " at " << far << " m";
      ASSERT_EQ(world.report().incompatible, 0) << "step " << i << " at " << far << " m";
    }
  }
}

// A ball strikes two welded boxes at rest: the error of the weld stays as small as ever beside what
// it bears.
TEST(RedundantJoints, WhatRestsMayBeStruck) {
  DelassusWorld world;
  world->setGravity({0, 0, 0});
  btRigidBody& first = world.addBox({0.25, 0.25, 0.25}, {0, 0, 0}, 1);
  btRigidBody& second = world.addBox({0.25, 0.25, 0.25}, {btScalar(0.6), 0, 0}, 1);
  btTransform ofFirst = btTransform::getIdentity(), ofSecond = btTransform::getIdentity();
  ofFirst.setOrigin({btScalar(0.3), 0, 0});
  ofSecond.setOrigin({btScalar(-0.3), 0, 0});
  world.addJoint<btFixedConstraint>(first, second, ofFirst, ofSecond);
  btRigidBody& ball = world.addSphere(btScalar(0.2), {-1, btScalar(0.05), btScalar(0.02)}, 1);
  ball.setLinearVelocity({10, 0, 0});
  for (int step = 0; step < 30; ++step) {
    world.advance();
    EXPECT_EQ(world.report().incompatible, 0) << step;
  }
  EXPECT_GT(second.getLinearVelocity().x(), 1);
}

// Two boxes hang together by a pivot and a hinge beside it, which hold two motions twice. They are
// thrown, land and lie: energy is only lost.
TEST(RedundantJoints, APairThatIsHeldTwiceGainsNothing) {
  constexpr double gain = 0.1;  // J, of the 40 that they begin with
  DelassusWorld world;
  world.addGround();
  btRigidBody& a = world.addBox({btScalar(0.3), btScalar(0.2), btScalar(0.2)}, {0, 2, 0}, 1);
  btRigidBody& b =
      world.addBox({btScalar(0.3), btScalar(0.2), btScalar(0.2)}, {btScalar(0.8), 2, 0}, 1);
  const btVector3 inA(btScalar(0.4), 0, 0), inB(btScalar(-0.4), 0, 0), aside(0, 0, btScalar(0.2));
  const btVector3 axis =
      quatRotate(btQuaternion(btVector3(btScalar(0.3), 0.5, 1).normalized(), 0.5), {0, 0, 1});
  a.setIgnoreCollisionCheck(&b, true);
  b.setIgnoreCollisionCheck(&a, true);
  world.addJoint<btPoint2PointConstraint>(a, b, inA, inB);
  world.addJoint<btHingeConstraint>(a, b, inA + aside, inB + aside, axis, axis);
  a.setAngularVelocity({3, 4, 2});
  b.setLinearVelocity({0, -1, 1});
  const auto energy = [&] {
    double sum = 0;
    for (const btRigidBody* body : {&a, &b})
      sum += 0.5 * body->getLinearVelocity().length2() +
             0.5 * body->getAngularVelocity().dot(body->getInvInertiaTensorWorld().inverse() *
                                                  body->getAngularVelocity()) +
             body->getWorldTransform().getOrigin().y() * g;
    return sum;
  };
  double before = energy();
  for (int step = 0; step < 300; ++step) {
    world.advance();
    const double after = energy();
    ASSERT_LT(after, before + gain) << step;
    before = after;
  }
}

}  // namespace
}  // namespace delassus::test
