#include "demos/scenes/builders.h"

namespace demos {

std::unique_ptr<World> buildSpheresBin(int side) {
  constexpr btScalar radius = btScalar(0.45);
  // Spheres are displaced by up to this, m, so that the pile has no preferred direction.
  constexpr double disorder = 0.04;
  auto world = std::make_unique<World>();
  const Material material{surfaceFriction(usualFriction), 0};
  const btScalar wall = btScalar(-0.5 * side);
  world->add(0, world->plane(btVector3(0, 1, 0), 0), at(0, 0, 0), material);
  for (const btVector3& normal :
       {btVector3(1, 0, 0), btVector3(-1, 0, 0), btVector3(0, 0, 1), btVector3(0, 0, -1)})
    world->add(0, world->plane(normal, wall), at(0, 0, 0), material);

  Jitter jitter(disorder);
  btSphereShape& sphere = world->sphere(radius);
  for (int layer = 0; layer < side; ++layer)
    for (int row = 0; row < side; ++row)
      for (int column = 0; column < side; ++column) {
        const double x = column - 0.5 * (side - 1) + jitter(), y = 0.5 + layer,
                     z = row - 0.5 * (side - 1) + jitter();
        world->add(1, sphere, at(x, y, z), material);
      }
  return world;
}

}  // namespace demos
