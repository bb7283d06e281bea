#include "demos/scenes/wall_and_ball.h"

#include "demos/scenes/builders.h"

namespace demos {

btVector3 throwVelocity(const Throw& thrown) {
  constexpr double gravity = 9.81;  // m/s², that of World
  return vec3(0, gravity * thrown.timeOfFlight / 2, -thrown.distance / thrown.timeOfFlight);
}

std::unique_ptr<World> buildWallAndBall(int columns, int rows, const Throw& thrown) {
  auto world = buildWall(columns, rows);
  btRigidBody& ball =
      world->add(btScalar(thrown.mass), world->sphere(btScalar(thrown.radius)),
                 at(0, thrown.height, thrown.distance), {surfaceFriction(usualFriction), 0});
  ball.setLinearVelocity(throwVelocity(thrown));
  return world;
}

}  // namespace demos
