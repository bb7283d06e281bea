#include "bullet_ext/solve_group.h"

#include <algorithm>

#include "BulletCollision/NarrowPhaseCollision/btPersistentManifold.h"
#include "BulletDynamics/ConstraintSolver/btContactSolverInfo.h"
#include "BulletDynamics/ConstraintSolver/btTypedConstraint.h"
#include "bullet_ext/obsolete.h"
#include "delassus/island.h"
#include "delassus/residual.h"

namespace delassus::bullet {
namespace {

/// Collects the reactions of the island, in the order of its unknowns.
void collectGuess(const Island& island, const Answer& answer, VectorXd& r) {
  r.resize(island.unknowns());
  int at = 0;
  for (int i : island.frictional) {
    r.segment<3>(at) = answer.contacts[i];
    at += 3;
  }
  for (int i : island.frictionless) r[at++] = answer.contacts[i][0];
  for (int i : island.rows) r[at++] = answer.rows[i];
}

void keepReactions(const Island& island, const Solution& solution, Answer& answer) {
  int at = 0, state = 0;
  for (int i : island.frictional) {
    answer.contacts[i] = solution.r.segment<3>(at);
    answer.modes[i] = solution.activeSet.contacts[at / 3];
    at += 3;
  }
  for (int i : island.frictionless) {
    answer.contacts[i] = {solution.r[at++], 0, 0};
    // Nothing holds a contact without friction in place: as long as it persists it slides.
    const bool open = solution.activeSet.rows[state++] == RowState::AtLower;
    answer.modes[i] = open ? Mode::Open : Mode::Slide;
  }
  for (int i : island.rows) answer.rows[i] = solution.r[at++];
}

Trouble troubleOf(Status status) {
  switch (status) {
    case Status::OutOfBudget:
      return Trouble::OutOfBudget;
    case Status::Incompatible:
      return Trouble::Incompatible;
    case Status::NonFinite:
      return Trouble::LeftOut;
    case Status::Solved:
      break;
  }
  return Trouble::None;
}

/// Notes that the contact or joint whose first unknown is `unknown` is in trouble; returns its name.
std::string blame(const Group& group, const Island& island, int unknown, Trouble trouble,
                  Answer& answer) {
  const auto contacts = static_cast<int>(island.frictional.size());
  const auto frictionless = static_cast<int>(island.frictionless.size());
  const int scalar = unknown - 3 * contacts;
  if (scalar < frictionless) {
    const int i = scalar < 0 ? island.frictional[unknown / 3] : island.frictionless[scalar];
    answer.troubles[i] = trouble;
    return nameOf(group.contactSources[i]);
  }
  const int row = island.rows[scalar - frictionless];
  if (const int governor = group.rows[row].governor; governor >= 0) {
    answer.troubles[governor] = trouble;
    return nameOf(group.contactSources[governor]);
  }
  const auto joint =
      std::find_if(group.joints.begin(), group.joints.end(),
                   [&](const JointSource& j) { return row < j.firstRow + j.rowCount; });
  if (joint != group.joints.end()) return nameOf(*joint->constraint);
  const auto source =
      std::find_if(group.multiBodyRows.begin(), group.multiBodyRows.end(),
                   [&](const MultiBodyRowSource& candidate) { return candidate.row == row; });
  return nameOf(*source->constraint);
}

/// Finite in Bullet's precision.
bool fitsBullet(const VectorXd& r) { return r.size() == 0 || r.cwiseAbs().sum() < SIMD_INFINITY; }

void note(const Solution& solution, int parts, IslandResult& result) {
  result.status = solution.status;
  result.tier = solution.tier;
  result.residualMax = solution.residual;
  result.residualRms = solution.residualRms;
  result.parts = parts;
  result.restless = -1;
  result.blamed.clear();
}

int partsOf(const Island& island) {
  return static_cast<int>(island.frictional.size() + island.frictionless.size() +
                          island.rows.size());
}

/// Reactions that have just been found also stopped what moved, and would set it in motion the other way if they came
/// again: before they are kept they must be those of the rest.
double shareToKeep(const Group& group, const Island& island) {
  const auto restless = [&](int i) { return group.restless[i] != 0; };
  const bool settled =
      group.restless.empty() ||
      (std::none_of(island.frictional.begin(), island.frictional.end(), restless) &&
       std::none_of(island.frictionless.begin(), island.frictionless.end(), restless));
  return settled ? worldKeptShare : worldPolishedShare;
}

/// Whether the island needs no W: then `solution` answers it, and its bodies move in `answer`.
bool needsNoSolving(const Group& group, const Island& island, const Economies& economies,
                    Answer& answer, Solution& solution) {
  if (economies.keptIslands) {
    collectGuess(island, answer, solution.r);
    if (solution.r.any() &&
        answer.check.isKept(group.bodies, group.contacts, group.rows, island,
                            shareToKeep(group, island), answer.bodies, solution))
      return true;
  }
  return economies.freeIslands &&
         answer.check.isFree(group.bodies, group.contacts, group.rows, island, solution);
}

/// Island `i` of the step; trees join what the assembler has split.
const Island& islandOf(const Group& group, const Answer& answer, int i) {
  return group.articulation.trees.empty() ? answer.assembler.island(i) : answer.joiner.islands()[i];
}

void solveIsland(const Group& group, const Island& island, Solver& solver, Answer& answer,
                 IslandResult& result) {
  const Problem& apart =
      answer.assembler.assemble(group.bodies, group.contacts, group.rows, island);
  const bool articulated = group.articulation.moves(island);
  const Problem& problem =
      articulated ? answer.coupling.couple(group.articulation, apart, island) : apart;
  collectGuess(island, answer, answer.guess);
  Solution& solution = answer.solution;
  solver.solve(problem, answer.guess, solution);
  ++answer.matrices;
  answer.regions += solution.regions;
  answer.factorisations += solution.factorisations;
  answer.sweeps += solution.sweeps;

  note(solution, partsOf(island), result);
  constexpr double gain = 10;
  const double tolerance = solver.options().tolerance * problem.q.cwiseAbs().maxCoeff();
  if (solution.tier == Tier::Walk && solution.startResidual > worldKeptShare * tolerance &&
      solution.startResidual > gain * solution.residual)
    result.restless = island.bodies.front();
  if (fitsBullet(solution.r)) {
    keepReactions(island, solution, answer);
    applyReaction(answer.bodies, group.contacts, group.rows, island, solution.r);
    if (articulated) answer.coupling.addGain(group.articulation, solution.r);
  } else {
    // Better no reaction than one that spoils the world; the residual says how good that is.
    for (int i : island.frictional) answer.contacts[i].setZero();
    for (int i : island.frictionless) answer.contacts[i].setZero();
    for (int i : island.rows) answer.rows[i] = 0;
    const NaturalResidual atRest = naturalResidual(problem, VectorXd::Zero(problem.size()));
    result.status = Status::NonFinite;
    result.residualMax = atRest.max;
    result.residualRms = atRest.rms;
    solution.blamed = {atRest.worst};
  }
  for (int unknown : solution.blamed)
    result.blamed.push_back(blame(group, island, unknown, troubleOf(result.status), answer));
}

/// Solves the islands that the check has left.
void solveOpenIslands(const Group& group, Solver& solver, Answer& answer) {
  for (int i : answer.open)
    solveIsland(group, islandOf(group, answer, i), solver, answer, answer.islands[i]);
}

}  // namespace

std::size_t Answer::bytes() const {
  const auto of = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
  std::size_t numbers = guess.size();
  for (const Solution& solution : seen) numbers += solution.r.size() + solution.u.size();
  return of(bodies) + of(contacts) + of(modes) + of(troubles) + of(rows) + of(islands) + of(seen) +
         of(open) + numbers * sizeof(double);
}

void checkIslands(const Group& group, const Economies& economies, Answer& answer) {
  const Articulation& articulation = group.articulation;
  int count = answer.assembler.islands();
  if (!articulation.trees.empty()) {
    answer.coupling.reset(articulation);
    count = static_cast<int>(answer.joiner.join(answer.assembler, articulation).size());
  }
  answer.islands.resize(count);
  if (static_cast<int>(answer.seen.size()) < count) answer.seen.resize(count);
  answer.open.clear();
  answer.bodies = group.bodies;
  answer.modes.assign(group.contacts.size(), Mode::Open);
  answer.troubles.assign(group.contacts.size(), Trouble::None);
  for (int i = 0; i < count; ++i) {
    const Island& island = islandOf(group, answer, i);
    Solution& solution = answer.seen[i];
    // The check knows of bodies, not of trees.
    if (!articulation.moves(island) && needsNoSolving(group, island, economies, answer, solution)) {
      note(solution, partsOf(island), answer.islands[i]);
      keepReactions(island, solution, answer);
    } else {
      answer.open.push_back(i);
    }
  }
}

void startFromGuess(const Group& group, Answer& answer) {
  answer.regions = answer.factorisations = answer.sweeps = 0;
  answer.matrices = answer.obsoleteConstraints = 0;
  answer.contacts = group.guess;
  answer.rows = group.rowGuess;
  answer.rows.resize(group.rows.size(), 0);
}

void solveIslands(Group& group, const btContactSolverInfo& info, Solver& solver, Answer& answer,
                  StepReport& report) {
  solveOpenIslands(group, solver, answer);
  if (group.obsolete.empty()) return;

  ObsoleteConstraints obsolete(group, info);
  for (int sweep = 0; sweep < info.m_numIterations && obsolete.sweep(group, answer.bodies, report);
       ++sweep) {
    checkIslands(group, solver.options().economies, answer);
    solveOpenIslands(group, solver, answer);
  }
  answer.obsoleteConstraints = obsolete.acted();
}

}  // namespace delassus::bullet
