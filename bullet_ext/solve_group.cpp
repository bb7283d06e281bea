#include "bullet_ext/solve_group.h"

#include <algorithm>
#include <numeric>

#include "BulletDynamics/ConstraintSolver/btContactSolverInfo.h"
#include "bullet_ext/group.h"
#include "bullet_ext/solve_island.h"
#include "bullet_ext/workshop.h"
#include "delassus/bytes.h"
#include "delassus/island.h"

namespace delassus::bullet {
namespace {

/// Solves the islands that the check has left.
void solveUnanswered(const Group& group, Workshop& workshop, Answer& answer) {
  const auto count = static_cast<int>(answer.unanswered.size());
  const auto island = [&](int k) -> const Island& { return answer.islands[answer.unanswered[k]]; };
  answer.matrices += count;
  workshop.shareSolving(
      count, [&](int k) { return island(k).unknowns(); },
      [&](Bench& bench, int k) {
        solveIsland(group, island(k), bench, answer, answer.results[answer.unanswered[k]]);
      });
  answer.unanswered.clear();
}

/// Takes back the answers of islands with bodies whose free velocity a constraint has changed, as
/// if no reaction had moved them. The other islands keep their answers, bit for bit.
void takeBackChanged(const Group& group, Answer& answer) {
  const std::vector<char>& changed = answer.obsolete.changed();
  for (std::size_t body = 0; body < changed.size(); ++body)
    if (changed[body]) answer.bodies[body] = group.bodies[body];  // it may be in no island
  for (int i = 0; i < answer.islands.count(); ++i) {
    const Island& island = answer.islands[i];
    if (std::none_of(island.bodies.begin(), island.bodies.end(),
                     [&](int body) { return changed[body] != 0; }))
      continue;
    answer.unanswered.push_back(i);
    answer.results[i].isAnswered = false;
    answer.results[i].marks = {};
    for (int body : island.bodies) {
      answer.bodies[body] = group.bodies[body];
      if (const Articulation::Limb* limb = group.articulation.limbOf(body))
        answer.gains.of[limb->tree].setZero();
    }
    island.eachContact([&](int contact) {
      answer.modes[contact] = Mode::Open;
      answer.troubles[contact] = Trouble::None;
    });
  }
}

}  // namespace

std::size_t Answer::bytes() const {
  std::size_t sum = bytesOf(results, unanswered, bodies, contacts, modes, troubles, rows) +
                    islands.bytes() + gains.bytes() + obsolete.bytes();
  for (const IslandResult& result : results) sum += bytesOf(result.blamed);
  return sum;
}

void startAnswer(const Group& group, Answer& answer) {
  const int islands = answer.islands.count();
  answer.results.resize(islands);
  for (IslandResult& result : answer.results) {
    result.marks = {};
    result.isAnswered = false;
  }
  answer.unanswered.resize(islands);
  std::iota(answer.unanswered.begin(), answer.unanswered.end(), 0);

  answer.bodies = group.bodies;
  answer.contacts = group.guess;
  answer.modes.assign(group.contacts.size(), Mode::Open);
  answer.troubles.assign(group.contacts.size(), Trouble::None);
  answer.rows = group.rowGuess;
  answer.rows.resize(group.rows.size(), 0);
  answer.gains.reset(group.articulation);
  answer.matrices = answer.obsoleteConstraints = 0;
}

void checkIslands(const Group& group, Workshop& workshop, Answer& answer) {
  // With fewer unknowns the check is faster than a call to another thread.
  constexpr int worthwhile = 6000;
  std::vector<int>& unanswered = answer.unanswered;
  workshop.share(
      static_cast<int>(unanswered.size()), worthwhile,
      [&](int k) { return answer.islands[unanswered[k]].unknowns(); },
      [&](Bench& bench, int k) {
        const int i = unanswered[k];
        checkIsland(group, answer.islands[i], workshop.options().economies, bench, answer,
                    answer.results[i]);
      });
  const auto isAnswered = [&](int i) { return answer.results[i].isAnswered; };
  unanswered.erase(std::remove_if(unanswered.begin(), unanswered.end(), isAnswered),
                   unanswered.end());
}

void solveIslands(Group& group, const btContactSolverInfo& info, Workshop& workshop, Answer& answer,
                  StepReport& report) {
  solveUnanswered(group, workshop, answer);
  if (group.obsolete.empty()) return;

  ObsoleteConstraints& obsolete = answer.obsolete;
  obsolete.start(group);
  for (int sweep = 0; sweep < info.m_numIterations &&
                      obsolete.sweep(group, info.m_timeStep, answer.bodies, report);
       ++sweep) {
    takeBackChanged(group, answer);
    checkIslands(group, workshop, answer);
    solveUnanswered(group, workshop, answer);
  }
  answer.obsoleteConstraints = obsolete.acted();
}

}  // namespace delassus::bullet
