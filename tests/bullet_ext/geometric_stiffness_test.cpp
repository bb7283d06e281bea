/// Light bodies in taut joints get an inertia that their step can follow, and only where the step
/// could not follow their own.

#include "bullet_ext/geometric_stiffness.h"

#include <BulletDynamics/ConstraintSolver/btContactSolverInfo.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>

#include "bullet_ext/convert.h"
#include "bullet_ext/gather.h"
#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

constexpr double linkLength = 0.5;

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

  double energy() const {
    double sum = 0;
    for (const btRigidBody* body : hung)
      sum += (0.5 * body->getLinearVelocity().length2() +
              gravity * body->getCenterOfMassPosition().y()) /
                 body->getInvMass() +
             0.5 * body->getAngularVelocity().dot(body->getInvInertiaTensorWorld().inverse() *
                                                  body->getAngularVelocity());
    return sum;
  }
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

TEST(GeometricStiffness, HoldsRopesThatStepsCannotFollow) {
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
TEST(GeometricStiffness, HoldsRopesOfHinges) {
  EXPECT_FALSE(Rope(1e3, false, true).holds());
  Rope rope(1e3, true, true);
  EXPECT_TRUE(rope.holds()) << "gain " << rope.gain() << ", gap " << rope.gap();
}

// Forces go on from step to step, whatever impulses the lengths of the steps make of them.
TEST(GeometricStiffness, HoldsRopesInStepsOfAnyLength) {
  for (const std::vector<double>& lengths :
       {std::vector<double>{1.0 / 60, 1.0 / 60, 1.0 / 60, 1.0 / 960},
        std::vector<double>{1.0 / 60, 1.0 / 240}}) {
    Rope rope(1e3, true);
    EXPECT_TRUE(rope.holds(lengths)) << "gain " << rope.gain() << ", gap " << rope.gap();
  }
}

TEST(GeometricStiffness, LeavesAloneWhatStepsFollow) {
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

/// A plate whose two joints pull at it with 900 N·s along its length.
using Join = std::function<void(DelassusWorld&, btRigidBody&, const btVector3& pivot)>;
struct PulledPlate {
  DelassusWorld world;
  bullet::Group group;
  StepReport report;
  btRigidBody& plate =
      world.addBox(btVector3(1, btScalar(0.5), btScalar(0.1)), btVector3(0, 5, 0), 3);
  double pull = 900;  ///< N·s

  explicit PulledPlate(const Join& join = point) {
    for (const int x : {-1, 1}) join(world, plate, btVector3(btScalar(x), 0, 0));
    // Six-dof joints that are met to the last bit have no rows, so the plate is shifted a little.
    plate.translate(btVector3(1, 1, 1) * btScalar(1e-3));
  }
  static void point(DelassusWorld& world, btRigidBody& body, const btVector3& pivot) {
    world.addJoint<btPoint2PointConstraint>(body, pivot);
  }
  /// Gathers as the solver does. The reactions of the last step are those of the pull.
  void gather() {
    btCollisionObject* body = &plate;
    std::vector<btTypedConstraint*> joints;
    for (int i = 0; i < world->getNumConstraints(); ++i) joints.push_back(world->getConstraint(i));
    bullet::gatherGroup(group,
                        {&body, 1, nullptr, 0, joints.data(), static_cast<int>(joints.size()),
                         &world.info(), &world.dispatcher()},
                        report);
    for (bullet::JointSource& joint : group.joints) {
      const double sign = joint.firstRow == 0 ? -1 : 1;
      bullet::JointLoad& load = joint.lastLoad;
      (group.rows[joint.firstRow].a >= 0 ? load.onA : load.onB)[0] = sign * pull;
    }
  }
  int stiffen(double lastStep = BulletWorld::step) {
    world.info().m_timeStep = BulletWorld::step;
    gather();
    return bullet::GeometricStiffness().stiffen(group, world.info(), lastStep);
  }
};

constexpr double needed = 2 * BulletWorld::step * 900;  // 30 kg m²

/// Two pulls of impulse p at arms ±a along x give the stiffness h² K = 2 h p a about y and z.
void expectInertiaOfSprings(PulledPlate& pulled) {
  const Mat3 inertia = bullet::toCore(pulled.plate.getInvInertiaTensorWorld()).inverse();
  EXPECT_EQ(pulled.stiffen(), 1);
  const Mat3 expected = inertia + Mat3(Vec3(0, needed, needed).asDiagonal());
  EXPECT_LT((pulled.group.bodies[0].inverseInertia.inverse() - expected).norm(),
            100 * precision * needed);
}

TEST(GeometricStiffness, HasItFromJointsOfEveryKind) {
  const auto frame = [](const btVector3& pivot) { return DelassusWorld::at(pivot); };
  const std::vector<Join> kinds{
      PulledPlate::point,
      [&](DelassusWorld& world, btRigidBody& body, const btVector3& pivot) {
        world.addJoint<btConeTwistConstraint>(body, frame(pivot));
      },
      [&](DelassusWorld& world, btRigidBody& body, const btVector3& pivot) {
        world.addJoint<btGeneric6DofConstraint>(body, frame(pivot), false);
      },
      [&](DelassusWorld& world, btRigidBody& body, const btVector3& pivot) {
        world.addJoint<btGeneric6DofSpring2Constraint>(body, frame(pivot));
      }};
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    SCOPED_TRACE(kind);
    PulledPlate pulled(kinds[kind]);
    expectInertiaOfSprings(pulled);
  }
}

// A hinge holds all other turns.
TEST(GeometricStiffness, HasItAboutTheAxisOfAHinge) {
  const Vec3 axis(0, 0.6, 0.8);
  PulledPlate pulled([&](DelassusWorld& world, btRigidBody& body, const btVector3& pivot) {
    auto& hinge = world.addJoint<btHingeConstraint>(body, pivot, bullet::toBullet(axis));
    // Neither a motor nor a limit holds the turn about the axis.
    hinge.enableAngularMotor(true, 1, 10);
    hinge.setLimit(btScalar(-0.1), btScalar(0.1));
  });
  const Mat3 inertia = bullet::toCore(pulled.plate.getInvInertiaTensorWorld()).inverse();
  EXPECT_EQ(pulled.stiffen(), 1);
  const Mat3 expected = inertia + needed * axis * axis.transpose();
  EXPECT_LT((pulled.group.bodies[0].inverseInertia.inverse() - expected).norm(),
            1000 * precision * needed);
}

TEST(GeometricStiffness, HasNoneFromJointsThatHoldAllTurns) {
  const std::vector<Join> kinds{
      [](DelassusWorld& world, btRigidBody& body, const btVector3& pivot) {
        const btQuaternion across(btVector3(0, 1, 0), btScalar(M_PI / 2));  // slides along z
        world.addJoint<btSliderConstraint>(body, btTransform(across, pivot), true);
      },
      [](DelassusWorld& world, btRigidBody& body, const btVector3& pivot) {
        auto& joint =
            world.addJoint<btGeneric6DofConstraint>(body, DelassusWorld::at(pivot), false);
        joint.setAngularLowerLimit({0, 0, 0});
        joint.setAngularUpperLimit({0, 0, 0});
      }};
  for (const Join& kind : kinds) {
    PulledPlate pulled(kind);
    pulled.plate.setAngularVelocity({1, 2, 3});
    // Six-dof joints have rows only for turns that they find.
    pulled.plate.setWorldTransform(
        btTransform(btQuaternion(btVector3(1, 1, 1).normalized(), btScalar(1e-3)),
                    pulled.plate.getWorldTransform().getOrigin()));
    EXPECT_EQ(pulled.stiffen(), 0);
  }
}

// By (ω h)²: none as far as steps can follow, then a growing share, all from an eighth more on.
TEST(GeometricStiffness, ComesGraduallyWhereStepsFollowNoMore) {
  for (const bool changes : {false, true})
    for (const double over : {0.95, 1.05, 1.1, 1.5}) {
      SCOPED_TRACE(testing::Message() << over << (changes ? " in steps that change" : ""));
      const double limit = changes ? 0.5 : 4;
      PulledPlate pulled;
      const Mat3 inverse = bullet::toCore(pulled.plate.getInvInertiaTensorWorld());
      // The stiffness is the same about y and z; the plate turns more easily about y.
      const double stiffness = over * limit / inverse(1, 1);
      ASSERT_GT(inverse(1, 1), inverse(2, 2));
      pulled.pull = stiffness / (2 * BulletWorld::step);
      EXPECT_EQ(pulled.stiffen(changes ? 2 * BulletWorld::step : BulletWorld::step), over > 1);
      // Each direction counts by itself.
      const auto shareAbout = [&](int axis) {
        return std::clamp((stiffness * inverse(axis, axis) / limit - 1) / 0.125, 0.0, 1.0);
      };
      const Vec3 held = stiffness * Vec3(0, shareAbout(1), shareAbout(2));
      const Mat3 expected = inverse.inverse() + Mat3(held.asDiagonal());
      EXPECT_LT((pulled.group.bodies[0].inverseInertia.inverse() - expected).norm(),
                1e4 * precision);
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
TEST(GeometricStiffness, ChainsOfEqualLinksSwingAsStocks) {
  DelassusWorld ours;
  StockWorld stock;
  stock.info().m_numIterations = 2000;
  const double place = swung(ours);
  EXPECT_EQ(ours.report().stiffened, 0);
  EXPECT_NEAR(place, swung(stock), tolerance(1e-4, 0.05));
}

TEST(GeometricStiffness, HasNoneOfWhatPushes) {
  PulledPlate pulled;
  pulled.pull = -pulled.pull;
  EXPECT_EQ(pulled.stiffen(), 0);
}

// What joints pull against each other across a body does not turn it about the line between them.
TEST(GeometricStiffness, HasNoneAboutTheLineOfItsPulls) {
  for (const double pull : {900.0, 9e6, -9e6}) {
    PulledPlate pulled([](DelassusWorld& world, btRigidBody& body, const btVector3& pivot) {
      world.addJoint<btPoint2PointConstraint>(body, pivot + btVector3(0, btScalar(0.5), 0));
    });
    pulled.pull = pull;
    const Mat3 inverse = bullet::toCore(pulled.plate.getInvInertiaTensorWorld());
    pulled.plate.setAngularVelocity({1, 0, 0});
    EXPECT_EQ(pulled.stiffen(), pull > 0);
    const Body& body = pulled.group.bodies[0];
    EXPECT_NEAR(body.inverseInertia(0, 0), inverse(0, 0), 10 * precision * inverse(0, 0));
    EXPECT_NEAR(body.velocity[3], 1, 10 * precision);
  }
}

// A door whose hinges are further apart on the frame than on the door: they press it with tens of
// kN along the axis about which it swings.
TEST(GeometricStiffness, LeavesDoorsToSwing) {
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

TEST(GeometricStiffness, IsNeverWithoutNumbers) {
  for (const double pull : {1e100, 1e153, 1e300, double(INFINITY), std::nan("")}) {
    PulledPlate pulled;
    pulled.plate.setMassProps(3, btVector3(1, 1, 1) * btScalar(1e-10));
    pulled.plate.updateInertiaTensor();
    pulled.pull = pull;
    pulled.stiffen();
    const Body& body = pulled.group.bodies[0];
    EXPECT_TRUE(body.inverseInertia.allFinite() && body.velocity.allFinite()) << pull;
  }
}

TEST(GeometricStiffness, KeepsAngularMomentumAndTorque) {
  PulledPlate pulled;
  const btVector3 turning(1, 2, 3), torque(7, 8, 9);
  pulled.plate.setFlags(0);  // no gyroscopic terms
  pulled.plate.setAngularVelocity(turning);
  pulled.plate.applyTorque(torque);
  const Mat3 inertia = bullet::toCore(pulled.plate.getInvInertiaTensorWorld()).inverse();
  pulled.stiffen();
  const Body& body = pulled.group.bodies[0];
  const Vec3 momentum =
      inertia * bullet::toCore(turning) + bullet::toCore(torque) * BulletWorld::step;
  EXPECT_LT((body.inverseInertia.inverse() * body.velocity.tail<3>() - momentum).norm(),
            100 * precision * needed);
}

TEST(GeometricStiffness, KeepsLockedAxesLocked) {
  PulledPlate pulled;
  pulled.plate.setAngularFactor(btVector3(1, 0, 1));
  EXPECT_EQ(pulled.stiffen(), 1);
  const Mat3& inverse = pulled.group.bodies[0].inverseInertia;
  EXPECT_LT(inverse.row(1).norm() + inverse.col(1).norm(), 10 * precision);
  EXPECT_NEAR(inverse(2, 2), 1 / (3.0 / 12 * (2 * 2 + 1) + needed), 100 * precision);
}

}  // namespace
}  // namespace delassus::test
