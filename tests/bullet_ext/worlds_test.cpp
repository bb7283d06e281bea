/// Other worlds and their contents: Mt world and solver pool, articulated and soft bodies,
/// vehicles, characters.

#include <gtest/gtest.h>

#include <BulletCollision/CollisionDispatch/btGhostObject.h>
#include <BulletDynamics/Character/btKinematicCharacterController.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorldMt.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBodyHelpers.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>

#include <array>
#include <thread>

#include "tests/support/bullet_world.h"
#include "tests/support/same_bits.h"

namespace delassus::test {
namespace {

constexpr btScalar step = BulletWorld::step;

std::vector<btScalar> motionOf(const std::vector<btRigidBody*>& bodies) {
  std::vector<btScalar> motion;
  for (const btRigidBody* body : bodies)
    for (const btVector3& v :
         {body->getWorldTransform().getOrigin(), body->getWorldTransform().getBasis()[0],
          body->getLinearVelocity(), body->getAngularVelocity()})
      motion.insert(motion.end(), {v.x(), v.y(), v.z()});
  return motion;
}

/// Whether entry i of the numbers that motionOf gives is a velocity.
bool isVelocity(std::size_t i) { return i % 12 >= 6; }

/// Towers side by side on one ground and one moving platform, which they all share.
struct Towers {
  static constexpr int count = 8, storeys = 3;

  btBoxShape slab{btVector3(50, 1, 50)}, cube{btVector3(0.5, 0.5, 0.5)};
  btRigidBody ground{0, nullptr, &slab}, platform{0, nullptr, &slab};
  std::vector<std::unique_ptr<btRigidBody>> owned;
  std::vector<btRigidBody*> boxes;

  Towers() {
    ground.setWorldTransform(BulletWorld::at({0, -1, 0}));
    platform.setWorldTransform(BulletWorld::at({0, -1, 200}));
    platform.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
    for (int tower = 0; tower < count; ++tower)
      for (int i = 0; i < storeys; ++i) {
        btVector3 inertia;
        cube.calculateLocalInertia(1, inertia);
        owned.push_back(std::make_unique<btRigidBody>(1, nullptr, &cube, inertia));
        const btScalar z = tower % 2 ? 200 : 0, lean = btScalar(0.02) * i * tower;
        owned.back()->setWorldTransform(
            BulletWorld::at({3 * btScalar(tower) + lean, btScalar(0.5) + i, z}));
        owned.back()->setActivationState(DISABLE_DEACTIVATION);
        boxes.push_back(owned.back().get());
      }
  }

  void addTo(btDiscreteDynamicsWorld& world) {
    world.addRigidBody(&ground);
    world.addRigidBody(&platform);
    for (btRigidBody* box : boxes) world.addRigidBody(box);
  }
  void removeFrom(btDiscreteDynamicsWorld& world) {
    for (btRigidBody* box : boxes) world.removeRigidBody(box);
    world.removeRigidBody(&platform);
    world.removeRigidBody(&ground);
  }
  void run(btDiscreteDynamicsWorld& world, int steps = 60) {
    addTo(world);
    for (int i = 1; i <= steps; ++i) {
      // So gently that nothing slides.
      const btScalar time = i * step;
      platform.setWorldTransform(BulletWorld::at({btScalar(0.15) * time * time, -1, 200}));
      world.stepSimulation(step, 0);
    }
    removeFrom(world);
  }
};

std::vector<btScalar> motionInMtWorld() {
  Towers towers;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  // The pool owns its solvers; the world does not own its solver for large islands.
  std::array<btConstraintSolver*, 4> solvers;
  for (btConstraintSolver*& solver : solvers) solver = new btDelassusConstraintSolver;
  btConstraintSolverPoolMt pool(solvers.data(), int(solvers.size()));
  btDelassusConstraintSolver large;
  btDiscreteDynamicsWorldMt world(&dispatcher, &broadphase, &pool, &large, &configuration);
  towers.run(world);
  return motionOf(towers.boxes);
}

TEST(Parity, Row48MtWorldWithAPoolOfFour) {
  Towers towers;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btDelassusConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  towers.run(world);
  const std::vector<btScalar> plain = motionOf(towers.boxes), pooled = motionInMtWorld();
  // The Mt world hands contacts over in another order. The motion is the same up to rounding, and
  // up to what the narrow phase makes of rounding when it picks the points of a box anew: then a
  // leaning tower jerks by some mm/s for a step.
  for (std::size_t i = 0; i < plain.size(); ++i)
    ASSERT_NEAR(pooled[i], plain[i], isVelocity(i) ? 1e-2 : 1e-3) << i;
  expectSameBits(motionInMtWorld(), pooled);
}

/// Hands each tower alone to one of the solvers, in threads or one after the other.
class DealingSolver : public btConstraintSolver {
 public:
  explicit DealingSolver(bool threads) : threads_(threads) {}

  btScalar solveGroup(btCollisionObject** bodies, int bodyCount, btPersistentManifold** manifolds,
                      int manifoldCount, btTypedConstraint**, int, const btContactSolverInfo& info,
                      btIDebugDraw*, btDispatcher* dispatcher) override {
    if (bodyCount == 0) return 0;
    std::vector<std::thread> threads;
    for (std::size_t hand = 0; hand < solvers_.size(); ++hand) {
      const auto work = [=, &info] {
        for (int tower = int(hand); tower < Towers::count; tower += int(solvers_.size()))
          solveTower(solvers_[hand], tower, bodies, bodyCount, manifolds, manifoldCount, info,
                     dispatcher);
      };
      if (threads_)
        threads.emplace_back(work);
      else
        work();
    }
    for (std::thread& thread : threads) thread.join();
    return 0;
  }
  void reset() override {}
  btConstraintSolverType getSolverType() const override { return solvers_[0].getSolverType(); }

 private:
  static int towerOf(const btCollisionObject& object) {
    // Ground and platform come first in the world.
    return (object.getWorldArrayIndex() - 2) / Towers::storeys;
  }

  static void solveTower(btDelassusConstraintSolver& solver, int tower, btCollisionObject** bodies,
                         int bodyCount, btPersistentManifold** manifolds, int manifoldCount,
                         const btContactSolverInfo& info, btDispatcher* dispatcher) {
    std::vector<btCollisionObject*> own;
    for (int i = 0; i < bodyCount; ++i)
      if (towerOf(*bodies[i]) == tower) own.push_back(bodies[i]);
    std::vector<btPersistentManifold*> ownManifolds;
    for (int i = 0; i < manifoldCount; ++i) {
      const btCollisionObject &a = *manifolds[i]->getBody0(), &b = *manifolds[i]->getBody1();
      if (towerOf(a.isStaticOrKinematicObject() ? b : a) == tower)
        ownManifolds.push_back(manifolds[i]);
    }
    solver.prepareSolve(int(own.size()), int(ownManifolds.size()));
    solver.solveGroup(own.data(), int(own.size()), ownManifolds.data(), int(ownManifolds.size()),
                      nullptr, 0, info, nullptr, dispatcher);
  }

  bool threads_;
  mutable std::array<btDelassusConstraintSolver, 4> solvers_;
};

TEST(Parity, Row48FourSolversInFourThreadsShareKinematicAndStaticBodies) {
  std::array<Towers, 2> towers;
  for (bool threads : {false, true}) {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    DealingSolver solver(threads);
    btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
    world.getSolverInfo().m_minimumSolverBatchSize = 100000;
    towers[threads].run(world);
  }
  expectSameBits(motionOf(towers[1].boxes), motionOf(towers[0].boxes));
}

TEST(Parity, Row49MultiBodyWorldKeepsItsOwnSolver) {
  // A rigid solver that is set here is never called. Its type must not be the one that is cast.
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btMultiBodyConstraintSolver own;
  btDelassusConstraintSolver rigid;
  btMultiBodyDynamicsWorld world(&dispatcher, &broadphase, &own, &configuration);
  world.setConstraintSolver(&rigid);
  Towers towers;
  towers.run(world, 10);
  EXPECT_EQ(rigid.report().islands, 0);
  EXPECT_NEAR(towers.boxes[0]->getWorldTransform().getOrigin().y(), 0.5, 1e-2);
}

/// The towers in a soft-rigid world, with a cloth that falls beside them or on one of them.
struct ClothRun {
  std::vector<btScalar> boxes;
  btScalar lowestNode = 0, highestNode = 0;
};

ClothRun runCloth(bool overTheBoxes) {
  btSoftBodyRigidBodyCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btDelassusConstraintSolver solver;
  btSoftRigidDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  Towers towers;
  towers.addTo(world);
  const btScalar x = overTheBoxes ? 0 : -40, half = 2, y = btScalar(3.3);
  btSoftBody* cloth = btSoftBodyHelpers::CreatePatch(world.getWorldInfo(), {x - half, y, -half},
                                                     {x + half, y, -half}, {x - half, y, half},
                                                     {x + half, y, half}, 17, 17, 0, true);
  cloth->setTotalMass(btScalar(0.1));
  world.addSoftBody(cloth);
  for (int i = 0; i < 90; ++i) world.stepSimulation(step, 0);

  ClothRun out;
  out.boxes = motionOf(towers.boxes);
  out.lowestNode = out.highestNode = cloth->m_nodes[0].m_x.y();
  for (int i = 0; i < cloth->m_nodes.size(); ++i) {
    out.lowestNode = btMin(out.lowestNode, cloth->m_nodes[i].m_x.y());
    out.highestNode = btMax(out.highestNode, cloth->m_nodes[i].m_x.y());
  }
  world.removeSoftBody(cloth);
  delete cloth;
  towers.removeFrom(world);
  return out;
}

TEST(Parity, Row50SoftRigidWorldSolvesItsRigidPart) {
  Towers alone;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btDelassusConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  alone.addTo(world);
  for (int i = 0; i < 90; ++i) world.stepSimulation(step, 0);
  expectSameBits(runCloth(false).boxes, motionOf(alone.boxes));
  alone.removeFrom(world);
}

TEST(Parity, Row50ClothLiesOnATower) {
  const ClothRun run = runCloth(true);
  EXPECT_GT(run.highestNode, 2.9) << "held up by the tower of three metres";
  EXPECT_LT(run.lowestNode, 2.5) << "and hanging down beside it";
  for (int i = 0; i < Towers::storeys; ++i)
    EXPECT_NEAR(run.boxes[12 * i + 1], 0.5 + i, 0.02) << "the tower stands";
}

/// A car of 800 kg on four wheels that accelerates over a low plank.
btVector3 drive(BulletWorld& world, int steps) {
  world.addGround();
  world.addBox({btScalar(0.3), btScalar(0.05), 3}, {6, btScalar(0.05), 0}, 50);
  btRigidBody& chassis = world.addBox({2, btScalar(0.4), 1}, {0, btScalar(1.2), 0}, 800);
  btDefaultVehicleRaycaster raycaster(&*world);
  const btRaycastVehicle::btVehicleTuning tuning;
  btRaycastVehicle vehicle(tuning, &chassis, &raycaster);
  vehicle.setCoordinateSystem(2, 1, 0);  // right, up, forward
  world->addVehicle(&vehicle);
  for (int x : {-1, 1})
    for (int z : {-1, 1}) {
      btWheelInfo& wheel =
          vehicle.addWheel({btScalar(1.5) * x, 0, btScalar(0.9) * z}, {0, -1, 0}, {0, 0, -1},
                           btScalar(0.5), btScalar(0.4), tuning, x > 0);
      wheel.m_suspensionStiffness = 20;
      wheel.m_wheelsDampingRelaxation = wheel.m_wheelsDampingCompression = 4;
    }
  for (int i = 0; i < steps; ++i) {
    for (int wheel = 0; wheel < 2; ++wheel) vehicle.applyEngineForce(1000, wheel);
    world.advance();
  }
  world->removeVehicle(&vehicle);
  return chassis.getWorldTransform().getOrigin();
}

TEST(Parity, Row51RaycastVehicleDrivesAsInStock) {
  DelassusWorld ours;
  StockWorld stock;
  const btVector3 a = drive(ours, 180), b = drive(stock, 180);
  EXPECT_GT(btFabs(a.x()), 5) << "it has driven off";
  EXPECT_LT((a - b).length(), tolerance(1e-3, 1e-2));
}

/// The path of a character that walks up to a wall, past boxes.
std::vector<btVector3> walk(BulletWorld& world) {
  world.addGround();
  world.addCube({3, btScalar(0.5), 0}, 0);
  for (int x : {0, 1, 2}) world.addCube({btScalar(1.2) * x, btScalar(0.5), btScalar(1.5)});
  btCapsuleShape capsule(btScalar(0.3), 1);
  btPairCachingGhostObject ghost;
  btGhostPairCallback pairs;
  world->getPairCache()->setInternalGhostPairCallback(&pairs);
  ghost.setCollisionShape(&capsule);
  ghost.setCollisionFlags(btCollisionObject::CF_CHARACTER_OBJECT);
  ghost.setWorldTransform(BulletWorld::at({0, 1, 0}));
  btKinematicCharacterController character(&ghost, &capsule, btScalar(0.2), btVector3(0, 1, 0));
  world->addCollisionObject(&ghost, btBroadphaseProxy::CharacterFilter,
                            btBroadphaseProxy::StaticFilter | btBroadphaseProxy::DefaultFilter);
  world->addAction(&character);
  character.setWalkDirection({btScalar(0.02), 0, 0});
  std::vector<btVector3> track;
  for (int i = 0; i < 180; ++i) {
    world.advance();
    track.push_back(ghost.getWorldTransform().getOrigin());
  }
  world->removeAction(&character);
  world->removeCollisionObject(&ghost);
  world->getPairCache()->setInternalGhostPairCallback(nullptr);
  return track;
}

TEST(Parity, Row51CharacterWalksAsInStock) {
  DelassusWorld ours;
  StockWorld stock;
  const std::vector<btVector3> a = walk(ours), b = walk(stock);
  EXPECT_GT(a.back().x(), 1) << "it has walked";
  EXPECT_TRUE(ours.report().messages.empty());
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_EQ(a[i], b[i]) << i;
}

}  // namespace
}  // namespace delassus::test
