#include "bullet_ext/btDelassusConstraintSolver.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "BulletDynamics/ConstraintSolver/btContactSolverInfo.h"
#include "bullet_ext/contradictions.h"
#include "bullet_ext/extension.h"
#include "bullet_ext/gather.h"
#include "bullet_ext/geometric_stiffness.h"
#include "bullet_ext/group.h"
#include "bullet_ext/memory.h"
#include "bullet_ext/plan.h"
#include "bullet_ext/push.h"
#include "bullet_ext/saturating_sum.h"
#include "bullet_ext/solve_group.h"
#include "bullet_ext/solve_island.h"
#include "bullet_ext/workshop.h"
#include "bullet_ext/write_back.h"
#include "delassus/bytes.h"
#include "delassus/quiet_arithmetic.h"

using namespace delassus;
using namespace delassus::bullet;

namespace {

using Listener = std::function<void(const ContactEvent&)>;

/// Null if the function is empty.
std::shared_ptr<const Listener> shared(Listener listener) {
  return listener ? std::make_shared<const Listener>(std::move(listener)) : nullptr;
}

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
      addTo(report.solved, 1);
      break;
    case Status::OutOfBudget:
      addTo(report.outOfBudget, 1);
      break;
    case Status::Incompatible:
      addTo(report.incompatible, 1);
      break;
    case Status::NonFinite:
      addTo(report.nonFinite, 1);
      break;
  }
}

void countTier(Tier tier, StepReport& report) {
  addTo(tier == Tier::Free         ? report.freeIslands
        : tier == Tier::Kept       ? report.keptIslands
        : tier == Tier::ClosedForm ? report.closedForms
                                   : report.walks,
        1);
}

/// The reason that messages give after the name of a blamed contact or joint.
const char* reasonOf(const IslandResult& result) {
  if (result.isSoftened)
    return ": no exact answer, or only one that throws or wedges a body; solved as if contacts "
           "gave a little, or joints asked for less";
  switch (result.status) {
    case Status::OutOfBudget:
      return ": the budget of its island ended above the tolerance; the error is largest here";
    case Status::Incompatible:
      return ": no motion meets its demand; a compromise is taken";
    case Status::NonFinite:
      return ": its island is left without reactions: the numbers do not stay finite";
    case Status::Solved:
      break;
  }
  return "";
}

/// In a world each step starts from the last reactions. The island check has already rejected these
/// as an answer when the solver gets them as a guess.
Options forWorlds(Options options) {
  options.guessShare = std::min(options.guessShare, polishedShare);
  return options;
}

}  // namespace

struct btDelassusConstraintSolver::Workspace {
  explicit Workspace(const Options& options) : workshop(forWorlds(options)) {}

  Workshop workshop;
  Group group;
  Memory memory;
  GeometricStiffness stiffness;
  Answer answer;
  Pushes pushes;
  std::vector<ContactEvent> events;
  double residualSquares = 0;  ///< of the whole step, (m/s)²
  long residualParts = 0;

  /// Frees all storage that no later step depends on.
  void release();
  std::size_t bytes() const {
    return group.bytes() + memory.bytes() + stiffness.bytes() + answer.bytes() + pushes.bytes() +
           workshop.bytes() + bytesOf(events);
  }
  Work countSolve(const Bench::Counts& counts, StepReport& report);
};

void btDelassusConstraintSolver::Workspace::release() {
  workshop.clear();
  group = Group();
  stiffness = GeometricStiffness();
  answer = Answer();
  pushes = Pushes();
  events = {};
}

btDelassusConstraintSolver::Work btDelassusConstraintSolver::Workspace::countSolve(
    const Bench::Counts& counts, StepReport& report) {
  Work work;
  work.iterations = counts.regions + counts.sweeps;
  work.residualMax = 0;
  addTo(report.contacts, static_cast<int>(group.contacts.size()));
  addTo(report.rows, static_cast<int>(group.rows.size()) - group.turningRows);
  addTo(report.islands, answer.islands.count());
  for (int i = 0; i < answer.islands.count(); ++i) {
    const IslandResult& result = answer.results[i];
    countStatus(result.status, report);
    countTier(result.tier, report);
    addTo(report.softened, result.isSoftened);
    work.residualMax = std::max(work.residualMax, result.residualMax);
    residualSquares += result.residualRms * result.residualRms * result.parts;
    residualParts += result.parts;
    for (int unknown : result.blamed)
      report.tell(nameOf(group, answer.islands[i], unknown) + reasonOf(result));
  }
  report.residualMax = std::max(report.residualMax, work.residualMax);
  if (residualParts > 0) report.residualRms = std::sqrt(residualSquares / residualParts);

  addTo(report.matrices, answer.matrices);
  addTo(report.regions, counts.regions + pushes.counts.regions);
  addTo(report.factorisations, counts.factorisations + pushes.counts.factorisations);
  addTo(report.sweeps, counts.sweeps + pushes.counts.sweeps);
  addTo(report.patches, counts.patches + pushes.counts.patches);
  addTo(report.obsoleteConstraints, answer.obsoleteConstraints);
  addTo(report.pushIslands, pushes.islands);
  addTo(report.pushUnsolved, pushes.counts.unsolved);
  addTo(report.pushSoftened, pushes.softened);
  return work;
}

btDelassusConstraintSolver::btDelassusConstraintSolver(const Options& options, btDelassusPrecision)
    : workspace_(std::make_unique<Workspace>(options)) {}

btDelassusConstraintSolver::~btDelassusConstraintSolver() = default;

void btDelassusConstraintSolver::prepareSolve(int, int) {
  report_ = {};
  workspace_->residualSquares = 0;
  workspace_->residualParts = 0;
  workspace_->memory.nextStep();
}

btScalar btDelassusConstraintSolver::solveGroup(btCollisionObject** bodies, int bodyCount,
                                                btPersistentManifold** manifolds, int manifoldCount,
                                                btTypedConstraint** constraints,
                                                int constraintCount,
                                                const btContactSolverInfo& info, btIDebugDraw*,
                                                btDispatcher* dispatcher) {
  solve({bodies, bodyCount, manifolds, manifoldCount, constraints, constraintCount, &info,
         dispatcher},
        nullptr);
  return 0;
}

btDelassusConstraintSolver::Work btDelassusConstraintSolver::solve(const GroupInput& input,
                                                                   Extension* extension) {
  std::optional<QuietArithmetic> quiet(std::in_place);
  const btContactSolverInfo& info = *input.info;
  Workspace& w = *workspace_;
  if (!(info.m_timeStep > 0) || !std::isfinite(info.m_timeStep)) {
    report_.leaveOut("step", "its time step is not a positive number");
    return {};
  }

  const Economies& economies = w.workshop.options().economies;
  Laps laps;
  if (!economies.storage) {
    w.release();
    if (extension) extension->release();
  }
  gather(input, extension);
  laps.end(report_.secondsGather);

  const bool heard = listener_ || troubleListener_ || turningListener_;
  w.answer.islands.find(w.group, economies);
  const Plan plan = makePlan(w.group, heard, economies, w.answer.islands);
  startAnswer(w.group, w.answer);
  checkIslands(w.group, w.workshop, w.answer);
  laps.end(report_.secondsPlan);

  if (!w.answer.unanswered.empty() || plan.obsolete > 0) {
    solveIslands(w.group, info, w.workshop, w.answer, report_);
    laps.end(report_.secondsSolve);
  }
  judgeContradictions(w.group, w.answer);
  const Bench::Counts counts = w.workshop.takeCounts();
  w.pushes.clear();
  if (plan.pushContacts > 0) {
    solvePushes(w.group, info.m_timeStep, w.workshop, w.pushes);
    laps.end(report_.secondsPush);
  }
  report_.plan.add(plan);
  const Work work = w.countSolve(counts, report_);
  report_.workspaceBytes =
      std::max(report_.workspaceBytes, w.bytes() + (extension ? extension->bytes() : 0));
  w.memory.keep(w.group, w.answer, info.m_timeStep);

  writeBack(plan, info, extension);
  laps.end(report_.secondsWriteBack);

  quiet.reset();
  if (plan.heard && !w.events.empty()) {
    tellListeners();
    laps.end(report_.secondsListener);
  }
  return work;
}

void btDelassusConstraintSolver::gather(const GroupInput& input, Extension* extension) {
  const btContactSolverInfo& info = *input.info;
  Workspace& w = *workspace_;
  const Options& options = w.workshop.options();
  // Few sweeps go further where loads have many ways.
  const Manner manner{stockRollingFriction_,
                      options.economies.weldedContacts && !options.isHurried()};
  gatherGroup(w.group, input, report_, extension, manner);
  if (!warmStarts(info)) return;
  w.memory.recall(w.group);
  // reset() forgets the impulses that constraints of articulated bodies keep, too.
  if (extension && w.memory.lastStep() > 0) extension->recall(w.group);
  w.memory.fitTimeStep(w.group, info.m_timeStep);
  if (geometricStiffness_)
    addTo(report_.stiffened, w.stiffness.stiffen(w.group, info, w.memory.lastStep()));
}

void btDelassusConstraintSolver::writeBack(const Plan& plan, const btContactSolverInfo& info,
                                           Extension* extension) {
  Workspace& w = *workspace_;
  w.events.clear();
  writeVelocities(w.group, w.answer);
  writePushes(w.group, w.pushes, info);
  writeContacts(w.group, w.answer, report_, plan.events ? &w.events : nullptr,
                turningListener_ != nullptr);
  writeJoints(w.group, w.answer, info);
  if (extension) extension->writeBack(w.group, w.answer, info);
  addTo(report_.events, static_cast<int>(w.events.size()));
}

void btDelassusConstraintSolver::tellListeners() const {
  const auto listener = listener_, troubleListener = troubleListener_,
             turningListener = turningListener_;
  for (const ContactEvent& event : workspace_->events) {
    if (listener && event.from != event.to) (*listener)(event);
    if (troubleListener && event.trouble != Trouble::None) (*troubleListener)(event);
    if (turningListener && !event.moment.isZero()) (*turningListener)(event);
  }
}

void btDelassusConstraintSolver::setThreads(int threads) {
  workspace_->workshop.setThreads(threads);
}

void btDelassusConstraintSolver::setStockRollingFriction(bool on) { stockRollingFriction_ = on; }

void btDelassusConstraintSolver::setGeometricStiffness(bool on) { geometricStiffness_ = on; }

void btDelassusConstraintSolver::reset() {
  const int threads = workspace_->workshop.threads();
  workspace_ = std::make_unique<Workspace>(workspace_->workshop.options());
  report_ = {};
  setThreads(threads);
}

void btDelassusConstraintSolver::setContactListener(
    std::function<void(const ContactEvent&)> listener) {
  listener_ = shared(std::move(listener));
}

void btDelassusConstraintSolver::setTroubleListener(
    std::function<void(const ContactEvent&)> listener) {
  troubleListener_ = shared(std::move(listener));
}

void btDelassusConstraintSolver::setTurningListener(
    std::function<void(const ContactEvent&)> listener) {
  turningListener_ = shared(std::move(listener));
}
