/// Ropes, chains, doors, whirling loads and tracks: how bodies move that taut joints hold.

#include <BulletDynamics/ConstraintSolver/btContactSolverInfo.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

constexpr double linkLength = 0.5;

double energyOf(const std::vector<btRigidBody*>& bodies) {
  double sum = 0;
  for (const btRigidBody* body : bodies)
    sum += (0.5 * body->getLinearVelocity().length2() +
            BulletWorld::gravity * body->getCenterOfMassPosition().y()) /
               body->getInvMass() +
           0.5 * body->getAngularVelocity().dot(body->getInvInertiaTensorWorld().inverse() *
                                                body->getAngularVelocity());
  return sum;
}

/// Twenty links of 1 kg and a ball, let go from 30 degrees beside the vertical.
struct Rope : DelassusWorld {
  static constexpr int links = 20;
  static constexpr double swing = M_PI / 6;

  Rope(double ballMass, bool stiffness, bool inHinges = false) : ball(ballMass) {
    delassus().setGeometricStiffness(stiffness);
    const btVector3 along(btScalar(std::sin(swing)), -btScalar(std::cos(swing)), 0);
    const btQuaternion turn(btVector3(0, 0, 1),
                            btScalar(swing - M_PI / 2));  // turns e_x to `along`
    const btVector3 end(btScalar(0.5 * linkLength), 0, 0), across(0, 0, 1);
    btRigidBody* above = nullptr;
    const auto hang = [&](btRigidBody& body, const btVector3& pivot) {
      if (above && inHinges)
        addJoint<btHingeConstraint>(*above, body, end, pivot, across, across);
      else if (above)
        addJoint<btPoint2PointConstraint>(*above, body, end, pivot);
      else
        addJoint<btPoint2PointConstraint>(body, pivot);
      body.setCollisionFlags(btCollisionObject::CF_NO_CONTACT_RESPONSE);  // neighbours overlap
      above = &body;
      hung.push_back(&body);
    };
    for (int i = 0; i < links; ++i)
      hang(addBody(std::make_unique<btBoxShape>(btVector3(end.x(), btScalar(0.03), btScalar(0.03))),
                   btTransform(turn, along * btScalar((i + 0.5) * linkLength)), 1),
           -end);
    const btScalar radius = btScalar(0.3);
    hang(addBody(std::make_unique<btSphereShape>(radius),
                 btTransform(turn, along * (btScalar(links * linkLength) + radius)),
                 btScalar(ballMass)),
         btVector3(-radius, 0, 0));
    start = energy();
  }

  double energy() const { return energyOf(hung); }
  /// Energy gained, as a share of the energy of the swing.
  double gain() const {
    return (energy() - start) / (gravity * ball * links * linkLength * (1 - std::cos(swing)));
  }
  /// The largest distance between the joined ends of neighbours, m.
  double gap() const {
    double worst = 0;
    for (int i = 1; i <= links; ++i) {
      const double x = i < links ? -0.5 * linkLength : -0.3;
      const btVector3 upper = hung[i - 1]->getWorldTransform() * btVector3(0.5 * linkLength, 0, 0);
      worst = std::max<double>(
          worst, (upper - hung[i]->getWorldTransform() * btVector3(x, 0, 0)).length());
    }
    return worst;
  }
  /// Steps for two seconds, as long as the rope holds. `lengths`: of the steps, in turn.
  bool holds(const std::vector<double>& lengths = {step}) {
    int most = 0;
    double time = 0;
    for (std::size_t i = 0; time < 2; ++i) {
      const double length = lengths[i % lengths.size()];
      time += length;
      (*this)->stepSimulation(btScalar(length), 0);
      most = std::max(most, report().stiffened);
      if (!(gain() < 0.05 && gap() < 0.05 * linkLength)) return false;
    }
    mostStiffened = most;
    return true;
  }

  double ball, start;
  int mostStiffened = 0;
  std::vector<btRigidBody*> hung;
};

TEST(TautJoints, HoldsRopesThatStepsCannotFollow) {
  // ω h = √(12 T/(m l)) h is 8, 800 and 8000. In float joints give a hundred times as much, and the
  // heaviest ball would pull them apart.
  for (const double ball : {1e3, 1e7, isDouble ? 1e9 : 1e6}) {
    EXPECT_FALSE(Rope(ball, false).holds()) << ball;
    Rope rope(ball, true);
    EXPECT_TRUE(rope.holds()) << ball << ": gain " << rope.gain() << ", gap " << rope.gap();
    EXPECT_EQ(rope.mostStiffened, Rope::links);
  }
}

// In every step Bullet turns the rows of a hinge between two bodies anew, and weighs their arms.
TEST(TautJoints, HoldsRopesOfHinges) {
  EXPECT_FALSE(Rope(1e3, false, true).holds());
  Rope rope(1e3, true, true);
  EXPECT_TRUE(rope.holds()) << "gain " << rope.gain() << ", gap " << rope.gap();
}

// Forces go on from step to step, whatever impulses the lengths of the steps make of them.
TEST(TautJoints, HoldsRopesInStepsOfAnyLength) {
  for (const std::vector<double>& lengths :
       {std::vector<double>{1.0 / 60, 1.0 / 60, 1.0 / 60, 1.0 / 960},
        std::vector<double>{1.0 / 60, 1.0 / 240}}) {
    Rope rope(1e3, true);
    EXPECT_TRUE(rope.holds(lengths)) << "gain " << rope.gain() << ", gap " << rope.gap();
  }
}

// Lengths that are measured, or are differences of times, are equal but for a little.
TEST(TautJoints, StepsThatHardlyDifferLoseNoMore) {
  const auto lost = [](double jitter) {
    Rope rope(1e3, true);
    for (int i = 0; i < 60; ++i)
      rope->stepSimulation(btScalar(h * (1 + (i % 2 == 0 ? jitter : -jitter))), 0);
    return -rope.gain();
  };
  const double equal = lost(0);
  for (const double jitter : {4 * precision, 1e-3, 4e-3})
    EXPECT_NEAR(lost(jitter), equal, 0.1 * equal) << jitter;
}

TEST(TautJoints, LeavesAloneWhatStepsFollow) {
  Rope with(1, true), without(1, false);
  for (Rope* rope : {&with, &without}) {
    (*rope)->setGravity(btVector3(0, btScalar(-0.1), 0));  // ω h = 0.13
    for (btRigidBody* body : rope->hung) body->setGravity((*rope)->getGravity());
    rope->advance(60);
  }
  EXPECT_EQ(with.report().stiffened, 0);
  for (std::size_t i = 0; i < with.hung.size(); ++i)
    EXPECT_EQ((with.hung[i]->getCenterOfMassPosition() - without.hung[i]->getCenterOfMassPosition())
                  .length2(),
              0)
        << i;
}

// A link that spins turns by so much in a step that springs which turn along would drive it.
TEST(TautJoints, ASpinningLinkGainsNoEnergy) {
  constexpr int links = 5;
  constexpr double length = 0.3, radius = 0.2;
  for (const double ballMass : {100.0, 1000.0}) {
    SCOPED_TRACE(ballMass);
    DelassusWorld world;
    std::vector<btRigidBody*> hung;
    const auto hang = [&](btRigidBody& body, double halfLength) {
      body.setDamping(0, 0);
      body.setCollisionFlags(btCollisionObject::CF_NO_CONTACT_RESPONSE);
      const btVector3 top(0, btScalar(halfLength), 0), bottom(0, btScalar(-0.5 * length), 0);
      if (hung.empty())
        world.addJoint<btPoint2PointConstraint>(body, top);
      else
        world.addJoint<btPoint2PointConstraint>(*hung.back(), body, bottom, top);
      hung.push_back(&body);
    };
    for (int i = 0; i < links; ++i)
      hang(world.addBox({btScalar(0.03), btScalar(0.5 * length), btScalar(0.03)},
                        {0, btScalar(-(i + 0.5) * length), 0}, 1),
           0.5 * length);
    hang(world.addSphere(btScalar(radius), {0, btScalar(-links * length - radius), 0},
                         btScalar(ballMass)),
         radius);
    world.advance(60);
    hung[links / 2]->applyCentralImpulse({5, 0, 0});
    hung[links / 2]->applyTorqueImpulse({0, 0, btScalar(0.3)});
    const double start = energyOf(hung);
    for (int step = 0; step < 300; ++step) {
      world.advance();
      ASSERT_LT(energyOf(hung), start + 0.1) << step;
    }
  }
}

/// Where the last of five links is after 5 s. Each has 1 kg and 0.2 m; they swing from a pivot.
template <class World>
double swung(World& world) {
  constexpr double length = 0.2;
  btRigidBody* above = nullptr;
  for (int i = 0; i < 5; ++i) {
    btRigidBody& link = world.addBox({btScalar(0.4 * length), btScalar(0.05), btScalar(0.05)},
                                     {btScalar((i + 0.5) * length), 0, 0});
    link.setCollisionFlags(btCollisionObject::CF_NO_CONTACT_RESPONSE);
    const btVector3 end(btScalar(0.5 * length), 0, 0);
    if (above)
      world.template addJoint<btPoint2PointConstraint>(*above, link, end, -end);
    else
      world.template addJoint<btPoint2PointConstraint>(link, -end);
    above = &link;
  }
  world.advance(300);
  return above->getWorldTransform().getOrigin().x();
}

// A chain that steps can follow swings as with sequential impulses run to convergence.
TEST(TautJoints, ChainsOfEqualLinksSwingAsStocks) {
  DelassusWorld ours;
  StockWorld stock;
  stock.info().m_numIterations = 2000;
  const double place = swung(ours);
  EXPECT_EQ(ours.report().stiffened, 0);
  EXPECT_NEAR(place, swung(stock), tolerance(1e-4, 0.05));
}

// A door whose hinges are further apart on the frame than on the door: they press it with tens of
// kN along the axis about which it swings.
TEST(TautJoints, LeavesDoorsToSwing) {
  constexpr double speed = 2;
  for (const double mismatch : {1e-4, 1e-3, -1e-3}) {
    SCOPED_TRACE(mismatch);
    DelassusWorld world;
    btRigidBody& frame = world.addBox({0.5, 1, btScalar(0.05)}, {btScalar(-0.5), 2, 0}, 0);
    btRigidBody& door = world.addBox({0.5, 1, btScalar(0.05)}, {btScalar(0.5), 2, 0}, 20);
    door.setDamping(0, 0);
    for (const double y : {-0.9, 0.9}) {
      const double onFrame = y + (y > 0 ? mismatch : 0);
      world.addJoint<btHingeConstraint>(frame, door, btVector3(0.5, btScalar(onFrame), 0),
                                        btVector3(-0.5, btScalar(y), 0), btVector3(0, 1, 0),
                                        btVector3(0, 1, 0));
    }
    frame.setCollisionFlags(frame.getCollisionFlags() | btCollisionObject::CF_NO_CONTACT_RESPONSE);
    door.setAngularVelocity({0, btScalar(speed), 0});
    door.setLinearVelocity({0, 0, btScalar(-0.5 * speed)});
    world.advance(60);
    EXPECT_NEAR(door.getAngularVelocity().y(), speed, 0.01 * speed);
    EXPECT_EQ(world.report().outOfBudget + world.report().incompatible, 0);
  }
}

/// The speed, m/s, of a ball of 10 kg after five seconds in which it whirls on a rod of 0.1 kg.
double whirled(bool isStiff, double speed) {
  constexpr double rodMass = 0.1, ballMass = 10, length = 1.2;
  DelassusWorld world;
  world->setGravity({0, 0, 0});
  world.delassus().setGeometricStiffness(isStiff);
  btRigidBody& rod = world.addBox({0.5, btScalar(0.02), btScalar(0.02)}, {0.5, 0, 0}, rodMass);
  btRigidBody& ball = world.addSphere(btScalar(0.2), {btScalar(length), 0, 0}, ballMass);
  rod.setCollisionFlags(btCollisionObject::CF_NO_CONTACT_RESPONSE);
  world.addJoint<btPoint2PointConstraint>(rod, btVector3(-0.5, 0, 0));
  world.addJoint<btPoint2PointConstraint>(rod, ball, btVector3(0.5, 0, 0),
                                          btVector3(btScalar(-0.2), 0, 0));
  for (btRigidBody* body : {&rod, &ball}) {
    body->setDamping(0, 0);
    const btVector3 turning(0, 0, btScalar(speed / length));
    body->setAngularVelocity(turning);
    body->setLinearVelocity(turning.cross(body->getCenterOfMassPosition()));
  }
  int stiffened = 0;
  for (int step = 0; step < 300; ++step) {
    world.advance();
    stiffened += world.report().stiffened;
  }
  if (isStiff) {
    EXPECT_GT(stiffened, 250);
  }
  return ball.getLinearVelocity().length();
}

// It loses two hundredths of its speed a second.
TEST(TautJoints, LeavesLoadsToWhirl) {
  const double alone = whirled(false, 6);
  EXPECT_GT(alone, 5);
  EXPECT_NEAR(whirled(true, 6), alone, 0.12 * alone);
}

/// A track of hinged plates around two wheels, and the speed of its plates over the last second of
/// three, m/s. A motor turns one wheel. Each plate is `stretch` shorter than its way.
double speedOfTrack(bool isStiff, double stretch) {
  constexpr int plates = 40;
  constexpr double radius = 0.3, apart = 1.2, halfThickness = 0.02, speed = 2;
  constexpr double path = radius + halfThickness, arc = M_PI * path;
  constexpr double pitch = 2 * (apart + arc) / plates;
  const double half = (pitch - stretch) / 2;
  DelassusWorld world;
  world->setGravity({0, 0, 0});
  world.delassus().setGeometricStiffness(isStiff);
  for (const int side : {-1, 1}) {
    btRigidBody& wheel = world.addBody(std::make_unique<btCylinderShapeZ>(btVector3(
                                           btScalar(radius), btScalar(radius), btScalar(0.2))),
                                       DelassusWorld::at({btScalar(side * 0.5 * apart), 0, 0}), 5);
    wheel.setFriction(2);
    auto& axle = world.addJoint<btHingeConstraint>(wheel, btVector3(0, 0, 0), btVector3(0, 0, 1));
    if (side > 0) continue;
    axle.enableAngularMotor(true, btScalar(speed / radius), 50);
  }
  // Along the lower side, around the right wheel, back, and around the left one.
  const auto placeAt = [&](double along) {
    along = std::fmod(along, 2 * (apart + arc));
    const bool isBack = along >= apart + arc;
    if (isBack) along -= apart + arc;
    const double turn = along < apart ? 0 : (along - apart) / path;
    const double x = along < apart ? along - 0.5 * apart : 0.5 * apart + path * std::sin(turn);
    const btVector3 place(btScalar(x), btScalar(-path * std::cos(turn)), 0);
    return isBack ? -place : place;
  };
  std::vector<btRigidBody*> track;
  for (int i = 0; i < plates; ++i) {
    const btVector3 from = placeAt(i * pitch), to = placeAt((i + 1) * pitch), way = to - from;
    const btQuaternion turn(btVector3(0, 0, 1), btScalar(std::atan2(way.y(), way.x())));
    track.push_back(
        &world.addBody(std::make_unique<btBoxShape>(btVector3(
                           btScalar(0.9 * half), btScalar(halfThickness), btScalar(0.15))),
                       btTransform(turn, 0.5 * (from + to)), 1));
    track.back()->setFriction(1);
  }
  const btVector3 end(btScalar(half), 0, 0), across(0, 0, 1);
  for (int i = 0; i < plates; ++i) {
    auto& joint = world.addJoint<btHingeConstraint>(*track[i], *track[(i + 1) % plates], end, -end,
                                                    across, across);
    world->removeConstraint(&joint);
    world->addConstraint(&joint, true);
  }
  world.advance(120);
  double sum = 0;
  for (int step = 0; step < 60; ++step) {
    world.advance();
    for (const btRigidBody* plate : track) sum += plate->getLinearVelocity().length();
  }
  return sum / (60 * plates);
}

// Implicit springs at rest would stop it, since its plates turn where they meet a wheel.
TEST(TautJoints, ATrackRunsOverItsWheels) {
  const double alone = speedOfTrack(false, 1e-3);
  EXPECT_GT(alone, 1.5);
  EXPECT_NEAR(speedOfTrack(true, 1e-3), alone, 0.2 * alone);
}

}  // namespace
}  // namespace delassus::test
