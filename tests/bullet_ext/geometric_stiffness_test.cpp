/// Light bodies in taut joints get an inertia that their step can follow, and only where the step
/// could not follow their own.

#include "bullet_ext/geometric_stiffness.h"

#include <BulletDynamics/ConstraintSolver/btContactSolverInfo.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "bullet_ext/convert.h"
#include "bullet_ext/gather.h"
#include "bullet_ext/thrown_bodies.h"
#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

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

// A search that finds no answer may end with forces of any size. (From 1e9 N·s on rounding made
// inertias negative, and a body left at 6e9 rad/s.)
TEST(GeometricStiffness, LeavesInertiasPositiveUnderForcesOfAnySize) {
  for (const double pull : {1e3, 1e6, 1e9, 1e12, 1e15})
    for (int k = 0; k < 20; ++k) {
      SCOPED_TRACE(testing::Message() << pull << " N·s, turn " << k);
      PulledPlate pulled([k](DelassusWorld& world, btRigidBody& body, const btVector3& pivot) {
        const btVector3 aside(0, btScalar(0.1 * (k % 3)), btScalar(0.1 * (k % 4 - 1)));
        world.addJoint<btPoint2PointConstraint>(body, pivot + aside);
      });
      pulled.pull = pull;
      pulled.plate.setWorldTransform(
          btTransform(btQuaternion(btVector3(1, btScalar(k), 2).normalized(), btScalar(0.3 * k)),
                      pulled.plate.getWorldTransform().getOrigin()));
      pulled.plate.updateInertiaTensor();
      const Mat3 own = bullet::toCore(pulled.plate.getInvInertiaTensorWorld());
      pulled.stiffen();
      const Mat3& inverse = pulled.group.bodies[0].inverseInertia;
      const double rounding = 10 * precision * own.norm();
      const auto leastOf = [](const Mat3& matrix) {
        return Eigen::SelfAdjointEigenSolver<Mat3>(matrix).eigenvalues().minCoeff();
      };
      EXPECT_GE(leastOf(inverse), -1e-15 * own.norm());
      EXPECT_GE(leastOf(own - inverse), -rounding);
    }
}

// Energies are those of bodies as they are: the springs' inertia would excuse any throw.
TEST(GeometricStiffness, IsNoSourceOfEnergy) {
  PulledPlate pulled;
  pulled.plate.setAngularVelocity({0, 5, 0});
  const Mat3 own = bullet::toCore(pulled.plate.getInvInertiaTensorWorld());
  ASSERT_EQ(pulled.stiffen(), 1);
  EXPECT_EQ(pulled.group.ownInverseInertia(0), own);
  std::vector<Body> bodies = pulled.group.bodies;
  bodies[0].velocity << Vec3::Zero(), 0, 5, 0;
  Island island;
  island.bodies = {0};
  EXPECT_NEAR(bullet::energyOf(pulled.group, island, bodies), 0.5 * 5 * 5 / own(1, 1), 1e-3);
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

// All but a tenth of the springs turns along with the body, but none in steps that change.
TEST(GeometricStiffness, BrakesWithATenthOfItsSprings) {
  for (const bool changes : {false, true}) {
    SCOPED_TRACE(changes);
    PulledPlate pulled;
    const btVector3 turning(1, 2, 3), torque(7, 8, 9);
    pulled.plate.setFlags(0);  // no gyroscopic terms
    pulled.plate.setAngularVelocity(turning);
    pulled.plate.applyTorque(torque);
    const Mat3 inertia = bullet::toCore(pulled.plate.getInvInertiaTensorWorld()).inverse();
    pulled.stiffen(changes ? 2 * BulletWorld::step : BulletWorld::step);
    const Body& body = pulled.group.bodies[0];
    const Mat3 springs = Vec3(0, needed, needed).asDiagonal();
    const Vec3 momentum = (inertia + (changes ? 0 : bullet::GeometricStiffness::along) * springs) *
                              bullet::toCore(turning) +
                          bullet::toCore(torque) * BulletWorld::step;
    EXPECT_LT((body.inverseInertia.inverse() * body.velocity.tail<3>() - momentum).norm(),
              100 * precision * needed);
  }
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
