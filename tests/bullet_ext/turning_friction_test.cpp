/// Rolling and spinning friction (Bullet's contract, friction): |τ_n| ≤ κ_s r_n, ‖τ_t‖ ≤ κ_r r_n.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "tests/support/ground_plane.h"
#include "tests/support/turning_balls.h"

namespace delassus::test {
namespace {

/// Makes the ball roll without slip on y = 0.
void roll(btRigidBody& ball, const Vector2& velocity) {
  ball.setLinearVelocity(vector(velocity[0], 0, velocity[1]));
  ball.setAngularVelocity(vector(velocity[1], 0, -velocity[0]) / btScalar(ballRadius));
}

double speedOf(const btRigidBody& body) { return body.getLinearVelocity().length(); }

/// The speed that rolling friction takes from a ball in one step, m/s: (I + m R²) Δω = κ m g h with
/// I = 2/5 m R².
double rollingLoss(double kappa) { return 5.0 / 7 * kappa * g / ballRadius * h; }

TEST(Parity, Row24RollingBallStopsAtItsDistance) {
  constexpr double kappa = 0.01;
  for (double mass : {0.1, 1.0, 1000.0}) {  // stock lets the heavy one roll on
    SCOPED_TRACE(mass);
    DelassusWorld world;
    world.addGround();
    btRigidBody& ball = addBall(world, mass);
    ball.setRollingFriction(btScalar(kappa));
    double speed = 40.5 * rollingLoss(kappa), x = 0;
    roll(ball, {speed, 0});
    for (int i = 0; i < 40; ++i) {
      world.advance();
      speed -= rollingLoss(kappa);
      x += h * speed;
      ASSERT_NEAR(speedOf(ball), speed, tolerance(1e-8, 1e-4)) << i;
    }
    world.advance(20);
    EXPECT_LT(speedOf(ball), tolerance(1e-9, 1e-5));
    EXPECT_NEAR(ball.getWorldTransform().getOrigin().x(), x, tolerance(1e-8, 1e-3));
  }
}

TEST(Parity, Row24RollingFrictionIsTheSameInAllDirections) {
  constexpr double kappa = 0.02;
  for (double heading : {0.0, 0.5, 0.7853981633974483, 2.0}) {
    DelassusWorld world;
    world.addGround();
    btRigidBody& ball = addBall(world);
    ball.setRollingFriction(btScalar(kappa));
    const Vector2 along(std::cos(heading), std::sin(heading));
    roll(ball, along);
    world.advance(10);
    const Vector2 velocity(ball.getLinearVelocity().x(), ball.getLinearVelocity().z());
    EXPECT_LT((velocity - (1 - 10 * rollingLoss(kappa)) * along).norm(), tolerance(1e-8, 1e-4));
  }
}

// One step only: afterwards the narrow phase keeps a second, open point for a while, and stock's
// rolling friction acts there too.
TEST(Parity, Row24IsThatOfStockOnItsAxesBelowItsCap) {
  for (const Vector2& velocity : {Vector2(1, 0), Vector2(0, 1), Vector2(0.002, 0), Vector2(0, 0)})
    for (double spin : {0.0, 0.01, 3.0}) {
      DelassusWorld ours;
      StockWorld stock;
      const auto step = [&](BulletWorld& world) -> btRigidBody& {
        world.addGround();
        btRigidBody& ball = addBall(world);
        ball.setRollingFriction(btScalar(0.01));
        ball.setSpinningFriction(btScalar(0.004));
        roll(ball, velocity);
        ball.setAngularVelocity(ball.getAngularVelocity() + vector(0, spin, 0));
        world.info().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
        world.advance();
        return ball;
      };
      const btRigidBody &ball = step(ours), &stockBall = step(stock);
      EXPECT_LT((ball.getLinearVelocity() - stockBall.getLinearVelocity()).length(),
                tolerance(1e-7, 1e-5))
          << velocity.transpose() << " " << spin;
      EXPECT_LT((ball.getAngularVelocity() - stockBall.getAngularVelocity()).length(),
                tolerance(1e-6, 1e-4))
          << velocity.transpose() << " " << spin;
    }
}

/// The velocities of a ball that rolls and spins, after one step of a solver.
struct Turned {
  btVector3 velocity, rotation;
};
Turned oneStep(BulletWorld& world, double mass, double rolling, double spinning) {
  world.addGround();
  btRigidBody& ball = addBall(world, mass);
  ball.setRollingFriction(btScalar(rolling));
  ball.setSpinningFriction(btScalar(spinning));
  roll(ball, {1, 0});
  ball.setAngularVelocity(ball.getAngularVelocity() + vector(0, 3, 0));
  world.info().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
  world.advance();
  return {ball.getLinearVelocity(), ball.getAngularVelocity()};
}

// Stock bounds the load by 1 N·s a step, the weight of 6.1 kg.
TEST(Parity, Row24OptionHasTheBoundsOfStock) {
  for (const double mass : {1.0, 6.0, 6.5, 100.0, 10000.0})
    for (const double rolling : {0.01, 0.0})
      for (const double spinning : {0.004, 0.0}) {
        SCOPED_TRACE(::testing::Message() << mass << " " << rolling << " " << spinning);
        DelassusWorld ours;
        ours.delassus().setStockRollingFriction(true);
        StockWorld stock;
        const Turned turned = oneStep(ours, mass, rolling, spinning),
                     stockTurned = oneStep(stock, mass, rolling, spinning);
        EXPECT_LT((turned.velocity - stockTurned.velocity).length(), tolerance(1e-7, 1e-5));
        EXPECT_LT((turned.rotation - stockTurned.rotation).length(), tolerance(1e-6, 1e-4));

        DelassusWorld physical;
        const Turned resisted = oneStep(physical, mass, rolling, spinning);
        const bool alike =
            mass * g * h < 1 ? rolling > 0 || spinning == 0 : rolling + spinning == 0;
        EXPECT_EQ((resisted.rotation - turned.rotation).length() < tolerance(1e-6, 1e-4), alike);
      }
}

TEST(Parity, Row24OptionLetsAHeavyBallRollOutAsInStock) {
  // (I + m R²) Δω = κ · 1 N·s a step, whatever the load above that.
  constexpr double kappa = 0.5, mass = 60;
  constexpr double loss = kappa / (1.4 * mass * ballRadius);
  DelassusWorld world;
  world.delassus().setStockRollingFriction(true);
  world.addGround();
  btRigidBody& ball = addBall(world, mass);
  ball.setRollingFriction(btScalar(kappa));
  double speed = 30.5 * loss;
  roll(ball, {speed, 0});
  for (int i = 0; i < 30; ++i) {
    world.advance();
    speed -= loss;
    ASSERT_NEAR(speedOf(ball), speed, tolerance(1e-8, 1e-4)) << i;
  }
  world.advance(20);
  EXPECT_LT(speedOf(ball), tolerance(1e-9, 1e-5));
}

TEST(Parity, Row24BallRestsOnASlopeUpToItsAngle) {
  constexpr double kappa = 0.02;
  const double limit = std::atan(kappa / ballRadius);
  for (double part : {0.9, 1.1}) {
    const double slope = part * limit;
    DelassusWorld world;
    const btQuaternion tilt(btVector3(0, 0, 1), btScalar(-slope));
    const btVector3 up = quatRotate(tilt, btVector3(0, 1, 0));
    world.addBody(std::make_unique<btBoxShape>(btVector3(100, 1, 100)), btTransform(tilt, -up), 0)
        .setFriction(1);
    btRigidBody& ball = world.addSphere(btScalar(ballRadius), up * btScalar(ballRadius));
    ball.setRollingFriction(btScalar(kappa));
    const btVector3 start = ball.getWorldTransform().getOrigin();
    const int steps = part < 1 ? 600 : 60;
    int checked = 0;
    for (int i = 0; i < steps; ++i) {
      world.advance();
      checked += world.report().keptIslands;
    }
    if (part < 1) {
      EXPECT_LT((ball.getWorldTransform().getOrigin() - start).length(), tolerance(1e-9, 1e-5));
      if (isDouble) {
        EXPECT_GT(checked, 3 * steps / 4) << "and it is only checked";
      }
    } else {
      const double a = 5.0 / 7 * g * (std::sin(slope) - kappa / ballRadius * std::cos(slope));
      EXPECT_NEAR(speedOf(ball), a * steps * h, tolerance(1e-7, 1e-3));
    }
  }
}

TEST(Parity, Row24SpinningAloneStopsATop) {
  constexpr double kappa = 0.005, loss = kappa * g / (0.4 * ballRadius * ballRadius) * h;
  DelassusWorld world;
  world.addGround();
  btRigidBody& ball = addBall(world);
  ball.setSpinningFriction(btScalar(kappa));
  double rate = 20.5 * loss;
  ball.setAngularVelocity(vector(0, rate, 0));
  for (int i = 0; i < 20; ++i) {
    world.advance();
    rate -= loss;
    ASSERT_NEAR(ball.getAngularVelocity().y(), rate, tolerance(1e-8, 1e-3)) << i;
  }
  world.advance(2);
  EXPECT_LT(ball.getAngularVelocity().length(), tolerance(1e-9, 1e-5));
  EXPECT_EQ(world.report().plan.spinning, 1);
  EXPECT_EQ(world.report().plan.rolling, 0);
}

TEST(Parity, Row24FourPointsOfASmoothBoxResistTogether) {
  constexpr double kappa = 0.01, mass = 2, inertia = mass / 6;
  DelassusWorld world;
  world.addGround();
  btRigidBody& box = world.addCube(vector(0, 0.5, 0), btScalar(mass));
  box.setFriction(0);
  box.setSpinningFriction(btScalar(kappa));
  box.setAngularVelocity({0, 2, 0});
  double rate = 2;
  for (int i = 0; i < 30; ++i) {
    world.advance();
    double load = 0;  // not always the weight: the narrow phase moves the points
    for (const btManifoldPoint* point : world.points()) load += point->m_appliedImpulse;
    rate -= kappa * load / inertia;
    EXPECT_NEAR(box.getAngularVelocity().y(), rate, tolerance(1e-6, 1e-4)) << i;
  }
  EXPECT_LT(rate, 1.8);
}

TEST(Parity, Row24TorqueBelowSpinningFrictionTurnsNothing) {
  constexpr double kappa = 0.01;
  DelassusWorld world;
  world.addGround();
  btRigidBody& ball = addBall(world);
  ball.setSpinningFriction(btScalar(kappa));
  for (int i = 0; i < 60; ++i) {
    ball.applyTorque(vector(0, 0.9 * kappa * g, 0));
    world.advance();
  }
  EXPECT_LT(ball.getAngularVelocity().length(), tolerance(1e-8, 1e-5));
}

TEST(Parity, Row24TwoBallsTurnEachOtherAlike) {
  // In the air, pressed together: spinning friction gives one ball what it takes from the other.
  DelassusWorld world;
  world->setGravity({0, 0, 0});
  btRigidBody& left = world.addSphere(btScalar(ballRadius), vector(-ballRadius, 0, 0));
  btRigidBody& right = world.addSphere(btScalar(ballRadius), vector(ballRadius, 0, 0), 3);
  for (btRigidBody* ball : {&left, &right}) ball->setSpinningFriction(btScalar(0.02));
  left.setAngularVelocity({4, 0, 0});
  const double inertia = 0.4 * ballRadius * ballRadius;
  for (int i = 0; i < 30; ++i) {
    left.applyCentralForce({5, 0, 0});
    right.applyCentralForce({-5, 0, 0});
    world.advance();
    EXPECT_NEAR(left.getAngularVelocity().x() + 3 * right.getAngularVelocity().x(), 4,
                tolerance(1e-9, 1e-5));
  }
  // κ_s = 2 · 0.02 · 0.5 and r_n/h = 5 N: both balls are pressed with 5 N, whatever their masses.
  const double kappa = 0.02, force = 5;
  EXPECT_NEAR(left.getAngularVelocity().x(), 4 - kappa * force / inertia * 30 * h,
              tolerance(1e-7, 1e-3));
}

TEST(Parity, Row24LockedBodiesHaveNoRows) {
  DelassusWorld world;
  world.addGround();
  btRigidBody& ball = addBall(world);
  ball.setRollingFriction(btScalar(0.1));
  ball.setSpinningFriction(btScalar(0.1));
  ball.setAngularFactor(0);
  world.advance();
  EXPECT_EQ(world.report().plan.unknowns, 3);
}

TEST(Parity, Row24ACoefficientThatIsNoNumberIsNone) {
  DelassusWorld world;
  world.addGround();
  btRigidBody& ball = addBall(world);
  ball.setSpinningFriction(std::numeric_limits<btScalar>::quiet_NaN());
  world.advance();
  EXPECT_TRUE(world.report().messages.empty());
  EXPECT_EQ(world.report().plan.unknowns, 3);
}

TEST(Parity, Row24AnInfiniteCoefficientStopsAtOnce) {
  DelassusWorld world;
  world.addGround();
  btRigidBody& ball = addBall(world);
  ball.setRollingFriction(SIMD_INFINITY);
  ball.setSpinningFriction(SIMD_INFINITY);
  ball.setFriction(10);
  roll(ball, {0.5, 0});
  world.advance(3);
  EXPECT_LT(ball.getAngularVelocity().length(), tolerance(1e-7, 1e-4));
}

TEST(Parity, Row25AnisotropicRollingFrictionIsAnEllipse) {
  // ω' = ω − κ m g h / (I + m R²) D Dᵀω'/|Dᵀω'|, maximum dissipation on { κ r_n D s : |s| ≤ 1 }.
  constexpr double kappa = 0.02;
  for (double yaw : {0.0, 0.4})
    for (double heading : {0.0, 0.3, 1.2}) {
      DelassusWorld world;
      world.addGround();
      const btTransform pose(btQuaternion(btVector3(0, 1, 0), btScalar(yaw)),
                             vector(0, ballRadius, 0));
      btRigidBody& ball =
          world.addBody(std::make_unique<btSphereShape>(btScalar(ballRadius)), pose, 1);
      ball.setRollingFriction(btScalar(kappa));
      ball.setAnisotropicFriction(vector(1, 1, 0.25),
                                  btCollisionObject::CF_ANISOTROPIC_ROLLING_FRICTION);
      roll(ball, {std::cos(heading), std::sin(heading)});
      const auto turn = [&] {
        return Vector2(ball.getAngularVelocity().x(), ball.getAngularVelocity().z());
      };
      const Vector2 before = turn();
      world.advance();
      const Matrix2 D = stretch(1, 0.25, yaw);
      const Vector2 lost =
          rollingLoss(kappa) / ballRadius * D * (D.transpose() * turn()).normalized();
      EXPECT_LT((turn() - (before - lost)).norm(), tolerance(1e-7, 1e-4)) << yaw << " " << heading;
    }
}

TEST(Parity, Row25WhatResistsByLessThanAThousandthRollsFreely) {
  for (const double resists : {5e-4, 2e-3}) {
    DelassusWorld world;
    world.addGround();
    btRigidBody& ball = addBall(world);
    ball.setRollingFriction(btScalar(0.02));
    ball.setAnisotropicFriction(vector(resists, resists, resists),
                                btCollisionObject::CF_ANISOTROPIC_ROLLING_FRICTION);
    roll(ball, {1, 0});
    world.advance();
    EXPECT_EQ(world.report().plan.rolling, resists < 1e-3 ? 0 : 1);
  }
}

TEST(Parity, Row25IsThatOfStockOnTheAxes) {
  for (int axis : {0, 2}) {
    const auto build = [axis](BulletWorld& world) -> btRigidBody& {
      world.addGround();
      btRigidBody& ball = addBall(world);
      ball.setRollingFriction(btScalar(0.02));
      ball.setAnisotropicFriction(vector(0.3, 1, 0.8),
                                  btCollisionObject::CF_ANISOTROPIC_ROLLING_FRICTION);
      roll(ball, axis == 0 ? Vector2(1, 0) : Vector2(0, 1));
      return ball;
    };
    DelassusWorld ours;
    StockWorld stock;
    btRigidBody &ball = build(ours), &stockBall = build(stock);
    stock.info().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    ours.advance();
    stock.advance();
    EXPECT_LT(speedOf(ball), 0.9985);
    EXPECT_LT((ball.getLinearVelocity() - stockBall.getLinearVelocity()).length(),
              tolerance(1e-7, 1e-4));
  }
}

TEST(Parity, Row25CapsuleAndCylinderRollAgainstTheirOwnAxis) {
  // (I + m R²) Δω = κ m g h, with the inertia that Bullet gives the shape. Motion is bound to the
  // plane, since the narrow phase finds one point anywhere on the line that touches.
  constexpr double kappa = 0.01;
  for (const bool capsule : {true, false}) {
    // In float that point wanders ahead of the cylinder and back.
    if (!capsule && !isDouble) continue;
    DelassusWorld world;
    world.addGround();
    std::unique_ptr<btCollisionShape> shape;
    if (capsule)
      shape = std::make_unique<btCapsuleShapeZ>(btScalar(ballRadius), btScalar(1));
    else
      shape = std::make_unique<btCylinderShapeZ>(vector(ballRadius, ballRadius, 0.5));
    const btVector3 direction = shape->getAnisotropicRollingFrictionDirection();
    EXPECT_EQ(direction, btVector3(0, 0, 1));
    btRigidBody& body =
        world.addBody(std::move(shape), BulletWorld::at(vector(0, ballRadius, 0)), 1);
    body.setRollingFriction(btScalar(kappa));
    body.setAnisotropicFriction(direction, btCollisionObject::CF_ANISOTROPIC_ROLLING_FRICTION);
    body.setLinearFactor({1, 1, 0});
    body.setAngularFactor({0, 0, 1});
    roll(body, {1, 0});
    constexpr int steps = 8;
    world.advance(steps);
    const double inertia = 1 / body.getInvInertiaDiagLocal().z();
    const double loss = kappa * g * h / (inertia + ballRadius * ballRadius) * ballRadius;
    EXPECT_NEAR(body.getLinearVelocity().x(), 1 - steps * loss, tolerance(1e-6, 1e-4)) << capsule;
  }
}

}  // namespace
}  // namespace delassus::test
