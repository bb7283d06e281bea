#include <algorithm>
#include <cmath>

#include "demos/report/stability/sweep.h"
#include "demos/scenes/builders.h"
#include "demos/scenes/wall_and_ball.h"

namespace demos::report::stability {

namespace {

double fastest(const World& world) {
  double most = 0;
  for (const btRigidBody* body : world.movableBodies()) {
    const double speed = body->getLinearVelocity().length();
    if (!(speed <= most)) most = speed;  // also a NaN
  }
  return most;
}

/// Three balls in a row that touch; the first runs into the others, and all share its momentum.
Sweep collision() {
  Sweep sweep;
  sweep.name = "collision";
  sweep.title = "ball running into two at rest, restitution 0";
  sweep.axis = "speed, m/s";
  sweep.law = "momentum is kept and the three have one speed, to 1e-3 of it";
  sweep.allowed = 1e-3;
  sweep.values = decades(-3, 5);
  sweep.build = [](double speed) {
    auto world = std::make_unique<World>();
    world->dynamics().setGravity(vec3(0, 0, 0));
    std::vector<btRigidBody*> balls;
    for (int i = 0; i < 3; ++i)
      balls.push_back(&world->add(1, world->sphere(btScalar(unitHalf)), at(i, 0, 0), {0.7f, 0}));
    balls[0]->setLinearVelocity(vec3(speed, 0, 0));
    Trial trial{std::move(world), 1, 1.0 / 60, {}};
    trial.error = [balls, speed](double) {
      double worst = 0;
      for (const btRigidBody* ball : balls)
        worst = std::max(
            worst, double((ball->getLinearVelocity() - vec3(speed / 3, 0, 0)).length()) / speed);
      return worst;
    };
    return trial;
  };
  return sweep;
}

Sweep wallHit() {
  Sweep sweep;
  sweep.name = "wall_hit";
  sweep.title = "ball of 50 kg into a wall of 24 bricks of 2 kg";
  sweep.axis = "speed of the ball, m/s";
  sweep.law = "no more than 1 % of its energy is gained";
  sweep.allowed = 0.01;
  sweep.values = decades(0, 5);
  sweep.build = [](double speed) {
    Throw thrown;
    thrown.distance = thrown.radius + unitHalf + 0.001;
    thrown.timeOfFlight = thrown.distance / speed;
    return gaining(buildWallAndBall(6, 4, thrown), 60);
  };
  return sweep;
}

/// Boxes that start inside each other: they must come apart without being thrown.
Sweep overlap() {
  Sweep sweep;
  sweep.name = "overlap";
  sweep.title = "five boxes put into each other";
  sweep.axis = "overlap of neighbours over their side";
  sweep.law = "none rises higher than 1 % of a side above the stack that they make";
  sweep.allowed = 0.01;
  sweep.values = {1e-6, 1e-4, 1e-3, 0.01, 0.03, 0.1, 0.2, 0.3, 0.4, 0.5};
  sweep.build = [](double depth) {
    constexpr int count = 5;
    auto world = std::make_unique<World>();
    addGround(*world);
    for (int i = 0; i < count; ++i)
      addBox(*world, unitBox, 1, at(0, unitHalf + i - depth * (i + 1), 0));
    Trial trial{std::move(world), 180, 1.0 / 60, {}};
    const std::vector<btRigidBody*> bodies = trial.world->movableBodies();
    trial.error = [bodies](double) {
      double highest = 0;
      for (const btRigidBody* body : bodies) {
        const double y = body->getWorldTransform().getOrigin().y();
        highest = std::isnan(y) ? INFINITY : std::max(highest, y);
      }
      return highest - (unitHalf + count - 1);
    };
    return trial;
  };
  sweep.remark =
      "Down to 4 cm Bullet's split impulse moves them apart without velocity; less than that is "
      "corrected with velocity, which adds up through the stack, whoever solves it.";
  return sweep;
}

Sweep onePoint() {
  Sweep sweep;
  sweep.name = "one_point";
  sweep.title = "boxes put at one and the same place on the ground";
  sweep.axis = "boxes";
  sweep.law = "none is faster than 50 m/s within 1 s";
  sweep.remark =
      "n boxes in one place are n²/2 pairs, all squeezed: from 16 boxes on `delassus` may walk to "
      "the end of its budget, tenths of seconds a step, and says so.";
  sweep.allowed = 50;
  sweep.values = {2, 3, 5, 8, 12, 16, 24, 32};
  sweep.build = [](double count) {
    auto world = std::make_unique<World>();
    addGround(*world);
    for (int i = 0; i < int(count); ++i) addBox(*world, unitBox, 1, at(0, unitHalf, 0));
    Trial trial{std::move(world), 60, 1.0 / 60, {}};
    trial.error = [&world = *trial.world](double) { return fastest(world); };
    return trial;
  };
  return sweep;
}

Sweep thinPlate() {
  Sweep sweep;
  sweep.name = "thin";
  sweep.title = "plate of 1 x 1 m lying under a box, thinner and thinner";
  sweep.axis = "half thickness, m";
  sweep.law = "nothing drifts more than 1 cm";
  sweep.allowed = 0.01;
  sweep.values = {0.1, 0.01, 1e-3, 1e-4, 1e-6, 1e-9, 0};
  sweep.build = [](double half) {
    auto world = std::make_unique<World>();
    addGround(*world);
    constexpr double bite = 1e-6;  // rounding would part them
    addBox(*world, vec3(unitHalf, half, unitHalf), 1, at(0, half - bite, 0));
    addBox(*world, vec3(0.4, 0.4, 0.4), 1, at(0, 2 * half + 0.4 - 2 * bite, 0));
    return drifting(std::move(world), 120);
  };
  return sweep;
}

Sweep smallInertia() {
  Sweep sweep;
  sweep.name = "point_inertia";
  sweep.title = "stack of five boxes with smaller and smaller moments of inertia; 0: none turns";
  sweep.axis = "moment of inertia over that of a box";
  sweep.law = "no box drifts more than 1 cm";
  sweep.allowed = 0.01;
  sweep.values = {1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 0};
  sweep.build = [](double share) {
    auto world = buildStack(5, 1);
    const double inertia = share / 6;
    for (btRigidBody* body : world->movableBodies()) {
      body->setMassProps(1, vec3(inertia, inertia, inertia));
      body->updateInertiaTensor();
    }
    return drifting(std::move(world), 120);
  };
  return sweep;
}

Sweep bouncing() {
  Sweep sweep;
  sweep.name = "restitution";
  sweep.title = "five boxes, 0.2 m of air between them, dropped";
  sweep.axis = "coefficient of restitution";
  sweep.law = "no more than 1 % of the energy is gained";
  sweep.allowed = 0.01;
  sweep.values = {0, 0.3, 0.6, 0.9, 0.99, 0.999, 1};
  sweep.build = [](double restitution) {
    constexpr double air = 0.2;
    auto world = std::make_unique<World>();
    // Bullet multiplies the coefficients of two bodies.
    const btScalar own = btScalar(std::sqrt(restitution));
    addGround(*world).setRestitution(own);
    for (int i = 0; i < 5; ++i)
      addBox(*world, unitBox, 1, at(0, unitHalf + i + air * (i + 1), 0)).setRestitution(own);
    return gaining(std::move(world), 480, 1.0 / 240);
  };
  sweep.remark =
      "From 0.99 on all solvers gain alike, ours with a residual of 1e-10: Newton's law of impact, "
      "contact by contact with friction, asks for it.";
  return sweep;
}

/// Stacks that are put to sleep and woken again and again.
Sweep sleepStorm() {
  Sweep sweep;
  sweep.name = "sleep";
  sweep.title = "nine stacks of three boxes put to sleep and woken in turn";
  sweep.axis = "steps between two changes";
  sweep.law = "no box drifts more than 5 mm";
  sweep.allowed = 5e-3;
  sweep.values = {60, 30, 15, 8, 4, 2, 1};
  sweep.build = [](double every) {
    auto world = std::make_unique<World>();
    addGround(*world);
    for (int x = 0; x < 3; ++x)
      for (int z = 0; z < 3; ++z)
        for (int y = 0; y < 3; ++y) addBox(*world, unitBox, 1, at(2 * x, unitHalf + y, 2 * z));
    const std::vector<btRigidBody*> bodies = world->movableBodies();
    world->setScript([bodies, step = 0, period = int(every)](double) mutable {
      const int turn = step++ / period;
      for (std::size_t i = 0; i < bodies.size(); ++i)
        bodies[i]->forceActivationState((int(i) * 7 + turn) % 3 == 0 ? ISLAND_SLEEPING
                                                                     : ACTIVE_TAG);
    });
    return drifting(std::move(world), 240);
  };
  sweep.remark =
      "In double precision the velocities of 1e-11 m/s that a solve leaves open a corner by 1e-13 "
      "m, and Bullet's box-box test, which knows only corners that overlap, puts another point in "
      "its place: for a step the box stands on a part of its foot and tips, at up to 0.03 m/s (see "
      "the feet). It pushes what sleeps on it, which has no weight until it wakes, and glides on "
      "for as long. Positions in single precision do not see such gaps.";
  return sweep;
}

}  // namespace

SweepGroup speedSweeps() {
  return {"speeds",
          "Speeds, overlaps and degenerate bodies",
          {collision(), wallHit(), overlap(), onePoint(), thinPlate(), smallInertia(), bouncing(),
           sleepStorm()}};
}

}  // namespace demos::report::stability
