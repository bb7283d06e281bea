#include <algorithm>
#include <cmath>

#include "demos/report/stability/arch_limit.h"
#include "demos/report/stability/sweep.h"
#include "demos/scenes/builders.h"

namespace demos::report::stability {

namespace {

/// The body is pressed into the ground by this much, m: Bullet reports boxes only when they touch.
constexpr double bite = 1e-6;

/// The way of a body that slides from 0 at `speed`: it loses μ g h a step until it stands.
double slidingWay(double speed, double mu, double time, double timeStep) {
  double way = 0;
  const long steps = std::lround(time / timeStep);
  for (long i = 0; i < steps && speed > 0; ++i) {
    speed = std::max(0.0, speed - mu * gravity * timeStep);
    way += speed * timeStep;
  }
  return way;
}

Sweep slidingPlate() {
  Sweep sweep;
  sweep.name = "sliding";
  sweep.title = "flat plate sliding askew on the ground at 4 m/s";
  sweep.axis = "coefficient of friction";
  sweep.law =
      "its way is that of Coulomb's law, step by step, to 1 cm or to what friction does in two "
      "steps, 2 μ g h²";
  sweep.allowed = 1;
  sweep.values = {0, 1e-6, 1e-3, 0.01, 0.1, 0.5, 1, 2, 5, 10};
  sweep.build = [](double mu) {
    constexpr double speed = 4, heading = 0.5, timeStep = 1.0 / 60;
    auto world = std::make_unique<World>();
    addGround(*world, mu);
    btRigidBody& plate = addBox(*world, vec3(1, 0.02, 1), 1, at(0, 0.02 - bite, 0), mu);
    plate.setLinearVelocity(vec3(speed * std::cos(heading), 0, speed * std::sin(heading)));
    Trial trial{std::move(world), 180, timeStep, {}};
    trial.error = [&plate, mu](double time) {
      const double way = slidingWay(speed, mu, time, timeStep);
      const double tolerance = std::max(0.01, 2 * mu * gravity * timeStep * timeStep);
      const btVector3& p = plate.getWorldTransform().getOrigin();
      return std::hypot(double(p.x()) - way * std::cos(heading),
                        double(p.z()) - way * std::sin(heading)) /
             tolerance;
    };
    return trial;
  };
  return sweep;
}

Sweep incline() {
  Sweep sweep;
  sweep.name = "incline";
  sweep.title = "self-locking: box on a slope just below the friction angle";
  sweep.axis = "friction angle minus slope, share of it";
  sweep.law = "it creeps less than 1 mm in 5 s";
  sweep.allowed = 1e-3;
  sweep.values = {0.5, 0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9};
  sweep.build = [](double margin) {
    const double angle = (1 - margin) * frictionAngle();
    auto world = buildInclines({{angle, 0}});
    btRigidBody& box = *world->movableBodies()[0];
    box.translate(vec3(-bite * std::sin(angle), -bite * std::cos(angle), 0));
    return drifting(std::move(world), 300);
  };
  return sweep;
}

/// Painlevé's paradox: a rod is pushed along with its tip ahead. With tan(tilt) = 2 and μ > 4/3 the
/// ground's push on the tip turns it deeper into the ground: no finite force is right.
Sweep painleve() {
  Sweep sweep;
  sweep.name = "painleve";
  sweep.title = "Painlevé's rod, its tip ahead, pushed along at 3 m/s";
  sweep.axis = "coefficient of friction";
  sweep.law = "no more than 1 % of its energy is gained";
  sweep.allowed = 0.01;
  sweep.values = {0.1, 0.5, 1, 1.2, 1.3, 1.4, 1.6, 2, 4, 10};
  sweep.build = [](double mu) {
    constexpr double halfLength = 1, radius = 0.05, speed = 3;
    const double tilt = std::atan(2.0);
    auto world = std::make_unique<World>();
    world->add(0, world->plane(vec3(0, 1, 0), 0), at(0, 0, 0), {surfaceFriction(mu), 0});
    auto& capsule =
        world->own(std::make_unique<btCapsuleShapeX>(btScalar(radius), btScalar(2 * halfLength)));
    // The tip is at the lower right, and moves to the right.
    btRigidBody& rod = world->add(
        1, capsule, btTransform(aboutZ(-tilt), vec3(0, radius + halfLength * std::sin(tilt), 0)),
        {surfaceFriction(mu), 0});
    rod.setLinearVelocity(vec3(speed, 0, 0));
    rod.setLinearFactor(btVector3(1, 1, 0));
    rod.setAngularFactor(btVector3(0, 0, 1));
    return gaining(std::move(world), 120);
  };
  sweep.limit = 4.0 / 3;
  sweep.remark =
      "Beyond the line (4/3) rigid bodies with Coulomb's law have no finite force; steps of "
      "impulses have an answer all the same.";
  return sweep;
}

Sweep archAtItsLimit() {
  Sweep sweep;
  sweep.name = "arch_6";
  sweep.title = "semicircular arch of six voussoirs";
  sweep.axis = "thickness over the least that stands, minus 1";
  sweep.law = "no voussoir drifts more than 2 cm in 2 s";
  sweep.allowed = 0.02;
  sweep.values = {1, 0.3, 0.1, 0.03, 1e-2, 3e-3, 1e-3, 1e-4, 1e-5};
  sweep.build = [](double margin) {
    constexpr int voussoirs = 6;
    return drifting(buildArch(voussoirs, (1 + margin) * leastArchThickness(voussoirs, archRadius)),
                    120);
  };
  sweep.remark =
      "The least thickness is that of statics: a line of thrust that touches both edges. Settling "
      "opens the "
      "joints by millimetres, which a margin of 1 % does not bear.";
  return sweep;
}

Sweep tower() {
  Sweep sweep;
  sweep.name = "tower";
  sweep.title = "tower of boxes of 1 kg";
  sweep.axis = "boxes";
  sweep.law = "no box drifts more than 1 cm";
  sweep.allowed = 0.01;
  sweep.values = {5, 10, 20, 40, 80, 120, 160, 200};
  sweep.build = [](double count) { return drifting(buildStack(int(count), 1), 120); };
  return sweep;
}

Sweep shakenCards() {
  Sweep sweep;
  sweep.name = "card_house";
  sweep.title = "house of cards of three storeys, shaken sideways at 3 Hz";
  sweep.axis = "acceleration over gravity";
  sweep.law = "no card drifts more than 1 cm";
  sweep.allowed = 0.01;
  sweep.values = {0, 1e-5, 1e-4, 1e-3, 3e-3, 1e-2, 3e-2, 0.1};
  sweep.build = [](double share) {
    auto world = buildCardHouse(3);
    btDiscreteDynamicsWorld& dynamics = world->dynamics();
    world->setScript([&dynamics, share](double time) {
      const double sideways = share * gravity * std::sin(2 * M_PI * 3 * time);
      dynamics.setGravity(vec3(sideways, -gravity, 0));
    });
    return drifting(std::move(world), 180);
  };
  return sweep;
}

}  // namespace

SweepGroup frictionSweeps() {
  return {"friction",
          "Friction",
          {slidingPlate(), incline(), painleve(), archAtItsLimit(), tower(), shakenCards()}};
}

}  // namespace demos::report::stability
