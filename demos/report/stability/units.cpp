#include <cmath>

#include "demos/report/stability/sweep.h"
#include "demos/scenes/builders.h"

namespace demos::report::stability {

namespace {

/// Boxes are pressed into each other by this share of a side: Bullet reports boxes only when they
/// touch, and rounding would part some.
constexpr double bite = 1e-5;

/// `boxes` boxes of side `size` and `mass`, the top one ten times as heavy, under a gravity of
/// `pull`.
std::unique_ptr<World> buildScaledStack(int boxes, double size, double mass, double pull,
                                        double pressed = bite) {
  auto world = std::make_unique<World>();
  world->dynamics().setGravity(vec3(0, -pull, 0));
  btBoxShape& slab = world->box(vec3(50 * size, size, 50 * size));
  world->add(0, slab, at(0, -size, 0), {surfaceFriction(usualFriction), 0});
  for (int i = 0; i < boxes; ++i)
    addBox(*world, vec3(0.5 * size, 0.5 * size, 0.5 * size),
           btScalar(i == boxes - 1 ? 10 * mass : mass),
           at(0, (0.5 + i - pressed * (i + 1)) * size, 0));
  return world;
}

Sweep stackSweep(const std::string& name, const std::string& title, const std::string& axis,
                 std::vector<double> values) {
  Sweep sweep;
  sweep.name = name;
  sweep.title = "five boxes, the top ten times as heavy: " + title;
  sweep.axis = axis;
  sweep.law = "no box drifts more than 1 % of its side";
  sweep.allowed = 0.01;
  sweep.values = std::move(values);
  return sweep;
}

Trial standing(std::unique_ptr<World> world, double size) {
  return drifting(std::move(world), 180, 1.0 / 60, size);
}

Sweep timeSteps() {
  Sweep sweep = stackSweep("time_step", "time step", "time step, s",
                           {1e-6, 1e-5, 1e-4, 1e-3, 1.0 / 240, 1.0 / 60, 1.0 / 30, 0.05, 0.1, 0.2});
  sweep.law = "no box drifts more than 1 % of its free fall, or of its side if that is less";
  sweep.build = [](double timeStep) {
    constexpr int steps = 180;
    const double fall = 0.5 * gravity * std::pow(steps * timeStep, 2);
    return drifting(buildScaledStack(5, 1, 1, gravity, 0), steps, timeStep, std::min(1.0, fall));
  };
  sweep.remark =
      "In float a height of 5 m is known to 5e-7 m: within 180 steps of 1e-5 s or less nothing "
      "falls "
      "that far.";
  return sweep;
}

Sweep gravities() {
  Sweep sweep = stackSweep("gravity", "gravity", "gravity, m/s²",
                           {0, 1e-6, 1e-4, 1e-2, 1, 10, 100, 1e3, 1e4});
  sweep.build = [](double pull) { return standing(buildScaledStack(5, 1, 1, pull), 1); };
  return sweep;
}

Sweep lengths() {
  Sweep sweep =
      stackSweep("length", "size, gravity in proportion", "side of a box, m", decades(-4, 4));
  sweep.build = [](double size) {
    return standing(buildScaledStack(5, size, 1, gravity * size), size);
  };
  sweep.remark =
      "Bullet's narrow phase has lengths of its own: contacts break at 2 cm, and penetration "
      "is split beyond 4 cm.";
  return sweep;
}

Sweep trueLengths() {
  Sweep sweep =
      stackSweep("length_on_earth", "size, gravity as it is", "side of a box, m", decades(-4, 4));
  sweep.build = [](double size) { return standing(buildScaledStack(5, size, 1, gravity), size); };
  return sweep;
}

Sweep masses() {
  Sweep sweep = stackSweep("mass", "all masses", "mass of a box, kg", decades(-6, 9));
  sweep.build = [](double mass) { return standing(buildScaledStack(5, 1, mass, gravity), 1); };
  return sweep;
}

}  // namespace

SweepGroup unitSweeps() {
  return {"units",
          "Time step, gravity, sizes and units",
          {timeSteps(), gravities(), lengths(), trueLengths(), masses()}};
}

}  // namespace demos::report::stability
