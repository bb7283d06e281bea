/// Bodies: free velocity, kinematic and static bodies, locked axes (Bullet's contract, bodies).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

void expectSameMotion(const btRigidBody& a, const btRigidBody& b, double allowed) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(a.getWorldTransform().getOrigin()[i], b.getWorldTransform().getOrigin()[i],
                allowed);
    EXPECT_NEAR(a.getLinearVelocity()[i], b.getLinearVelocity()[i], allowed);
    EXPECT_NEAR(a.getAngularVelocity()[i], b.getAngularVelocity()[i], allowed);
  }
}

TEST(Parity, Row01FreeFall) {
  DelassusWorld ours;
  StockWorld stock;
  const btRigidBody& a = ours.addCube({0, 100, 0});
  const btRigidBody& b = stock.addCube({0, 100, 0});
  ours.advance(60);
  stock.advance(60);
  expectSameMotion(a, b, 60 * 100 * precision);
}

TEST(Parity, Row02UserForceAndTorqueLastOverAllSubsteps) {
  DelassusWorld ours;
  StockWorld stock;
  const auto run = [](BulletWorld& world) -> const btRigidBody& {
    btRigidBody& body = world.addBox({0.5, 0.3, 0.2}, {0, 10, 0}, 2);
    body.applyCentralForce({3, 4, 5});
    body.applyTorque({0.1, 0.2, -0.3});
    world->stepSimulation(4 * BulletWorld::step, 4, BulletWorld::step);
    return body;
  };
  expectSameMotion(run(ours), run(stock), 1e3 * precision);
}

/// A body with three different moments of inertia, spun about the middle one.
btRigidBody& addHandle(BulletWorld& world, int gyroscopicFlag,
                       const btVector3& inertia = btVector3(1, 2, 3)) {
  btRigidBody& body = world.addCube({0, 0, 0});
  body.setMassProps(1, inertia);
  body.updateInertiaTensor();
  body.setFlags(gyroscopicFlag);
  body.setAngularVelocity({btScalar(0.01), 2, btScalar(0.01)});
  return body;
}

TEST(Parity, Row03GyroscopicModes) {
  for (int flag :
       {0, int(BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT), int(BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD),
        int(BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY)}) {
    SCOPED_TRACE(flag);
    DelassusWorld ours;
    StockWorld stock;
    ours->setGravity({0, 0, 0});
    stock->setGravity({0, 0, 0});
    const btRigidBody& a = addHandle(ours, flag);
    const btRigidBody& b = addHandle(stock, flag);
    ours.advance(600);
    stock.advance(600);
    // Spin about the middle axis is unstable: rounding grows a thousandfold in ten seconds.
    expectSameMotion(a, b, tolerance(1e-9, 1e-2));
  }
}

// Two equal moments of inertia do not make a ball: gyroscopic terms still act.
TEST(Parity, Row03ADiscWobblesWhicheverItsAxis) {
  for (const int axis : {0, 1, 2}) {
    btVector3 inertia(1, 1, 1);
    inertia[axis] = 2;
    const auto wobble = [&](BulletWorld& world) {
      world->setGravity({0, 0, 0});
      btRigidBody& disc = addHandle(world, BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY, inertia);
      disc.setAngularVelocity({1, 2, 3});
      world.advance(60);
      return disc.getAngularVelocity();
    };
    DelassusWorld ours;
    StockWorld stock;
    const btVector3 turning = wobble(ours);
    EXPECT_GT((turning - btVector3(1, 2, 3)).length(), 0.1) << axis;
    EXPECT_NEAR((turning - wobble(stock)).length(), 0, tolerance(1e-9, 1e-3)) << axis;
  }
}

// Bullet's implicit gyroscopic terms divide by the inertia, which may be zero about an axis.
TEST(Parity, Row03AnAxisWithoutInertiaMakesNoBrokenBody) {
  for (const int flag : {int(BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD),
                         int(BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY)}) {
    DelassusWorld world;
    btRigidBody& body = addHandle(world, flag, {0, 0, 3});
    body.setAngularVelocity({0, 0, 2});
    world.advance(10);
    EXPECT_TRUE(world.report().messages.empty()) << flag;
    EXPECT_NEAR(body.getLinearVelocity().y(), -10 * g * h, 1e3 * precision) << flag;
    EXPECT_NEAR(body.getAngularVelocity().z(), 2, 100 * precision) << flag;
  }
}

TEST(Parity, Row03GyroscopicTermsDoNotLeakIntoLockedAxes) {
  DelassusWorld world;
  world->setGravity({0, 0, 0});
  btRigidBody& body = addHandle(world, BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY);
  body.setAngularVelocity({1, 2, 0});
  body.setAngularFactor({1, 1, 0});
  world.advance(60);
  EXPECT_EQ(body.getAngularVelocity().z(), 0);
}

// The length of Bullet's explicit terms, −ω × I ω, is bounded.
TEST(Parity, Row03ExplicitGyroscopicTorqueHasAMaximum) {
  const btVector3 inertia(1, 2, 3), omega(3, 4, 5);
  for (const double most : {100.0, 1.0, 0.0}) {
    const auto gain = [&](BulletWorld& world) {
      btRigidBody& body = addHandle(world, BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT);
      body.setAngularVelocity(omega);
      world.info().m_maxGyroscopicForce = btScalar(most);
      world.advance();
      return body.getAngularVelocity() - omega;
    };
    DelassusWorld ours;
    StockWorld stock;
    const btVector3 gained = gain(ours), torque = inertia * gained / BulletWorld::step;
    const double whole = omega.cross(inertia * omega).length();
    EXPECT_NEAR(torque.length(), std::min(whole, most), 1e4 * precision);
    EXPECT_NEAR((gained - gain(stock)).length(), 0, 100 * precision);
  }
}

TEST(Parity, Row04DampingIsAppliedOnce) {
  DelassusWorld world;
  world->setGravity({0, 0, 0});
  btRigidBody& body = world.addCube({0, 0, 0});
  body.setDamping(btScalar(0.3), 0);
  body.setLinearVelocity({1, 0, 0});
  world.advance(60);
  EXPECT_NEAR(body.getLinearVelocity().x(), 0.7, 1e3 * precision);
}

btRigidBody& addPlatform(BulletWorld& world, btScalar leftoverMass) {
  btRigidBody& platform = world.addBox({5, 0.5, 5}, {0, -0.5, 0}, leftoverMass);
  platform.setCollisionFlags(platform.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
  platform.setFriction(1);
  return platform;
}

TEST(Parity, Row05KinematicPlatformCarriesABox) {
  for (btScalar leftoverMass : {0, 5}) {
    DelassusWorld world;
    btRigidBody& platform = addPlatform(world, leftoverMass);
    btRigidBody& box = world.addCube({0, btScalar(0.5), 0}, 100);
    for (int i = 1; i <= 120; ++i) {
      const btTransform pose = BulletWorld::at({i * BulletWorld::step, btScalar(-0.5), 0});
      platform.setWorldTransform(pose);
      world.advance();
      EXPECT_EQ(platform.getWorldTransform(), pose) << "a kinematic body is never written";
    }
    EXPECT_NEAR(box.getLinearVelocity().x(), 1, tolerance(1e-8, 1e-4)) << leftoverMass;
    EXPECT_NEAR(box.getLinearVelocity().y(), 0, tolerance(1e-8, 1e-4)) << leftoverMass;
  }
}

TEST(Parity, Row05RotatingPlatformTurnsABox) {
  DelassusWorld world;
  btRigidBody& platform = addPlatform(world, 0);
  btRigidBody& box = world.addCube({0, btScalar(0.5), 0});
  const btScalar spin = btScalar(0.5);
  for (int i = 1; i <= 120; ++i) {
    platform.setWorldTransform(
        btTransform(btQuaternion(btVector3(0, 1, 0), spin * i * BulletWorld::step),
                    btVector3(0, btScalar(-0.5), 0)));
    world.advance();
  }
  // Bullet derives the platform's velocity from its poses; in float this velocity is noisy itself.
  EXPECT_NEAR(box.getAngularVelocity().y(), platform.getAngularVelocity().y(),
              tolerance(1e-6, 1e-3));
  EXPECT_NEAR(box.getAngularVelocity().y(), spin, tolerance(1e-6, 1e-2));
}

TEST(Parity, Row06VelocityOfAStaticBodyIsIgnored) {
  DelassusWorld world;
  btRigidBody& ground = world.addGround();
  btRigidBody& box = world.addCube({0, btScalar(0.5), 0});
  ground.setLinearVelocity({5, 0, 0});
  world.advance(60);
  EXPECT_NEAR(box.getWorldTransform().getOrigin().x(), 0, tolerance(1e-10, 1e-5));
}

// Nor does the velocity of a body without mass count, even if its static flag has been cleared.
TEST(Parity, Row06VelocityOfABodyWithoutMassIsIgnored) {
  const auto drift = [](BulletWorld& world) {
    btRigidBody& ground = world.addGround();
    ground.setCollisionFlags(0);
    btRigidBody& box = world.addCube({0, btScalar(0.5), 0});
    ground.setLinearVelocity({5, 0, 0});
    world.advance(5);
    return box.getLinearVelocity().x();
  };
  DelassusWorld ours;
  StockWorld stock;
  EXPECT_NEAR(drift(ours), 0, tolerance(1e-10, 1e-5));
  EXPECT_NEAR(drift(stock), 0, tolerance(1e-10, 1e-5));
}

TEST(Parity, Row07NoMotionInLockedAxes) {
  DelassusWorld world;
  world.addGround();
  std::vector<btRigidBody*> boxes;
  for (int i = 0; i < 6; ++i) {
    // The poses are turned and shifted out of the plane, so that contacts do push along locked
    // axes.
    btTransform pose(
        btQuaternion(btVector3(1, 2, 3).normalized(), btScalar(0.2) * i),
        btVector3(btScalar(0.3) * (i % 2), 1 + btScalar(1.3) * i, btScalar(0.1) * (i % 3)));
    btRigidBody& box =
        world.addBody(std::make_unique<btBoxShape>(btVector3(0.5, 0.5, 0.5)), pose, 1);
    box.setLinearFactor({1, 1, 0});
    box.setAngularFactor({0, 0, 1});
    boxes.push_back(&box);
  }
  std::vector<btScalar> z;
  for (btRigidBody* box : boxes) z.push_back(box->getWorldTransform().getOrigin().z());
  world.info().m_splitImpulse = false;
  world.advance(120);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    EXPECT_EQ(boxes[i]->getWorldTransform().getOrigin().z(), z[i]);
    EXPECT_EQ(boxes[i]->getAngularVelocity().x(), 0);
    EXPECT_EQ(boxes[i]->getAngularVelocity().y(), 0);
  }
}

TEST(Parity, Row42DisabledSimulationStaysWhereItIs) {
  DelassusWorld world;
  world.addGround();
  btRigidBody& frozen = world.addCube({0, 3, 0});
  frozen.forceActivationState(DISABLE_SIMULATION);
  // The free body is deep inside the frozen one: the push goes to the free body alone.
  btRigidBody& free = world.addCube({btScalar(0.1), btScalar(3.9), 0});
  world.advance(30);
  EXPECT_EQ(frozen.getWorldTransform().getOrigin(), btVector3(0, 3, 0));
  EXPECT_EQ(frozen.getLinearVelocity(), btVector3(0, 0, 0));
  EXPECT_GT(free.getWorldTransform().getOrigin().y(), 3.95);
}

}  // namespace
}  // namespace delassus::test
