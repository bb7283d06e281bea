#include <cmath>

#include "demos/scenes/builders.h"

namespace demos {

std::unique_ptr<World> buildNewtonCradle(int balls) {
  constexpr btScalar radius = btScalar(0.5), halfWidth = btScalar(0.5);
  constexpr double length = 3, height = 4, raised = 45 * M_PI / 180;
  auto world = std::make_unique<World>();
  btSphereShape& shape = world->sphere(radius);
  for (int i = 0; i < balls; ++i) {
    const double x = (i - 0.5 * (balls - 1)) * 2 * radius;
    // The first ball starts aside, turned about its hanging line.
    const double angle = i == 0 ? -raised : 0;
    const btQuaternion turn = aboutZ(angle);
    const btVector3 hook = vec3(x, height, 0);
    const btVector3 centre = hook + quatRotate(turn, vec3(0, -length, 0));
    btRigidBody& ball = world->add(1, shape, btTransform(turn, centre), {0, 1});
    // Two strings hold it in the plane: five independent rows out of six.
    for (const btScalar z : {-halfWidth, halfWidth})
      world->join(std::make_unique<btPoint2PointConstraint>(ball, vec3(0, length, z)));
  }
  return world;
}

}  // namespace demos
