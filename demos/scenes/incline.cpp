#include <cmath>

#include "demos/scenes/builders.h"

namespace demos {

double frictionAngle(double mu) { return std::atan(mu); }

std::unique_ptr<World> buildInclines(const std::vector<Slope>& slopes, double mu) {
  constexpr btScalar laneWidth = 4, halfLength = 20, halfThickness = btScalar(0.5),
                     half = btScalar(unitHalf);
  auto world = std::make_unique<World>();
  for (std::size_t lane = 0; lane < slopes.size(); ++lane) {
    const btQuaternion tilt = aboutZ(-slopes[lane].angle);
    const btVector3 foot = vec3(0, 0, laneWidth * lane);
    const btVector3 up = quatRotate(tilt, btVector3(0, 1, 0));
    addBox(*world, btVector3(halfLength, halfThickness, laneWidth / 2), 0,
           btTransform(tilt, foot - up * halfThickness), mu);
    const btQuaternion turn =
        tilt * btQuaternion(btVector3(0, 1, 0), btScalar(slopes[lane].heading));
    addBox(*world, btVector3(half, half, half), 1, btTransform(turn, foot + up * half), mu);
  }
  return world;
}

}  // namespace demos
