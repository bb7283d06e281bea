#include <cmath>

#include "demos/report/stability/sweep.h"
#include "demos/scenes/builders.h"
#include "demos/table.h"

namespace demos::report::stability {

namespace {

const std::vector<double> angleValues{0.3, 0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9};

/// A ball of 1 kg and radius 0.5 m that touches two planes.
Trial between(const btVector3& normal1, const btVector3& normal2, const btVector3& force,
              double mu = 0) {
  std::unique_ptr<World> world = buildBead({normal1, normal2}, force);
  if (mu > 0)
    for (int i = 0; i < world->dynamics().getNumCollisionObjects(); ++i)
      world->dynamics().getCollisionObjectArray()[i]->setFriction(surfaceFriction(mu));
  return drifting(std::move(world), 120);
}

/// The ball between two planes that close to a shaft; it is pressed down.
Trial wedge(double angle, double press, double mu) {
  const double c = std::cos(angle), s = std::sin(angle);
  return between(vec3(c, s, 0), vec3(-c, s, 0), vec3(0, -press, 0), mu);
}

Sweep nearlyOpposite() {
  Sweep sweep;
  sweep.name = "opposite";
  sweep.title = "frictionless ball of 1 kg pressed into a wedge: normals nearly opposite";
  sweep.axis = "half angle of the wedge, rad";
  sweep.law = "it drifts less than 1 mm in 2 s";
  sweep.allowed = 1e-3;
  sweep.values = angleValues;
  sweep.build = [](double angle) { return wedge(angle, beadForce, 0); };
  sweep.remark =
      "At 1e-7 rad W has a condition of 1e14: the demands of the two planes cannot be told from "
      "contradicting ones, and are reported as such.";
  return sweep;
}

Sweep nearlyParallel() {
  Sweep sweep;
  sweep.name = "parallel";
  sweep.title =
      "frictionless ball on two planes nearly the same, pushed aside by less than they lean";
  sweep.axis = "lean of either plane, rad";
  sweep.law = "it drifts less than 1 mm in 2 s";
  sweep.allowed = 1e-3;
  sweep.values = angleValues;
  sweep.build = [](double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return between(vec3(s, c, 0), vec3(-s, c, 0),
                   vec3(0.5 * beadForce * std::tan(angle), -beadForce, 0));
  };
  sweep.remark = "Below 1e-5 rad a ball that slips freely would not go 1 mm either.";
  return sweep;
}

Sweep roughWedge() {
  Sweep sweep;
  sweep.name = "rough_wedge";
  sweep.title =
      "the ball in a wedge of half angle 0.1 rad, friction 0.5, pressed harder and harder";
  sweep.axis = "press, N";
  sweep.law = "it drifts less than 1 mm in 2 s";
  sweep.allowed = 1e-3;
  sweep.values = decades(0, 12);
  sweep.build = [](double press) { return wedge(0.1, press, 0.5); };
  sweep.remark =
      "The tolerance of `delassus` is relative, 1e-8 of the largest demand, which is press h/m: "
      "1e9 N on "
      "1 kg ask for 1.6e7 m/s, and cm/s are left.";
  return sweep;
}

/// Three planes about the vertical: W goes to rank one as they flatten, to rank two as they close.
Sweep trihedron() {
  Sweep sweep;
  sweep.name = "trihedron";
  sweep.title = "frictionless ball in a corner of three planes that close to a shaft";
  sweep.axis = "vertical part of the normals";
  sweep.law = "it drifts less than 1 mm in 2 s";
  sweep.allowed = 1e-3;
  sweep.values = angleValues;
  sweep.build = [](double height) {
    return drifting(buildBeadInTrihedron(height, vec3(0, -1, 0)), 120);
  };
  return sweep;
}

}  // namespace

SweepGroup wedgePair() {
  SweepGroup group{"wedge_pair", "Ball of 1 kg pressed into a wedge", {}, "friction"};
  for (const double mu : {0.0, 0.1, 0.3, 1.0, 3.0}) {
    Sweep sweep = nearlyOpposite();
    const std::string number = shortNumber(mu, 2);
    sweep.name = "wedge_" + number;
    sweep.title = "μ = " + number;
    sweep.build = [mu](double angle) { return wedge(angle, beadForce, mu); };
    group.sweeps.push_back(sweep);
  }
  return group;
}

SweepGroup angleSweeps() {
  return {"angles",
          "Angles between planes",
          {nearlyOpposite(), nearlyParallel(), trihedron(), roughWedge()}};
}

}  // namespace demos::report::stability
