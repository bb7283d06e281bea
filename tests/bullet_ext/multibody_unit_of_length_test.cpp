#include <BulletDynamics/Featherstone/btMultiBodyJointLimitConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <gtest/gtest.h>

#include <vector>

#include "tests/support/multibody_world.h"
#include "tests/support/unit_of_length.h"

namespace delassus::test {
namespace {

using MultiBodyUnitOfLength = UnitOfLength;

/// A tree of balls on a heavier one, with motors and limits in its joints, falls on the plane. The
/// angles of its joints after two seconds.
std::vector<btScalar> anglesOfTree(btScalar unit, const Options& options) {
  MultiBodyWorld world(std::make_unique<btDelassusMultiBodyConstraintSolver>(options));
  addPlane(world, unit);
  const auto inertiaOf = [&](btScalar mass) {
    const btScalar moment = btScalar(0.4) * mass * unitRadius * unitRadius * unit * unit;
    return btVector3(moment, moment, moment);
  };
  const auto sphere = [&] { return std::make_unique<btSphereShape>(unitRadius * unit); };
  btMultiBody& tree =
      world.addTree(ballCount, 2, inertiaOf(2), false, btVector3(0, btScalar(0.6), 0) * unit);
  world.addCollider(tree, -1, sphere()).setRollingFriction(btScalar(0.02) * unit);
  const btVector3 half(unitSpacing / 2 * unit, 0, 0);
  for (int i = 0; i < ballCount; ++i) {
    tree.setupRevolute(i, 1, inertiaOf(1), i - 1, btQuaternion::getIdentity(), btVector3(0, 0, 1),
                       half, half, true);
    world.addCollider(tree, i, sphere()).setRollingFriction(btScalar(0.02) * unit);
  }
  world.finish(tree);
  for (int i = 0; i < ballCount; ++i) {
    world.addConstraint<btMultiBodyJointLimitConstraint>(&tree, i, btScalar(-0.3), btScalar(0.3))
        .setMaxAppliedImpulse(100 * unit * unit);
    world.addConstraint<btMultiBodyJointMotor>(&tree, i, btScalar(i % 2 ? 2 : -1),
                                               btScalar(0.2) * unit * unit);
  }
  world.advance(120);
  std::vector<btScalar> angles;
  for (int i = 0; i < ballCount; ++i) angles.push_back(tree.getJointPos(i));
  return angles;
}

TEST_P(MultiBodyUnitOfLength, MakesNoDifferenceToATree) {
  const std::vector<btScalar> angles = anglesOfTree(1, options());
  for (const btScalar unit : {smallUnit, largeUnit}) {
    const std::vector<btScalar> others = anglesOfTree(unit, options());
    for (int i = 0; i < ballCount; ++i)
      EXPECT_NEAR(others[i], angles[i], tolerance(1e-6, 5e-2)) << unit << " joint " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(WithBudgets, MultiBodyUnitOfLength, testing::Values(0, 5, 10));

}  // namespace
}  // namespace delassus::test
