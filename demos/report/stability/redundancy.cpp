#include <cmath>

#include "demos/report/stability/hung_chain.h"
#include "demos/report/stability/sweep.h"
#include "demos/scenes/builders.h"

namespace demos::report::stability {

namespace {

/// A box on a grid of feet, each a small ball that touches in one point.
Sweep manyFeet() {
  Sweep sweep;
  sweep.name = "feet";
  sweep.title = "one body of 1 kg on many feet, a 100 kg box on it";
  sweep.axis = "points of contact under it";
  sweep.law = "nothing drifts more than 1 cm";
  sweep.allowed = 0.01;
  sweep.values = {4, 9, 16, 36, 64, 100, 196, 400};
  sweep.build = [](double points) {
    constexpr double radius = 0.02, halfHeight = 0.2;
    const int side = int(std::lround(std::sqrt(points)));
    auto world = std::make_unique<World>();
    addGround(*world);
    auto& body = world->own(std::make_unique<btCompoundShape>());
    body.addChildShape(at(0, 0, 0), &world->box(vec3(unitHalf, halfHeight, unitHalf)));
    btSphereShape& foot = world->sphere(btScalar(radius));
    for (int i = 0; i < side; ++i)
      for (int k = 0; k < side; ++k) {
        const double x = -0.45 + 0.9 * i / (side - 1), z = -0.45 + 0.9 * k / (side - 1);
        body.addChildShape(at(x, -halfHeight - radius, z), &foot);
      }
    // The bodies are pressed together by this, m: rounding would part some.
    constexpr double bite = 1e-5;
    const double height = 2 * radius + halfHeight - bite;
    world->add(1, body, at(0, height, 0), {surfaceFriction(usualFriction), 0});
    addBox(*world, unitBox, 100, at(0, height + halfHeight + unitHalf - bite, 0));
    return drifting(std::move(world), 120);
  };
  sweep.remark =
      "A body that exact reactions leave with a gap of rounding is lost by Bullet's narrow phase "
      "for one "
      "or two steps: it falls by g h² = 2.7 mm, or 8.2 mm. `m_linearSlop = 1e-6` prevents it (2e-5 "
      "m), and "
      "so does the CFM of `dantzig:1e-6`.";
  return sweep;
}

Sweep copiedJoints() {
  Sweep sweep;
  sweep.name = "joint_copies";
  sweep.title = "ball of 10 kg on five links, every joint there many times";
  sweep.axis = "copies of each joint";
  sweep.law = "as the chains: 5 % of a link, 5 % of the energy";
  sweep.allowed = 0.05;
  sweep.values = {1, 2, 3, 4, 8, 16, 32, 64};
  sweep.build = [](double copies) { return hungChain({5, 10, 240, 1, int(copies)}, 2); };
  return sweep;
}

/// Bars with their ends on a circle, hinged about parallel axes, the first one fixed.
Sweep hingeLoop() {
  Sweep sweep;
  sweep.name = "hinge_loop";
  sweep.title = "closed loop of hinged bars in a vertical plane, one bar fixed";
  sweep.axis = "bars";
  sweep.law = "no joint opens by more than 5 % of a bar";
  sweep.allowed = 0.05;
  sweep.values = {4, 6, 8, 12, 16, 24, 32, 48};
  sweep.build = [](double bars) {
    const int count = int(bars);
    constexpr double length = 1;
    const double angle = 2 * M_PI / count;
    const double reach =
        0.5 * length / std::tan(angle / 2);  // from the centre to the middle of a bar
    auto world = std::make_unique<World>();
    btBoxShape& shape = world->box(vec3(0.5 * length, 0.05, 0.05));
    std::vector<btRigidBody*> ring;
    for (int i = 0; i < count; ++i) {
      // The first is on top; bars follow each other to the left.
      const double place = M_PI / 2 + angle * i;
      btRigidBody& bar =
          world->add(i == 0 ? 0 : 1, shape,
                     btTransform(aboutZ(place + M_PI / 2),
                                 vec3(reach * std::cos(place), reach * std::sin(place), 0)),
                     {});
      bar.setCollisionFlags(bar.getCollisionFlags() | btCollisionObject::CF_NO_CONTACT_RESPONSE);
      ring.push_back(&bar);
    }
    const btVector3 axis(0, 0, 1), end = vec3(0.5 * length, 0, 0);
    for (int i = 0; i < count; ++i)
      world->join(std::make_unique<btHingeConstraint>(*ring[i], *ring[(i + 1) % count], end, -end,
                                                      axis, axis));
    Trial trial{std::move(world), 480, 1.0 / 240, {}};
    trial.error = jointsOf(*trial.world, length);
    return trial;
  };
  return sweep;
}

Sweep hub() {
  Sweep sweep;
  sweep.name = "hub";
  sweep.title = "platform of 100 kg that carries boxes of 1 kg side by side";
  sweep.axis = "boxes on it";
  sweep.law = "nothing drifts more than 1 mm";
  sweep.allowed = 1e-3;
  sweep.values = {1, 4, 16, 64, 144, 324, 625, 1024};
  sweep.build = [](double boxes) {
    constexpr double spacing = 1.1, halfHeight = 0.5;
    const int side = int(std::lround(std::sqrt(boxes)));
    auto world = std::make_unique<World>();
    addGround(*world);
    const double half = 0.5 * spacing * side;
    addBox(*world, vec3(half, halfHeight, half), 100, at(0, halfHeight, 0));
    for (int i = 0; i < side; ++i)
      for (int k = 0; k < side; ++k)
        addBox(*world, unitBox, 1,
               at((i - 0.5 * (side - 1)) * spacing, 2 * halfHeight + unitHalf,
                  (k - 0.5 * (side - 1)) * spacing));
    return drifting(std::move(world), 60);
  };
  return sweep;
}

}  // namespace

SweepGroup redundancySweeps() {
  return {"redundancy", "Redundancy", {manyFeet(), copiedJoints(), hingeLoop(), hub()}};
}

}  // namespace demos::report::stability
