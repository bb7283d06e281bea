#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "demos/scenes/world.h"

namespace demos::report::stability {

/// One world at one hardness.
struct Trial {
  std::unique_ptr<World> world;
  int steps = 300;
  double timeStep = 1.0 / 60;  ///< s
  /// The error of the world now, in the unit of its sweep's law; asked after each step, with the
  /// time since the start.
  std::function<double(double time)> error;
  bool geometricStiffness = false;  ///< of delassus; the others have none
};

/// One thing made harder and harder, all else as it was.
struct Sweep {
  std::string name;   ///< its file
  std::string title;  ///< what stands or moves
  std::string axis;   ///< what is made harder, and its unit
  std::string law;    ///< what counts as holding, in words
  double allowed;     ///< the error up to which it holds
  std::vector<double> values;
  std::function<Trial(double value)> build;
  /// Where the time stepping itself fails, with any solver; 0: nowhere.
  double limit = 0;
  std::string remark;  ///< for the page, may be empty
  /// A trial takes no more steps than fit in this many times its usual seconds.
  double patience = 1;
  /// Each value takes longer than the one before: a solver that was too slow for one is not asked
  /// for the next.
  bool lengthens = false;
};

/// Sweeps of one kind: a figure and a section of the page.
struct SweepGroup {
  std::string name, title;
  std::vector<Sweep> sweeps;
  /// If not empty, names a second thing that is made harder, too. All sweeps are then one and the
  /// same, at the values of that thing: their titles are its values. Their own values are the same,
  /// and so are their law and remark: those of the first sweep.
  std::string second = {};
};

SweepGroup massSweeps();
SweepGroup unitSweeps();
SweepGroup stiffnessSweeps();
SweepGroup frictionSweeps();
SweepGroup redundancySweeps();
SweepGroup angleSweeps();
SweepGroup speedSweeps();
SweepGroup longRunSweeps();

/// Two things at once.
SweepGroup stackPair();
SweepGroup chainPair();
SweepGroup softGroundPair();
SweepGroup wedgePair();

/// 10^from, 10^(from + every), … 10^to.
std::vector<double> decades(int from, int to, int every = 1);

constexpr double gravity = 9.81;                // m/s²
const btVector3 unitBox = vec3(0.5, 0.5, 0.5);  // half of its sides

// --- Errors
// -------------------------------------------------------------------------------------------------
// Each may be asked as long as the world lives.

/// Largest distance of a body from its present place, m, over `unit`.
std::function<double(double)> driftFrom(const World& world, double unit = 1);
/// Energy gained since now, J, over `unit`.
std::function<double(double)> energyGainedFrom(const World& world, double unit);
/// Largest motion of a movable body up or sideways from its place, m; sinking does not count.
std::function<double(double)> strayFrom(const World& world, std::vector<btVector3> places);
/// How far joints come apart, m, over `unit`.
std::function<double(double)> jointsOf(const World& world, double unit = 1);
/// The larger one of two errors.
std::function<double(double)> worseOf(std::function<double(double)> a,
                                      std::function<double(double)> b);

/// Trials of a world whose law is that bodies stay in place, m over `unit`, or that it gains no
/// energy beyond what it has.
Trial drifting(std::unique_ptr<World> world, int steps, double timeStep = 1.0 / 60,
               double unit = 1);
Trial gaining(std::unique_ptr<World> world, int steps, double timeStep = 1.0 / 60);

}  // namespace demos::report::stability
