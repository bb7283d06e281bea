/// A step that is like the one before takes no memory.

#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "bullet_ext/gather.h"
#include "bullet_ext/solve_group.h"
#include "bullet_ext/write_back.h"
#include "tests/support/allocations.h"
#include "tests/support/bullet_world.h"

// Eigen asks malloc, the standard library new, which asks malloc too. Sanitizers bring a malloc of their own.
#ifndef __SANITIZE_ADDRESS__
namespace delassus::testing {
thread_local long allocations = 0;
}

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);

void* malloc(std::size_t size) {
  ++delassus::testing::allocations;
  return __libc_malloc(size);
}
void* realloc(void* memory, std::size_t size) {
  ++delassus::testing::allocations;
  return __libc_realloc(memory, size);
}
void* calloc(std::size_t count, std::size_t size) {
  ++delassus::testing::allocations;
  return __libc_calloc(count, size);
}
}

namespace delassus::testing {
namespace {

TEST(Allocation, GatheringAndWritingBackTakeNoMemoryOnceWarm) {
  DelassusWorld world;
  world.addGround();
  std::vector<btCollisionObject*> bodies;
  for (int i = 0; i < 30; ++i) bodies.push_back(&world.addCube({0, btScalar(0.5) + i, 0}));
  bullet::Group group;
  std::vector<btTypedConstraint*> joints;
  for (int i = 0; i < 5; ++i)
    joints.push_back(&world.addJoint<btHingeConstraint>(*btRigidBody::upcast(bodies[i]),
                                                        btVector3(0, 0, 0), btVector3(0, 0, 1)));
  world.advance();
  std::vector<btPersistentManifold*> manifolds;
  for (int i = 0; i < world.dispatcher().getNumManifolds(); ++i)
    manifolds.push_back(world.dispatcher().getManifoldByIndexInternal(i));

  bullet::Answer answer;
  StepReport report;
  std::vector<ContactEvent> events;
  for (int pass = 0; pass < 4; ++pass) {
    const long before = allocations;
    group.clear();
    bullet::gatherBodies(group, bodies.data(), int(bodies.size()), world.info(), report);
    bullet::gatherContacts(group, manifolds.data(), int(manifolds.size()), world.info(),
                           &world.dispatcher(), report);
    bullet::gatherJoints(group, joints.data(), int(joints.size()), world.info(), report);
    answer.bodies = group.bodies;
    answer.contacts = group.guess;
    answer.modes.assign(group.contacts.size(), pass % 2 ? Mode::Open : Mode::Stick);
    answer.troubles.assign(group.contacts.size(), Trouble::None);
    answer.rows.assign(group.rows.size(), 0);
    events.clear();
    bullet::writeVelocities(group, answer);
    bullet::writeContacts(group, answer, report, &events);
    bullet::writeJoints(group, answer, world.info());
    if (pass > 1) {
      EXPECT_EQ(allocations - before, 0) << pass;
    }
  }
  EXPECT_EQ(group.contacts.size(), 120u);
  EXPECT_EQ(events.size(), 120u);
}

/// Counts what solveGroup takes; Bullet's own share of a step is not counted.
class CountingSolver : public btDelassusConstraintSolver {
 public:
  using btDelassusConstraintSolver::btDelassusConstraintSolver;

  btScalar solveGroup(btCollisionObject** bodies, int bodyCount, btPersistentManifold** manifolds,
                      int manifoldCount, btTypedConstraint** constraints, int constraintCount,
                      const btContactSolverInfo& info, btIDebugDraw* drawer,
                      btDispatcher* dispatcher) override {
    const long before = allocations;
    const btScalar answer = btDelassusConstraintSolver::solveGroup(
        bodies, bodyCount, manifolds, manifoldCount, constraints, constraintCount, info, drawer,
        dispatcher);
    taken += allocations - before;
    return answer;
  }

  long taken = 0;
};

/// Allocations of the last 30 steps of a scene, which is warm by then, `work` done before each of them.
template <class Build, class Work>
long allocationsOf(const Options& options, const Build& build, const Work& work) {
  BulletWorld world(std::make_unique<CountingSolver>(options));
  build(world);
  auto& solver = dynamic_cast<CountingSolver&>(world.delassus());
  for (int i = 0; i < 90; ++i) {
    if (i == 60) solver.taken = 0;
    work(world, i);
    world.advance();
  }
  return solver.taken;
}

void buildTower(BulletWorld& world) {
  world.addGround();
  for (int i = 0; i < 3; ++i) world.addCube({0, btScalar(0.5) + i, 0});
  btRigidBody& ball = world.addSphere(btScalar(0.2), {5, 4, 0});
  world.addJoint<btPoint2PointConstraint>(ball, btVector3(0, 1, 0));
}

TEST(Allocation, AWarmStepTakesNoMemory) {
  const auto rest = [](BulletWorld&, int) {};
  EXPECT_EQ(allocationsOf(optionsOfPrecision(), buildTower, rest), 0);

  // Pushed to and fro, so that each step is solved anew.
  int walked = 0;
  const auto shake = [&](BulletWorld& world, int step) {
    walked += world.report().walks;
    btRigidBody::upcast(world->getCollisionObjectArray()[1])
        ->applyCentralForce({btScalar(step % 2 ? 3 : -3), 0, 0});
  };
  EXPECT_EQ(allocationsOf(optionsOfPrecision(), buildTower, shake), 0);
  EXPECT_GT(walked, 80);

  // The same with rolling and spinning friction.
  const auto buildTurning = [](BulletWorld& world) {
    world.addGround();
    btRigidBody& box = world.addCube({0, btScalar(0.5), 0});
    box.setRollingFriction(btScalar(0.1));
    box.setSpinningFriction(btScalar(0.1));
  };
  EXPECT_EQ(allocationsOf(optionsOfPrecision(), buildTurning, rest), 0);
  walked = 0;
  EXPECT_EQ(allocationsOf(optionsOfPrecision(), buildTurning, shake), 0);
  EXPECT_GT(walked, 80);

  Options options = optionsOfPrecision();
  options.economies.storage = false;
  EXPECT_GT(allocationsOf(options, buildTower, rest), 0);
}

TEST(Allocation, APushTakesNoMemory) {
  const auto build = [](BulletWorld& world) {
    world.addGround();
    world.addCube({0, btScalar(0.5), 0});
  };
  int pushed = 0;
  const auto sink = [&](BulletWorld& world, int) {
    pushed += world.report().pushIslands;
    btRigidBody& box = *btRigidBody::upcast(world->getCollisionObjectArray()[1]);
    box.setWorldTransform(BulletWorld::at({0, btScalar(0.4), 0}));
    box.setLinearVelocity({0, 0, 0});
  };
  EXPECT_EQ(allocationsOf(optionsOfPrecision(), build, sink), 0);
  EXPECT_EQ(pushed, 89);
}

}  // namespace
}  // namespace delassus::testing

#endif
