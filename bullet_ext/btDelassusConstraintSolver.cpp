#include "bullet_ext/btDelassusConstraintSolver.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "BulletDynamics/ConstraintSolver/btContactSolverInfo.h"
#include "bullet_ext/extension.h"
#include "bullet_ext/gather.h"
#include "bullet_ext/geometric_stiffness.h"
#include "bullet_ext/memory.h"
#include "bullet_ext/plan.h"
#include "bullet_ext/push.h"
#include "bullet_ext/solve_group.h"
#include "bullet_ext/workshop.h"
#include "bullet_ext/write_back.h"

using namespace delassus;
using namespace delassus::bullet;

namespace {

/// Adds the time since the last lap to a counter; for the report only.
class Laps {
 public:
  void end(double& seconds) {
    const Clock::time_point now = Clock::now();
    seconds += std::chrono::duration<double>(now - start_).count();
    start_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

void countStatus(Status status, StepReport& report) {
  switch (status) {
    case Status::Solved:
      ++report.solved;
      break;
    case Status::OutOfBudget:
      ++report.outOfBudget;
      break;
    case Status::Incompatible:
      ++report.incompatible;
      break;
    case Status::NonFinite:
      ++report.nonFinite;
      break;
  }
}

void countTier(Tier tier, StepReport& report) {
  ++(tier == Tier::Free         ? report.freeIslands
     : tier == Tier::Kept       ? report.keptIslands
     : tier == Tier::ClosedForm ? report.closedForms
                                : report.walks);
}

/// What messages say after the name of a contact or joint that is blamed.
const char* reasonOf(Status status) {
  switch (status) {
    case Status::OutOfBudget:
      return ": the budget of its island ended above the tolerance; the error is largest here";
    case Status::Incompatible:
      return ": no motion meets its demand; the nearest one is taken";
    case Status::NonFinite:
      return ": its island is left without reactions: the numbers do not stay finite";
    case Status::Solved:
      break;
  }
  return "";
}

/// Worlds step on from their reactions: what comes to a solver with a guess has been found wanting by the island check.
Options forWorlds(Options options) {
  options.guessShare = std::min(options.guessShare, worldPolishedShare);
  return options;
}

}  // namespace

struct btDelassusConstraintSolver::Workspace {
  explicit Workspace(const Options& userOptions)
      : options(userOptions), workshop(forWorlds(options), options) {}

  Options options;
  Workshop workshop;
  Group group;
  Memory memory;
  GeometricStiffness stiffness;
  Answer answer;
  Pushes pushes;
  std::vector<ContactEvent> events;
  StepReport report;
  double residualSquares = 0;  ///< of the whole step, (m/s)²
  long residualParts = 0;

  void clearReport() {
    report = StepReport{};
    residualSquares = 0;
    residualParts = 0;
  }
  /// Lets go of all storage that no later step depends on.
  void release();
  void countSolve(const Bench::Counts& work);
};

void btDelassusConstraintSolver::Workspace::release() {
  workshop.clear();
  group = Group();
  stiffness = GeometricStiffness();
  answer = Answer();
  pushes = Pushes();
  events = {};
}

void btDelassusConstraintSolver::Workspace::countSolve(const Bench::Counts& work) {
  report.contacts += static_cast<int>(group.contacts.size());
  report.rows += static_cast<int>(group.rows.size()) - group.turningRows;
  report.islands += static_cast<int>(answer.islands.size());
  for (std::size_t i = 0; i < answer.islands.size(); ++i) {
    const IslandResult& island = answer.islands[i];
    countStatus(island.status, report);
    countTier(island.tier, report);
    report.residualMax = std::max(report.residualMax, island.residualMax);
    residualSquares += island.residualRms * island.residualRms * island.parts;
    residualParts += island.parts;
    for (int unknown : island.blamed)
      report.tell(nameOf(group, answer, static_cast<int>(i), unknown) + reasonOf(island.status));
  }
  if (residualParts > 0) report.residualRms = std::sqrt(residualSquares / residualParts);

  report.matrices += answer.matrices;
  report.regions += work.regions + pushes.counts.regions;
  report.factorisations += work.factorisations + pushes.counts.factorisations;
  report.sweeps += work.sweeps + pushes.counts.sweeps;
  report.patches += work.patches + pushes.counts.patches;
  report.obsoleteConstraints += answer.obsoleteConstraints;
  report.pushIslands += pushes.islands;
  report.pushUnsolved += pushes.counts.unsolved;
  report.workspaceBytes = std::max(
      report.workspaceBytes, group.bytes() + memory.bytes() + stiffness.bytes() + answer.bytes() +
                                 pushes.bytes() + workshop.bytes() + bytesOf(events));
}

btDelassusConstraintSolver::btDelassusConstraintSolver(const Options& options, btDelassusPrecision)
    : workspace_(std::make_unique<Workspace>(options)) {}

btDelassusConstraintSolver::~btDelassusConstraintSolver() = default;

void btDelassusConstraintSolver::prepareSolve(int, int) {
  workspace_->clearReport();
  workspace_->memory.nextStep();
}

btScalar btDelassusConstraintSolver::solveGroup(btCollisionObject** bodies, int bodyCount,
                                                btPersistentManifold** manifolds, int manifoldCount,
                                                btTypedConstraint** constraints,
                                                int constraintCount,
                                                const btContactSolverInfo& info, btIDebugDraw*,
                                                btDispatcher* dispatcher) {
  solve(bodies, bodyCount, manifolds, manifoldCount, constraints, constraintCount, info, dispatcher,
        nullptr);
  return 0;
}

void btDelassusConstraintSolver::solve(btCollisionObject** bodies, int bodyCount,
                                       btPersistentManifold** manifolds, int manifoldCount,
                                       btTypedConstraint** constraints, int constraintCount,
                                       const btContactSolverInfo& info, btDispatcher* dispatcher,
                                       Extension* extension) {
  Workspace& w = *workspace_;
  if (!(info.m_timeStep > 0) || !std::isfinite(info.m_timeStep)) {
    w.report.leaveOut("step", "its time step is not a positive number");
    return;
  }

  const Economies& economies = w.options.economies;
  Laps laps;
  if (!economies.storage) w.release();
  w.group.clear();
  gatherBodies(w.group, bodies, bodyCount, info, w.report);
  if (extension) extension->gatherBodies(w.group, w.report);
  gatherContacts(w.group, manifolds, manifoldCount, info, dispatcher, w.report);
  gatherJoints(w.group, constraints, constraintCount, info, w.report);
  if (extension) extension->gatherRows(w.group, w.report);
  gatherTurningFriction(w.group, stockRollingFriction_);
  if (warmStarts(info)) {
    w.memory.recall(w.group);
    if (extension) extension->recall(w.group);
    if (geometricStiffness_) w.report.stiffened += w.stiffness.stiffen(w.group, info);
  }
  laps.end(w.report.secondsGather);

  const bool heard = listener_ || troubleListener_ || turningListener_;
  findIslands(w.group, economies, w.answer);
  const Plan plan = makePlan(w.group, heard, economies, w.answer);
  startFromGuess(w.group, w.answer);
  w.workshop.clearCounts();
  checkIslands(w.group, w.workshop, w.answer);
  laps.end(w.report.secondsPlan);

  if (!w.answer.open.empty() || plan.obsolete > 0) {
    solveIslands(w.group, info, w.workshop, w.answer, w.report);
    laps.end(w.report.secondsSolve);
  }
  const Bench::Counts work = w.workshop.counts();
  w.pushes.clear();
  if (plan.pushContacts > 0) {
    solvePushes(w.group, plan.pushContacts > plan.deep, w.workshop, w.pushes);
    laps.end(w.report.secondsPush);
  }
  w.report.plan.add(plan);
  w.countSolve(work);
  w.memory.keep(w.group, w.answer);

  w.events.clear();
  writeVelocities(w.group, w.answer);
  writePushes(w.group, w.pushes, info);
  writeContacts(w.group, w.answer, w.report, plan.events ? &w.events : nullptr,
                turningListener_ != nullptr);
  writeJoints(w.group, w.answer, info);
  if (extension) extension->writeBack(w.group, w.answer);
  w.report.events += static_cast<int>(w.events.size());
  laps.end(w.report.secondsWriteBack);

  if (plan.heard && !w.events.empty()) {
    // Who listens may end that while it is called.
    const auto listener = listener_, troubleListener = troubleListener_,
               turningListener = turningListener_;
    for (const ContactEvent& event : w.events) {
      if (listener && event.from != event.to) listener(event);
      if (troubleListener && event.trouble != Trouble::None) troubleListener(event);
      if (turningListener && !event.moment.isZero()) turningListener(event);
    }
    laps.end(w.report.secondsListener);
  }
}

void btDelassusConstraintSolver::setThreads(int threads) {
  workspace_->workshop.setThreads(threads);
}

void btDelassusConstraintSolver::setStockRollingFriction(bool on) { stockRollingFriction_ = on; }

void btDelassusConstraintSolver::setGeometricStiffness(bool on) { geometricStiffness_ = on; }

void btDelassusConstraintSolver::reset() {
  const int threads = workspace_->workshop.threads();
  workspace_ = std::make_unique<Workspace>(workspace_->options);
  setThreads(threads);
}

const StepReport& btDelassusConstraintSolver::report() const { return workspace_->report; }

void btDelassusConstraintSolver::setContactListener(
    std::function<void(const ContactEvent&)> listener) {
  listener_ = std::move(listener);
}

void btDelassusConstraintSolver::setTroubleListener(
    std::function<void(const ContactEvent&)> listener) {
  troubleListener_ = std::move(listener);
}

void btDelassusConstraintSolver::setTurningListener(
    std::function<void(const ContactEvent&)> listener) {
  turningListener_ = std::move(listener);
}
