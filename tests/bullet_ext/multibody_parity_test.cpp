/// Against Bullet's own articulated solver run to convergence, and against our rigid one.

#include <BulletDynamics/Featherstone/btMultiBodyJointLimitConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <BulletDynamics/Featherstone/btMultiBodyPoint2Point.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "tests/support/multibody_world.h"

namespace delassus::test {
namespace {

/// A chain of links of 0.4 m between ball-shaped ends, bent out of its plane, on a base that is
/// fixed or free.
btMultiBody& addChain(MultiBodyWorld& world, int links, bool fixed, const btVector3& position,
                      btScalar friction = 0) {
  const btScalar I = btScalar(0.02), half = btScalar(0.2), radius = btScalar(0.1);
  btMultiBody& tree = world.addTree(links, 1, btVector3(I, I, I), fixed, position);
  const btVector3 axes[] = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
  world.addCollider(tree, -1, std::make_unique<btSphereShape>(radius), friction);
  for (int i = 0; i < links; ++i) {
    tree.setupRevolute(i, 1 + btScalar(0.1) * i, btVector3(I, 2 * I, 2 * I), i - 1,
                       btQuaternion(axes[(i + 1) % 3], btScalar(0.2)), axes[i % 2],
                       btVector3(half, 0, 0), btVector3(half, 0, 0), true);
    world.addCollider(tree, i, std::make_unique<btSphereShape>(radius), friction);
  }
  world.finish(tree);
  return tree;
}

std::vector<double> motionOf(const btMultiBody& tree) {
  std::vector<double> motion(tree.getVelocityVector(),
                             tree.getVelocityVector() + 6 + tree.getNumDofs());
  for (int i = 0; i < tree.getNumLinks(); ++i) motion.push_back(tree.getJointPos(i));
  for (int i = 0; i < 3; ++i) motion.push_back(tree.getBasePos()[i]);
  return motion;
}

/// Runs one scene with both solvers. Compares step by step the trees that `build` returns.
template <class Build>
void expectSameMotion(const Build& build, int steps, double most) {
  DelassusMultiBodyWorld ours;
  StockMultiBodyWorld stock;
  const btMultiBody& treeOfOurs = build(ours);
  const btMultiBody& treeOfStock = build(stock);
  for (int step = 0; step < steps; ++step) {
    ours.advance();
    stock.advance();
    const std::vector<double> a = motionOf(treeOfOurs), b = motionOf(treeOfStock);
    for (std::size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i], b[i], most) << step << " " << i;
    EXPECT_EQ(ours.report().solved, ours.report().islands);
  }
}

TEST(MultiBodyParity, LoopWithMotorsMovesAsInStock) {
  const auto build = [](MultiBodyWorld& world) -> btMultiBody& {
    btMultiBody& tree = addChain(world, 5, true, btVector3(0, 3, 0));
    const btVector3 end = tree.localPosToWorld(4, btVector3(btScalar(0.2), 0, 0));
    world.addConstraint<btMultiBodyPoint2Point>(&tree, 4, nullptr, btVector3(btScalar(0.2), 0, 0),
                                                end);
    world.addConstraint<btMultiBodyJointMotor>(&tree, 1, btScalar(0.3), btScalar(0.05));
    return tree;
  };
  expectSameMotion(build, 30, tolerance(1e-6, 2e-2));
}

TEST(MultiBodyParity, LimitsStopAsInStock) {
  const auto build = [](MultiBodyWorld& world) -> btMultiBody& {
    world.info().m_splitImpulse = false;
    btMultiBody& tree = addChain(world, 4, true, btVector3(0, 3, 0));
    for (int i = 0; i < 4; ++i)
      world.addConstraint<btMultiBodyJointLimitConstraint>(&tree, i, btScalar(-0.2), btScalar(0.2));
    return tree;
  };
  expectSameMotion(build, 60, tolerance(1e-6, 2e-2));
}

/// Stock splits off the error of a limit that is exceeded by far, and then forgets it.
TEST(MultiBodyParity, DeepLimitsRecoverWithSplitImpulseToo) {
  DelassusMultiBodyWorld world;
  world->setGravity(btVector3(0, 0, 0));
  btMultiBody& tree = addChain(world, 2, true, btVector3(0, 3, 0));
  world.addConstraint<btMultiBodyJointLimitConstraint>(&tree, 1, btScalar(-0.1), btScalar(0.1));
  tree.setJointPos(1, btScalar(0.5));
  ASSERT_TRUE(world.info().m_splitImpulse);
  world.advance(60);
  EXPECT_LE(tree.getJointPos(1), 0.1 + 1e-3);
}

// A split push would move rigid bodies only.
TEST(MultiBodyParity, DeepContactsRecoverWithSplitImpulseToo) {
  constexpr btScalar radius = btScalar(0.5);
  constexpr double depth = 0.1;
  for (const bool linkFirst : {true, false}) {
    DelassusMultiBodyWorld world;
    world->setGravity({0, 0, 0});
    const auto addBall = [&] { return &world.addSphere(radius, {0, btScalar(1 - depth), 0}); };
    const btRigidBody* ball = linkFirst ? nullptr : addBall();
    const btVector3 inertia(btScalar(0.1), btScalar(0.1), btScalar(0.1));
    btMultiBody& link = world.addTree(0, 1, inertia, false);
    world.addCollider(link, -1, std::make_unique<btSphereShape>(radius));
    world.finish(link);
    if (linkFirst) ball = addBall();
    world.advance();
    EXPECT_NEAR(ball->getLinearVelocity().y() - link.getBaseVel().y(), 0.2 * depth / h,
                tolerance(1e-9, 1e-4))
        << linkFirst;
    EXPECT_EQ(world.report().pushIslands, 0) << linkFirst;
  }
}

TEST(MultiBodyParity, TwoTreesOnOneKnotMoveAsInStock) {
  const auto build = [](MultiBodyWorld& world) -> btMultiBody& {
    btMultiBody& one = addChain(world, 3, true, btVector3(0, 3, 0));
    btMultiBody& other = addChain(world, 2, false, btVector3(0, 3, 3));
    const btVector3 end = one.localPosToWorld(2, btVector3(btScalar(0.2), 0, 0));
    const btVector3 there = other.worldPosToLocal(1, end);
    world.addConstraint<btMultiBodyPoint2Point>(&one, 2, &other, 1, btVector3(btScalar(0.2), 0, 0),
                                                there);
    return one;
  };
  expectSameMotion(build, 30, tolerance(1e-6, 2e-2));
}

TEST(MultiBodyParity, ChainLandsOnAFloorAndABoxWithoutFrictionAsInStock) {
  const auto build = [](MultiBodyWorld& world) -> btMultiBody& {
    world.addGround().setFriction(0);
    world.addSphere(btScalar(0.2), {btScalar(0.8), btScalar(0.2), 0}, 2).setFriction(0);
    return addChain(world, 4, false, btVector3(0, btScalar(0.8), 0));
  };
  expectSameMotion(build, 45, tolerance(1e-6, 2e-2));
}

TEST(MultiBodyParity, TreeThatFoldsOntoItselfMovesAsInStock) {
  const auto build = [](MultiBodyWorld& world) -> btMultiBody& {
    world->setGravity(btVector3(0, 0, 0));
    btMultiBody& tree = addChain(world, 3, false, btVector3(0, 3, 0));
    tree.setHasSelfCollision(true);
    tree.setJointPos(1, btScalar(-2.4));
    tree.setJointVel(1, -4);
    MultiBodyWorld::place(tree);
    return tree;
  };
  expectSameMotion(build, 60, tolerance(1e-6, 2e-2));

  DelassusMultiBodyWorld world;
  build(world);
  double touched = 0;
  for (int step = 0; step < 60; ++step) {
    world.advance();
    for (const btManifoldPoint* point : world.points()) touched += point->m_appliedImpulse;
  }
  EXPECT_GT(touched, 0.1);
}

/// Heaps, pendulums and balls, none of them articulated.
template <class World>
std::vector<btScalar> rigidMotion(World& world) {
  world.info().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;  // as multibody worlds set it
  world.addGround();
  for (int heap = 0; heap < 4; ++heap)
    for (int i = 0; i < 3; ++i)
      world.addCube(
          {btScalar(1.2 * heap) + btScalar(0.1) * i, btScalar(0.6) + i * btScalar(1.1), 0});
  btRigidBody& ball = world.addSphere(btScalar(0.3), {btScalar(1.5), 5, 0});
  world.template addJoint<btPoint2PointConstraint>(ball, btVector3(1, 0, 0));
  world.advance(90);
  std::vector<btScalar> motion;
  for (int i = 0; i < world->getNumCollisionObjects(); ++i) {
    const btRigidBody& body = *btRigidBody::upcast(world->getCollisionObjectArray()[i]);
    for (const btVector3& v : {body.getWorldTransform().getOrigin(), body.getLinearVelocity(),
                               body.getAngularVelocity()})
      motion.insert(motion.end(), {v.x(), v.y(), v.z()});
  }
  return motion;
}

TEST(MultiBodyParity, RigidWorldMovesAsWithTheRigidSolver) {
  DelassusMultiBodyWorld articulated;
  DelassusWorld rigid;
  const std::vector<btScalar> a = rigidMotion(articulated), b = rigidMotion(rigid);
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(btScalar)), 0);
}

TEST(MultiBodyParity, FrictionOfATreeIsThatOfARigidBody) {
  const btVector3 half(btScalar(0.3), btScalar(0.1), btScalar(0.2)), start(0, btScalar(0.1), 0);
  const btVector3 push(3, 0, 1);
  DelassusMultiBodyWorld articulated;
  articulated.addGround();
  btVector3 inertia;
  btBoxShape(half).calculateLocalInertia(2, inertia);
  btMultiBody& tree = articulated.addTree(0, 2, inertia, false, start);
  articulated.addCollider(tree, -1, std::make_unique<btBoxShape>(half), btScalar(0.5));
  articulated.finish(tree);
  tree.setBaseVel(push);

  DelassusWorld rigid;
  rigid.addGround();
  btRigidBody& box = rigid.addBox(half, start, 2);
  box.setLinearVelocity(push);
  for (int step = 0; step < 60; ++step) {
    articulated.advance();
    rigid.advance();
    EXPECT_LE((tree.getBaseVel() - box.getLinearVelocity()).length(), tolerance(1e-5, 1e-3))
        << step;
  }
  EXPECT_LE(tree.getBaseVel().length(), 0.01);
}

TEST(MultiBodyParity, RollingFrictionOfATreeIsThatOfARigidBody) {
  const btScalar radius = btScalar(0.25), inertia = btScalar(0.4) * 2 * radius * radius;
  const btVector3 start(0, radius, 0), velocity(1, 0, btScalar(0.5)),
      rotation = btVector3(0, 1 / radius, 0).cross(velocity) + btVector3(0, 2, 0);
  DelassusMultiBodyWorld articulated;
  articulated.addGround();
  btMultiBody& tree = articulated.addTree(0, 2, btVector3(inertia, inertia, inertia), false, start);
  articulated.addCollider(tree, -1, std::make_unique<btSphereShape>(radius), btScalar(0.5));
  articulated.finish(tree);
  tree.setBaseVel(velocity);
  tree.setBaseOmega(rotation);

  DelassusWorld rigid;
  rigid.addGround();
  btRigidBody& ball = rigid.addSphere(radius, start, 2);
  ball.setLinearVelocity(velocity);
  ball.setAngularVelocity(rotation);
  for (btCollisionObject* object : {static_cast<btCollisionObject*>(tree.getBaseCollider()),
                                    static_cast<btCollisionObject*>(&ball)}) {
    object->setRollingFriction(btScalar(0.02));
    object->setSpinningFriction(btScalar(0.005));
  }
  for (int step = 0; step < 60; ++step) {
    articulated.advance();
    rigid.advance();
    EXPECT_LE((tree.getBaseVel() - ball.getLinearVelocity()).length(), tolerance(1e-6, 1e-3))
        << step;
    EXPECT_LE((tree.getBaseOmega() - ball.getAngularVelocity()).length(), tolerance(1e-5, 1e-2))
        << step;
  }
  EXPECT_LE(tree.getBaseVel().length(), 0.8);
}

TEST(MultiBodyParity, BrokenTreeIsLeftOutAndTold) {
  DelassusMultiBodyWorld world;
  world.addGround();
  btRigidBody& box = world.addCube({5, btScalar(0.5), 0});
  btMultiBody& tree = addChain(world, 2, false, btVector3(0, btScalar(0.1), 0));
  world.advance(10);
  tree.setBaseVel(btVector3(std::numeric_limits<btScalar>::quiet_NaN(), 0, 0));
  world.advance();
  ASSERT_FALSE(world.report().messages.empty());
  EXPECT_NE(world.report().messages[0].find("left out"), std::string::npos);
  EXPECT_NE(world.report().messages[0].find(" of the multibody that begins with body 2)"),
            std::string::npos)
      << world.report().messages[0];
  EXPECT_LE(box.getLinearVelocity().length(), tolerance(1e-8, 1e-5));
}

TEST(MultiBodyParity, RowsThatAreNoNumbersAreLeftOutAndTold) {
  DelassusMultiBodyWorld world;
  world.addGround();
  btMultiBody& tree = addChain(world, 2, true, btVector3(0, 3, 0));
  auto& motor = world.addConstraint<btMultiBodyJointMotor>(&tree, 1, btScalar(1), btScalar(10));
  world.advance(2);
  EXPECT_TRUE(world.report().messages.empty());
  motor.setVelocityTarget(std::numeric_limits<btScalar>::quiet_NaN());
  world.advance();
  ASSERT_EQ(world.report().messages.size(), 1u);
  EXPECT_NE(world.report().messages[0].find("is not finite"), std::string::npos)
      << world.report().messages[0];
  EXPECT_TRUE(std::isfinite(tree.getJointVel(1)));
}

// The partner that held the chain is left out, and so does not hold it any more.
TEST(MultiBodyParity, RowsWhosePartnerIsLeftOutAreLeftOutAndTold) {
  const auto swing = [](bool isHeld) {
    DelassusMultiBodyWorld world;
    btMultiBody& tree = addChain(world, 2, true, btVector3(0, 3, 0));
    btRigidBody& box = world.addCube({0, 30, 0});
    if (isHeld)
      world
          .addConstraint<btMultiBodyPoint2Point>(&tree, 1, &box, btVector3(btScalar(0.2), 0, 0),
                                                 btVector3(0, 0, 0))
          .setMaxAppliedImpulse(BT_LARGE_FLOAT);
    box.setLinearVelocity({0, std::numeric_limits<btScalar>::quiet_NaN(), 0});
    world.advance();
    int rows = 0;
    for (const std::string& message : world.report().messages)
      rows += message.find("one of its bodies is left out") != std::string::npos;
    EXPECT_EQ(rows, isHeld ? 3 : 0);
    return tree.getJointVel(0);
  };
  EXPECT_EQ(swing(true), swing(false));
}

/// The message names link and multibody, by their own names if they have some.
TEST(MultiBodyParity, TroubleNamesLinkAndMultiBody) {
  DelassusMultiBodyWorld world;
  btMultiBody& tree = addChain(world, 2, true, btVector3(0, 3, 0));
  // One end of the chain is held in two places at once, whatever force it takes.
  for (const btScalar x : {btScalar(0.5), btScalar(1.5)})
    world
        .addConstraint<btMultiBodyPoint2Point>(&tree, 1, nullptr, btVector3(btScalar(0.2), 0, 0),
                                               btVector3(x, 3, 0))
        .setMaxAppliedImpulse(BT_LARGE_FLOAT);
  world.advance();
  ASSERT_FALSE(world.report().messages.empty());
  EXPECT_EQ(world.report().messages[0].rfind(
                "a constraint of link 1 of the multibody that begins with body 0: ", 0),
            0u)
      << world.report().messages[0];

  tree.setBaseName("arm");
  tree.getLink(1).m_linkName = "wrist";
  world.advance();
  ASSERT_FALSE(world.report().messages.empty());
  EXPECT_EQ(
      world.report().messages[0].rfind("a constraint of link 1 'wrist' of multibody 'arm': ", 0),
      0u)
      << world.report().messages[0];
}

TEST(MultiBodyParity, ListenerHearsTheContactsOfATree) {
  DelassusMultiBodyWorld world;
  world.addGround();
  addChain(world, 2, false, btVector3(0, btScalar(0.5), 0), btScalar(0.5));
  int events = 0, changes = 0;
  dynamic_cast<btDelassusMultiBodyConstraintSolver&>(world.solver())
      .setContactListener([&](const ContactEvent& event) { events += event.from != event.to; });
  for (int step = 0; step < 60; ++step) {
    world.advance();
    changes += world.report().modeChanges;
  }
  EXPECT_GT(events, 0);
  EXPECT_EQ(events, changes);
}

}  // namespace
}  // namespace delassus::test
