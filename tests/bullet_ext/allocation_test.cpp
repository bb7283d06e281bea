/// A step that is like the one before takes no memory.

#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "bullet_ext/gather.h"
#include "bullet_ext/solve_group.h"
#include "bullet_ext/write_back.h"
#include "tests/support/bullet_world.h"

namespace {
thread_local long allocations = 0;

void* counted(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size ? size : 1)) return memory;
  throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

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

}  // namespace
}  // namespace delassus::testing
