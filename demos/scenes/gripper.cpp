#include "demos/scenes/builders.h"

namespace demos {

namespace {

constexpr btScalar closingSpeed = btScalar(0.2);  // m/s, each finger
constexpr btScalar gripForce = 30;                // N; μ = 0.5 on two sides holds 30 N
constexpr btScalar liftingSpeed = btScalar(0.5);  // m/s
constexpr btScalar liftForce = 500;               // N
constexpr double closedAt = 0.5, liftedAt = 2.5;  // s

/// A slide along `axis` (given by the rotation that turns e_x to it) that does not turn.
btSliderConstraint& addSlide(World& world, btRigidBody& carrier, btRigidBody& body,
                             const btQuaternion& axis, btScalar force) {
  const btTransform frame(axis, body.getWorldTransform().getOrigin());
  auto slide = std::make_unique<btSliderConstraint>(
      carrier, body, carrier.getWorldTransform().inverse() * frame,
      body.getWorldTransform().inverse() * frame, true);
  slide->setLowerAngLimit(0);
  slide->setUpperAngLimit(0);
  slide->setPoweredLinMotor(true);
  slide->setMaxLinMotorForce(force);
  return static_cast<btSliderConstraint&>(world.join(std::move(slide)));
}

}  // namespace

std::unique_ptr<World> buildGripper() {
  constexpr btScalar half = btScalar(unitHalf), halfFinger = btScalar(0.1), gap = btScalar(0.05);
  auto world = std::make_unique<World>();
  btRigidBody& ground = addGround(*world);
  addBox(*world, btVector3(half, half, half), 1, at(0, half, 0));

  btRigidBody& palm = addBox(*world, btVector3(1, halfFinger, half), 1, at(0, 2, 0));
  const btQuaternion upwards = aboutZ(M_PI / 2);
  btSliderConstraint& lift = addSlide(*world, ground, palm, upwards, liftForce);

  const btScalar fingerX = half + gap + halfFinger;
  const btVector3 fingerHalf = vec3(halfFinger, 0.6, 0.3);
  for (const int side : {-1, 1}) {
    btRigidBody& finger = addBox(*world, fingerHalf, 1, at(side * fingerX, 1, 0));
    btSliderConstraint& slide =
        addSlide(*world, palm, finger, btQuaternion::getIdentity(), gripForce);
    slide.setTargetLinMotorVelocity(btScalar(-side) * closingSpeed);
  }

  world->setScript([&lift](double time) {
    lift.setTargetLinMotorVelocity(time < closedAt || time >= liftedAt ? 0 : liftingSpeed);
  });
  return world;
}

}  // namespace demos
