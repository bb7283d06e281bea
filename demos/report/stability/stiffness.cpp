#include <algorithm>
#include <cmath>

#include "demos/report/stability/sweep.h"
#include "demos/scenes/builders.h"

namespace demos::report::stability {

namespace {

constexpr double weight = gravity;  // of the box of 1 kg, N
constexpr double rate = 240;

/// A box of 1 kg set on a ground of stiffness `k` at each of its four points, N/m, for 4 s of
/// `stepRate` steps each.
Sweep softGround(bool damped, double stepRate = rate) {
  Sweep sweep;
  sweep.name = damped ? "contact_damped" : "contact_undamped";
  sweep.title = std::string("box of 1 kg on contacts with a spring each, ") +
                (damped ? "critically damped" : "undamped");
  sweep.axis = "stiffness of a contact, N/m";
  sweep.law =
      damped
          ? "after 4 s it has sunk by m g/(4 k), to 1 mm or 1 %"
          : "it swings about m g/(4 k): never 1 mm or 1 % beyond twice that, nor above its start";
  sweep.allowed = 1;
  sweep.values = decades(1, 12);
  sweep.build = [damped, stepRate](double k) {
    constexpr double seconds = 4;
    auto world = std::make_unique<World>();
    btRigidBody& ground = addGround(*world);
    const double damping = damped ? 2 * std::sqrt(k / 4) : 0;
    ground.setContactStiffnessAndDamping(btScalar(k), btScalar(damping));
    btRigidBody& box = addBox(*world, unitBox, 1, at(0, unitHalf, 0));
    Trial trial{std::move(world), int(std::lround(seconds * stepRate)), 1 / stepRate, {}};
    const double sag = weight / (4 * k), tolerance = std::max(1e-3, 0.01 * sag);
    trial.error = [&box, damped, sag, tolerance, stepRate](double time) {
      const double sunk = unitHalf - double(box.getWorldTransform().getOrigin().y());
      if (!damped) return std::max(sunk - 2 * sag, -sunk) / tolerance;
      return time < seconds - 1.5 / stepRate ? 0 : std::abs(sunk - sag) / tolerance;
    };
    return trial;
  };
  return sweep;
}

/// A heavy box held by a spring on soft contacts is no harder than one; here a hard box stands on a
/// soft one on a hard one.
Sweep softOnHard() {
  Sweep sweep;
  sweep.name = "soft_on_hard";
  sweep.title = "six boxes, every second one soft, under one of 100 kg";
  sweep.axis = "stiffness of a contact, N/m";
  sweep.law = "no box rises by more than 1 cm or moves aside by more than 1 cm";
  sweep.allowed = 0.01;
  sweep.values = decades(4, 12);
  sweep.build = [](double k) {
    auto world = std::make_unique<World>();
    addGround(*world);
    for (int i = 0; i < 6; ++i) {
      btRigidBody& box = addBox(*world, unitBox, i == 5 ? 100 : 1, at(0, unitHalf + i, 0));
      if (i % 2 == 0) box.setContactStiffnessAndDamping(btScalar(k), btScalar(2 * std::sqrt(k)));
    }
    std::vector<btVector3> start;
    for (const btRigidBody* body : world->movableBodies())
      start.push_back(body->getWorldTransform().getOrigin());
    auto error = strayFrom(*world, start);
    return Trial{std::move(world), 480, 1 / rate, error};
  };
  return sweep;
}

/// A 1 kg box on a spring of Bullet's six-dof joint, let go where the spring is slack.
Sweep spring() {
  Sweep sweep;
  sweep.name = "spring";
  sweep.title = "box of 1 kg hung on a spring of btGeneric6DofSpring2Constraint, let go";
  sweep.axis = "stiffness, N/m";
  sweep.law =
      "no more energy than 5 % of its deepest fall is gained, it falls no deeper than 1.05 times "
      "2 m g/k or 1 cm";
  sweep.allowed = 0.05;
  sweep.values = decades(1, 9);
  sweep.build = [](double k) {
    auto world = std::make_unique<World>();
    btRigidBody& box = addBox(*world, unitBox, 1, at(0, 0, 0));
    auto joint = std::make_unique<btGeneric6DofSpring2Constraint>(box, btTransform::getIdentity());
    constexpr int vertical = 1;
    joint->setLinearLowerLimit(vec3(0, 1, 0));
    joint->setLinearUpperLimit(vec3(0, -1, 0));  // crossed: free along the spring
    joint->setAngularLowerLimit(vec3(0, 0, 0));
    joint->setAngularUpperLimit(vec3(0, 0, 0));
    joint->enableSpring(vertical, true);
    joint->setStiffness(vertical, btScalar(k));
    joint->setDamping(vertical, 0);
    joint->setEquilibriumPoint(vertical, 0);
    world->join(std::move(joint));
    Trial trial{std::move(world), 480, 1 / rate, {}};
    const double reach = std::max(2 * weight / k, 0.01);
    trial.error = [&box, reach](double) {
      const double y = box.getWorldTransform().getOrigin().y();
      return std::max(-y / reach - 1, y / reach);
    };
    return trial;
  };
  return sweep;
}

/// A motor that drives a box along a rail at 2 m/s, without gravity or friction.
Sweep motor() {
  Sweep sweep;
  sweep.name = "motor";
  sweep.title = "box of 1 kg on a slider whose motor asks for 2 m/s";
  sweep.axis = "largest force of the motor, N";
  sweep.law = "its speed is min(F t/m, 2 m/s), to 1 %";
  sweep.allowed = 0.01;
  sweep.values = decades(-3, 9);
  sweep.build = [](double force) {
    auto world = std::make_unique<World>();
    world->dynamics().setGravity(vec3(0, 0, 0));
    btRigidBody& box = addBox(*world, unitBox, 1, at(0, 0, 0));
    auto slider = std::make_unique<btSliderConstraint>(box, btTransform::getIdentity(), true);
    slider->setLowerLinLimit(-1e3);
    slider->setUpperLinLimit(1e3);
    slider->setPoweredLinMotor(true);
    slider->setTargetLinMotorVelocity(2);
    slider->setMaxLinMotorForce(btScalar(force));
    world->join(std::move(slider));
    Trial trial{std::move(world), 120, 1.0 / 60, {}};
    trial.error = [&box, force](double time) {
      const double right = std::min(force * time, 2.0);
      return std::abs(std::abs(double(box.getLinearVelocity().x())) - right) / right;
    };
    return trial;
  };
  return sweep;
}

Sweep compliance() {
  Sweep sweep;
  sweep.name = "cfm";
  sweep.title = "stack of ten boxes, the world's global CFM";
  sweep.axis = "CFM";
  sweep.law = "no more than 1 % of the stack's energy is gained";
  sweep.allowed = 0.01;
  sweep.values = {0, 1e-9, 1e-6, 1e-3, 1, 1e3, 1e6, 1e9};
  sweep.build = [](double cfm) {
    auto world = buildStack(10, 1);
    world->dynamics().getSolverInfo().m_globalCfm = btScalar(cfm);
    return gaining(std::move(world), 120);
  };
  sweep.remark = "`dantzig:1e-6` sets this CFM itself.";
  return sweep;
}

Sweep errorReduction() {
  Sweep sweep;
  sweep.name = "erp";
  sweep.title = "stack of ten boxes that overlap by 0.1 mm, ERP of contacts";
  sweep.axis = "ERP";
  sweep.law = "no box rises more than 1 cm above where the stack ends, nor moves aside by 1 cm";
  sweep.allowed = 0.01;
  sweep.values = {0, 0.01, 0.1, 0.2, 0.5, 0.8, 0.9, 1};
  sweep.build = [](double erp) {
    constexpr double overlap = 1e-4;
    auto world = std::make_unique<World>();
    addGround(*world);
    std::vector<btVector3> ends;
    for (int i = 0; i < 10; ++i) {
      ends.push_back(vec3(0, unitHalf + i, 0));
      addBox(*world, unitBox, 1, at(0, (unitHalf + i) - overlap * (i + 1), 0));
    }
    btContactSolverInfo& info = world->dynamics().getSolverInfo();
    info.m_erp = info.m_erp2 = btScalar(erp);
    auto error = strayFrom(*world, ends);
    return Trial{std::move(world), 180, 1.0 / 60, error};
  };
  return sweep;
}

}  // namespace

SweepGroup softGroundPair() {
  SweepGroup group{"soft_ground_pair",
                   "Box of 1 kg on contacts with a spring each, critically damped",
                   {},
                   "time step"};
  for (const int stepRate : {10, 30, 60, 240, 1000}) {
    Sweep sweep = softGround(true, stepRate);
    sweep.name = "soft_ground_" + std::to_string(stepRate);
    sweep.title = std::to_string(stepRate) + " steps a second";
    sweep.values = decades(1, 11, 2);
    group.sweeps.push_back(sweep);
  }
  return group;
}

SweepGroup stiffnessSweeps() {
  return {"stiffness",
          "Stiffness",
          {softGround(true), softGround(false), softOnHard(), spring(), motor(), compliance(),
           errorReduction()}};
}

}  // namespace demos::report::stability
