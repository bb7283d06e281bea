#include <cmath>

#include "demos/scenes/builders.h"

namespace demos {

std::unique_ptr<World> buildRollingBalls(const std::vector<RollingBall>& balls, double speed) {
  constexpr double laneWidth = 2;
  auto world = std::make_unique<World>();
  btRigidBody& ground = addGround(*world);
  btSphereShape& shape = world->sphere(btScalar(rollingRadius));
  for (std::size_t lane = 0; lane < balls.size(); ++lane) {
    const double z = (double(lane) - 0.5 * double(balls.size() - 1)) * laneWidth;
    btRigidBody& ball = world->add(btScalar(balls[lane].mass), shape, at(0, rollingRadius, z),
                                   {surfaceFriction(usualFriction), 0});
    // Bullet combines κ_A μ_B + κ_B μ_A.
    ball.setRollingFriction(btScalar(balls[lane].kappa) / ground.getFriction());
    ball.setLinearVelocity(vec3(speed, 0, 0));
    ball.setAngularVelocity(vec3(0, 0, -speed / rollingRadius));
  }
  return world;
}

}  // namespace demos
