#include <cmath>

#include "demos/scenes/builders.h"

namespace demos {

std::unique_ptr<World> buildBead(const std::vector<btVector3>& normals, const btVector3& force) {
  constexpr btScalar radius = btScalar(0.5);
  auto world = std::make_unique<World>();
  world->dynamics().setGravity(btVector3(0, 0, 0));
  for (const btVector3& normal : normals)
    world->add(0, world->plane(normal, -radius), at(0, 0, 0), {});
  btRigidBody& bead = world->add(1, world->sphere(radius), at(0, 0, 0), {});
  bead.setGravity(force);  // 1 kg: the acceleration is the force
  return world;
}

std::array<btVector3, 2> angleNormals(double cosine) {
  return {btVector3(0, 1, 0), vec3(std::sqrt((1 - cosine) * (1 + cosine)), cosine, 0)};
}

std::unique_ptr<World> buildBeadInAngle(double cosine, double forceAngle) {
  const auto normals = angleNormals(cosine);
  const btVector3 force =
      vec3(beadForce * std::cos(forceAngle), beadForce * std::sin(forceAngle), 0);
  return buildBead({normals.begin(), normals.end()}, force);
}

std::array<btVector3, 3> trihedronNormals(double height) {
  const double lean = std::sqrt(1 - height * height);
  std::array<btVector3, 3> normals;
  for (int i = 0; i < 3; ++i) {
    const double turn = i * 2 * M_PI / 3;
    normals[i] = vec3(lean * std::cos(turn), height, lean * std::sin(turn));
  }
  return normals;
}

std::unique_ptr<World> buildBeadInTrihedron(double height, const btVector3& direction) {
  const auto normals = trihedronNormals(height);
  return buildBead({normals.begin(), normals.end()}, direction.normalized() * btScalar(beadForce));
}

}  // namespace demos
