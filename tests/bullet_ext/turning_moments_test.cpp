/// The moments of rolling and spinning friction that `setTurningListener` reports.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/turning_balls.h"

namespace delassus::test {
namespace {

/// What a listener was told in the last step.
class Told {
 public:
  explicit Told(btDelassusConstraintSolver& solver) {
    solver.setTurningListener([this](const ContactEvent& event) { events.push_back(event); });
  }
  const ContactEvent& only() const {
    EXPECT_EQ(events.size(), 1u);
    return events.at(0);
  }
  /// The value with its sign on `body`, whichever of the two it is.
  static btVector3 on(const btRigidBody& body, const ContactEvent& event, const btVector3& value) {
    const bool first = event.manifold->getBody0() == &body;
    const bool second = event.manifold->getBody1() == &body;
    return first ? value : second ? -value : btVector3(0, 0, 0);
  }
  std::vector<ContactEvent> events;
};

btVector3 normalOf(const ContactEvent& event) {
  return event.manifold->getContactPoint(event.point).m_normalWorldOnB;
}

double kineticEnergy(const btRigidBody& ball) {
  return (ball.getLinearVelocity().length2() +
          inertiaOfUnit * ball.getAngularVelocity().length2()) /
         (2 * ball.getInvMass());
}

// The contact point of a rolling ball stands still. So the energy lost is the work of the moment:
// τ times the mean of the rotation before and after the step.
TEST(TurningListener, RollingBallLosesTheMomentsWork) {
  constexpr double kappa = 0.01;
  for (const double mass : {1.0, 50.0}) {
    DelassusWorld world;
    world.addGround();
    btRigidBody& ball = addBall(world, mass);
    ball.setRollingFriction(btScalar(kappa));
    ball.setLinearVelocity(vector(0.8, 0, 0.6));
    ball.setAngularVelocity(vector(0.6, 0, -0.8) / btScalar(ballRadius));
    Told told(world.delassus());
    for (int step = 0; step < 20; ++step) {
      told.events.clear();
      const btVector3 rotationBefore = ball.getAngularVelocity();
      const double energyBefore = kineticEnergy(ball);
      world.advance();
      const ContactEvent& event = told.only();
      const btVector3 moment = Told::on(ball, event, event.moment);
      const double load = std::abs(event.reaction.dot(normalOf(event)));
      EXPECT_NEAR(load, mass * g * h, mass * tolerance(1e-9, 1e-3));  // positions round
      EXPECT_NEAR(moment.length(), kappa * load, mass * tolerance(1e-10, 1e-6));
      EXPECT_NEAR(moment.dot(ball.getAngularVelocity()),
                  -kappa * load * ball.getAngularVelocity().length(), mass * tolerance(1e-8, 1e-5))
          << "opposite to the rotation";
      EXPECT_NEAR(kineticEnergy(ball) - energyBefore,
                  moment.dot(rotationBefore + ball.getAngularVelocity()) / 2,
                  mass * tolerance(1e-8, 1e-4));
    }
  }
}

// I Δω = moment + arm × reaction, for each of two balls that are pressed together, spin and roll on
// each other. One gets what the other loses. (In a step where they have slid a hair apart there is
// no contact.)
TEST(TurningListener, MomentsAndReactionsMakeTheMotion) {
  DelassusWorld world;
  world->setGravity({0, 0, 0});
  btRigidBody& left = world.addSphere(btScalar(ballRadius), vector(-ballRadius, 0, 0));
  btRigidBody& right = world.addSphere(btScalar(ballRadius), vector(ballRadius, 0, 0), 3);
  for (btRigidBody* ball : {&left, &right}) {
    ball->setRollingFriction(btScalar(0.01));
    ball->setSpinningFriction(btScalar(0.02));
    ball->setAnisotropicFriction(vector(1, 0.5, 0.2),
                                 btCollisionObject::CF_ANISOTROPIC_ROLLING_FRICTION);
  }
  left.setAngularVelocity({4, 2, 1});
  Told told(world.delassus());
  int spinning = 0, rolling = 0;
  for (int step = 0; step < 20; ++step) {
    told.events.clear();
    left.applyCentralForce({5, 0, 0});
    right.applyCentralForce({-5, 0, 0});
    const btVector3 before[] = {left.getAngularVelocity(), right.getAngularVelocity()};
    world.advance();
    for (btRigidBody* ball : {&left, &right}) {
      btVector3 sum(0, 0, 0);
      for (const ContactEvent& event : told.events) {
        const btManifoldPoint& point = event.manifold->getContactPoint(event.point);
        // Points are where they were at the start of the step; the ball's centre is not.
        const btVector3 centre =
            ball->getWorldTransform().getOrigin() - btScalar(h) * ball->getLinearVelocity();
        const bool first = event.manifold->getBody0() == ball;
        const btVector3 arm =
            (first ? point.getPositionWorldOnA() : point.getPositionWorldOnB()) - centre;
        sum += Told::on(*ball, event, event.moment + arm.cross(event.reaction));
        const double spin = event.moment.dot(normalOf(event));
        spinning += std::abs(spin) > 1e-4;
        rolling += (event.moment - btScalar(spin) * normalOf(event)).length() > 1e-4;
      }
      const btVector3 change = ball->getAngularVelocity() - before[ball == &right];
      const double inertia = inertiaOfUnit / ball->getInvMass();
      EXPECT_LT((btScalar(inertia) * change - sum).length(), tolerance(1e-10, 1e-6)) << step;
    }
  }
  EXPECT_GT(spinning, 10);
  EXPECT_GT(rolling, 10);
}

TEST(TurningListener, HoldsTheTorqueOfABodyThatRests) {
  constexpr double kappa = 0.02;
  const btVector3 torque = vector(0.3, 0.5, -0.2) * btScalar(kappa * g);
  DelassusWorld world;
  world.addGround();
  btRigidBody& ball = addBall(world);
  ball.setFriction(0);  // so that sliding friction takes no part
  ball.setRollingFriction(btScalar(kappa));
  ball.setSpinningFriction(btScalar(kappa));
  Told told(world.delassus());
  for (int step = 0; step < 10; ++step) {
    told.events.clear();
    ball.applyTorque(torque);
    world.advance();
    const ContactEvent& event = told.only();
    EXPECT_LT((Told::on(ball, event, event.moment) + btScalar(h) * torque).length(),
              tolerance(1e-10, 1e-6));
  }
}

/// A ball that rolls beside a box that slides, and what listeners were told of them in 40 steps.
struct Traffic {
  int changes = 0, turnings = 0, eventsMade = 0, modeChanges = 0;
};
Traffic listen(bool toChanges, bool toTurning) {
  DelassusWorld world;
  world.addGround();
  btRigidBody& ball = addBall(world);
  ball.setRollingFriction(btScalar(0.01));
  ball.setLinearVelocity({1, 0, 0});
  ball.setAngularVelocity(vector(0, 0, -1 / ballRadius));
  world.addCube({0, btScalar(0.5), 5}).setLinearVelocity({0, 0, 1});
  Traffic traffic;
  if (toChanges)
    world.delassus().setContactListener([&](const ContactEvent& event) {
      EXPECT_NE(event.from, event.to);
      ++traffic.changes;
    });
  if (toTurning)
    world.delassus().setTurningListener([&](const ContactEvent& event) {
      EXPECT_TRUE(event.manifold->getBody0() == &ball || event.manifold->getBody1() == &ball);
      ++traffic.turnings;
    });
  for (int step = 0; step < 40; ++step) {
    world.advance();
    traffic.eventsMade += world.report().events;
    traffic.modeChanges += world.report().modeChanges;
  }
  return traffic;
}

TEST(TurningListener, IsToldEveryStepAndOthersAreNot) {
  const Traffic nobody = listen(false, false), changes = listen(true, false),
                turning = listen(false, true), both = listen(true, true);
  EXPECT_EQ(nobody.eventsMade, 0);
  EXPECT_GT(changes.changes, 0);
  EXPECT_EQ(changes.changes, changes.modeChanges);
  EXPECT_EQ(changes.eventsMade, changes.changes) << "rolling alone is no event for it";
  EXPECT_EQ(turning.turnings, 40);
  EXPECT_EQ(turning.changes, 0);
  EXPECT_LE(turning.eventsMade, turning.turnings + turning.modeChanges) << "rest is no event";
  EXPECT_EQ(both.turnings, 40);
  EXPECT_EQ(both.changes, changes.changes);
}

}  // namespace
}  // namespace delassus::test
