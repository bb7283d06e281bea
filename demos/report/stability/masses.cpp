#include <cmath>

#include "demos/report/stability/hung_chain.h"
#include "demos/report/stability/sweep.h"
#include "demos/scenes/builders.h"

namespace demos::report::stability {

namespace {

Sweep heavyTop(int boxes, int steps) {
  const std::string count = std::to_string(boxes);
  Sweep sweep;
  sweep.name = "stack_" + count;
  sweep.title = "stack of " + count + " boxes of 1 kg, the top heavier";
  sweep.axis = "mass of the top over that of the others";
  sweep.law = "no box drifts more than 1 cm";
  sweep.allowed = 0.01;
  sweep.values = decades(0, 9);
  sweep.build = [boxes, steps](double ratio) { return drifting(buildStack(boxes, ratio), steps); };
  sweep.remark =
      "Exact reactions leave gaps of 1e-10 m by rounding, and Bullet's narrow phase drops and "
      "finds such points again: beyond 1e6 in double their loads are found anew in every step.";
  return sweep;
}

/// The remedy for points that come and go: keep them pressed in.
Sweep heavyTopWithSlop() {
  Sweep sweep = heavyTop(10, 300);
  sweep.name = "stack_10_slop";
  sweep.title = "the same stack of 10 with m_linearSlop = 1e-6";
  sweep.build = [build = sweep.build](double ratio) {
    Trial trial = build(ratio);
    trial.world->dynamics().getSolverInfo().m_linearSlop = btScalar(1e-6);
    return trial;
  };
  sweep.remark =
      "The remedy: `m_linearSlop` of the world's solver info keeps contacts pressed in by that, m, "
      "so "
      "that the narrow phase does not lose them.";
  return sweep;
}

constexpr double chainRate = 240;

Sweep chain(int links) {
  const std::string count = std::to_string(links);
  Sweep sweep;
  sweep.name = "chain_" + count;
  sweep.title = "ball on " + count + " links of 1 kg, let go from 30 degrees, 240 steps a second";
  sweep.axis = "mass of the ball over that of a link";
  sweep.law =
      "joints open less than 5 % of a link, and no more than 5 % of the swing's energy is gained";
  sweep.allowed = 0.05;
  sweep.values = decades(0, 9);
  sweep.limit = heaviestBall(links, 1 / chainRate);
  sweep.build = [links](double ratio) { return hungChain({links, ratio, chainRate}, 2); };
  return sweep;
}

/// The first remedy for a taut chain.
Sweep chainSubsteps() {
  constexpr int links = 20;
  constexpr double ball = 1e4, rate = 60;
  Sweep sweep;
  sweep.name = "chain_substeps";
  sweep.title = "the same chain of 20 with a ball of 1e4 kg, 60 steps a second of more substeps";
  sweep.axis = "substeps";
  sweep.law = "as above";
  sweep.allowed = 0.05;
  sweep.values = {1, 2, 4, 8, 16, 32, 64, 128};
  sweep.limit = leastRate(links, ball) / rate;
  sweep.build = [](double substeps) { return hungChain({links, ball, rate, int(substeps)}, 1); };
  sweep.remark =
      "A remedy for a taut chain: `stepSimulation(dt, substeps, dt / substeps)`. The time of a "
      "step is that of all its substeps.";
  return sweep;
}

/// The second one.
Sweep geometricChain() {
  Sweep sweep = chain(20);
  sweep.name = "chain_20_geometric";
  sweep.title = "the same chain of 20 with geometric stiffness (delassus), 60 steps a second";
  sweep.limit = 0;
  sweep.build = [](double ratio) {
    Trial trial = hungChain({20, ratio, 60}, 2);
    trial.geometricStiffness = true;
    return trial;
  };
  sweep.remark =
      "Another remedy, and on unless it is switched off, as it is in all other maps: "
      "`setGeometricStiffness(true)`. Each link turns as if implicit springs of the stiffness that "
      "the last step's tension gives it held it, and no other body does. It costs no time, and a "
      "swing 2 % of its energy a second at 60 Hz, less in shorter steps. The stock solvers have "
      "nothing of the kind. What opens in the end are joints that give by 1e-10 (in "
      "float 1e-8) of their W, lest rounding in redundant ones contradict itself.";
  return sweep;
}

/// The third one, which serves all solvers.
Sweep stiffenedChain() {
  Sweep sweep = chain(20);
  sweep.name = "chain_20_stiffened";
  sweep.title = "the same chain of 20, its links stiffened against turning, 240 steps a second";
  sweep.limit = 0;
  sweep.build = [](double ratio) { return hungChain({20, ratio, chainRate, 1, 1, true}, 2); };
  sweep.remark =
      "A remedy for any solver: h² T l/3 is added to the moments of inertia of the links across "
      "them "
      "(`setMassProps`), T the largest tension. It slows only the turning that the step cannot "
      "follow (ω h < √3), and costs no time. It must be known how taut the chain gets.";
  return sweep;
}

Sweep press() {
  Sweep sweep;
  sweep.name = "press";
  sweep.title = "27 boxes of 1 kg, 3 x 3 x 3, under a plate";
  sweep.axis = "mass of the plate over that of a box";
  sweep.law = "nothing drifts more than 1 cm";
  sweep.allowed = 0.01;
  sweep.values = decades(0, 9);
  sweep.build = [](double mass) {
    constexpr double spacing = 1.02;
    auto world = std::make_unique<World>();
    addGround(*world);
    for (int y = 0; y < 3; ++y)
      for (int x = -1; x <= 1; ++x)
        for (int z = -1; z <= 1; ++z)
          addBox(*world, unitBox, 1, at(spacing * x, unitHalf + y, spacing * z));
    addBox(*world, vec3(2, 0.25, 2), btScalar(mass), at(0, 3.25, 0));
    return drifting(std::move(world), 120);
  };
  return sweep;
}

/// A body spun about the vertical on the ground, with moments of inertia that no box has.
Sweep anisotropy() {
  Sweep sweep;
  sweep.name = "inertia";
  sweep.title = "tilted box spinning at 6 rad/s on the ground, one moment of inertia smaller";
  sweep.axis = "largest over smallest moment of inertia";
  sweep.law = "no more than 1 % of its energy is gained";
  sweep.allowed = 0.01;
  sweep.values = decades(0, 6);
  sweep.build = [](double ratio) {
    auto world = std::make_unique<World>();
    addGround(*world);
    // On one edge, so that it falls over while it spins.
    const double tilt = 0.3;
    const double height = unitHalf * (std::sin(tilt) + std::cos(tilt));
    btRigidBody& body = addBox(*world, unitBox, 1, btTransform(aboutZ(tilt), vec3(0, height, 0)));
    body.setMassProps(1, vec3(1.0 / 6, 1.0 / 6, 1.0 / 6 / ratio));
    body.updateInertiaTensor();
    body.setAngularVelocity(vec3(0, 6, 0));
    return gaining(std::move(world), 180);
  };
  return sweep;
}

}  // namespace

SweepGroup stackPair() {
  SweepGroup group{"stack_pair", "Stack of boxes of 1 kg, the top heavier", {}, "height"};
  for (const int boxes : {2, 5, 10, 20, 40}) {
    Sweep sweep = heavyTop(boxes, 60);
    sweep.title = std::to_string(boxes) + " boxes";
    sweep.values = decades(0, 8, 2);
    sweep.remark = {};
    group.sweeps.push_back(sweep);
  }
  return group;
}

SweepGroup chainPair() {
  SweepGroup group{"chain_pair",
                   "Ball on 20 links of 1 kg, let go from 30 degrees, 1 s instead of 2",
                   {},
                   "time step"};
  for (const double rate : {60, 240, 960, 3840}) {
    Sweep sweep = chain(20);
    sweep.name = "chain_" + std::to_string(int(rate));
    sweep.title = std::to_string(int(rate)) + " steps a second";
    sweep.values = decades(0, 6);
    sweep.limit = heaviestBall(20, 1 / rate);
    sweep.build = [rate](double ratio) { return hungChain({20, ratio, rate}, 1); };
    sweep.patience = 2;  // for the most steps
    group.sweeps.push_back(sweep);
  }
  return group;
}

SweepGroup massSweeps() {
  return {"masses",
          "Mass ratio",
          {heavyTop(10, 300), heavyTopWithSlop(), heavyTop(40, 120), chain(20), chain(100),
           chainSubsteps(), geometricChain(), stiffenedChain(), press(), anisotropy()}};
}

}  // namespace demos::report::stability
