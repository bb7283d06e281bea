// Scenes 1 to 4 of Bullet's BenchmarkDemo, rebuilt: its counts, sizes, masses, spacings and
// frictions. Unlike there, nothing sleeps, gravity is that of all scenes, and dolls and barrels are
// ours.
#include "demos/scenes/benchmarks.h"

#include <cmath>

#include "demos/scenes/builders.h"

namespace demos {

namespace {

/// The friction of two surfaces with Bullet's default of 0.5.
constexpr double stockPairFriction = 0.25;

/// An empty world with the benchmark's ground.
std::unique_ptr<World> buildGround() {
  auto world = std::make_unique<World>();
  addGround(*world, stockPairFriction, 250);
  return world;
}

void addCopy(World& world, btScalar mass, btCollisionShape& shape, const btTransform& pose) {
  world.add(mass, shape, pose, {surfaceFriction(stockPairFriction), 0});
}

/// Layers of `side` x `side` bodies, shifted further to −x and −z from layer to layer.
struct Layers {
  int side, count;
  double halfSize;       ///< of a body, m
  double spacingGrowth;  ///< factor of the gap between bodies, a layer
};
void addLayers(World& world, const Layers& layers, btScalar mass, btCollisionShape& shape) {
  double gap = layers.halfSize, y = 2 * layers.halfSize;
  double offset = -0.5 * layers.side * (2 * layers.halfSize + gap);
  for (int layer = 0; layer < layers.count; ++layer) {
    const double pitch = 2 * layers.halfSize + gap;
    for (int row = 0; row < layers.side; ++row)
      for (int column = 0; column < layers.side; ++column)
        addCopy(world, mass, shape, at(offset + column * pitch, y, offset + row * pitch));
    offset -= 0.05 * gap * (layers.side - 1);
    gap *= layers.spacingGrowth;
    y += 2 * layers.halfSize + gap;
  }
}

/// Half size of the town's boxes, m, and their mass, kg.
constexpr double half = 1;
constexpr btScalar boxMass = 1;

/// `base` x `base` boxes below, 2 % apart, one less each way in every layer above.
void addSquarePyramid(World& world, btBoxShape& box, double centreX, int base) {
  constexpr double reach = 1.02 * half, pitch = 2 * reach + 1e-4;
  for (int layer = 0; layer < base; ++layer) {
    const int side = base - layer;
    const double first = -0.5 * base * pitch + layer * reach;
    for (int row = 0; row < side; ++row)
      for (int column = 0; column < side; ++column)
        addCopy(world, boxMass, box,
                at(centreX + first + column * pitch, half + layer * pitch, first + row * pitch));
  }
}

/// A triangle of boxes that touch, in the plane x = `x`.
void addTriangle(World& world, btBoxShape& box, double x, int base) {
  for (int layer = 0; layer < base; ++layer)
    for (int i = 0; i < base - layer; ++i)
      addCopy(world, boxMass, box, at(x, half * (1 + 2 * layer), half * (2 * i + layer - base)));
}

/// Rings of boxes, each turned by half a box against the one below.
void addRoundTower(World& world, btBoxShape& box, double centreX, int storeys, int around) {
  const double radius = 1.3 * around * half / M_PI;
  for (int storey = 0; storey < storeys; ++storey)
    for (int i = 0; i < around; ++i) {
      const btScalar angle = btScalar(2 * M_PI * (i + 0.5 * storey) / around);
      const btQuaternion turn(btVector3(0, 1, 0), angle);
      const btVector3 place =
          vec3(centreX, half * (1 + 2 * storey), 0) + quatRotate(turn, vec3(0, 0, radius));
      addCopy(world, boxMass, box, btTransform(turn, place));
    }
}

/// A barrel of eight staves, 4 m high: rings of radius 1.1, 1.6 and 1.8 m, and the middles of its
/// ends.
btConvexHullShape& makeBarrel(World& world) {
  constexpr int staves = 8;
  constexpr double rings[][2] = {{-2, 1.1}, {-1, 1.6}, {0, 1.8}, {1, 1.6}, {2, 1.1}};  // y, radius
  auto barrel = std::make_unique<btConvexHullShape>();
  for (const auto& [y, radius] : rings)
    for (int i = 0; i < staves; ++i) {
      const double angle = 2 * M_PI * i / staves;
      barrel->addPoint(vec3(radius * std::cos(angle), y, radius * std::sin(angle)), false);
    }
  for (const double y : {-2, 2}) barrel->addPoint(vec3(0, y, 0), false);
  barrel->recalcLocalAabb();
  barrel->initializePolyhedralFeatures();
  return world.own(std::move(barrel));
}

}  // namespace

std::unique_ptr<World> buildBenchmarkBoxes() {
  auto world = buildGround();
  addLayers(*world, {8, 47, 1, 1}, 2, world->box(vec3(1, 1, 1)));
  return world;
}

std::unique_ptr<World> buildBenchmarkTown() {
  auto world = buildGround();
  btBoxShape& box = world->box(vec3(half, half, half));
  addSquarePyramid(*world, box, -20, 12);
  for (const double x : {-2, 4, 10}) addTriangle(*world, box, x, 12);
  addRoundTower(*world, box, 25, 8, 24);
  return world;
}

std::unique_ptr<World> buildBenchmarkRagdolls() {
  constexpr int longestRow = 16;
  constexpr double scale = 3.5, pitch = 6, rise = 7, step = 2;
  auto world = buildGround();
  for (int row = 0; row < longestRow; ++row)
    for (int i = 0; i < longestRow - row; ++i)
      addDoll(*world, at(pitch * (i - 0.5 * (longestRow - row)), 1 + rise * row, step * row), scale,
              stockPairFriction);
  for (btRigidBody* limb : world->movableBodies()) limb->setDamping(btScalar(0.05), btScalar(0.85));
  return world;
}

std::unique_ptr<World> buildBenchmarkHulls() {
  auto world = buildGround();
  addLayers(*world, {8, 15, 1.5, 1.01}, 1, makeBarrel(*world));
  return world;
}

}  // namespace demos
