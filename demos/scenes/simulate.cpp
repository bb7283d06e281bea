#include "demos/scenes/simulate.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "LinearMath/btScalar.h"
#include "bullet_ext/btDelassusConstraintSolver.h"
#include "demos/scenes/solver_in_world.h"
#include "demos/scenes/statistics.h"
#include "demos/scenes/step_judge.h"

namespace demos {

namespace {

void collect(const std::vector<std::string>& told, std::vector<RunSummary::Message>& all) {
  // The first messages are enough, as in the report of one step.
  constexpr std::size_t longest = 64;
  for (const std::string& text : told) {
    const auto known = std::find_if(all.begin(), all.end(),
                                    [&](const RunSummary::Message& m) { return m.text == text; });
    if (known != all.end())
      ++known->steps;
    else if (all.size() < longest)
      all.push_back({text, 1});
  }
}

void count(RunSummary& summary, const delassus::StepReport& report) {
  RunSummary::Regions& regions = *summary.regions;
  regions.perStep += report.regions;
  regions.factorisationsPerStep += report.factorisations;
  regions.solved += report.solved;
  regions.outOfBudget += report.outOfBudget;
  regions.incompatible += report.incompatible;
  regions.nonFinite += report.nonFinite;
  regions.leftOut += report.leftOut;
  regions.pushUnsolved += report.pushUnsolved;
  regions.stiffened = std::max(regions.stiffened, report.stiffened);
  collect(report.messages, regions.messages);
  regions.totals.add(report);
  summary.modes = {report.open, report.stick, report.slide};
}

}  // namespace

int stepsIn(double seconds, double hz) {
  const double steps = std::round(seconds * hz);
  if (!(steps <= 1e9)) throw std::runtime_error("more than a billion steps were asked for");
  const double most = 1 / double(SIMD_EPSILON);
  if (hz > most)
    throw std::runtime_error("more than " + std::to_string(static_cast<long long>(most)) +
                             " steps a second were asked for: Bullet leaves out steps so short");
  return int(steps);
}

RunSummary simulate(World& world, NamedSolver& named, const RunSettings& settings,
                    const std::function<void(double)>& progress) {
  btDiscreteDynamicsWorld& dynamics = world.dynamics();
  SolverInWorld solving(world, named);
  StepJudge judge(solving.timed(), named, solving.sceneCfm());
  world.setSolver(judge.solver());

  RunSummary summary;
  summary.solver = named.name();
  summary.hz = settings.hz;
  summary.steps = std::max(1, stepsIn(settings.seconds, settings.hz));
  summary.bodies = int(world.movableBodies().size());
  if (named.delassus() != nullptr) summary.regions = RunSummary::Regions();
  const Drift drift(world);
  Tunnelling tunnelling(world);
  const int settled = summary.steps / 4;
  std::vector<double> milliseconds;
  StepResidual settledResidual;
  for (int step = 0; step < summary.steps; ++step) {
    world.step(1 / settings.hz);

    milliseconds.push_back(1e3 * solving.timed().takeSeconds());
    StepResidual now = judge.takeResidual();
    if (!isFinite(world)) {
      // Lost bodies are left out of the contacts and of the judged problem: the rest may look
      // sound.
      ++summary.stepsLost;
      now.max = now.sumOfSquares = std::nan("");
      now.count = std::max(now.count, 1L);
      summary.penetrationMax = summary.jointErrorMax = summary.driftMax = std::nan("");
      summary.reactionOverWeight = std::nan("");
      if (settings.law) summary.lawError = std::nan("");
    }
    summary.stepsAbove += !(now.max <= RunSummary::strict);
    if (step >= settled) {
      settledResidual.max = largerOf(settledResidual.max, now.max);
      settledResidual.sumOfSquares += now.sumOfSquares;
      settledResidual.count += now.count;
      summary.reactionOverWeight +=
          reactionOverWeight(world, 1 / settings.hz) / (summary.steps - settled);
      if (settings.law)
        summary.lawError =
            largerOf(summary.lawError.value_or(0), settings.law->error(world, 1 / settings.hz));
    }
    if (summary.regions) count(summary, named.delassus()->report());
    summary.contactsMax = std::max(summary.contactsMax, world.contactCount());
    summary.penetrationMax = largerOf(summary.penetrationMax, deepestPenetration(dynamics));
    summary.jointErrorMax = largerOf(summary.jointErrorMax, largestJointError(dynamics));
    summary.driftMax = largerOf(summary.driftMax, drift.largest());
    tunnelling.look();
    progress(double(step + 1) / summary.steps);
  }

  if (summary.regions) {
    summary.regions->perStep /= summary.steps;
    summary.regions->factorisationsPerStep /= summary.steps;
  } else {
    summary.modes = writtenModes(dynamics);
  }
  summary.msFirst = milliseconds.front();
  summary.msMean = std::accumulate(milliseconds.begin(), milliseconds.end(), 0.0) / summary.steps;
  summary.msMedian = median(milliseconds);
  summary.msP95 = quantile(milliseconds, 0.95);
  summary.residualMax = settledResidual.max;
  summary.residualRms = settledResidual.rms();
  summary.kineticEnergy = kineticEnergy(world);
  summary.tunnelled = tunnelling.bodies();
  summary.fallbacks = named.fallbacks();
  return summary;
}

}  // namespace demos
