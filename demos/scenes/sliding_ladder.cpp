#include <cmath>

#include "demos/scenes/builders.h"

namespace demos {

std::unique_ptr<World> buildSlidingLadder(double startAngle) {
  // A capsule's ends are balls. Their centres stay `radius` away from wall and floor, so that the
  // line between them slides on the planes x = 0 and y = 0, whatever its angle.
  constexpr btScalar radius = btScalar(0.05), halfLength = 1;
  auto world = std::make_unique<World>();
  world->add(0, world->plane(btVector3(0, 1, 0), -radius), at(0, 0, 0), {});
  world->add(0, world->plane(btVector3(1, 0, 0), -radius), at(0, 0, 0), {});

  btCapsuleShape& shape = world->own(std::make_unique<btCapsuleShapeX>(radius, 2 * halfLength));
  const btQuaternion lean = aboutZ(-startAngle);
  const btVector3 centre =
      vec3(halfLength * std::cos(startAngle), halfLength * std::sin(startAngle), 0);
  btRigidBody& ladder = world->add(1, shape, btTransform(lean, centre), {});
  ladder.setLinearFactor(btVector3(1, 1, 0));
  ladder.setAngularFactor(btVector3(0, 0, 1));
  return world;
}

}  // namespace demos
