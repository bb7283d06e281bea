/// Worlds that change between steps: the solver reads nothing of things that are gone, and keeps
/// nothing of them. (Run under the address sanitizer as well.)

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "tests/support/bullet_world.h"
#include "tests/support/same_bits.h"

namespace delassus::test {
namespace {

std::vector<btScalar> motionOf(BulletWorld& world) {
  std::vector<btScalar> motion;
  for (int i = 0; i < world->getNumCollisionObjects(); ++i) {
    const btRigidBody& body = *btRigidBody::upcast(world->getCollisionObjectArray()[i]);
    for (const btVector3& v :
         {body.getWorldTransform().getOrigin(), body.getWorldTransform().getBasis()[0],
          body.getLinearVelocity(), body.getAngularVelocity()})
      motion.insert(motion.end(), {v.x(), v.y(), v.z()});
  }
  return motion;
}

/// Largest difference of two motions, m and m/s.
double difference(const std::vector<btScalar>& a, const std::vector<btScalar>& b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, double(std::abs(a[i] - b[i])));
  return largest;
}

/// Three boxes on top of each other and a pendulum of two links, at `x`.
void addTowerAndPendulum(BulletWorld& world, btScalar x) {
  world.addGround();
  for (int i = 0; i < 3; ++i) world.addCube({x + btScalar(0.1) * i, btScalar(0.5) + i, 0});
  btRigidBody& upper = world.addSphere(btScalar(0.2), {x, 4, 3});
  btRigidBody& lower = world.addSphere(btScalar(0.2), {x + 1, 4, 3});
  world.addJoint<btPoint2PointConstraint>(upper, btVector3(-1, 0, 0));
  world.addJoint<btPoint2PointConstraint>(lower, upper, btVector3(-1, 0, 0), btVector3(0, 0, 0));
}

/// Takes out and puts in bodies and joints, changes masses, shapes and flags, all at random.
class Meddler {
 public:
  explicit Meddler(BulletWorld& world) : world_(world) { world.addGround(); }

  void meddle() {
    switch (random_() % 8) {
      case 0:
      case 1:
        addBody();
        break;
      case 2:
        removeBody();
        break;
      case 3:
        addJoint();
        break;
      case 4:
        removeJoint();
        break;
      case 5:
        changeMass();
        break;
      case 6:
        changeShape();
        break;
      case 7:
        changeFlags();
        break;
    }
  }

 private:
  btScalar some(double from, double to) {
    return btScalar(std::uniform_real_distribution<double>(from, to)(random_));
  }
  btRigidBody* anyBody() { return bodies_.empty() ? nullptr : bodies_[random_() % bodies_.size()]; }

  void addBody() {
    bodies_.push_back(&world_.addCube({some(-2, 2), some(0.5, 5), some(-2, 2)}, some(0.5, 5)));
  }
  void removeBody() {
    btRigidBody* body = anyBody();
    if (!body) return;
    for (std::size_t i = joints_.size(); i-- > 0;)
      if (&joints_[i]->getRigidBodyA() == body || &joints_[i]->getRigidBodyB() == body) take(i);
    bodies_.erase(std::find(bodies_.begin(), bodies_.end(), body));
    world_.remove(*body);
  }
  void addJoint() {
    if (bodies_.size() < 2) return;
    btRigidBody &a = *bodies_[random_() % bodies_.size()],
                &b = *bodies_[random_() % bodies_.size()];
    const btVector3 inA(some(-1, 1), some(-1, 1), 0), inB(some(-1, 1), some(-1, 1), 0);
    if (&a == &b || random_() % 2)
      joints_.push_back(&world_.addJoint<btHingeConstraint>(a, inA, btVector3(0, 0, 1)));
    else
      joints_.push_back(&world_.addJoint<btPoint2PointConstraint>(a, b, inA, inB));
  }
  void removeJoint() {
    if (!joints_.empty()) take(random_() % joints_.size());
  }
  void take(std::size_t i) {
    btTypedConstraint* joint = joints_[i];
    joints_.erase(joints_.begin() + std::ptrdiff_t(i));
    world_.remove(*joint);
  }
  /// Bullet requires a body to be out of the world when it turns static or dynamic.
  void changeMass() {
    btRigidBody* body = anyBody();
    if (!body) return;
    world_->removeRigidBody(body);
    const btScalar mass = random_() % 3 ? some(0.1, 10) : 0;
    btVector3 inertia(0, 0, 0);
    if (mass > 0) body->getCollisionShape()->calculateLocalInertia(mass, inertia);
    body->setMassProps(mass, inertia);
    body->updateInertiaTensor();
    world_->addRigidBody(body);
  }
  void changeShape() {
    btRigidBody* body = anyBody();
    if (!body) return;
    world_->getBroadphase()->getOverlappingPairCache()->cleanProxyFromPairs(
        body->getBroadphaseHandle(), &world_.dispatcher());
    body->setCollisionShape(random_() % 2 ? static_cast<btCollisionShape*>(&ball_) : &plate_);
  }
  void changeFlags() {
    btRigidBody* body = anyBody();
    if (!body) return;
    constexpr int flags[] = {btCollisionObject::CF_NO_CONTACT_RESPONSE,
                             btCollisionObject::CF_KINEMATIC_OBJECT,
                             btCollisionObject::CF_HAS_CONTACT_STIFFNESS_DAMPING};
    body->setCollisionFlags(body->getCollisionFlags() ^ flags[random_() % 3]);
    if (random_() % 2)
      body->setLinearFactor({1, 1, btScalar(random_() % 2)});
    else
      body->forceActivationState(random_() % 2 ? DISABLE_SIMULATION : DISABLE_DEACTIVATION);
  }

  BulletWorld& world_;
  std::mt19937_64 random_{11};
  std::vector<btRigidBody*> bodies_;
  std::vector<btTypedConstraint*> joints_;
  btSphereShape ball_{btScalar(0.4)};
  btBoxShape plate_{btVector3(1, btScalar(0.1), 1)};
};

/// Steps while everything changes. Two meddlers with the same seed do the same.
std::vector<btScalar> meddledMotion(int steps, long& told) {
  auto world = std::make_unique<DelassusWorld>();
  Meddler meddler(*world);
  world->delassus().setContactListener([&](const ContactEvent& event) {
    ++told;
    EXPECT_LT(event.point, event.manifold->getNumContacts());
  });
  for (int i = 0; i < steps; ++i) {
    meddler.meddle();
    world->advance();
    EXPECT_EQ(world->report().leftOut, 0);
    EXPECT_EQ(world->report().nonFinite, 0);
  }
  std::vector<btScalar> motion = motionOf(*world);
  world.reset();  // before the shapes of the meddler
  return motion;
}

TEST(ChangingWorlds, EverythingChangesAndTheMotionIsTheSameAgain) {
  long told = 0;
  const std::vector<btScalar> first = meddledMotion(120, told);
  EXPECT_GT(told, 100) << "contacts came and went";
  for (btScalar x : first) ASSERT_TRUE(std::isfinite(x));
  // The heap is filled differently in the second run: the places of things must not matter.
  std::vector<std::unique_ptr<char[]>> clutter;
  for (std::size_t i = 0; i < 1000; ++i) clutter.emplace_back(new char[100 + 17 * i % 3000]);
  for (std::size_t i = 0; i < clutter.size(); i += 2) clutter[i].reset();
  expectSameBits(meddledMotion(120, told), first);
}

TEST(ChangingWorlds, AClearedWorldLeavesNothingBehind) {
  DelassusWorld fresh;
  addTowerAndPendulum(fresh, 0);
  fresh.advance(30);
  for (int emptySteps : {0, 1}) {
    DelassusWorld world;
    addTowerAndPendulum(world, btScalar(0.3));
    world.advance(25);
    world.clear();
    world.advance(emptySteps);
    addTowerAndPendulum(world, 0);
    world.advance(30);
    EXPECT_EQ(world.report().islands, 2);
    // A broadphase that has been used gives out pairs in another order: equal up to rounding.
    EXPECT_LT(difference(motionOf(world), motionOf(fresh)), tolerance(1e-6, 1e-2)) << emptySteps;
  }
}

TEST(ChangingWorlds, ThroughStockAndBack) {
  DelassusWorld world;
  addTowerAndPendulum(world, 0);
  btSequentialImpulseConstraintSolver stock;
  for (int turn = 0; turn < 6; ++turn) {
    world.advance(10);
    EXPECT_EQ(world.report().solved, world.report().islands);
    EXPECT_GE(world.report().stick + world.report().slide, 9) << "three or four under each box";
    world->setConstraintSolver(&stock);
    world.advance(10);
    world->setConstraintSolver(&world.delassus());
  }
  for (int i = 1; i <= 3; ++i)
    EXPECT_NEAR(
        btRigidBody::upcast(world->getCollisionObjectArray()[i])->getLinearVelocity().length(), 0,
        1e-2);
}

TEST(ChangingWorlds, ASolverThatIsGoneIsNotMissed) {
  DelassusWorld world;
  addTowerAndPendulum(world, 0);
  for (int i = 0; i < 5; ++i) {
    auto other = std::make_unique<btDelassusConstraintSolver>();
    world->setConstraintSolver(other.get());
    world.advance(5);
    EXPECT_EQ(other->report().solved, 2);
    EXPECT_GT(other->report().contacts, 0);
    world->setConstraintSolver(&world.delassus());
  }
  world.advance(5);
  EXPECT_EQ(world.report().solved, 2);
}

TEST(ChangingWorlds, TwoWorldsTakeTurnsWithOneSolver) {
  DelassusWorld first, second;
  DelassusWorld firstAlone, secondAlone;
  for (BulletWorld* world : {&first, &firstAlone}) addTowerAndPendulum(*world, 0);
  for (BulletWorld* world : {&second, &secondAlone}) {
    addTowerAndPendulum(*world, btScalar(0.5));
    world->addCube({btScalar(5), 3, 0}, 20).setLinearVelocity({1, 0, 0});
  }
  btDelassusConstraintSolver shared;
  // Off, since it remembers from the last step what the joints of this world have pulled.
  for (btDelassusConstraintSolver* solver :
       {&shared, &firstAlone.delassus(), &secondAlone.delassus()})
    solver->setGeometricStiffness(false);
  first->setConstraintSolver(&shared);
  second->setConstraintSolver(&shared);
  for (int i = 0; i < 60; ++i) {
    first.advance();
    EXPECT_EQ(shared.report().islands, 2);
    second.advance();
    EXPECT_EQ(shared.report().solved, shared.report().islands);
    if (i == 30) shared.reset();
  }
  firstAlone.advance(60);
  secondAlone.advance(60);
  EXPECT_LT(difference(motionOf(first), motionOf(firstAlone)), tolerance(1e-6, 1e-2));
  EXPECT_LT(difference(motionOf(second), motionOf(secondAlone)), tolerance(1e-6, 1e-2));
  first->setConstraintSolver(&first.delassus());
  second->setConstraintSolver(&second.delassus());
}

TEST(ChangingWorlds, BodiesRemovedInATickCallback) {
  DelassusWorld world;
  addTowerAndPendulum(world, 0);
  btRigidBody* top = btRigidBody::upcast(world->getCollisionObjectArray()[3]);
  world->setInternalTickCallback(
      [](btDynamicsWorld* inside, btScalar) {
        auto& doomed = *static_cast<btRigidBody*>(inside->getWorldUserInfo());
        if (doomed.isInWorld()) inside->removeRigidBody(&doomed);
      },
      top);
  world->stepSimulation(4 * BulletWorld::step, 4, BulletWorld::step);
  EXPECT_EQ(world.report().contacts, 8);
  EXPECT_EQ(world.report().solved, world.report().islands);
}

TEST(ChangingWorlds, ANewJointIsNotTakenForTheOneThatLayThere) {
  // Same place in memory, same bodies: only the impulse that the joint carries tells them apart.
  const auto run = [](bool atTheSamePlace) {
    DelassusWorld world;
    btRigidBody& ball = world.addSphere(btScalar(0.2), {1, 4, 0});
    alignas(16) unsigned char places[2][sizeof(btPoint2PointConstraint)];
    auto* joint = new (places[0]) btPoint2PointConstraint(ball, btVector3(-1, 0, 0));
    world->addConstraint(joint);
    world.advance(20);
    world->removeConstraint(joint);
    joint->~btPoint2PointConstraint();
    joint = new (places[atTheSamePlace ? 0 : 1]) btPoint2PointConstraint(ball, btVector3(-1, 0, 0));
    world->addConstraint(joint);
    world.advance(20);
    std::vector<btScalar> motion = motionOf(world);
    world->removeConstraint(joint);
    joint->~btPoint2PointConstraint();
    return motion;
  };
  expectSameBits(run(true), run(false));
}

TEST(ChangingWorlds, ANewBodyIsNotTakenForTheOneThatLayThere) {
  // Same place in memory, same pose: only the number that the world gives to the body is new.
  const auto run = [](bool atTheSamePlace) {
    DelassusWorld world;
    world.addGround();
    for (const int i : {0, 1})
      world.addCube({btScalar(0.17) * i, btScalar(0.49) + btScalar(0.99) * i, btScalar(0.1) * i});
    btBoxShape shape(btVector3(btScalar(0.5), btScalar(0.5), btScalar(0.5)));
    alignas(16) unsigned char places[2][sizeof(btRigidBody)];
    const auto put = [&](int place, const btRigidBody* like) {
      btVector3 inertia;
      shape.calculateLocalInertia(3, inertia);
      btRigidBody::btRigidBodyConstructionInfo info(3, nullptr, &shape, inertia);
      info.m_startWorldTransform = like ? like->getWorldTransform()
                                        : world.at({btScalar(0.3), btScalar(2.46), btScalar(0.1)});
      const btVector3 velocity = like ? like->getLinearVelocity() : btVector3(0, 0, 0),
                      turning = like ? like->getAngularVelocity() : btVector3(0, 0, 0);
      if (like) like->~btRigidBody();
      auto* body = new (places[place]) btRigidBody(info);
      body->setLinearVelocity(velocity);
      body->setAngularVelocity(turning);
      world->addRigidBody(body);
      return body;
    };
    btRigidBody* body = put(0, nullptr);
    world.advance(19);
    world->removeRigidBody(body);
    body = put(atTheSamePlace ? 0 : 1, body);
    std::vector<btScalar> motion;
    for (int i = 0; i < 20; ++i) {
      world.advance();
      const std::vector<btScalar> now = motionOf(world);
      motion.insert(motion.end(), now.begin(), now.end());
    }
    world->removeRigidBody(body);
    body->~btRigidBody();
    return motion;
  };
  expectSameBits(run(true), run(false));
}

// A program that steps as fast as it renders has no two steps of the same length.
TEST(ChangingWorlds, WhatRestsIsKeptInStepsOfAnyLength) {
  DelassusWorld world;
  world.addGround();
  for (int i = 0; i < 3; ++i) world.addCube({0, btScalar(0.5) + i, 0});
  world.advance(5);
  int kept = 0;
  for (int i = 0; i < 50; ++i) {
    world->stepSimulation(BulletWorld::step * (1 + btScalar(0.1) * btScalar(i % 7)), 0);
    kept += world.report().keptIslands;
    EXPECT_EQ(world.report().solved, 1);
  }
  EXPECT_GE(kept, tolerance(50, 40)) << "of 50";
}

TEST(ChangingWorlds, StepsThatNobodyAnnouncesTakeNoMoreMemory) {
  // A solver pool does not call prepareSolve.
  DelassusWorld world;
  addTowerAndPendulum(world, 0);
  world.advance();
  std::vector<btCollisionObject*> bodies;
  for (int i = 0; i < world->getNumCollisionObjects(); ++i)
    bodies.push_back(world->getCollisionObjectArray()[i]);
  std::vector<btPersistentManifold*> manifolds;
  for (int i = 0; i < world.dispatcher().getNumManifolds(); ++i)
    manifolds.push_back(world.dispatcher().getManifoldByIndexInternal(i));
  std::vector<btTypedConstraint*> joints;
  for (int i = 0; i < world->getNumConstraints(); ++i) joints.push_back(world->getConstraint(i));

  // Nor do unannounced steps after one that was announced, in one group or in two.
  for (const bool announced : {false, true})
    for (const int groups : {1, 2}) {
      SCOPED_TRACE(::testing::Message() << announced << ", groups: " << groups);
      btDelassusConstraintSolver solver;
      if (announced) solver.prepareSolve(int(bodies.size()), int(manifolds.size()));
      std::size_t warm = 0;
      for (int i = 0; i < 200; ++i) {
        const int together = groups == 1 ? int(joints.size()) : 0;
        solver.solveGroup(bodies.data(), int(bodies.size()), manifolds.data(),
                          int(manifolds.size()), joints.data(), together, world.info(), nullptr,
                          &world.dispatcher());
        if (groups == 2)
          solver.solveGroup(nullptr, 0, nullptr, 0, joints.data(), int(joints.size()), world.info(),
                            nullptr, &world.dispatcher());
        if (i == 100) warm = solver.report().workspaceBytes;
      }
      EXPECT_GT(warm, 0u);
      EXPECT_EQ(solver.report().workspaceBytes, warm);
    }
}

}  // namespace
}  // namespace delassus::test
