#include "tests/support/unit_of_length.h"

#include <gtest/gtest.h>

#include <vector>

namespace delassus::test {
namespace {

/// A mast of balls that turn all ways, with hinges between them, some with motors, on a heavy one
/// that stands on the plane and resists rolling. (Only one touches yet: Bullet passes contacts in
/// another order where its margins are larger than balls.) Places after 40 steps, in units.
std::vector<btVector3> placesOfMast(btScalar unit, const Options& options) {
  DelassusWorld world(options);
  addPlane(world, unit);
  std::vector<btRigidBody*> mast;
  for (int i = 0; i < ballCount; ++i) {
    const btVector3 place(0, unitRadius + unitSpacing * i, 0);
    mast.push_back(&world.addSphere(unitRadius * unit, place * unit, btScalar(i == 0 ? 100 : 1)));
    mast[i]->setAngularVelocity(btVector3(i % 3 - 1, 2 - i % 4, btScalar(0.5) * i - 1));
    if (i == 0) continue;
    const btVector3 half(0, unitSpacing / 2 * unit, 0), axis(i % 2, 0, 1 - i % 2);
    auto& hinge =
        world.addJoint<btHingeConstraint>(*mast[i - 1], *mast[i], half, -half, axis, axis);
    hinge.enableAngularMotor(true, btScalar(i - 3), btScalar(0.2) * unit * unit);
  }
  mast[0]->setRollingFriction(btScalar(0.1) * unit);
  mast[0]->setSpinningFriction(btScalar(0.02) * unit);
  world.advance(40);
  std::vector<btVector3> places;
  for (const btRigidBody* body : mast) places.push_back(body->getCenterOfMassPosition() / unit);
  return places;
}

TEST_P(UnitOfLength, MakesNoDifferenceToAMast) {
  const std::vector<btVector3> places = placesOfMast(1, options());
  for (const btScalar unit : {smallUnit, largeUnit}) {
    const std::vector<btVector3> others = placesOfMast(unit, options());
    for (int i = 0; i < ballCount; ++i)
      EXPECT_LT((others[i] - places[i]).length(), tolerance(1e-6, 5e-2)) << unit << " ball " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(WithBudgets, UnitOfLength, testing::Values(0, 5, 10));

}  // namespace
}  // namespace delassus::test
