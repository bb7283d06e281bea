#include "demos/report/stability/sweep.h"

#include <algorithm>
#include <cmath>

#include "demos/scenes/measures.h"

namespace demos::report::stability {

std::vector<SweepGroup> allSweeps() {
  return {massSweeps(),       unitSweeps(),  stiffnessSweeps(), frictionSweeps(),
          redundancySweeps(), angleSweeps(), speedSweeps(),     longRunSweeps()};
}

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
  const double start = kineticEnergy(world) + potentialEnergy(world);
  return [&world, start, unit](double) {
    return (kineticEnergy(world) + potentialEnergy(world) - start) / unit;
  };
}

std::function<double(double)> jointsOf(const World& world, double unit) {
  return [&world, unit](double) { return largestJointError(world.dynamics()) / unit; };
}

std::function<double(double)> worseOf(std::function<double(double)> a,
                                      std::function<double(double)> b) {
  // A NaN of either must not be lost: std::max would drop one of them.
  return [a = std::move(a), b = std::move(b)](double time) {
    const double x = a(time), y = b(time);
    return std::isnan(x) || x > y ? x : y;
  };
}

}  // namespace demos::report::stability
