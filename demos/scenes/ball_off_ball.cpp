#include <cmath>

#include "demos/scenes/builders.h"

namespace demos {

std::unique_ptr<World> buildBallOffBall(double startAngle) {
  constexpr btScalar fixedRadius = btScalar(0.75), radius = btScalar(0.25);
  auto world = std::make_unique<World>();
  // A capsule of no length is a ball. Bullet finds its contact with a sphere in closed form, and
  // does so (unlike for two spheres) even while they are a hair apart, as steps along the tangent
  // leave them.
  btCapsuleShape& fixedBall =
      world->own(std::make_unique<btCapsuleShape>(fixedRadius, btScalar(0)));
  world->add(0, fixedBall, at(0, 0, 0), {});
  const double distance = fixedRadius + radius;
  world->add(1, world->sphere(radius),
             at(distance * std::sin(startAngle), distance * std::cos(startAngle), 0), {});
  return world;
}

}  // namespace demos
