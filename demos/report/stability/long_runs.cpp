#include <cmath>

#include "demos/report/stability/sweep.h"
#include "demos/scenes/builders.h"

namespace demos::report::stability {

namespace {

constexpr double rate = 60;
Sweep lasting(const std::string& name, const std::string& title, double allowed,
              std::vector<double> seconds, double patience,
              const std::function<std::unique_ptr<World>()>& build) {
  Sweep sweep;
  sweep.name = name;
  sweep.title = title;
  sweep.axis = "simulated time, s";
  sweep.law = "no drift of more than " + std::string(allowed > 0.01 ? "2 cm" : "1 mm");
  sweep.allowed = allowed;
  sweep.values = std::move(seconds);
  sweep.patience = patience;
  sweep.lengthens = true;
  sweep.build = [build](double time) { return drifting(build(), int(time * rate), 1 / rate); };
  return sweep;
}

/// A kinematic slab whose surface runs at 1 m/s while it stays where it is, and a box that a stop keeps from going with it.
std::unique_ptr<World> buildConveyor() {
  auto world = std::make_unique<World>();
  btRigidBody& belt = addGround(*world);
  belt.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
  addBox(*world, unitBox, 1, at(0, unitHalf, 0));
  world->add(0, world->box(vec3(0.5, 2, 2)), at(1, 2, 0), {});
  // Bullet derives the velocity of a kinematic body from its pose when a step begins; the tick comes after that.
  const auto run = [](btDynamicsWorld* dynamics, btScalar) {
    static_cast<btRigidBody*>(dynamics->getWorldUserInfo())->setLinearVelocity(vec3(1, 0, 0));
  };
  world->dynamics().setInternalTickCallback(run, &belt, true);
  return world;
}

}  // namespace

SweepGroup longRunSweeps() {
  Sweep arch = lasting("arch_long", "arch of 21 voussoirs", 0.02, {1, 10, 60, 600, 3600}, 6,
                       [] { return buildArch(21, 1); });
  arch.remark =
      "It creeps, in double precision by 1.5 cm in the first 400 s. An hour would take `delassus` "
      "about ten minutes of the processor.";
  return {"long_runs",
          "Long runs",
          {lasting("cube", "one cube at rest", 1e-3, {1, 10, 100, 1000, 3600, 36000}, 8,
                   [] { return buildGridOfBoxes(1, 3); }),
           lasting("stack_40_long", "stack of forty boxes", 1e-3, {1, 10, 100, 600, 3600}, 20,
                   [] { return buildStack(40, 1); }),
           arch,
           lasting("conveyor", "box on a running belt, kept by a stop", 1e-3,
                   {1, 10, 100, 600, 3600}, 6, buildConveyor)}};
}

}  // namespace demos::report::stability
