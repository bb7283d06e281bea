#include <cmath>

#include "demos/scenes/builders.h"

namespace demos {

namespace {

/// A prism over the quadrilateral `outline` (x, y; about its centre of mass), as a hull that
/// touches others face to face.
btConvexHullShape& addPrism(World& world, const std::array<btVector3, 4>& outline,
                            btScalar halfDepth) {
  auto hull = std::make_unique<btConvexHullShape>();
  for (const btVector3& corner : outline)
    for (const btScalar z : {-halfDepth, halfDepth})
      hull->addPoint(btVector3(corner.x(), corner.y(), z), false);
  hull->recalcLocalAabb();
  // Contacts come from the polyhedra themselves; the margin only widens the search.
  hull->initializePolyhedralFeatures();
  return world.own(std::move(hull));
}

/// Centre of area, above the base, of a symmetric trapezium of `height` that narrows from `low` to
/// `high`.
double trapeziumCentre(double low, double high, double height) {
  return height / 3 * (low + 2 * high) / (low + high);
}

}  // namespace

std::unique_ptr<World> buildArch(int voussoirs, double thickness) {
  constexpr double radius = 5, mu = 0.7;
  constexpr btScalar halfDepth = btScalar(0.5);
  // Blocks are pressed together by this, m, so that Bullet sees all corners of every joint from the
  // first step on.
  constexpr double bite = 1e-5;
  auto world = std::make_unique<World>();
  world->dynamics().getDispatchInfo().m_enableSatConvex = true;
  const Material stone{surfaceFriction(mu), 0};

  // The faces of all voussoirs lie on rays from the arch's centre, a step apart.
  const double halfStep = 0.5 * M_PI / voussoirs;
  const double inner = (radius - 0.5 * thickness) * std::cos(halfStep),
               outer = (radius + 0.5 * thickness) * std::cos(halfStep);
  const double innerHalf = inner * std::tan(halfStep) + 0.5 * bite,
               outerHalf = outer * std::tan(halfStep) + 0.5 * bite;
  const double centre = trapeziumCentre(2 * innerHalf, 2 * outerHalf, outer - inner);
  const std::array<btVector3, 4> outline = {
      vec3(-innerHalf, -centre, 0), vec3(innerHalf, -centre, 0),
      vec3(outerHalf, outer - inner - centre, 0), vec3(-outerHalf, outer - inner - centre, 0)};
  btConvexHullShape& voussoir = addPrism(*world, outline, halfDepth);
  for (int i = 0; i < voussoirs; ++i) {
    const double turn =
        0.5 * M_PI - (2 * i + 1) * halfStep;  // of the outward axis, from the vertical
    const btQuaternion rotation = aboutZ(turn);
    const btVector3 place = quatRotate(rotation, vec3(0, inner + centre, 0));
    world->add(1, voussoir, btTransform(rotation, place), stone);
  }

  // Abutments: fixed blocks under both springings, at y = 0.
  const btScalar halfBlock = btScalar(thickness), blockHeight = 1;
  const std::array<btVector3, 4> block = {btVector3(-halfBlock, -blockHeight, 0),
                                          btVector3(halfBlock, -blockHeight, 0),
                                          btVector3(halfBlock, 0, 0), btVector3(-halfBlock, 0, 0)};
  btConvexHullShape& abutment = addPrism(*world, block, 2 * halfDepth);
  for (const double x : {-radius, radius}) world->add(0, abutment, at(x, 0.5 * bite, 0), stone);
  return world;
}

}  // namespace demos
