#include "demos/scenes/builders.h"

namespace demos {

btRigidBody& addGround(World& world, double mu, double halfSize) {
  btBoxShape& slab = world.box(vec3(halfSize, 1, halfSize));
  return world.add(0, slab, at(0, -1, 0), {surfaceFriction(mu), 0});
}

btRigidBody& addBox(World& world, const btVector3& halfSize, btScalar mass, const btTransform& pose,
                    double mu) {
  return world.add(mass, world.box(halfSize), pose, {surfaceFriction(mu), 0});
}

}  // namespace demos
