/// A step like the one before takes no memory. The memory kept between steps is in proportion to
/// the contacts.

#include <gtest/gtest.h>
#include <malloc.h>

#include <cstdlib>
#include <new>

#include "bullet_ext/gather.h"
#include "bullet_ext/solve_group.h"
#include "bullet_ext/write_back.h"
#include "delassus/solver.h"
#include "tests/support/allocations.h"
#include "tests/support/bullet_world.h"
#include "tests/support/pressed_piles.h"

// Eigen calls malloc; the standard library calls new, which calls malloc. Sanitizers have a malloc
// of their own, so nothing is counted with them.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
namespace delassus::test {
thread_local long allocations = 0;
namespace {
thread_local long heldBytes = 0;  ///< taken and not given back, by this thread
thread_local long granted = -1;   ///< how often this thread will get memory yet; −1: always

bool isRefused() {
  if (granted == 0) return true;
  if (granted > 0) --granted;
  return false;
}

void* taken(void* memory) {
  ++allocations;
  heldBytes += static_cast<long>(malloc_usable_size(memory));
  return memory;
}
void givenBack(void* memory) { heldBytes -= static_cast<long>(malloc_usable_size(memory)); }
}  // namespace
}  // namespace delassus::test

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* memory);

void* malloc(std::size_t size) {
  if (delassus::test::isRefused()) return nullptr;
  return delassus::test::taken(__libc_malloc(size));
}
void* realloc(void* memory, std::size_t size) {
  delassus::test::givenBack(memory);
  return delassus::test::taken(__libc_realloc(memory, size));
}
void* calloc(std::size_t count, std::size_t size) {
  return delassus::test::taken(__libc_calloc(count, size));
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  if (delassus::test::isRefused()) return nullptr;
  return delassus::test::taken(__libc_memalign(alignment, size));
}
void free(void* memory) {
  delassus::test::givenBack(memory);
  __libc_free(memory);
}
}

namespace delassus::test {
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

  const bullet::GroupInput input{bodies.data(),         int(bodies.size()), manifolds.data(),
                                 int(manifolds.size()), joints.data(),      int(joints.size()),
                                 &world.info(),         &world.dispatcher()};
  bullet::Answer answer;
  StepReport report;
  std::vector<ContactEvent> events;
  for (int pass = 0; pass < 4; ++pass) {
    const long before = allocations;
    bullet::gatherGroup(group, input, report);
    answer.bodies = group.bodies;
    answer.contacts = group.guess;
    answer.modes.assign(group.contacts.size(), pass % 2 ? Mode::Open : Mode::Stick);
    answer.troubles.assign(group.contacts.size(), Trouble::None);
    answer.rows.assign(group.rows.size(), 0);
    events.clear();
    bullet::writeVelocities(group, answer);
    bullet::writeContacts(group, answer, report, &events, true);
    bullet::writeJoints(group, answer, world.info());
    if (pass > 1) {
      EXPECT_EQ(allocations - before, 0) << pass;
    }
  }
  EXPECT_EQ(group.contacts.size(), 120u);
  EXPECT_EQ(events.size(), 120u);
}

/// Counts the allocations of solveGroup; Bullet's own share of a step is not counted.
class CountingSolver : public btDelassusConstraintSolver {
 public:
  using btDelassusConstraintSolver::btDelassusConstraintSolver;

  btScalar solveGroup(btCollisionObject** bodies, int bodyCount, btPersistentManifold** manifolds,
                      int manifoldCount, btTypedConstraint** constraints, int constraintCount,
                      const btContactSolverInfo& info, btIDebugDraw* drawer,
                      btDispatcher* dispatcher) override {
    const long before = allocations, heldBefore = heldBytes;
    const btScalar answer = btDelassusConstraintSolver::solveGroup(
        bodies, bodyCount, manifolds, manifoldCount, constraints, constraintCount, info, drawer,
        dispatcher);
    taken += allocations - before;
    held += heldBytes - heldBefore;
    return answer;
  }

  long taken = 0;
  long held = 0;  ///< bytes, since the first step
};

/// Allocations in the last 30 steps of a scene, which is warm by then. Calls `work` before each
/// step.
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

  // A force to and fro, so that each step is solved anew.
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

// Boxes are joined and dragged to and fro: their joints are eliminated in each step.
TEST(Allocation, AChainTakesNoMemory) {
  const auto build = [](BulletWorld& world) {
    world.addGround();
    btRigidBody& box = world.addCube({0, btScalar(0.5), 0});
    btRigidBody& trailer = world.addCube({btScalar(1.5), btScalar(0.5), 0});
    world.addJoint<btPoint2PointConstraint>(box, trailer, btVector3(btScalar(0.75), 0, 0),
                                            btVector3(btScalar(-0.75), 0, 0));
  };
  int walked = 0;
  const auto drag = [&](BulletWorld& world, int step) {
    walked += world.report().walks;
    btRigidBody::upcast(world->getCollisionObjectArray()[1])
        ->applyCentralForce({btScalar(step % 2 ? 3 : -3), 0, 0});
  };
  EXPECT_EQ(allocationsOf(optionsOfPrecision(), build, drag), 0);
  EXPECT_GT(walked, 80);
}

// A joint whose axes are all within their limits has no rows. The solver then asks whether it
// solves itself.
TEST(Allocation, AJointWithoutRowsTakesNoMemory) {
  int withoutRows = 0;
  const auto build = [](BulletWorld& world) {
    world.addGround();
    btRigidBody& box = world.addCube({0, btScalar(0.5), 0});
    auto& joint = world.addJoint<btGeneric6DofConstraint>(box, BulletWorld::at({0, 0, 0}), true);
    for (int axis = 0; axis < 6; ++axis) joint.setLimit(axis, -1, 1);
  };
  const auto rest = [&](BulletWorld& world, int) {
    btTypedConstraint::btConstraintInfo1 size{};
    world->getConstraint(0)->getInfo1(&size);
    withoutRows += size.m_numConstraintRows == 0;
  };
  EXPECT_EQ(allocationsOf(optionsOfPrecision(), build, rest), 0);
  EXPECT_EQ(withoutRows, 90);
}

TEST(Allocation, AListenerOfAnySizeTakesNoMemory) {
  struct Large {
    double numbers[16];
  };
  int heard = 0;
  const auto build = [&](BulletWorld& world) {
    buildTower(world);
    world.delassus().setContactListener(
        [&heard, large = Large{}](const ContactEvent&) { heard += large.numbers[0] == 0; });
  };
  const auto slip = [](BulletWorld& world, int step) {
    btRigidBody::upcast(world->getCollisionObjectArray()[3])
        ->applyCentralForce({btScalar(step % 2 ? 7 : -7), 0, 0});
  };
  EXPECT_EQ(allocationsOf(optionsOfPrecision(), build, slip), 0);
  EXPECT_GT(heard, 10);
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

// The proof that the boxes are pressed takes no memory, nor does the compromise; with friction or
// without.
TEST(Allocation, PressedBoxesTakeNoMemoryInTurn) {
  Random random(207);
  const PileIsland two(makePressed(2, 0.5, 0, 0.1, 1, random)),
      three(makePressed(3, 0.5, 0, 0.1, 1, random)), smooth(makePressed(2, 0, 0, 0.1, 1, random));
  Solver solver;
  Solution solution;
  for (int pass = 0; pass < 3; ++pass)
    for (const PileIsland* island : {&three, &smooth, &two}) {
      const long before = allocations;
      solver.solve(island->problem, {}, solution);
      EXPECT_EQ(solution.status, Status::Incompatible);
      if (pass > 0) {
        EXPECT_EQ(allocations - before, 0) << pass;
      }
    }
}

TEST(Allocation, IslandsOfSeveralSizesTakeNoMemoryInTurn) {
  constexpr int stacks = 12;
  // Boxes, then pendulums: islands of contacts and of rows.
  const auto build = [](BulletWorld& world) {
    world.addGround();
    for (int stack = 0; stack < stacks; ++stack)
      for (int i = 0; i <= stack % 3; ++i)
        world.addCube({btScalar(3 * stack), btScalar(0.5) + i, 0});
    for (int i = 0; i < 2; ++i) {
      btRigidBody& ball = world.addSphere(btScalar(0.2), {btScalar(i), 9, 0});
      world.addJoint<btPoint2PointConstraint>(ball, btVector3(0, 1, 0));
    }
  };
  int walked = 0;
  const auto shake = [&](BulletWorld& world, int step) {
    walked += world.report().walks;
    btCollisionObjectArray& objects = world->getCollisionObjectArray();
    for (int i = 1; i < objects.size(); ++i)
      btRigidBody::upcast(objects[i])->applyCentralForce({btScalar(step % 2 ? 1 : -1), 0, 0});
  };
  EXPECT_EQ(allocationsOf(optionsOfPrecision(), build, shake), 0);
  EXPECT_GT(walked, 80 * stacks);
}

/// Bytes that the solver holds per contact of a world that came to rest, was kept, and then was
/// pushed again.
template <class Build>
double bytesPerContact(const Build& build) {
  BulletWorld world(std::make_unique<CountingSolver>(optionsOfPrecision()));
  world.addGround();
  build(world);
  int contacts = 0;
  for (int step = 0; step < 9; ++step) {
    btCollisionObjectArray& objects = world->getCollisionObjectArray();
    if (step == 5) btRigidBody::upcast(objects[objects.size() / 2])->applyCentralImpulse({2, 0, 1});
    world.advance();
    contacts = std::max(contacts, world.report().contacts);
  }
  const auto held = static_cast<double>(dynamic_cast<CountingSolver&>(world.delassus()).held);
  EXPECT_NEAR(static_cast<double>(world.report().workspaceBytes), held, 0.03 * held);
  return held / contacts;
}

TEST(Allocation, AContactTakesFourKilobytesAtMost) {
  const auto buildPyramid = [](BulletWorld& world) {
    constexpr int base = 20;
    for (int row = 0; row < base; ++row)
      for (int i = 0; i < base - row; ++i)
        world.addCube({btScalar(1.02) * (i + btScalar(0.5) * row), btScalar(0.5) + row, 0});
  };
  const auto buildStack = [](BulletWorld& world) {
    for (int i = 0; i < 40; ++i) world.addCube({0, btScalar(0.5) + i, 0});
  };
  EXPECT_LE(bytesPerContact(buildPyramid), 4096);
  EXPECT_LE(bytesPerContact(buildStack), 4096);
}

// Whatever memory is missing for more threads, the caller then works alone.
TEST(Allocation, WhereThereIsNoneForThreadsTheCallerWorksAlone) {
  int refusals = 0;
  for (int enough = 0;; ++enough) {
    SCOPED_TRACE(enough);
    DelassusWorld world;
    world.addGround();
    for (int i = 0; i < 20; ++i) world.addCube({btScalar(3 * i), btScalar(0.5), 0});
    world.delassus().setThreads(2);
    world.advance();
    bool isRefused = false;
    granted = enough;
    try {
      world.delassus().setThreads(4);
    } catch (const std::bad_alloc&) {
      isRefused = true;
    }
    granted = -1;
    world.advance();
    ASSERT_EQ(world.report().contacts, 80);
    ASSERT_EQ(world.report().solved, 20);
    if (!isRefused) break;
    ++refusals;
  }
  EXPECT_GT(refusals, 3);
}

}  // namespace
}  // namespace delassus::test

#endif
