#include <cmath>

#include "demos/scenes/builders.h"

namespace demos {

std::unique_ptr<World> buildHeavyBallChain(int links, double ballMass) {
  constexpr btScalar halfLink = btScalar(0.25), halfWidth = btScalar(0.05),
                     linkMass = btScalar(0.1), ballRadius = btScalar(0.8);
  constexpr double swing = 45 * M_PI / 180;  // from the vertical, towards +x
  auto world = std::make_unique<World>();
  addGround(*world);

  const double reach = 2 * halfLink * links + ballRadius;
  const btVector3 top = vec3(0, reach + 2, 0);
  const btVector3 along = vec3(std::sin(swing), -std::cos(swing), 0);
  const btQuaternion turn = aboutZ(swing - M_PI / 2);  // turns e_x to `along`
  const Material material{surfaceFriction(usualFriction), 0};

  btBoxShape& linkShape = world->box(btVector3(halfLink, halfWidth, halfWidth));
  btRigidBody* above = nullptr;
  const btVector3 end(halfLink, 0, 0);
  for (int i = 0; i < links; ++i) {
    btRigidBody& link =
        world->add(linkMass, linkShape,
                   btTransform(turn, top + along * ((2 * btScalar(i) + 1) * halfLink)), material);
    if (above == nullptr)
      world->join(std::make_unique<btPoint2PointConstraint>(link, -end));
    else
      world->join(std::make_unique<btPoint2PointConstraint>(*above, link, end, -end));
    above = &link;
  }
  btRigidBody& ball = world->add(btScalar(ballMass), world->sphere(ballRadius),
                                 btTransform(turn, top + along * btScalar(reach)), material);
  world->join(
      std::make_unique<btPoint2PointConstraint>(*above, ball, end, btVector3(-ballRadius, 0, 0)));

  // The wall that the ball meets at the bottom of its swing: 3 x 4 bricks of 1 x 1 x 2 m, across
  // its way.
  const btScalar wallX = -ballRadius - btScalar(unitHalf);
  for (int row = 0; row < 4; ++row)
    for (int i = -1; i <= 1; ++i)
      addBox(*world, vec3(unitHalf, unitHalf, 1), 2,
             at(wallX, unitHalf + row, 2.02 * i + 0.5 * (row % 2)));
  return world;
}

}  // namespace demos
