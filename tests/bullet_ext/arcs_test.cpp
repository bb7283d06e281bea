#include "bullet_ext/arcs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bullet_ext/gather.h"
#include "bullet_ext/thrown_bodies.h"
#include "delassus/contact_motion.h"
#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

/// The group of a joint and its bodies.
void gather(BulletWorld& world, btTypedConstraint& joint, bullet::Group& group) {
  btTypedConstraint* joints[] = {&joint};
  StepReport report;
  bullet::gatherGroup(group, {nullptr, 0, nullptr, 0, joints, 1, &world.info(), nullptr}, report);
}

// W_ii is the sum of 1/m, as that of a row along an axis through the centres.
TEST(Arcs, RowsAboutAnAxisRespondAsRowsAlongOne) {
  DelassusWorld world;
  btRigidBody& rod = world.addBox({2, btScalar(0.1), btScalar(0.3)}, {0, 0, 0}, 3);
  btRigidBody& cube = world.addCube({0, 2, 0}, 5);
  const btVector3 axis(btScalar(0.6), btScalar(0.8), 0);
  auto& hinge = world.addJoint<btHingeConstraint>(rod, cube, btVector3(0, 1, 0),
                                                  btVector3(0, -1, 0), axis, axis);
  hinge.enableAngularMotor(true, 1, 1);
  bullet::Group group;
  gather(world, hinge, group);
  ASSERT_EQ(std::count_if(group.rows.begin(), group.rows.end(), bullet::turns), 3);
  for (const Row& row : group.rows)
    if (bullet::turns(row)) {
      EXPECT_NEAR(diagonal(group.bodies, row), 1.0 / 3 + 1.0 / 5, 100 * precision);
    }
}

// Bodies that turn about their own z only. In world axes their other two moments are rounding.
TEST(Arcs, AreNotMadeOfRounding) {
  DelassusWorld world;
  for (int i = 0; i < 20; ++i) {
    btRigidBody &top = world.addCube({0, 0, 0}, 3), &base = world.addCube({0, 0, 0}, 0);
    top.setMassProps(3, {0, 0, 2});
    const btQuaternion tilt(btVector3(1, 2, btScalar(i)).normalized(), btScalar(1 + 0.1 * i));
    top.setWorldTransform(btTransform(tilt, {0, 0, 0}));
    top.updateInertiaTensor();
    // About z, like the body.
    auto& hinge = world.addJoint<btHingeConstraint>(top, base, world.at({0, 0, 0}),
                                                    btTransform(tilt, {0, 0, 0}));
    hinge.enableAngularMotor(true, 1, 1);
    bullet::Group group;
    gather(world, hinge, group);
    int arcs = 0;
    for (int k = 0; k < static_cast<int>(group.rows.size()); ++k)
      if (const double arc = group.arcOf(k); arc != 1) {
        EXPECT_NEAR(arc, std::sqrt(2.0 / 3), 1e-3) << i;
        ++arcs;
      }
    EXPECT_EQ(arcs, 1) << i;
  }
}

// Neither of a row along an axis nor of one about an axis.
TEST(Arcs, LeaveBreakingThresholdsWhatTheyAre) {
  DelassusWorld world;
  for (const btScalar half : {btScalar(0.1), btScalar(10)}) {
    btRigidBody& cube = world.addBox({half, half, half}, {0, 0, 0});
    auto& weld =
        world.addJoint<btFixedConstraint>(cube, world.addBox({half, half, half}, {3 * half, 0, 0}),
                                          world.at({half, 0, 0}), world.at({-2 * half, 0, 0}));
    weld.setBreakingImpulseThreshold(7);
    bullet::Group group;
    gather(world, weld, group);
    ASSERT_EQ(group.rows.size(), 6U);
    for (int row = 0; row < 6; ++row)
      for (const bool up : {false, true}) EXPECT_FALSE(bullet::drives(group, row, up)) << row;
  }
}

}  // namespace
}  // namespace delassus::test
