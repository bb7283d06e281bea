#include "demos/scenes/force_plate.h"

#include <algorithm>
#include <cmath>

#include "demos/scenes/builders.h"
#include "demos/scenes/measures.h"

namespace demos {

namespace {

// Lengths in m, sums of powers of two, so that parts touch without rounding.
constexpr double legX = 0.75, legZ = 0.5, footRadius = 0.0625, halfTop = 0.0625, height = 0.75;
constexpr double halfLoad = 0.125, loadZ = 0.125;
constexpr btScalar tableMass = 20, loadMass = 100;  // kg
// Touching parts are sunk in by Bullet's linear slop: a foot one rounding above the ground would
// have no contact.
constexpr double slop = 1. / 8192;
constexpr double speed = 0.2, reach = 0.5;  // m/s, m: from −reach to +reach in 5 s

struct Place {
  double x, z;
};
Place placeOfFoot(int foot) { return {foot & 1 ? legX : -legX, foot & 2 ? legZ : -legZ}; }

btCompoundShape& makeTable(World& world) {
  auto table = std::make_unique<btCompoundShape>();
  table->addChildShape(at(0, 0, 0), &world.box(vec3(1, halfTop, 0.75)));
  for (int foot = 0; foot < 4; ++foot) {
    const auto [x, z] = placeOfFoot(foot);
    const double footY = footRadius - height;
    table->addChildShape(at(x, footY / 2, z), &world.box(vec3(0.03, -footY / 2, 0.03)));
    table->addChildShape(at(x, footY, z), &world.sphere(footRadius));
  }
  return world.own(std::move(table));
}

/// The centre of `body` at the beginning of the last step.
Place placeBefore(const btRigidBody& body, double timeStep) {
  const btVector3 centre =
      body.getWorldTransform().getOrigin() - btScalar(timeStep) * body.getLinearVelocity();
  return {centre.x(), centre.z()};
}

double weightOf(const btRigidBody& body) {
  return double(body.getGravity().length()) / double(body.getInvMass());
}

}  // namespace

std::unique_ptr<World> buildForcePlate() {
  auto world = std::make_unique<World>();
  world->dynamics().getSolverInfo().m_linearSlop = slop;
  addGround(*world);
  world->add(tableMass, makeTable(*world), at(0, height - slop, 0),
             {surfaceFriction(usualFriction), 0});
  btRigidBody& load = world->add(loadMass, world->box(vec3(halfLoad, halfLoad, halfLoad)),
                                 at(-reach, height + halfTop + halfLoad - 2 * slop, loadZ), {});
  load.setLinearVelocity(vec3(speed, 0, 0));
  return world;
}

FootForces measuredFootForces(const World& world, double timeStep) {
  const btRigidBody* table = world.movableBodies().front();
  const btVector3 middle = table->getWorldTransform().getOrigin();
  btDispatcher* dispatcher = const_cast<btDiscreteDynamicsWorld&>(world.dynamics()).getDispatcher();
  FootForces forces{};
  for (int i = 0; i < dispatcher->getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *dispatcher->getManifoldByIndexInternal(i);
    if (!manifold.getBody0()->isStaticObject() && !manifold.getBody1()->isStaticObject()) continue;
    for (int j = 0; j < manifold.getNumContacts(); ++j) {
      const btManifoldPoint& point = manifold.getContactPoint(j);
      const btVector3 arm = point.getPositionWorldOnA() - middle;
      forces[(arm.x() > 0 ? 1 : 0) + (arm.z() > 0 ? 2 : 0)] +=
          std::abs(double(writtenReaction(point).y())) / timeStep;
    }
  }
  return forces;
}

FootStatics staticsOf(const FootForces& forces) {
  FootStatics sum{};
  for (int foot = 0; foot < 4; ++foot) {
    const auto [x, z] = placeOfFoot(foot);
    sum.force += forces[foot];
    sum.momentX += forces[foot] * x;
    sum.momentZ += forces[foot] * z;
  }
  return sum;
}

FootStatics staticsOfWeights(const World& world, double timeStep) {
  const std::vector<btRigidBody*> bodies = world.movableBodies();
  const Place middle = placeBefore(*bodies.front(), timeStep);
  FootStatics sum{};
  for (const btRigidBody* body : bodies) {
    const Place centre = placeBefore(*body, timeStep);
    const double weight = weightOf(*body);
    sum.force += weight;
    sum.momentX += weight * (centre.x - middle.x);
    sum.momentZ += weight * (centre.z - middle.z);
  }
  return sum;
}

double footForceError(const World& world, double timeStep) {
  const FootStatics measured = staticsOf(measuredFootForces(world, timeStep)),
                    expected = staticsOfWeights(world, timeStep);
  return std::max({std::abs(measured.force - expected.force),
                   std::abs(measured.momentX - expected.momentX) / legX,
                   std::abs(measured.momentZ - expected.momentZ) / legZ}) /
         expected.force;
}

}  // namespace demos
