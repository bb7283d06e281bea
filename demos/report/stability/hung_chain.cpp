#include "demos/report/stability/hung_chain.h"

#include <cmath>

namespace demos::report::stability {

namespace {

constexpr double linkLength = 0.5, linkMass = 1, ballRadius = 0.3;
constexpr double swing = M_PI / 6;
/// Tension at the bottom of the swing over the weight: 3 − 2 cos(swing).
const double mostTension = 3 - 2 * std::cos(swing);

double tensionOf(int links, double ballMass) {
  return mostTension * gravity * (ballMass + linkMass * links);
}

std::unique_ptr<World> buildHungChain(const HungChain& chain) {
  auto world = std::make_unique<World>();
  const btVector3 along = vec3(std::sin(swing), -std::cos(swing), 0);
  const btQuaternion turn = aboutZ(swing - M_PI / 2);  // turns e_x to `along`
  const btVector3 end = vec3(0.5 * linkLength, 0, 0);
  btBoxShape& shape = world->box(vec3(0.5 * linkLength, 0.03, 0.03));

  btRigidBody* above = nullptr;
  const auto hang = [&](btRigidBody& body, const btVector3& pivot) {
    for (int copy = 0; copy < chain.copies; ++copy) {
      if (above == nullptr)
        world->join(std::make_unique<btPoint2PointConstraint>(body, pivot));
      else
        world->join(std::make_unique<btPoint2PointConstraint>(*above, body, end, pivot));
    }
    above = &body;
  };
  const double h = 1 / (chain.rate * chain.substeps);
  const double stiffness = tensionOf(chain.links, chain.ballMass) * linkLength;
  for (int i = 0; i < chain.links; ++i) {
    btRigidBody& link = world->add(btScalar(linkMass), shape,
                                   btTransform(turn, along * btScalar((i + 0.5) * linkLength)), {});
    if (chain.stiffened) {
      link.setMassProps(btScalar(linkMass),
                        link.getLocalInertia() + vec3(0, 1, 1) * btScalar(h * h * stiffness / 3));
      link.updateInertiaTensor();
    }
    hang(link, -end);
  }
  hang(world->add(btScalar(chain.ballMass), world->sphere(btScalar(ballRadius)),
                  btTransform(turn, along * btScalar(chain.links * linkLength + ballRadius)), {}),
       vec3(-ballRadius, 0, 0));
  world->setSubsteps(chain.substeps);
  return world;
}

}  // namespace

Trial hungChain(const HungChain& chain, double seconds) {
  auto world = buildHungChain(chain);
  const double height = linkLength * chain.links * (1 - std::cos(swing));
  const double energy = gravity * height * (chain.ballMass + 0.5 * linkMass * chain.links);
  auto error = worseOf(jointsOf(*world, linkLength), energyGainedFrom(*world, energy));
  return {std::move(world), int(std::lround(seconds * chain.rate)), 1 / chain.rate, error};
}

double heaviestBall(int links, double timeStep) {
  const double tension = 4 * linkMass * linkLength / (12 * timeStep * timeStep);
  return std::max(0.0, tension / (mostTension * gravity) - linkMass * links);
}

double leastRate(int links, double ballMass) {
  return 0.5 * std::sqrt(12 * tensionOf(links, ballMass) / (linkMass * linkLength));
}

}  // namespace demos::report::stability
