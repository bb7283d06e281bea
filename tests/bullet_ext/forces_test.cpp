/// What users read as forces, and the changes of mode that listeners hear of.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <tuple>

#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

/// Sum of all reactions on a body and their moment about its centre, from the fields of the points.
struct Wrench {
  btVector3 impulse{0, 0, 0}, moment{0, 0, 0};
};

Wrench reactionsOn(const btRigidBody& body, const btVector3& centre, BulletWorld& world) {
  Wrench sum;
  for (int i = 0; i < world.dispatcher().getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *world.dispatcher().getManifoldByIndexInternal(i);
    const bool first = manifold.getBody0() == &body;
    if (!first && manifold.getBody1() != &body) continue;
    for (int j = 0; j < manifold.getNumContacts(); ++j) {
      const btManifoldPoint& point = manifold.getContactPoint(j);
      const btVector3 r =
          (first ? 1 : -1) * (point.m_appliedImpulse * point.m_normalWorldOnB +
                              point.m_appliedImpulseLateral1 * point.m_lateralFrictionDir1 +
                              point.m_appliedImpulseLateral2 * point.m_lateralFrictionDir2);
      const btVector3 arm =
          (first ? point.getPositionWorldOnA() : point.getPositionWorldOnB()) - centre;
      sum.impulse += r;
      sum.moment += arm.cross(r);
    }
  }
  return sum;
}

/// Steps once. Beyond weight and user forces, the change of each body's momentum must come from the
/// reactions; to the tolerance where it rests. Cubes or balls of 1 kg have no gyroscopic terms.
void expectBalance(BulletWorld& world, const std::vector<btRigidBody*>& bodies,
                   const btVector3& force, const btVector3& torque) {
  std::vector<btVector3> centres, velocities, spins;
  for (btRigidBody* body : bodies) {
    body->applyCentralForce(force);
    body->applyTorque(torque);
    centres.push_back(body->getWorldTransform().getOrigin());
    velocities.push_back(body->getLinearVelocity());
    spins.push_back(body->getAngularVelocity());
  }
  world.advance();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const btRigidBody& body = *bodies[i];
    const Wrench sum = reactionsOn(body, centres[i], world);
    const btVector3 gain = body.getLinearVelocity() - velocities[i];
    const btVector3 expected = gain - h * (body.getGravity() + force);
    const double allowed = tolerance(body.getLinearVelocity().isZero() ? 1e-8 : 1e-9, 1e-3);
    ASSERT_LT((sum.impulse - expected).length() / h, allowed) << i;
    const btScalar inertia = 1 / body.getInvInertiaDiagLocal().x();
    const btVector3 turn = inertia * (body.getAngularVelocity() - spins[i]) - h * torque;
    ASSERT_LT((sum.moment - turn).length() / h, allowed) << i;
  }
}

struct Load {
  const char* name;
  btVector3 gravity, velocity, force, torque;
};

TEST(Forces, SumOverPointsIsTheTotalForceAndMoment) {
  const btVector3 down(0, btScalar(-g), 0), none(0, 0, 0);
  const Load loads[] = {
      {"at rest", down, none, none, none},
      {"sliding", down, {2, 0, 1}, none, none},
      {"on a slope, held", {3, btScalar(-9), 1}, none, none, none},
      {"on a slope, sliding", {6, btScalar(-8), 1}, none, none, none},
      {"under a force and a torque", down, none, {2, -1, 1}, {btScalar(0.3), 1, btScalar(-0.2)}},
      {"lifted off", down, none, {0, 12, 0}, none}};
  for (const Load& load : loads) {
    SCOPED_TRACE(load.name);
    DelassusWorld world;
    world.addGround();
    world->setGravity(load.gravity);
    std::vector<btRigidBody*> boxes;
    for (int i = 0; i < 3; ++i) {
      boxes.push_back(&world.addCube({btScalar(0.1) * i, btScalar(0.5) + i, 0}));
      boxes.back()->setGravity(load.gravity);
      boxes.back()->setLinearVelocity(load.velocity);
    }
    for (int i = 0; i < 60; ++i) expectBalance(world, boxes, load.force, load.torque);
  }
}

/// Cubes and balls thrown on a heap.
std::vector<btRigidBody*> throwHeap(BulletWorld& world, int seed) {
  world.addGround();
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<btScalar> some(-1, 1);
  std::vector<btRigidBody*> heap;
  for (int i = 0; i < 16; ++i) {
    const btVector3 place(some(random), 1 + btScalar(0.9) * i, some(random));
    heap.push_back(i % 2 ? &world.addSphere(btScalar(0.5), place) : &world.addCube(place));
  }
  return heap;
}

TEST(Forces, SumOverPointsIsTheTotalForceInAHeap) {
  DelassusWorld world;
  const auto heap = throwHeap(world, 1);
  for (int i = 0; i < 200; ++i) expectBalance(world, heap, {0, 0, 0}, {0, 0, 0});
}

/// The bits of an event; the manifold is named by its bodies.
using Event = std::tuple<int, int, int, int, Mode, Mode, btScalar, btScalar, btScalar>;

/// The events of a falling heap. They must be all the changes of mode, each once.
std::vector<Event> listenToHeap(int batch) {
  DelassusWorld world;
  world.info().m_minimumSolverBatchSize = batch;
  throwHeap(world, 2);
  std::vector<Event> all;
  std::map<const btManifoldPoint*, Mode> changed;
  int step = 0;
  world.delassus().setContactListener([&](const ContactEvent& event) {
    EXPECT_NE(event.from, event.to);
    const btManifoldPoint& point = event.manifold->getContactPoint(event.point);
    EXPECT_TRUE(changed.emplace(&point, event.to).second) << "told twice in one step";
    const btVector3 reaction = point.m_appliedImpulse * point.m_normalWorldOnB +
                               point.m_appliedImpulseLateral1 * point.m_lateralFrictionDir1 +
                               point.m_appliedImpulseLateral2 * point.m_lateralFrictionDir2;
    EXPECT_LT((reaction - event.reaction).length(), 100 * precision);
    if (event.to == Mode::Open) {
      EXPECT_NEAR(point.m_appliedImpulse, 0, 1e-9);
    }
    all.emplace_back(step, event.manifold->getBody0()->getWorldArrayIndex(),
                     event.manifold->getBody1()->getWorldArrayIndex(), event.point, event.from,
                     event.to, event.reaction.x(), event.reaction.y(), event.reaction.z());
  });
  for (; step < 150; ++step) {
    changed.clear();
    world.advance();
    EXPECT_EQ(int(changed.size()), world.report().modeChanges);
  }
  return all;
}

TEST(ContactListener, TellsEveryChangeOnceInTheSameOrderEachTime) {
  for (int batch : {1, 128}) {
    const std::vector<Event> events = listenToHeap(batch);
    EXPECT_GT(events.size(), 100u);
    EXPECT_EQ(listenToHeap(batch), events);
  }
}

TEST(ContactListener, ListeningChangesNothing) {
  const auto run = [](bool listening) {
    DelassusWorld world;
    const auto heap = throwHeap(world, 3);
    if (listening) world.delassus().setContactListener([](const ContactEvent&) {});
    world.advance(100);
    return heap.back()->getWorldTransform().getOrigin();
  };
  EXPECT_EQ(run(true), run(false));
}

}  // namespace
}  // namespace delassus::test
