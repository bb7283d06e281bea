#include "demos/scenes/builders.h"

namespace demos {

std::unique_ptr<World> buildPlankBridge(int planks, double loadMass) {
  constexpr double length = 1, height = 3, halfThickness = 0.05, halfWidth = 0.5;
  constexpr double halfPost = 0.3, halfLoad = 0.4, drop = 0.15;
  constexpr btScalar plankMass = 2;
  auto world = std::make_unique<World>();
  addGround(*world);

  const Material material{surfaceFriction(usualFriction), 0};
  const double end = 0.5 * planks * length;
  const auto addPost = [&](double x) -> btRigidBody& {
    btBoxShape& shape = world->box(vec3(halfPost, height / 2, halfWidth));
    return world->add(0, shape, at(x, height / 2, 0), material);
  };
  btRigidBody &first = addPost(-end - halfPost), &other = addPost(end + halfPost);

  // A little shorter than the distance of the hinges, so that folding planks do not touch.
  btBoxShape& shape = world->box(vec3(0.475 * length, halfThickness, halfWidth));
  const auto hinge = [&](btRigidBody& a, btRigidBody& b, double x) {
    const btVector3 place = vec3(x, height, 0), axis = vec3(0, 0, 1);
    const auto in = [&](const btRigidBody& body) {
      return place - body.getWorldTransform().getOrigin();
    };
    world->join(std::make_unique<btHingeConstraint>(a, b, in(a), in(b), axis, axis));
  };
  btRigidBody* last = &first;
  for (int i = 0; i < planks; ++i) {
    btRigidBody& plank =
        world->add(plankMass, shape, at((i + 0.5) * length - end, height, 0), material);
    hinge(*last, plank, i * length - end);
    last = &plank;
  }
  hinge(*last, other, end);
  addBox(*world, vec3(halfLoad, halfLoad, halfLoad), btScalar(loadMass),
         at(0, height + halfThickness + drop + halfLoad, 0));
  return world;
}

}  // namespace demos
