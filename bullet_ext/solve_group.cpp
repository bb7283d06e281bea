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

/// Collects in `answer.guess` the reactions of the island, in the order of its unknowns.
void collectGuess(const Island& island, Answer& answer) {
  const auto contacts = static_cast<int>(island.frictional.size());
  const auto scalars = static_cast<int>(island.frictionless.size() + island.rows.size());
  VectorXd& r = answer.guess;
  r.resize(3 * contacts + scalars);
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
  const auto joint =
      std::find_if(group.joints.begin(), group.joints.end(),
                   [&](const JointSource& j) { return row < j.firstRow + j.rowCount; });
  if (joint == group.joints.end()) return "a constraint of an articulated body";
  return nameOf(*joint->constraint);
}

/// Finite in Bullet's precision.
bool fitsBullet(const VectorXd& r) { return r.size() == 0 || r.cwiseAbs().sum() < SIMD_INFINITY; }

void solveIsland(const Group& group, const Island& island, Solver& solver, Answer& answer) {
  const Problem& apart =
      answer.assembler.assemble(group.bodies, group.contacts, group.rows, island);
  const bool articulated = group.articulation.moves(island);
  const Problem& problem =
      articulated ? answer.coupling.couple(group.articulation, apart, island) : apart;
  collectGuess(island, answer);
  Solution& solution = answer.solution;
  solver.solve(problem, answer.guess, solution);
  answer.regions += solution.regions;
  answer.factorisations += solution.factorisations;

  IslandResult result{solution.status,
                      solution.residual,
                      solution.residualRms,
                      problem.contacts() + problem.rows(),
                      {}};
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
    result = {Status::NonFinite, atRest.max, atRest.rms, result.parts, {}};
    solution.blamed = {atRest.worst};
  }
  for (int unknown : solution.blamed)
    result.blamed.push_back(blame(group, island, unknown, troubleOf(result.status), answer));
  answer.islands.push_back(std::move(result));
}

/// Solves every island, starting from the reactions in `answer`, which it replaces.
void solveIslands(const Group& group, Solver& solver, Answer& answer) {
  answer.islands.clear();
  answer.bodies = group.bodies;
  answer.modes.assign(group.contacts.size(), Mode::Open);
  answer.troubles.assign(group.contacts.size(), Trouble::None);
  answer.assembler.split(group.bodies, group.contacts, group.rows);
  if (group.articulation.trees.empty()) {
    for (int i = 0; i < answer.assembler.islands(); ++i)
      solveIsland(group, answer.assembler.island(i), solver, answer);
    return;
  }
  answer.coupling.reset(group.articulation);
  for (const Island& island : joinIslands(answer.assembler, group.articulation))
    solveIsland(group, island, solver, answer);
}

}  // namespace

std::size_t Answer::bytes() const {
  const auto of = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
  return of(bodies) + of(contacts) + of(modes) + of(troubles) + of(rows) + of(islands) +
         static_cast<std::size_t>(guess.size()) * sizeof(double);
}

void solveGroup(Group& group, const btContactSolverInfo& info, Solver& solver, Answer& answer,
                StepReport& report) {
  answer.regions = answer.factorisations = answer.obsoleteConstraints = 0;
  answer.contacts = group.guess;
  answer.rows = group.rowGuess;
  answer.rows.resize(group.rows.size(), 0);
  solveIslands(group, solver, answer);
  if (group.obsolete.empty()) return;

  ObsoleteConstraints obsolete(group, info);
  for (int sweep = 0; sweep < info.m_numIterations && obsolete.sweep(group, answer.bodies, report);
       ++sweep)
    solveIslands(group, solver, answer);
  answer.obsoleteConstraints = obsolete.acted();
}

}  // namespace delassus::bullet
