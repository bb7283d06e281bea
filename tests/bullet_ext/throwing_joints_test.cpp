/// Joints that would throw a body ask for less; they carry, lift and drive as before.
#include <BulletDynamics/ConstraintSolver/btFixedConstraint.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

struct TautChain {
  double gap;          ///< m
  double breaking;     ///< impulse at which joints break, N·s
  double skew = 0;     ///< of the axes at its ends, if joints are hinges, rad
  double off = 0;      ///< from the origin, where what holds the ends has its own, m
  double endMass = 0;  ///< of what holds either end, kg, without weight; 0: it stands
};

/// Two planks between two places, linked at their edges by joints that are too short by `gap` each.
void addTautChain(DelassusWorld& world, const TautChain& chain) {
  constexpr double half = 0.4;
  const auto addEnd = [&]() -> btRigidBody& {
    btRigidBody& end = world.addBox({0.1, 0.1, 0.1}, {0, 0, 0}, btScalar(chain.endMass));
    end.setCollisionFlags(end.getCollisionFlags() | btCollisionObject::CF_NO_CONTACT_RESPONSE);
    return end;
  };
  if (chain.endMass > 0) world->setGravity({0, 0, 0});
  btRigidBody &start = addEnd(), &end = chain.endMass > 0 ? addEnd() : start;
  const auto place = [&](int i) { return btVector3(btScalar(chain.off + 2 * half * i), 0, 0); };
  btRigidBody* last = &start;
  for (int i = 0; i < 3; ++i) {
    btRigidBody& plank =
        i < 2 ? world.addBox({btScalar(half), btScalar(0.2), 1}, place(i), 1) : end;
    plank.setCollisionFlags(plank.getCollisionFlags() | btCollisionObject::CF_NO_CONTACT_RESPONSE);
    const auto arm = btScalar(half - chain.gap / 2);
    for (const btScalar z : {btScalar(-0.5), btScalar(0.5)}) {
      const btVector3 right(arm, 0, z), left(-arm, 0, z);
      const btVector3 inLast = i == 0 ? place(-1) + right : right;
      const btVector3 inPlank = i == 2 ? place(2) + left : left;
      const btVector3 axis(0, 0, 1), askew(0, btScalar(chain.skew), 1);
      btTypedConstraint* joint;
      if (chain.skew > 0)
        joint = &world.addJoint<btHingeConstraint>(*last, plank, inLast, inPlank, axis,
                                                   i == 1 ? axis : askew.normalized());
      else
        joint = &world.addJoint<btPoint2PointConstraint>(*last, plank, inLast, inPlank);
      joint->setBreakingImpulseThreshold(btScalar(chain.breaking));
    }
    last = &plank;
  }
}

/// Of all bodies, m/s.
double fastestOf(DelassusWorld& world) {
  double fastest = 0;
  for (int i = 0; i < world->getNumCollisionObjects(); ++i)
    if (const auto* body = btRigidBody::upcast(world->getCollisionObjectArray()[i]))
      fastest = std::max(fastest, double(body->getLinearVelocity().length()));
  return fastest;
}

// Straight, it cannot be shorter: by the exact answer it gets out of the way at 20 to 400 m/s. With
// geometric stiffness it hangs still soon; without, it bends to and fro.
TEST(ThrowingJoints, ATautChainThrowsNothing) {
  constexpr double erp = 0.2, never = SIMD_INFINITY;
  for (const TautChain& chain :
       {TautChain{0.01, never}, TautChain{0.05, never}, TautChain{0.2, never}, TautChain{0.2, 1e7},
        TautChain{0.2, never, 0.005}, TautChain{0.2, never, 0.005, 1000},
        TautChain{0.2, never, 0, 0, 1e6}})
    for (const bool isStiff : {true, false}) {
      SCOPED_TRACE(testing::Message()
                   << chain.gap << " m, breaks at " << chain.breaking << ", skew " << chain.skew
                   << ", off " << chain.off << ", ends of " << chain.endMass << " kg, "
                   << (isStiff ? "with" : "without") << " geometric stiffness");
      DelassusWorld world;
      world.delassus().setGeometricStiffness(isStiff);
      addTautChain(world, chain);
      const double asked = g * h + erp * chain.gap / h;
      int softened = 0;
      double fastest = 0;
      for (int step = 0; step < 180; ++step) {
        world.advance();
        softened += world.report().softened;
        fastest = fastestOf(world);
        ASSERT_LE(fastest, (isStiff ? 1.1 : 10) * asked) << step;
      }
      if (!isStiff) {
        EXPECT_GT(softened, 0);
      } else if (chain.endMass == 0) {
        EXPECT_LT(fastest, 2e-3 * asked);
      }
    }
}

// What drives a joint is not held back with the joints that throw: a fan on a plank of the chain
// turns as fast as its motor asks.
TEST(ThrowingJoints, AMotorOnATautChainKeepsItsSpeed) {
  constexpr double speed = 5;  // rad/s
  DelassusWorld world;
  world.delassus().setGeometricStiffness(false);
  addTautChain(world, {0.01, SIMD_INFINITY});
  auto& plank = static_cast<btRigidBody&>(*world->getCollisionObjectArray()[1]);
  btRigidBody& fan = world.addBox({btScalar(0.2), btScalar(0.01), btScalar(0.02)},
                                  {0, btScalar(0.3), 0}, btScalar(0.01));
  auto& motor = world.addJoint<btHingeConstraint>(fan, plank, btVector3(0, 0, 0),
                                                  btVector3(0, btScalar(0.3), 0),
                                                  btVector3(0, 1, 0), btVector3(0, 1, 0));
  motor.enableAngularMotor(true, btScalar(speed), 1);
  int softened = 0;
  for (int step = 0; step < 120; ++step) {
    world.advance();
    softened += world.report().softened;
    const btVector3 turn = fan.getAngularVelocity() - plank.getAngularVelocity();
    const btVector3 axis = plank.getWorldTransform().getBasis().getColumn(1);
    ASSERT_NEAR(std::abs(turn.dot(axis)), speed, 0.05 * speed) << step;
  }
  EXPECT_GT(softened, 20);
}

/// Nine planks that hang on each other and collide, each linked to the next at two points, drawn
/// about by an impulse of at most `grip`, N·s, at one of them; for three seconds.
struct DraggedChain {
  static constexpr int planks = 9;
  static constexpr double grip = 30;
  std::vector<btRigidBody*> planksAndHook;

  DraggedChain(BulletWorld& world, int drawn) {
    for (int i = 0; i <= planks; ++i)
      planksAndHook.push_back(
          &world.addBox({1, 1, btScalar(0.25)}, {0, btScalar(5 + 2 * i), 0}, i == planks ? 0 : 1));
    for (int i = 0; i < planks; ++i)
      for (const double x : {-0.5, 0.5})
        world.addJoint<btPoint2PointConstraint>(*planksAndHook[i], *planksAndHook[i + 1],
                                                btVector3(btScalar(x), 1, 0),
                                                btVector3(btScalar(x), -1, 0));
    const btVector3 held(btScalar(0.3), btScalar(0.2), btScalar(0.25));
    const btVector3 from = planksAndHook[drawn]->getWorldTransform() * held;
    auto& drag = world.addJoint<btPoint2PointConstraint>(*planksAndHook[drawn], held);
    drag.m_setting.m_impulseClamp = btScalar(grip);
    for (int step = 0; step < 180; ++step) {
      const double turn = 2 * M_PI * step / 120;
      drag.setPivotB(from + btVector3(btScalar(2.25 * std::sin(turn)),
                                      btScalar(1.125 * (1 - std::cos(turn))),
                                      btScalar(1.5 * std::sin(2 * turn))));
      const double before = energy();
      world.advance();
      mostGained = std::max(mostGained, energy() - before);
    }
  }
  double energy() const {
    double sum = 0;
    for (const btRigidBody* plank : planksAndHook)
      if (plank->getInvMass() > 0)
        sum += (plank->getLinearVelocity().length2() +
                plank->getAngularVelocity().dot(plank->getInvInertiaTensorWorld().inverse() *
                                                plank->getAngularVelocity())) /
                   2 +
               g * plank->getWorldTransform().getOrigin().y();
    return sum;
  }
  double mostGained = 0;  ///< energy, in a step, J
};

// What drags does work, and so does not excuse what joints do at the same time; nor may the next
// step begin with reactions that few sweeps have left. (By either, a step gained 6 to 12 kJ.)
TEST(ThrowingJoints, ADraggedChainThrowsLittleWithFewSweeps) {
  constexpr double most = 3000;  // J; ten sweeps of stock's gain up to 300
  for (const int sweeps : {5, 10})
    for (const int drawn : {5, 6}) {
      DelassusWorld world(Options::bounded(sweeps));
      EXPECT_LT(DraggedChain(world, drawn).mostGained, most) << sweeps << " at " << drawn;
    }
}

/// How far 1 N along the chain stretches a spring on one of its planks.
double stretchOn(const TautChain& chain, int& softened) {
  DelassusWorld world;
  addTautChain(world, chain);
  auto& plank = static_cast<btRigidBody&>(*world->getCollisionObjectArray()[2]);
  btRigidBody& weight = world.addBox({0.1, 0.1, 0.1}, {btScalar(chain.off), 0, 0}, 1);
  weight.setCollisionFlags(weight.getCollisionFlags() | btCollisionObject::CF_NO_CONTACT_RESPONSE);
  auto& spring = world.addJoint<btPoint2PointConstraint>(weight, plank, btVector3(0, 0, 0),
                                                         btVector3(0, 0, 0));
  spring.setParam(BT_CONSTRAINT_CFM, 10);
  for (int step = 0; step < 120; ++step) {
    weight.applyCentralForce({1, 0, 0});
    world.advance();
    softened += world.report().softened;
  }
  return weight.getWorldTransform().getOrigin().x() - plank.getWorldTransform().getOrigin().x();
}

// A spring in the same island keeps its force, however little the joints that throw may ask for.
TEST(ThrowingJoints, ASpringOnATautChainKeepsItsForce) {
  constexpr double never = SIMD_INFINITY, endMass = 1e6;
  int none = 0, softened = 0;
  const double expected = stretchOn({0, never, 0, 0, endMass}, none);
  EXPECT_EQ(none, 0);
  EXPECT_GT(expected, 1e-3);
  EXPECT_NEAR(stretchOn({0.2, never, 0, 0, endMass}, softened), expected, 0.1 * expected);
  EXPECT_GT(softened, 100);
}

// Eight planks between two posts. As long as they are straight they carry nothing, and then pull
// with fifty times the weight that has fallen on them. Stock's ten sweeps let the heavier load
// swing ever higher.
TEST(ThrowingJoints, ABridgeOfPlanksCarriesALoad) {
  constexpr int planks = 8;
  for (const double load : {20.0, 100.0}) {
    SCOPED_TRACE(testing::Message() << load << " kg");
    DelassusWorld world;
    btRigidBody* last = nullptr;
    for (int i = 0; i < planks; ++i) {
      btRigidBody& plank = world.addBox({btScalar(0.475), btScalar(0.05), btScalar(0.5)},
                                        {btScalar(i + 0.5), 0, 0}, 2);
      const btVector3 end(0.5, 0, 0), axis(0, 0, 1);
      if (last == nullptr)
        world.addJoint<btHingeConstraint>(plank, -end, axis);
      else
        world.addJoint<btHingeConstraint>(*last, plank, end, -end, axis, axis);
      last = &plank;
    }
    world.addJoint<btHingeConstraint>(*last, btVector3(0.5, 0, 0), btVector3(0, 0, 1));
    world.addBox({btScalar(0.4), btScalar(0.4), btScalar(0.4)},
                 {btScalar(planks / 2), btScalar(0.6), 0}, btScalar(load));
    for (int step = 0; step < 600; ++step) {
      world.advance();
      ASSERT_LT(fastestOf(world), 4) << step;  // it falls 0.2 m, and 0.4 with the bridge
    }
    EXPECT_LT(fastestOf(world), 1e-3);
    EXPECT_EQ(world.report().incompatible, 0);
  }
}

// A light arm that a servo turns, limits being set to where it shall be, with 500 times its mass at
// its end. Most of the work of the joints goes into the load's height: it is no throw.
TEST(ThrowingJoints, AServoLiftsALoad) {
  constexpr double rate = 0.3, load = 500;  // rad/s
  for (const double hz : {60.0, 240.0}) {
    SCOPED_TRACE(testing::Message() << hz << " Hz");
    DelassusWorld world;
    btRigidBody& arm = world.addBox({1, btScalar(0.05), btScalar(0.05)}, {1, 0, 0}, 1);
    btRigidBody& weight =
        world.addBox({btScalar(0.2), btScalar(0.2), btScalar(0.2)}, {btScalar(2.2), 0, 0}, load);
    auto& servo = world.addJoint<btHingeConstraint>(arm, btVector3(0, 0, 0), btVector3(0, 0, 1));
    btTransform inArm = btTransform::getIdentity(), inWeight = btTransform::getIdentity();
    inArm.setOrigin({1, 0, 0});
    inWeight.setOrigin({btScalar(-0.2), 0, 0});
    world.addJoint<btFixedConstraint>(arm, weight, inArm, inWeight);
    const double from = servo.getHingeAngle();
    double turned = 0;
    for (int step = 0; step < 4 * hz; ++step) {
      turned += rate / hz;
      servo.setLimit(btScalar(from + turned), btScalar(from + turned));
      world->stepSimulation(btScalar(1 / hz), 0);
      ASSERT_EQ(world.report().softened, 0) << step;
    }
    const btVector3 along = arm.getWorldTransform().getBasis().getColumn(0);
    EXPECT_NEAR(std::atan2(along.y(), along.x()), turned, 0.1);
  }
}

}  // namespace
}  // namespace delassus::test
