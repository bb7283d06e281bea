#include <algorithm>
#include <cmath>

#include "demos/scenes/builders.h"

namespace demos {

namespace {

const btVector3 unitBox = vec3(unitHalf, unitHalf, unitHalf);

/// Ground that extends beyond both ends of something `length` long in the middle.
void addGroundUnder(World& world, double length) {
  addGround(world, usualFriction, std::max(usualGround, length));
}

}  // namespace

std::unique_ptr<World> buildBoxHeadings(int count, double speed) {
  auto world = std::make_unique<World>();
  addGround(*world);
  for (int i = 0; i < count; ++i) {
    const double heading = 2 * M_PI * i / count;
    const btVector3 outwards = vec3(std::cos(heading), 0, std::sin(heading));
    const btVector3 start = outwards * btScalar(headingsRadius) + vec3(0, unitHalf, 0);
    btRigidBody& box = addBox(*world, unitBox, 1, btTransform(btQuaternion::getIdentity(), start));
    box.setLinearVelocity(outwards * btScalar(speed));
  }
  return world;
}

std::unique_ptr<World> buildGridOfBoxes(int side, double spacing) {
  auto world = std::make_unique<World>();
  addGround(*world);
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const double x = (column - 0.5 * (side - 1)) * spacing,
                   z = (row - 0.5 * (side - 1)) * spacing;
      addBox(*world, unitBox, 1, at(x, unitHalf, z));
    }
  return world;
}

std::unique_ptr<World> buildStack(int count, double topMass) {
  auto world = std::make_unique<World>();
  addGround(*world);
  for (int i = 0; i < count; ++i) {
    const btScalar mass = i == count - 1 ? btScalar(topMass) : btScalar(1);
    addBox(*world, unitBox, mass, at(0, unitHalf + i, 0));
  }
  return world;
}

std::unique_ptr<World> buildPyramid(int base) {
  constexpr double spacing = 1.05;
  auto world = std::make_unique<World>();
  addGroundUnder(*world, base * spacing);
  for (int row = 0; row < base; ++row)
    for (int i = 0; i < base - row; ++i) {
      const double x = (i - 0.5 * (base - row - 1)) * spacing;
      addBox(*world, unitBox, 1, at(x, unitHalf + row, 0));
    }
  return world;
}

std::unique_ptr<World> buildWall(int columns, int rows) {
  // The shift of a quarter brick keeps the centre of every end brick over the brick below it.
  constexpr double length = 2, headJoint = 0.02, shift = length / 4;
  auto world = std::make_unique<World>();
  addGroundUnder(*world, columns * (length + headJoint));
  for (int row = 0; row < rows; ++row)
    for (int i = 0; i < columns; ++i) {
      const double x = (i - 0.5 * (columns - 1)) * (length + headJoint) + (row % 2) * shift;
      addBox(*world, vec3(1, unitHalf, unitHalf), 2, at(x, unitHalf + row, 0));
    }
  return world;
}

std::unique_ptr<World> buildDominoRun(int count) {
  constexpr double halfThickness = 0.1, halfHeight = 1, halfWidth = 0.5, spacing = 1;
  // The first one leans beyond its balance at atan(0.1) = 5.7 degrees, on its lower edge.
  constexpr double lean = 8 * M_PI / 180;
  auto world = std::make_unique<World>();
  addGround(*world);
  const btVector3 half = vec3(halfThickness, halfHeight, halfWidth);
  for (int i = 0; i < count; ++i) {
    const double x = (i - 0.5 * (count - 1)) * spacing;
    if (i > 0) {
      addBox(*world, half, 1, at(x, halfHeight, 0));
      continue;
    }
    const double centreX =
        x + halfThickness + halfHeight * std::sin(lean) - halfThickness * std::cos(lean);
    const double centreY = halfHeight * std::cos(lean) + halfThickness * std::sin(lean);
    const btQuaternion turn = aboutZ(-lean);
    addBox(*world, half, 1, btTransform(turn, vec3(centreX, centreY, 0)));
  }
  return world;
}

}  // namespace demos
