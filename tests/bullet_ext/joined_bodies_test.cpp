/// Bodies that a joint links and that collide all the same, or have ceased to collide.

#include <BulletDynamics/ConstraintSolver/btFixedConstraint.h>
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <vector>

#include "bullet_ext/softness.h"
#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

/// A box that overlaps a wall by `depth` and is held to it.
struct Bolted {
  DelassusWorld world;
  btRigidBody *wall, *box;
  btTypedConstraint* joint;
  btTransform place;
  btJointFeedback feedback;

  Bolted(double depth, bool isFixed) {
    wall = &world.addBox({1, 1, 1}, {0, 0, 0}, 0);
    box = &world.addBox({0.25, 0.25, 0.25}, {0, btScalar(1.25 - depth), 0});
    place = box->getWorldTransform();
    if (isFixed)
      joint = &world.addJoint<btFixedConstraint>(*wall, *box, place, btTransform::getIdentity());
    else
      joint = &world.addJoint<btPoint2PointConstraint>(*box, *wall, btVector3(0, 0, 0),
                                                       place.getOrigin());
    joint->setJointFeedback(&feedback);
  }
};

// A joint that leaves all play, as one that only a spring or a limit makes use of, is no bond.
TEST(JoinedBodies, AreThoseThatAJointHolds) {
  constexpr int boxes = 5;
  constexpr double heavy = 500;
  const auto sunk = [](bool hasSpring2, bool isLocked) {
    DelassusWorld world;
    world.addGround();
    btRigidBody* below = nullptr;
    for (int i = 0; i <= boxes; ++i) {
      btRigidBody& box = world.addCube({0, btScalar(0.5) + i, 0}, i < boxes ? 1 : btScalar(heavy));
      const btTransform up = world.at({0, btScalar(0.5), 0}),
                        down = world.at({0, btScalar(-0.5), 0});
      const btVector3 most(1, 1, 1), least = isLocked ? btVector3(1, -1, -1) : -most;
      const auto leavePlay = [&](auto& joint) {
        joint.setLinearLowerLimit(least);
        joint.setLinearUpperLimit(most);
      };
      if (below && hasSpring2)
        leavePlay(world.addJoint<btGeneric6DofSpring2Constraint>(*below, box, up, down));
      else if (below)
        leavePlay(world.addJoint<btGeneric6DofConstraint>(*below, box, up, down, true));
      below = &box;
    }
    world.advance(60);
    return boxes + 0.5 - below->getWorldTransform().getOrigin().y();
  };
  for (const bool hasSpring2 : {false, true}) {
    EXPECT_NEAR(sunk(hasSpring2, false), 0, tolerance(1e-6, 1e-3));
    EXPECT_GT(sunk(hasSpring2, true), 0.01) << "contacts of joined bodies give";
  }
}

// By default, bodies that a joint links collide in Bullet. The joint holds, and they press no
// harder than contacts that give by joinedSoftness.
TEST(JoinedBodies, DoNotPressWithoutBounds) {
  for (const double depth : {0.02, 0.1})
    for (const bool isFixed : {true, false}) {
      SCOPED_TRACE(testing::Message() << depth << (isFixed ? ", fixed" : ", point to point"));
      Bolted bolted(depth, isFixed);
      const double push = 0.2 * depth / h / bullet::joinedSoftness / h;  // N
      for (int step = 0; step < 60; ++step) {
        bolted.world.advance();
        ASSERT_EQ(bolted.world.report().solved, 1);
        ASSERT_LT(bolted.feedback.m_appliedForceBodyA.length(), 1.1 * push);
      }
      const double pull = bolted.feedback.m_appliedForceBodyA.length();
      if (isFixed)
        EXPECT_NEAR(pull, g, tolerance(1e-6, 1e-3)) << "no push could move it (held_contacts.h)";
      else
        EXPECT_GT(pull, 0.1 * push) << "they do collide";
      const btVector3 moved =
          bolted.box->getWorldTransform().getOrigin() - bolted.place.getOrigin();
      EXPECT_LT(moved.length(), tolerance(1e-6, 1e-4));
    }
}

TEST(JoinedBodies, OverlapIsMendedOnceTheJointIsGone) {
  Bolted bolted(0.1, true);
  bolted.world.advance(10);
  bolted.joint->setEnabled(false);
  bolted.world.advance(120);
  EXPECT_NEAR(bolted.box->getWorldTransform().getOrigin().y(), 1.25, 1e-3);
}

/// Adds one of Bullet's joints that hold, between the centres of two bodies.
using Hold = std::function<btTypedConstraint&(DelassusWorld&, btRigidBody&, btRigidBody&)>;
const btTransform centre = btTransform::getIdentity();
template <class Joint>
btTypedConstraint& framed(DelassusWorld& world, btRigidBody& a, btRigidBody& b) {
  return world.addJoint<Joint>(a, b, centre, centre, true);
}
const std::vector<Hold> holds{
    [](auto& world, auto& a, auto& b) -> btTypedConstraint& {
      return world.template addJoint<btPoint2PointConstraint>(a, b, btVector3(0, 0, 0),
                                                              btVector3(0, 0, 0));
    },
    framed<btHingeConstraint>,
    framed<btSliderConstraint>,
    framed<btGeneric6DofConstraint>,
    framed<btGeneric6DofSpringConstraint>,
    [](auto& world, auto& a, auto& b) -> btTypedConstraint& {
      return world.template addJoint<btConeTwistConstraint>(a, b, centre, centre);
    },
    [](auto& world, auto& a, auto& b) -> btTypedConstraint& {
      return world.template addJoint<btGeneric6DofSpring2Constraint>(a, b, centre, centre);
    },
    [](auto& world, auto& a, auto& b) -> btTypedConstraint& {
      return world.template addJoint<btFixedConstraint>(a, b, centre, centre);
    }};

// Split impulse pushes a deep overlap out, unless a joint holds the two bodies now.
TEST(JoinedBodies, AreThoseOfEveryJointThatHolds) {
  for (std::size_t kind = 0; kind < holds.size(); ++kind) {
    SCOPED_TRACE(kind);
    DelassusWorld world;
    btRigidBody& wall = world.addBox({1, 1, 1}, {0, 0, 0}, 0);
    btRigidBody& box = world.addBox({0.25, 0.25, 0.25}, {0, btScalar(1.15), 0});
    btTypedConstraint& joint = holds[kind](world, wall, box);
    joint.setEnabled(false);
    world.advance();
    EXPECT_EQ(world.report().pushIslands, 1) << "a disabled joint holds nothing";
    joint.setEnabled(true);
    world.advance();
    EXPECT_EQ(world.report().pushIslands, 0);
  }
}

// A gear does not hold its bodies in place.
TEST(JoinedBodies, AreNotThoseOfAGear) {
  DelassusWorld world;
  btRigidBody& wall = world.addBox({1, 1, 1}, {0, 0, 0}, 0);
  btRigidBody& box = world.addBox({0.25, 0.25, 0.25}, {0, btScalar(1.15), 0});
  world.addJoint<btGearConstraint>(wall, box, btVector3(1, 0, 0), btVector3(1, 0, 0));
  world.advance();
  EXPECT_EQ(world.report().pushIslands, 1);
}

// The softness of the contact is measured by the response of the heavy body.
TEST(JoinedBodies, AHeavyOneDoesNotSinkIntoALightOne) {
  DelassusWorld world;
  world.addGround();
  btRigidBody& plate = world.addBox({1, btScalar(0.1), 1}, {0, btScalar(0.1), 0}, 1);
  btRigidBody& load = world.addBox({0.5, 0.5, 0.5}, {0, btScalar(0.7), 0}, 1000);
  const btQuaternion upright(btVector3(0, 0, 1), SIMD_HALF_PI);
  auto& slider =
      world.addJoint<btSliderConstraint>(plate, load, btTransform(upright, {0, btScalar(0.1), 0}),
                                         btTransform(upright, {0, btScalar(-0.5), 0}), true);
  slider.setLowerLinLimit(-5);
  slider.setUpperLinLimit(5);
  world.advance(120);
  EXPECT_NEAR(load.getWorldTransform().getOrigin().y(), 0.7, 1e-3);
  EXPECT_LT(load.getLinearVelocity().length(), 1e-3);
}

// Where the joint leaves the bodies free, the contact stops them and mends their overlap.
TEST(JoinedBodies, CollideAsOthersDo) {
  for (const double overlap : {-0.2, 0.01}) {
    SCOPED_TRACE(overlap);
    DelassusWorld world;
    world->setGravity({0, 0, 0});
    btRigidBody& wall = world.addBox({0.5, 0.5, 0.5}, {0, 0, 0}, 0);
    btRigidBody& box = world.addBox({0.5, 0.5, 0.5}, {btScalar(1 - overlap), 0, 0});
    auto& slider = world.addJoint<btSliderConstraint>(wall, box, btTransform::getIdentity(),
                                                      btTransform::getIdentity(), true);
    slider.setLowerLinLimit(-5);
    slider.setUpperLinLimit(5);
    box.setLinearVelocity({-1, 0, 0});
    world.advance(60);
    EXPECT_GT(box.getWorldTransform().getOrigin().x(), 1);
    EXPECT_LT(box.getLinearVelocity().length(), 0.2) << "that of a shallow overlap's recovery";
  }
}

// Two boxes touch when a weld joins them and ends their collisions. Bullet keeps their points where
// they were.
TEST(JoinedBodies, WhatIsWeldedWhileItTouchesTouchesNoMore) {
  DelassusWorld world;
  world->setGravity({0, 0, 0});
  btRigidBody& a = world.addCube({0, 0, 0});
  btRigidBody& b = world.addCube({btScalar(0.1), btScalar(0.999), btScalar(0.1)});
  world.advance(2);
  const auto in = [](const btRigidBody& body) {
    return body.getWorldTransform().inverse() *
           btTransform(btQuaternion::getIdentity(),
                       {btScalar(0.05), btScalar(0.5), btScalar(0.05)});
  };
  auto weld = std::make_unique<btFixedConstraint>(a, b, in(a), in(b));
  world->addConstraint(weld.get(), true);
  // The two turn as one body about their common centre.
  const btVector3 spin(0, 0, 2),
      centre = (a.getCenterOfMassPosition() + b.getCenterOfMassPosition()) / 2;
  for (btRigidBody* body : {&a, &b}) {
    body->setAngularVelocity(spin);
    body->setLinearVelocity(spin.cross(body->getCenterOfMassPosition() - centre));
  }
  world.advance(60);
  EXPECT_EQ(world.report().contacts, 0);
  for (const btRigidBody* body : {&a, &b})
    EXPECT_NEAR(body->getAngularVelocity().length(), 2, 0.05);
  world->removeConstraint(weld.get());
}

}  // namespace
}  // namespace delassus::test
