/// How a world hands its parts to the solver: batches, empty groups, unsplit islands, sleeping,
/// removal, threads.

#include <gtest/gtest.h>

#include <BulletCollision/CollisionDispatch/btGhostObject.h>
#include <BulletCollision/CollisionDispatch/btSimulationIslandManager.h>

#include <random>
#include <thread>

#include "tests/support/bullet_world.h"
#include "tests/support/same_bits.h"

namespace delassus::test {
namespace {

/// Poses and velocities of all bodies, bit for bit.
std::vector<btScalar> motionOf(btDiscreteDynamicsWorld& world) {
  std::vector<btScalar> motion;
  for (int i = 0; i < world.getNumCollisionObjects(); ++i) {
    const btRigidBody& body = *btRigidBody::upcast(world.getCollisionObjectArray()[i]);
    for (const btVector3& v :
         {body.getWorldTransform().getOrigin(), body.getWorldTransform().getBasis()[0],
          body.getLinearVelocity(), body.getAngularVelocity()})
      motion.insert(motion.end(), {v.x(), v.y(), v.z()});
  }
  return motion;
}

/// Heaps of three boxes, thrown together at random, and a row of pendulums.
void build(BulletWorld& world) {
  world.addGround();
  std::mt19937_64 random(7);
  std::uniform_real_distribution<btScalar> some(btScalar(-0.2), btScalar(0.2));
  for (int heap = 0; heap < 6; ++heap)
    for (int i = 0; i < 3; ++i)
      world.addCube(
          {btScalar(3 * heap) + some(random), btScalar(0.6) + i * btScalar(1.1), some(random)});
  for (int i = 0; i < 4; ++i) {
    btRigidBody& ball = world.addSphere(btScalar(0.2), {btScalar(3 * i), 5, 5});
    world.addJoint<btPoint2PointConstraint>(ball, btVector3(1, 0, 0));
  }
}

std::vector<btScalar> motionWithBatch(int batch, int steps = 90) {
  DelassusWorld world;
  world.info().m_minimumSolverBatchSize = batch;
  build(world);
  world.advance(steps);
  return motionOf(*world);
}

TEST(Parity, Row36BatchSizeDoesNotMatter) {
  const std::vector<btScalar> one = motionWithBatch(1);
  expectSameBits(motionWithBatch(0), one);
  expectSameBits(motionWithBatch(128), one);
}

TEST(Parity, Row37EmptyGroups) {
  for (int batch : {0, 1, 128}) {
    DelassusWorld world;
    world.info().m_minimumSolverBatchSize = batch;
    world.advance(3);
    world.addGround();
    world.advance(3);
    EXPECT_EQ(world.report().islands, 0);
  }
  btDelassusConstraintSolver solver;
  solver.prepareSolve(0, 0);
  solver.solveGroup(nullptr, 0, nullptr, 0, nullptr, 0, btContactSolverInfo(), nullptr, nullptr);
  solver.allSolved(btContactSolverInfo(), nullptr);
  EXPECT_TRUE(solver.report().messages.empty());
}

TEST(Parity, Row38UnsplitIslandsSkipObjectsWithoutResponse) {
  DelassusWorld world;
  world->getSimulationIslandManager()->setSplitIslands(false);
  world.addGround();
  btRigidBody& resting = world.addCube({0, btScalar(0.5), 0});
  btRigidBody& sensor = world.addCube({0, btScalar(1.4), 0}, 1);
  sensor.setCollisionFlags(sensor.getCollisionFlags() | btCollisionObject::CF_NO_CONTACT_RESPONSE);
  btBoxShape shape(btVector3(1, 1, 1));
  btGhostObject ghost;
  ghost.setCollisionShape(&shape);
  ghost.setCollisionFlags(btCollisionObject::CF_NO_CONTACT_RESPONSE);
  world->addCollisionObject(&ghost);
  world.advance(30);
  EXPECT_NEAR(resting.getWorldTransform().getOrigin().y(), 0.5, tolerance(1e-9, 1e-4));
  EXPECT_NEAR(sensor.getLinearVelocity().y(), -BulletWorld::gravity * 30 * BulletWorld::step,
              1e3 * precision)
      << "falls through everything";
  world->removeCollisionObject(&ghost);
}

std::vector<btRigidBody*> addAwakeTower(BulletWorld& world, int count) {
  std::vector<btRigidBody*> tower;
  for (int i = 0; i < count; ++i) {
    tower.push_back(&world.addCube({0, btScalar(0.5) + i, 0}));
    tower.back()->forceActivationState(ACTIVE_TAG);
  }
  return tower;
}

/// Steps until the last box of a tower sleeps.
template <class World>
int stepsUntilAsleep() {
  World world;
  world.addGround();
  const auto tower = addAwakeTower(world, 10);
  for (int step = 1; step <= 300; ++step) {
    world.advance();
    bool asleep = true;
    for (const btRigidBody* box : tower) asleep &= box->getActivationState() == ISLAND_SLEEPING;
    if (asleep) return step;
  }
  return 301;
}

TEST(Parity, Row39TowerFallsAsleepNoLaterThanInStock) {
  struct StockAsUsed : StockWorld {
    StockAsUsed() : StockWorld(10) {}
  };
  constexpr int most = 150;  // both sleep two seconds after the start, as Bullet has it
  const int ours = stepsUntilAsleep<DelassusWorld>(), stocks = stepsUntilAsleep<StockAsUsed>();
  EXPECT_LE(ours, stocks);
  EXPECT_LE(ours, most);
  EXPECT_LE(stocks, most) << "or the comparison says nothing";
}

TEST(Parity, Row40RemovedSupportWakesTheTower) {
  DelassusWorld world;
  world.addGround();
  const auto tower = addAwakeTower(world, 4);
  world.advance(150);
  ASSERT_EQ(tower[3]->getActivationState(), ISLAND_SLEEPING);
  for (btRigidBody* box : tower) box->activate();
  world.remove(*tower[0]);
  world.advance(30);
  EXPECT_LT(tower[3]->getWorldTransform().getOrigin().y(), 3);
}

TEST(Parity, Row43SolverInfoIsReadAtEachStep) {
  DelassusWorld world;
  world->setGravity({0, 0, 0});
  world.addGround();
  btRigidBody& ball = world.addSphere(0.5, {0, btScalar(0.45), 0});
  world.advance();
  EXPECT_NEAR(ball.getLinearVelocity().y(), 0, 1e3 * precision) << "split: pushed";
  world.info().m_splitImpulse = false;
  world.info().m_erp2 = btScalar(0.5);
  const double depth = 0.5 - ball.getWorldTransform().getOrigin().y();
  world.advance();
  EXPECT_NEAR(ball.getLinearVelocity().y(), 0.5 * depth / BulletWorld::step,
              tolerance(1e-10, 1e-4));
}

TEST(Parity, Row44BodiesAndJointsMayBeRemovedAtAnyTime) {
  DelassusWorld world;
  world.addGround();
  const auto tower = addAwakeTower(world, 5);
  auto& joint = world.addJoint<btPoint2PointConstraint>(*tower[3], *tower[4], btVector3(0, 0.5, 0),
                                                        btVector3(0, -0.5, 0));
  world.delassus().setContactListener([](const ContactEvent&) {});
  world.advance(5);
  world.remove(joint);
  world.advance(5);
  world.remove(*tower[1]);
  world.advance(60);
  EXPECT_NEAR(tower[4]->getWorldTransform().getOrigin().y(), 3.5, 0.05);
}

TEST(Parity, Row45ResetForgets) {
  const auto run = [](btDelassusConstraintSolver& solver) {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
    btBoxShape shape(btVector3(0.5, 0.5, 0.5));
    btRigidBody ground(0, nullptr, &shape), box(1, nullptr, &shape, btVector3(1, 1, 1));
    box.setWorldTransform(btTransform(btQuaternion(btVector3(1, 1, 0).normalized(), btScalar(0.4)),
                                      btVector3(btScalar(0.2), btScalar(1.3), 0)));
    world.addRigidBody(&ground);
    world.addRigidBody(&box);
    for (int i = 0; i < 60; ++i) world.stepSimulation(BulletWorld::step, 0);
    std::vector<btScalar> motion = motionOf(world);
    world.removeRigidBody(&box);
    world.removeRigidBody(&ground);
    return motion;
  };
  btDelassusConstraintSolver solver;
  const std::vector<btScalar> first = run(solver);
  solver.reset();
  EXPECT_EQ(solver.report().islands, 0);
  expectSameBits(run(solver), first);
}

TEST(Parity, Row46SameInputSameBitsInAnyThread) {
  const std::vector<btScalar> alone = motionWithBatch(128);
  std::vector<std::vector<btScalar>> together(4);
  std::vector<std::thread> threads;
  for (auto& motion : together) threads.emplace_back([&motion] { motion = motionWithBatch(128); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& motion : together) expectSameBits(motion, alone);
}

// Bullet's worlds cast solvers of the one type, its examples those of the other.
TEST(Groups, SolverTypeIsNoneThatIsCast) {
  btDelassusConstraintSolver solver;
  EXPECT_NE(solver.getSolverType(), BT_MULTIBODY_SOLVER);
  EXPECT_NE(solver.getSolverType(), BT_MLCP_SOLVER);
}

}  // namespace
}  // namespace delassus::test
