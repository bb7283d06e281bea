#include "demos/report/stability/hung_chain.h"

#include <cmath>

namespace demos::report::stability {

namespace {

constexpr double linkLength = 0.5, linkMass = 1, ballRadius = 0.3;
constexpr double swing = M_PI / 6;
/// Tension at the bottom of the swing over the weight: 3 − 2 cos(swing).
const double mostTension = 3 - 2 * std::cos(swing);

std::unique_ptr<World> buildHungChain(int links, double ballMass, int copies) {
  auto world = std::make_unique<World>();
  const btVector3 along = vec3(std::sin(swing), -std::cos(swing), 0);
  const btQuaternion turn = aboutZ(swing - M_PI / 2);  // turns e_x to `along`
  const btVector3 end = vec3(0.5 * linkLength, 0, 0);
  btBoxShape& shape = world->box(vec3(0.5 * linkLength, 0.03, 0.03));

  btRigidBody* above = nullptr;
  const auto hang = [&](btRigidBody& body, const btVector3& pivot) {
    for (int copy = 0; copy < copies; ++copy) {
      if (above == nullptr)
        world->join(std::make_unique<btPoint2PointConstraint>(body, pivot));
      else
        world->join(std::make_unique<btPoint2PointConstraint>(*above, body, end, pivot));
    }
    above = &body;
  };
  for (int i = 0; i < links; ++i)
    hang(world->add(btScalar(linkMass), shape,
                    btTransform(turn, along * btScalar((i + 0.5) * linkLength)), {}),
         -end);
  hang(world->add(btScalar(ballMass), world->sphere(btScalar(ballRadius)),
                  btTransform(turn, along * btScalar(links * linkLength + ballRadius)), {}),
       vec3(-ballRadius, 0, 0));
  return world;
}

}  // namespace

Trial hungChain(int links, double ballMass, double seconds, double rate, int copies) {
  auto world = buildHungChain(links, ballMass, copies);
  const double height = linkLength * links * (1 - std::cos(swing));
  const double energy = gravity * height * (ballMass + 0.5 * linkMass * links);
  auto error = worseOf(jointsOf(*world, linkLength), energyGainedFrom(*world, energy));
  return {std::move(world), int(std::lround(seconds * rate)), 1 / rate, error};
}

double heaviestBall(int links, double timeStep) {
  const double tension = 4 * linkMass * linkLength / (12 * timeStep * timeStep);
  return std::max(0.0, tension / (mostTension * gravity) - linkMass * links);
}

double leastRate(int links, double ballMass) {
  const double tension = mostTension * gravity * (ballMass + linkMass * links);
  return 0.5 * std::sqrt(12 * tension / (linkMass * linkLength));
}

}  // namespace demos::report::stability
