/// What stands on bodies that the program moves: their motion is its own, and drives nothing of it.
/// (Bullet moves them before the step.)

#include <BulletDynamics/ConstraintSolver/btHingeConstraint.h>
#include <BulletDynamics/ConstraintSolver/btPoint2PointConstraint.h>
#include <BulletDynamics/ConstraintSolver/btSliderConstraint.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "tests/support/bullet_world.h"
#include "tests/support/welds.h"

namespace delassus::test {
namespace {

btRigidBody& addMoved(DelassusWorld& world, const btVector3& half, const btVector3& at) {
  btRigidBody& body = world.addBox(half, at, 0);
  body.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
  body.setActivationState(DISABLE_DEACTIVATION);
  return body;
}

/// Where a platform is at a time, s.
using Motion = std::function<btTransform(double)>;

Motion turning(const btVector3& axis, const std::function<double(double)>& angle) {
  return [=](double t) { return btTransform(btQuaternion(axis, btScalar(angle(t)))); };
}
Motion going(const btVector3& axis, const std::function<double(double)>& way) {
  return [=](double t) { return DelassusWorld::at(btScalar(way(t)) * axis); };
}
Motion rolling() {
  return turning({0, 0, 1}, [](double t) { return 0.2 * std::sin(t); });
}
std::vector<Motion> motions() {
  return {going({0, 1, 0}, [](double t) { return 0.2 * std::sin(t); }),
          going({1, 0, 0}, [](double t) { return 0.3 * std::sin(t); }),
          turning({0, 1, 0}, [](double t) { return 0.5 * t; }),
          turning({1, 0, 0}, [](double t) { return 1e-7 * t; })};
}

/// A platform, of one body or of two that move as one, and what is bolted to it and overlaps it: a
/// block, across the seam of the two, and a post with a door.
struct Platform {
  DelassusWorld world;
  std::vector<btRigidBody*> parts;
  std::vector<btTransform> starts;
  std::vector<btFixedConstraint*> bolts;
  btRigidBody* door;

  Platform(bool isDivided, double overlap) {
    const auto height = btScalar(0.1), top = btScalar(0.1 - overlap);
    if (isDivided) {
      addPart({2.5, height, 4}, {-1.5, 0, 0});
      addPart({1.5, height, 4}, {2.5, 0, 0});
    } else {
      addPart({4, height, 4}, {0, 0, 0});
    }
    const auto half = btScalar(0.3), thin = btScalar(0.05);
    bolt(*parts.back(), world.addBox({half, half, half}, {btScalar(1.1), top + half, 1}, 20));
    btRigidBody& post = world.addBox({thin, 1, thin}, {btScalar(-0.55), top + 1, 0}, 50);
    bolt(*parts.front(), post);
    door = &world.addBox({btScalar(0.5), 1, btScalar(0.04)}, {0, top + 1, 0}, 20);
    door->setIgnoreCollisionCheck(&post, true);
    const btVector3 axis(0, 1, 0);
    world.addJoint<btHingeConstraint>(post, *door, btVector3(thin, 0, 0),
                                      btVector3(btScalar(-0.5), 0, 0), axis, axis);
    door->setAngularVelocity({0, 2, 0});
    door->setLinearVelocity({0, 0, -1});
  }
  void addPart(const btVector3& half, const btVector3& at) {
    parts.push_back(&addMoved(world, half, at));
    starts.push_back(parts.back()->getWorldTransform());
  }
  void bolt(btRigidBody& part, btRigidBody& body) {
    const btTransform place = part.getWorldTransform().inverse() * body.getWorldTransform();
    bolts.push_back(
        &world.addJoint<btFixedConstraint>(part, body, place, btTransform::getIdentity()));
    bolts.back()->setBreakingImpulseThreshold(500);
  }
  void move(const btTransform& to) {
    for (std::size_t i = 0; i < parts.size(); ++i) parts[i]->setWorldTransform(to * starts[i]);
    world.advance();
  }
};

void expectGoesAlong(const Motion& motion, bool isDivided) {
  for (const double overlap : {1e-3, 0.01}) {
    SCOPED_TRACE("overlap " + std::to_string(overlap));
    Platform platform(isDivided, overlap);
    for (int step = 0; step < 60; ++step) {
      platform.move(motion((step + 1) * BulletWorld::step));
      ASSERT_EQ(notSolvedOf(platform.world), 0) << step;
    }
    for (const btFixedConstraint* bolt : platform.bolts) EXPECT_TRUE(bolt->isEnabled());
    const btVector3 own = platform.door->getAngularVelocity(),
                    ofPlatform = platform.parts.front()->getAngularVelocity();
    EXPECT_GT((own - ofPlatform).length(), 1.5);
  }
}

TEST(MovedBodies, WhatStandsOnOneGoesAlong) {
  for (const Motion& motion : motions()) expectGoesAlong(motion, false);
  expectGoesAlong(rolling(), false);
}

TEST(MovedBodies, WhatStandsOnSeveralThatMoveAsOneGoesAlong) {
  for (const Motion& motion : motions()) expectGoesAlong(motion, true);
  // In float, Bullet takes the velocity of slow turns from too few digits.
  if (!std::is_same_v<btScalar, float>) expectGoesAlong(rolling(), true);
}

// A machine of two welded bodies and a wheel is sunk deep into a deck that goes down, and is ahead
// of it by a step.
TEST(MovedBodies, WhatIsSunkInADeckStaysThere) {
  for (const double speed : {0.2, 3.0}) {
    SCOPED_TRACE(speed);
    DelassusWorld world;
    btRigidBody& deck = addMoved(world, {3, 0.5, 3}, {0, -0.5, 0});
    btRigidBody &block = world.addBox({0.25, 0.25, 0.25}, {1, btScalar(0.15), 0}, 20),
                &post = world.addBox({btScalar(0.1), btScalar(0.3), btScalar(0.1)},
                                     {1, btScalar(0.68), 0}, 5);
    addWeld(world, deck, post);
    addWeld(world, post, block);
    const auto radius = btScalar(0.15);
    btRigidBody& wheel = world.addBody(std::make_unique<btSphereShape>(radius),
                                       DelassusWorld::at({1, radius - btScalar(0.1), 0.5}), 1);
    const btVector3 axis(0, 0, 1);
    world.addJoint<btHingeConstraint>(block, wheel, btVector3(0, radius - btScalar(0.25), 0.5),
                                      btVector3(0, 0, 0), axis, axis);
    for (int step = 1; step <= 60; ++step) {
      deck.setWorldTransform(
          DelassusWorld::at({0, btScalar(-0.5 - speed * BulletWorld::step * step), 0}));
      world.advance();
      ASSERT_EQ(notSolvedOf(world), 0) << step;
    }
    world.clear();
  }
}

// A door on a hinge, which overlaps the floor, is opened by a rod that the program moves.
TEST(MovedBodies, ADoorThatARodOpensGrazesTheFloor) {
  DelassusWorld world;
  world.addGround();
  const auto overlap = btScalar(1e-3), height = btScalar(1.2), reach = btScalar(0.36);
  btRigidBody &door = world.addBox({0.5, 1, btScalar(0.04)}, {0, 1 - overlap, 0}, 20),
              &rod = world.addBox({btScalar(0.02), btScalar(0.02), reach},
                                  {btScalar(0.2), height, btScalar(-0.42)}, 1),
              &hand = addMoved(world, {btScalar(0.02), btScalar(0.02), btScalar(0.02)},
                               {btScalar(0.2), height, btScalar(-0.8)});
  const double weight = 21 * g * BulletWorld::step;  // of door and rod, N·s a step
  const btVector3 axis(0, 1, 0);
  world.addJoint<btHingeConstraint>(door, btVector3(-0.5, 0, 0), axis);
  rod.setIgnoreCollisionCheck(&door, true);
  rod.setIgnoreCollisionCheck(&hand, true);
  world.addJoint<btPoint2PointConstraint>(hand, rod, btVector3(0, 0, btScalar(0.02)),
                                          btVector3(0, 0, -reach));
  world.addJoint<btPoint2PointConstraint>(
      rod, door, btVector3(0, 0, reach),
      btVector3(btScalar(0.2), height - 1 + overlap, btScalar(-0.06)));
  for (int step = 1; step <= 120; ++step) {
    const double way = 0.1 * BulletWorld::step * step;
    hand.setWorldTransform(DelassusWorld::at({btScalar(0.2), height, btScalar(-0.8 + way)}));
    world.advance();
    ASSERT_EQ(notSolvedOf(world), 0) << step;
    double pressed = 0;
    for (const btManifoldPoint* point : world.points()) pressed += point->getAppliedImpulse();
    ASSERT_LT(pressed, 1.1 * weight) << step;
  }
  EXPECT_GT(std::abs(door.getOrientation().getAngle()), 0.2);
}

// Two platforms close on each other, each with a link on a hinge. A slider between the links lets
// them close until a plate on one of them meets the other: nothing then gives way.
TEST(MovedBodies, WhatStandsOnTwoIsPressed) {
  DelassusWorld world;
  world->setGravity({0, 0, 0});
  btRigidBody *platforms[2], *links[2];
  const auto reach = btScalar(0.35);
  const auto placeOf = [](int i, double closer) {
    return DelassusWorld::at({btScalar((i == 0 ? -1 : 1) * (1 - closer)), 0, 0});
  };
  for (int i = 0; i < 2; ++i) {
    const btScalar side = i == 0 ? -1 : 1;
    platforms[i] = &addMoved(world, {btScalar(0.1), 0.5, 0.5}, placeOf(i, 0).getOrigin());
    links[i] = &world.addBox({btScalar(0.2), btScalar(0.1), btScalar(0.1)},
                             {btScalar(0.45) * side, 0, 0}, 5);
    platforms[i]->setIgnoreCollisionCheck(links[i], true);
    world.addJoint<btHingeConstraint>(
        *platforms[i], *links[i], btVector3(btScalar(-0.2) * side, 0, 0),
        btVector3(reach * side, 0, 0), btVector3(0, 0, 1), btVector3(0, 0, 1));
  }
  btRigidBody& plate =
      world.addBox({btScalar(0.1), btScalar(0.1), btScalar(0.1)}, {btScalar(0.15), 0, 0}, 1);
  addWeld(world, *links[1], plate);
  links[0]->setIgnoreCollisionCheck(links[1], true);
  auto& slider = world.addJoint<btSliderConstraint>(
      *links[0], *links[1], DelassusWorld::at({btScalar(0.3), 0, 0}),
      DelassusWorld::at({btScalar(-0.3), 0, 0}), true);
  slider.setLowerLinLimit(-1);
  slider.setUpperLinLimit(1);
  slider.setLowerAngLimit(0);
  slider.setUpperAngLimit(0);
  constexpr double speed = 0.1, free = 0.3;
  for (int step = 1; step <= 120; ++step) {
    const double closer = speed * BulletWorld::step * step, overlap = 2 * closer - free;
    for (int i = 0; i < 2; ++i) platforms[i]->setWorldTransform(placeOf(i, closer));
    world.advance();
    if (std::abs(overlap) < 0.01) continue;
    EXPECT_EQ(notSolvedOf(world) > 0, overlap > 0) << step;
  }
}

}  // namespace
}  // namespace delassus::test
