#include "demos/scenes/builders.h"

namespace demos {

double Jitter::operator()() {
  // Spelled out, because the standard does not fix the values of its distributions.
  return size_ * (2 * double(random_() >> 11) / double(1ULL << 53) - 1);
}

btRigidBody& addGround(World& world, double mu, double halfSize) {
  btBoxShape& slab = world.box(vec3(halfSize, 1, halfSize));
  return world.add(0, slab, at(0, -1, 0), {surfaceFriction(mu), 0});
}

btRigidBody& addBox(World& world, const btVector3& halfSize, btScalar mass, const btTransform& pose,
                    double mu) {
  return world.add(mass, world.box(halfSize), pose, {surfaceFriction(mu), 0});
}

}  // namespace demos
