#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "demos/scenes/measures.h"
#include "demos/scenes/scene.h"
#include "demos/scenes/solvers.h"
#include "demos/scenes/step_totals.h"

namespace demos {

struct RunSettings {
  double seconds = 5;  ///< simulated, s
  double hz = 60;      ///< steps a second
  std::optional<Law> law = std::nullopt;
};

/// seconds · hz as a whole number. Throws std::runtime_error above a billion, since such a run
/// would take too long, and where the steps are so short that Bullet leaves them out.
int stepsIn(double seconds, double hz);

/// One solver on one world: what moved, how well the law was kept, what it cost. The keys of `run
/// --json`.
///
/// Residuals and the error of the law are over the last three quarters of the run; residuals are in
/// m/s. Times are of solveGroup alone, per step. In a lost world the residual, the drift and all
/// other measures of lost bodies are NaN.
struct RunSummary {
  static constexpr double strict = 1e-6;  ///< m/s

  std::string solver;
  int steps = 0;
  double hz = 60;
  int bodies = 0;
  int contactsMax = 0;
  double msFirst = 0;  ///< of the first step, from nothing
  double msMean = 0, msMedian = 0, msP95 = 0;
  double residualRms = 0, residualMax = 0;
  int stepsAbove = 0;              ///< steps, of all, with a residual above `strict`, or lost
  int stepsLost = 0;               ///< steps, of all, that ended with a body that is nowhere
  double penetrationMax = 0;       ///< m, over the run
  int tunnelled = 0;               ///< bodies in or under what cannot move, at the end (measures.h)
  double kineticEnergy = 0;        ///< J, at the end
  double driftMax = 0;             ///< largest distance of any body from its start, over the run, m
  double jointErrorMax = 0;        ///< m, over the run
  double reactionOverWeight = 0;   ///< mean of the last three quarters
  std::optional<double> lawError;  ///< the largest, in the unit of the law
  ModeCounts modes;                ///< of the last step
  int fallbacks = 0;

  /// Something that was left out or not solved, and in how many steps.
  struct Message {
    std::string text;
    int steps = 0;
  };
  /// Numbers that only our solver can tell.
  struct Regions {
    double perStep = 0, factorisationsPerStep = 0;
    long solved = 0, outOfBudget = 0, incompatible = 0, nonFinite = 0;  ///< islands, all steps
    long leftOut = 0;       ///< bodies, contacts and rows solved around, all steps
    long pushUnsolved = 0;  ///< islands of the push problem, all steps
    int stiffened = 0;      ///< largest number of bodies in a step that geometric stiffness slowed
    std::vector<Message> messages;
    StepTotals totals;
  };
  std::optional<Regions> regions;
};

/// Steps `world` with `named`. Tells `progress` the fraction done after each step.
RunSummary simulate(World& world, NamedSolver& named, const RunSettings& settings,
                    const std::function<void(double)>& progress);

}  // namespace demos
