/// Friction that depends on direction: anisotropic materials, directions and belts set by the user,
/// anchors (Bullet's contract, friction).

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "BulletCollision/NarrowPhaseCollision/btManifoldPoint.h"
#include "BulletDynamics/ConstraintSolver/btContactSolverInfo.h"
#include "bullet_ext/contact_frame.h"
#include "tests/support/bullet_world.h"
#include "tests/support/ground_plane.h"

namespace delassus::test {
namespace {

using namespace delassus::bullet;

/// The slip along x and z, the plane of the ground.
Vector2 slipOf(const btRigidBody& body) {
  return {body.getLinearVelocity().x(), body.getLinearVelocity().z()};
}

/// A ball that cannot turn: it has one contact point, and its axes stay. `yaw` turns it about y.
btRigidBody& addRunner(BulletWorld& world, double yaw, const Vector2& velocity) {
  const btTransform pose(btQuaternion(btVector3(0, 1, 0), btScalar(yaw)),
                         btVector3(0, btScalar(0.5), 0));
  btRigidBody& runner = world.addBody(std::make_unique<btSphereShape>(btScalar(0.5)), pose, 1);
  runner.setAngularFactor(0);
  runner.setLinearVelocity({btScalar(velocity[0]), 0, btScalar(velocity[1])});
  return runner;
}

/// Maximum dissipation on the ellipse { μ r_n D s : |s| ≤ 1 } while it slides: the velocity after
/// the step obeys v' = v − μ g h D Dᵀ v'/|Dᵀ v'|.
void expectEllipse(const Vector2& before, const Vector2& after, const Matrix2& D) {
  const Vector2 expected = before - friction * g * h * D * (D.transpose() * after).normalized();
  EXPECT_NEAR((after - expected).norm(), 0, tolerance(1e-9, 2e-6));
}

// Points of one manifold share a frame where they may, and only there.
TEST(ContactFrames, AreThoseOfTheirPointsInAnyOrder) {
  btContactSolverInfo info;
  info.m_solverMode |= SOLVER_ENABLE_FRICTION_DIRECTION_CACHING;
  const btVector3 up(0, 1, 0), askew = btVector3(1, 2, 2).normalized();
  const auto point = [](const btVector3& normal, int flags) {
    btManifoldPoint p({0, 0, 0}, {0, 0, 0}, normal, 0);
    p.m_positionWorldOnA = btVector3(btScalar(0.1), 0, btScalar(0.2));
    p.m_lateralFrictionDir1 = btVector3(btScalar(0.6), 0, btScalar(0.8));
    p.m_contactMotion1 = 3;
    p.m_contactPointFlags = flags;
    return p;
  };
  constexpr int own = BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED,
                anchored = BT_CONTACT_FLAG_FRICTION_ANCHOR;
  const std::vector<btManifoldPoint> points{point(up, 0),           point(up, 0), point(up, own),
                                            point(up, own),         point(up, 0), point(askew, 0),
                                            point(askew, 0),        point(up, 0), point(up, own),
                                            point(up, anchored),    point(up, 0), point(askew, own),
                                            point(-askew, anchored)};
  Anisotropy slippery;
  slippery.any = true;
  slippery.F = Vec3(1, 0.5, 0.25).asDiagonal();
  for (const Anisotropy& anisotropy : {Anisotropy(), slippery}) {
    ContactFrames frames(anisotropy, info);
    for (const btManifoldPoint& p : points) {
      const ContactFrame expected = contactFrame(p, anisotropy, info), &frame = frames.of(p);
      EXPECT_EQ(frame.axes, expected.axes);
      EXPECT_EQ(frame.motion1, expected.motion1);
      EXPECT_EQ(frame.motion2, expected.motion2);
      EXPECT_EQ(frame.softness, expected.softness);
    }
  }
}

TEST(Parity, Row20AnisotropicFrictionIsAnEllipse) {
  for (double yaw : {0.0, 0.4})
    for (double heading : {0.0, 0.3, 0.8, 1.5707963267948966}) {
      SCOPED_TRACE(::testing::Message() << yaw << " " << heading);
      DelassusWorld world;
      world.addGround();
      const Vector2 before(3 * std::cos(heading), 3 * std::sin(heading));
      btRigidBody& runner = addRunner(world, yaw, before);
      runner.setAnisotropicFriction({1, 1, btScalar(0.25)});
      world.advance();
      expectEllipse(before, slipOf(runner), stretch(1, 0.25, yaw));
    }
}

TEST(Parity, Row20AnisotropiesOfBothBodiesAreMultiplied) {
  DelassusWorld world;
  world.addGround().setAnisotropicFriction({btScalar(0.5), 1, 1});
  const Vector2 before(2, 1);
  btRigidBody& runner = addRunner(world, 0.4, before);
  runner.setAnisotropicFriction({1, 1, btScalar(0.25)});
  world.advance();
  // Bullet stretches by body 0 of the manifold first.
  const bool groundFirst = world.dispatcher().getManifoldByIndexInternal(0)->getBody1() == &runner;
  const Matrix2 ground = stretch(0.5, 1, 0), own = stretch(1, 0.25, 0.4);
  expectEllipse(before, slipOf(runner), groundFirst ? own * ground : ground * own);
}

TEST(Parity, Row20OnTheAxesFrictionIsThatOfStock) {
  for (int axis : {0, 2}) {
    DelassusWorld ours;
    StockWorld stock;
    const auto slide = [axis](BulletWorld& world) {
      world.addGround();
      Vector2 velocity = Vector2::Zero();
      velocity[axis / 2] = 3;
      btRigidBody& runner = addRunner(world, 0, velocity);
      runner.setAnisotropicFriction({btScalar(0.75), 1, btScalar(0.25)});
      world.advance(20);
      return slipOf(runner);
    };
    EXPECT_NEAR((slide(ours) - slide(stock)).norm(), 0, tolerance(1e-8, 1e-4)) << axis;
  }
}

TEST(Parity, Row20ASkateHoldsAcrossAndRunsAlong) {
  DelassusWorld world;
  world.addGround();
  btRigidBody& skate = addRunner(world, 0, {2, 0});
  skate.setAnisotropicFriction({0, 1, 1});
  for (int i = 0; i < 60; ++i) {
    skate.applyCentralForce({0, 0, btScalar(0.9 * friction * g)});
    world.advance();
    ASSERT_EQ(world.report().solved, 1);
  }
  // In float the narrow phase's normals lean by 1e-5.
  EXPECT_NEAR(skate.getLinearVelocity().x(), 2, tolerance(1e-9, 1e-3));
  EXPECT_NEAR(skate.getLinearVelocity().z(), 0, tolerance(1e-9, 1e-3));
}

TEST(Parity, Row20ImpulsesTimesDirectionsAreTheForce) {
  DelassusWorld world;
  world.addGround();
  const Vector2 before(2, 1);
  btRigidBody& runner = addRunner(world, 0.4, before);
  runner.setAnisotropicFriction({1, 1, btScalar(0.25)});
  world.advance();
  const btManifoldPoint& point = *world.points().at(0);
  btVector3 force = point.m_appliedImpulseLateral1 * point.m_lateralFrictionDir1 +
                    point.m_appliedImpulseLateral2 * point.m_lateralFrictionDir2;
  if (world.dispatcher().getManifoldByIndexInternal(0)->getBody1() == &runner) force = -force;
  const Vector2 gain = slipOf(runner) - before;
  EXPECT_NEAR(force.x(), gain[0], tolerance(1e-12, 1e-6));
  EXPECT_NEAR(force.z(), gain[1], tolerance(1e-12, 1e-6));
}

/// What the contact callback below writes into each new point.
struct Belt {
  btVector3 direction1{1, 0, 0}, direction2{0, 0, 1};
  btScalar motion1 = 0, motion2 = 0;  ///< of the body on the belt
  btScalar softness = 0;
  const btCollisionObject* belt = nullptr;
};
Belt theBelt;

bool driveBelt(btManifoldPoint& point, const btCollisionObjectWrapper* a, int, int,
               const btCollisionObjectWrapper*, int, int) {
  // Bullet's motion is that of body 0 relative to body 1.
  const btScalar sign = a->getCollisionObject() == theBelt.belt ? btScalar(-1) : btScalar(1);
  point.m_contactPointFlags |= BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED;
  point.m_lateralFrictionDir1 = theBelt.direction1;
  point.m_lateralFrictionDir2 = theBelt.direction2;
  point.m_contactMotion1 = sign * theBelt.motion1;
  point.m_contactMotion2 = sign * theBelt.motion2;
  point.m_frictionCFM = theBelt.softness;
  return true;
}

/// Calls the contact callback as long as it lives.
struct WithBelt {
  WithBelt(BulletWorld& world, btRigidBody& ground, const Belt& belt) {
    theBelt = belt;
    theBelt.belt = &ground;
    gContactAddedCallback = driveBelt;
    ground.setCollisionFlags(ground.getCollisionFlags() |
                             btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
    world.info().m_solverMode |=
        SOLVER_ENABLE_FRICTION_DIRECTION_CACHING | SOLVER_USE_2_FRICTION_DIRECTIONS;
  }
  ~WithBelt() { gContactAddedCallback = nullptr; }
};

TEST(Parity, Row21BeltDrivesABoxToItsMotion) {
  Belt belt;
  belt.motion1 = btScalar(0.6);
  belt.motion2 = btScalar(-0.8);
  DelassusWorld world;
  btRigidBody& ground = world.addGround();
  btRigidBody& box = addRunner(world, 0, {0, 0});
  const WithBelt running(world, ground, belt);
  for (int i = 1; i <= 30; ++i) {
    world.advance();
    const double speed = std::min(1.0, friction * g * i * h);
    EXPECT_NEAR((slipOf(box) - speed * Vector2(0.6, -0.8)).norm(), 0, tolerance(1e-9, 1e-4)) << i;
  }
}

TEST(Parity, Row21BeltHasTheSignAndSpeedOfStock) {
  const auto ride = [](BulletWorld& world) {
    Belt belt;
    belt.motion1 = 1;
    btRigidBody& ground = world.addGround();
    btRigidBody& box = addRunner(world, 0, {0, 0});
    const WithBelt running(world, ground, belt);
    world.advance(8);
    return slipOf(box);
  };
  DelassusWorld ours;
  StockWorld stock;
  EXPECT_NEAR((ride(ours) - ride(stock)).norm(), 0, tolerance(1e-8, 1e-3));
}

TEST(Parity, Row21LengthOfAUserDirectionScalesFriction) {
  Belt rails;
  rails.direction1 = {btScalar(0.2), 0, 0};
  DelassusWorld world;
  btRigidBody& ground = world.addGround();
  const Vector2 before(2, 1);
  btRigidBody& runner = addRunner(world, 0, before);
  const WithBelt running(world, ground, rails);
  world.advance();
  expectEllipse(before, slipOf(runner), stretch(0.2, 1, 0));
}

TEST(Parity, Row21WithOneDirectionTheOtherIsAcross) {
  Belt rails;
  rails.direction1 = {btScalar(0.6), 0, btScalar(0.8)};
  rails.direction2 = rails.direction1;  // left as it was by a user who does not know it
  DelassusWorld world;
  btRigidBody& ground = world.addGround();
  const Vector2 before(2, 1);
  btRigidBody& runner = addRunner(world, 0, before);
  const WithBelt running(world, ground, rails);
  world.info().m_solverMode &= ~SOLVER_USE_2_FRICTION_DIRECTIONS;
  world.advance();
  expectEllipse(before, slipOf(runner), Matrix2::Identity());
}

/// The speed along x after each step, of a body of 1 kg on soft friction that a force pushes from
/// rest. `length`: of the friction directions.
std::vector<double> softSlip(BulletWorld& world, double softness, double force, double length = 1) {
  Belt soft;
  soft.softness = btScalar(softness);
  soft.direction1 *= btScalar(length);
  soft.direction2 *= btScalar(length);
  btRigidBody& ground = world.addGround();
  btRigidBody& runner = addRunner(world, 0, {0, 0});
  const WithBelt running(world, ground, soft);
  std::vector<double> speeds;
  for (int i = 0; i < 60; ++i) {
    runner.applyCentralForce({btScalar(force), 0, 0});
    world.advance();
    speeds.push_back(slipOf(runner)[0]);
  }
  return speeds;
}

TEST(Parity, Row22SoftFrictionSlipsInProportionToItsImpulse) {
  // In each step v' = v + F h − r with v' = χ W r, W = 1/m, or r = μ m g h if that is less.
  for (double softness : {0.1, 0.5})
    for (double force : {1.0, 3.0, friction * g + 1}) {
      SCOPED_TRACE(::testing::Message() << softness << " " << force);
      DelassusWorld ours;
      StockWorld stock;
      const auto speeds = softSlip(ours, softness, force);
      const auto stockSpeeds = softSlip(stock, softness, force);
      double v = 0;
      for (std::size_t i = 0; i < speeds.size(); ++i) {
        v += force * h;
        v -= std::min(v / (1 + softness), friction * g * h);
        ASSERT_NEAR(speeds[i], v, tolerance(1e-8, 1e-3)) << i;
        ASSERT_NEAR(stockSpeeds[i], v, tolerance(1e-6, 1e-3)) << i;
      }
    }
}

// Soft friction lets the body slip at one speed, however long its direction vectors are.
TEST(Parity, Row22SoftnessDoesNotDependOnTheLengthOfItsDirections) {
  constexpr double softness = 0.5, force = 1;
  DelassusWorld world;
  const std::vector<double> unit = softSlip(world, softness, force);
  for (const double length : {0.5, 2.0}) {
    DelassusWorld other;
    const std::vector<double> speeds = softSlip(other, softness, force, length);
    for (std::size_t i = 0; i < speeds.size(); ++i)
      ASSERT_NEAR(speeds[i], unit[i], tolerance(1e-9, 1e-5)) << length << " " << i;
  }
}

TEST(Parity, Row23AnchorPullsBackTheDrift) {
  for (bool anchored : {true, false}) {
    DelassusWorld world;
    world.addGround();
    btRigidBody& box = world.addCube({0, btScalar(0.5), 0});
    if (anchored)
      box.setCollisionFlags(box.getCollisionFlags() | btCollisionObject::CF_HAS_FRICTION_ANCHOR);
    world.advance(10);
    const btVector3 place = box.getWorldTransform().getOrigin();
    const btVector3 move(btScalar(0.002), 0, btScalar(-0.001));
    const Vector2 drift(move.x(), move.z());
    box.setWorldTransform(BulletWorld::at(place + move));
    world.advance();
    const double rate = anchored ? world.info().m_frictionERP / h : 0;
    EXPECT_NEAR((slipOf(box) + rate * drift).norm(), 0, tolerance(1e-8, 1e-4)) << anchored;
    world.advance(120);
    // In float the narrow phase replaces a point now and then. The new point forgets the drift that
    // is left.
    const btVector3 kept = anchored ? place : place + move;
    EXPECT_NEAR((box.getWorldTransform().getOrigin() - kept).length(), 0,
                tolerance(1e-8, 0.2 * drift.norm()))
        << anchored;
  }
}

TEST(Parity, Row23AnchoredBoxDoesNotCreepDownASlope) {
  DelassusWorld world;
  world.addGround();
  btRigidBody& box = world.addCube({0, btScalar(0.5), 0});
  box.setCollisionFlags(box.getCollisionFlags() | btCollisionObject::CF_HAS_FRICTION_ANCHOR);
  const btVector3 gravity(btScalar(0.4 * g), btScalar(-g), 0);
  world->setGravity(gravity);
  box.setGravity(gravity);
  world.advance(10);
  const btVector3 start = box.getWorldTransform().getOrigin();
  world.advance(600);
  EXPECT_LT((box.getWorldTransform().getOrigin() - start).length(), tolerance(1e-9, 1e-5));
}

}  // namespace
}  // namespace delassus::test
