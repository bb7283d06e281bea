#include "demos/scenes/builders.h"

namespace demos {

std::unique_ptr<World> buildRodOnSupports(double a, double pull) {
  static constexpr btScalar halfLength = 2, halfWidth = btScalar(0.1),
                            supportRadius = btScalar(0.25);
  auto world = std::make_unique<World>();
  // Round supports: each touches the rod in one point, right under its axis.
  btSphereShape& support = world->sphere(supportRadius);
  for (const double x : {a, -a})
    world->add(0, support, at(x, 1 - halfWidth - supportRadius, 0), {});
  btBoxShape& shape = world->box(btVector3(halfLength, halfWidth, halfWidth));
  btRigidBody& rod = world->add(1, shape, at(0, 1, 0), {});
  // Keeps the problem plane: on round supports the rod would tip over sideways.
  rod.setLinearFactor(btVector3(1, 1, 0));
  rod.setAngularFactor(btVector3(0, 0, 1));

  world->setScript([&rod, pull](double) {
    const btVector3 end = rod.getWorldTransform().getBasis() * btVector3(halfLength, 0, 0);
    rod.applyForce(vec3(0, pull, 0), end);
  });
  return world;
}

}  // namespace demos
