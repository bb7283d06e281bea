/// More contacts than a body needs: how they share its load.

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <vector>

#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

TEST(Parity, Row33RedundantContactsShareTheLoadEvenly) {
  DelassusWorld world;
  world.addGround();
  world.addCube({0, btScalar(0.5), 0});
  world.advance(30);
  ASSERT_EQ(world.points().size(), 4u);
  for (const btManifoldPoint* point : world.points())
    EXPECT_NEAR(point->m_appliedImpulse, g * h / 4, tolerance(1e-8, 1e-4)) << "the least norm";
}

/// A plate of 5 kg lies on balls at these places under it, without friction.
void expectLeastNorm(const std::vector<btVector3>& places) {
  constexpr double mass = 5, half = 0.6, radius = 0.1, thick = 0.05;
  DelassusWorld world;
  for (const btVector3& place : places)
    world.addSphere(btScalar(radius), place - btVector3(0, btScalar(radius), 0), 0);
  world
      .addBox({btScalar(half), btScalar(thick), btScalar(half)}, {0, btScalar(thick), 0},
              btScalar(mass))
      .setFriction(0);
  world.advance();
  ASSERT_EQ(world.points().size(), places.size());
  // Least Σ W_ii r_i² under a given force and given moments: W_ii r_i is affine in the place.
  const double inertia = mass / 3 * (half * half + thick * thick);
  const auto count = static_cast<int>(places.size());
  Eigen::MatrixX3d affine(count, 3);
  Eigen::VectorXd weighed(count);
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const btManifoldPoint& point = *world.points()[i];
    const double x = point.getPositionWorldOnA().x(), z = point.getPositionWorldOnA().z();
    affine.row(i) << 1, x, z;
    weighed[i] = (1 / mass + (x * x + z * z) / inertia) * point.m_appliedImpulse;
    sum += point.m_appliedImpulse;
  }
  EXPECT_NEAR(sum, mass * g * h, tolerance(1e-8, 1e-4));
  const Eigen::VectorXd fit = affine * affine.colPivHouseholderQr().solve(weighed);
  EXPECT_LT((weighed - fit).norm(), tolerance(1e-6, 1e-3) * weighed.norm());
}

TEST(Parity, Row33FiveAndEightPointsShareByLeastNorm) {
  std::vector<btVector3> places{{0, 0, 0}};
  for (const double x : {-0.5, 0.5})
    for (const double z : {-0.5, 0.5}) places.emplace_back(btScalar(x), 0, btScalar(z));
  expectLeastNorm(places);
  places.front() = {btScalar(0.1), 0, btScalar(-0.3)};
  for (const double x : {-0.2, 0.3, 0.4}) places.emplace_back(btScalar(x), 0, btScalar(0.2));
  expectLeastNorm(places);
}

}  // namespace
}  // namespace delassus::test
