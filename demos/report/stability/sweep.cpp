#include "demos/report/stability/sweep.h"

#include <algorithm>
#include <cmath>

#include "demos/scenes/measures.h"
#include "demos/scenes/statistics.h"

namespace demos::report::stability {

std::vector<double> decades(int from, int to, int every) {
  std::vector<double> values;
  for (int exponent = from; exponent <= to; exponent += every)
    values.push_back(std::pow(10.0, exponent));
  return values;
}

std::function<double(double)> driftFrom(const World& world, double unit) {
  return [drift = Drift(world), unit](double) { return drift.largest() / unit; };
}

std::function<double(double)> energyGainedFrom(const World& world, double unit) {
  return [&world, start = totalEnergy(world), unit](double) {
    return (totalEnergy(world) - start) / unit;
  };
}

std::function<double(double)> strayFrom(const World& world, std::vector<btVector3> places) {
  return [bodies = world.movableBodies(), places = std::move(places)](double) {
    double worst = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const btVector3 way = bodies[i]->getWorldTransform().getOrigin() - places[i];
      const double aside = std::hypot(double(way.x()), double(way.z()));
      const double error = std::max(aside, double(way.y()));
      worst = std::isnan(error) ? INFINITY : std::max(worst, error);
    }
    return worst;
  };
}

std::function<double(double)> jointsOf(const World& world, double unit) {
  return [&world, unit](double) { return largestJointError(world.dynamics()) / unit; };
}

std::function<double(double)> worseOf(std::function<double(double)> a,
                                      std::function<double(double)> b) {
  return [a = std::move(a), b = std::move(b)](double time) { return largerOf(a(time), b(time)); };
}

Trial drifting(std::unique_ptr<World> world, int steps, double timeStep, double unit) {
  auto error = driftFrom(*world, unit);
  return {std::move(world), steps, timeStep, std::move(error)};
}

Trial gaining(std::unique_ptr<World> world, int steps, double timeStep) {
  auto error = energyGainedFrom(*world, totalEnergy(*world));
  return {std::move(world), steps, timeStep, std::move(error)};
}

}  // namespace demos::report::stability
