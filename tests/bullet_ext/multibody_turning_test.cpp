/// Rolling and spinning friction on links of articulated bodies.
#include <gtest/gtest.h>

#include <vector>

#include "tests/support/multibody_world.h"
#include "tests/support/turning_balls.h"

namespace delassus::test {
namespace {

// Stock bounds rolling friction on rigid bodies, but not on links, nor do ours. Such a bound would
// show here: 20 kg weigh more than 1 N·s a step.
TEST(MultiBodyTurning, IsHeardOnALinkWithStocksBoundsOrWithout) {
  constexpr double kappa = 0.02, mass = 20;
  const btScalar inertia = btScalar(mass * inertiaOfUnit);
  for (const bool asStock : {false, true}) {
    DelassusMultiBodyWorld world;
    world.addGround();
    btMultiBody& tree = world.addTree(0, mass, btVector3(inertia, inertia, inertia), false,
                                      vector(0, ballRadius, 0));
    world
        .addCollider(tree, -1, std::make_unique<btSphereShape>(btScalar(ballRadius)), btScalar(0.5))
        .setSpinningFriction(btScalar(kappa));
    world.finish(tree);
    tree.setBaseOmega(vector(0, 9, 0));
    auto& solver = dynamic_cast<btDelassusMultiBodyConstraintSolver&>(world.solver());
    solver.setStockRollingFriction(asStock);
    std::vector<ContactEvent> told;
    solver.setTurningListener([&told](const ContactEvent& event) { told.push_back(event); });
    for (int step = 0; step < 5; ++step) {
      told.clear();
      const btVector3 before = tree.getBaseOmega();
      world.advance();
      ASSERT_EQ(told.size(), 1u);
      const btVector3 lost = (before - tree.getBaseOmega()) * inertia;
      const bool first = told[0].manifold->getBody0() == tree.getBaseCollider();
      EXPECT_LT((lost + (first ? told[0].moment : -told[0].moment)).length(),
                tolerance(1e-8, 1e-3));
      EXPECT_NEAR(told[0].moment.length(), kappa * mass * g * h, tolerance(1e-8, 1e-3));
    }
  }
}

}  // namespace
}  // namespace delassus::test
