#include <algorithm>

#include "demos/scenes/builders.h"

namespace demos {

namespace {

// The size of the bin at first, from its middle, and the place where the closing wall stops, m.
constexpr double binHalfLength = 2, binHalfWidth = 1.5, shutAt = 0.2;
constexpr double wallHalfHeight = 2.5, wallHalf = 0.5;  // half their thickness, m
constexpr double settled = 2;                           // s
constexpr double pressSpeed = 0.5;                      // m/s
constexpr double rubbing = 0.25;                        // Coulomb's

}  // namespace

std::unique_ptr<World> buildCompactor(int boxes) {
  constexpr int columns = 6, rows = 4;
  constexpr double half = 0.25, spacing = 0.6, disorder = 0.01;
  auto world = std::make_unique<World>();
  addGround(*world, rubbing, 10);
  const auto addWall = [&world](const btVector3& halfSize, double x, double z) -> btRigidBody& {
    return addBox(*world, halfSize, 0, at(x, wallHalfHeight, z), rubbing);
  };
  const btVector3 along = vec3(binHalfLength + 2 * wallHalf, wallHalfHeight, wallHalf);
  addWall(along, 0, -binHalfWidth - wallHalf);
  // Towards the camera: in pictures a wall that is a plane looks like glass.
  world->add(0, world->plane(btVector3(0, 0, -1), btScalar(-binHalfWidth)), at(0, 0, 0),
             {surfaceFriction(rubbing), 0});
  const btVector3 across = vec3(wallHalf, wallHalfHeight, binHalfWidth);
  addWall(across, -binHalfLength - wallHalf, 0);
  btRigidBody& press = addWall(across, binHalfLength + wallHalf, 0);
  press.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);

  Jitter jitter(disorder);
  for (int i = 0; i < boxes; ++i) {
    const int column = i % columns, row = i / columns % rows, layer = i / (columns * rows);
    const double x = spacing * (column - 0.5 * (columns - 1)) + jitter();
    const double y = half + 0.05 + spacing * layer + jitter();
    const double z = spacing * (row - 0.5 * (rows - 1)) + jitter();
    addBox(*world, vec3(half, half, half), 1, at(x, y, z), rubbing);
  }

  world->setScript([&press](double time) {
    const double gone = pressSpeed * std::max(0.0, time - settled);
    const double face = std::max(binHalfLength - gone, shutAt);
    press.setWorldTransform(at(face + wallHalf, wallHalfHeight, 0));
  });
  return world;
}

}  // namespace demos
