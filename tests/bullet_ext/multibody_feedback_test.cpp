/// The forces that joints of articulated bodies report.

#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <gtest/gtest.h>

#include <memory>

#include "tests/support/multibody_chain.h"
#include "tests/support/multibody_world.h"

namespace delassus::test {
namespace {

TEST(MultiBodyFeedback, OfAnArmHeldByMotorsIsItsWeight) {
  DelassusMultiBodyWorld world;
  const Chain chain(world, 3);
  world.finish(*chain.tree);
  for (int i = 0; i < 3; ++i)
    world.addConstraint<btMultiBodyJointMotor>(chain.tree, i, btScalar(0), btScalar(1000));
  world.advance(10);
  double weight = 0;
  for (int i = 2; i >= 0; --i) {
    weight += Chain::mass(i) * g;
    EXPECT_NEAR(chain.feedback[i].m_reactionForces.getLinear().y() / weight, 1,
                tolerance(1e-6, 1e-4));
  }
}

constexpr double thrown[] = {0.3, -0.1};  ///< joint velocities, rad/s

/// Motors throw a straight chain of two upwards, from rest.
struct ThrownChain : Chain {
  explicit ThrownChain(MultiBodyWorld& world) : Chain(world, 2) {
    world.finish(*tree);
    for (int i : {0, 1})
      world.addConstraint<btMultiBodyJointMotor>(tree, i, btScalar(thrown[i]), btScalar(1000));
  }
  btVector3 force(int joint) { return feedback[joint].m_reactionForces.getLinear(); }
};

/// Each joint carries all that lies beyond it: Σ m (a + g), with a of the centres of mass.
TEST(MultiBodyFeedback, OfAThrownArmIsThatOfInverseDynamics) {
  DelassusMultiBodyWorld world;
  ThrownChain chain(world);
  world.advance();
  const double first = thrown[0] / h, both = (thrown[0] + thrown[1]) / h;  // rad/s²
  const double beyondSecond = Chain::mass(1) * (first + 0.5 * both + g);
  const double beyondFirst = Chain::mass(0) * (0.5 * first + g) + beyondSecond;
  EXPECT_NEAR(chain.force(1).y() / beyondSecond, 1, tolerance(1e-6, 1e-4));
  EXPECT_NEAR(chain.force(0).y() / beyondFirst, 1, tolerance(1e-6, 1e-4));
}

/// Where joints move, Bullet 3.24 makes no mechanics of our reactions: its pass for constraints
/// adds the Coriolis forces once more. It makes the same of stock's reactions.
TEST(MultiBodyFeedback, OfAMovingArmIsThatOfStock) {
  DelassusMultiBodyWorld ours;
  StockMultiBodyWorld stock;
  ThrownChain a(ours), b(stock);
  for (int step = 0; step < 20; ++step) {
    ours.advance();
    stock.advance();
    for (int joint : {0, 1})
      EXPECT_LE((a.force(joint) - b.force(joint)).length() / b.force(joint).length(),
                tolerance(1e-6, 1e-3))
          << step;
  }
}

/// The far end of a lever lies on a stop; the pivot carries the rest.
TEST(MultiBodyFeedback, OfALeverOnAStop) {
  DelassusMultiBodyWorld world;
  const Chain chain(world, 1);
  const btScalar radius = btScalar(0.1), arm = btScalar(0.8), overlap = btScalar(1e-3);
  auto shape = std::make_unique<btCompoundShape>();
  btSphereShape ball(radius);
  shape->addChildShape(BulletWorld::at({arm - btScalar(0.5), 0, 0}), &ball);
  world.addCollider(*chain.tree, 0, std::move(shape), 0);
  world.finish(*chain.tree);
  world.addSphere(radius, {arm, -2 * radius + overlap, 0}, 0);
  world.info().m_erp2 = 0;
  world.advance(20);

  const double weight = Chain::mass(0) * g, onStop = weight * 0.5 / arm;
  ASSERT_EQ(world.points().size(), 1u);
  EXPECT_NEAR(world.points()[0]->m_appliedImpulse / h, onStop, weight * tolerance(1e-6, 1e-4));
  EXPECT_NEAR(chain.feedback[0].m_reactionForces.getLinear().y(), weight - onStop,
              weight * tolerance(1e-6, 1e-4));
}

}  // namespace
}  // namespace delassus::test
