#pragma once
/// Worlds of other sizes. Where all lengths, forces and torques are measured in another unit, the
/// same happens, also with few sweeps, which end before all laws are met. The unit is a power of
/// two, so that rounding is the same.

#include <gtest/gtest.h>

#include <memory>

#include "tests/support/bullet_world.h"

namespace delassus::test {

constexpr btScalar smallUnit = btScalar(1) / 1024, largeUnit = 64;           // m
constexpr btScalar unitRadius = btScalar(0.5), unitSpacing = btScalar(1.1);  // units
constexpr int ballCount = 6;

template <class World>
void addPlane(World& world, btScalar unit) {
  world->setGravity(btVector3(0, -World::gravity * unit, 0));
  world.info().m_splitImpulse = false;  // from 4 cm of overlap on, in any unit
  world.addBody(std::make_unique<btStaticPlaneShape>(btVector3(0, 1, 0), 0),
                btTransform::getIdentity(), 0);
}

/// By budget; 0 is the default.
class UnitOfLength : public testing::TestWithParam<int> {
 protected:
  Options options() const { return GetParam() > 0 ? Options::bounded(GetParam()) : Options(); }
};

}  // namespace delassus::test
