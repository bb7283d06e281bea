#include "bullet_ext/solve_island.h"

#include <algorithm>

#include "BulletCollision/NarrowPhaseCollision/btPersistentManifold.h"
#include "BulletDynamics/ConstraintSolver/btTypedConstraint.h"
#include "bullet_ext/group.h"
#include "bullet_ext/names.h"
#include "bullet_ext/quarrels.h"
#include "bullet_ext/soft_answer.h"
#include "bullet_ext/solve_group.h"
#include "bullet_ext/thrown_bodies.h"
#include "bullet_ext/workshop.h"
#include "delassus/residual.h"

namespace delassus::bullet {
namespace {

/// The contact or the row whose first unknown is `unknown`; the other is −1. Turning friction
/// counts as its contact.
struct Part {
  int contact = -1, row = -1;
};
Part partAt(const Group& group, const Island& island, int unknown) {
  const auto contacts = static_cast<int>(island.frictional.size());
  const auto frictionless = static_cast<int>(island.frictionless.size());
  const int scalar = unknown - 3 * contacts;
  if (scalar < 0) return {island.frictional[unknown / 3], -1};
  if (scalar < frictionless) return {island.frictionless[scalar], -1};
  const int row = island.rows[scalar - frictionless];
  const int governor = group.rows[row].governor;
  return governor >= 0 ? Part{governor, -1} : Part{-1, row};
}

/// Collects the reactions of the island, in the order of its unknowns.
void collectGuess(const Island& island, const Answer& answer, VectorXd& r) {
  r.resize(island.unknowns());
  island.eachContactAt([&](int i, int at, int unknowns) {
    r.segment(at, unknowns) = answer.contacts[i].head(unknowns);
  });
  island.eachRowAt([&](int i, int at) { r[at] = answer.rows[i]; });
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

/// The marks of the island's contacts.
IslandMarks marksOf(const Group& group, const Island& island) {
  IslandMarks marks;
  if (!group.marks.empty()) island.eachContact([&](int i) { marks.add(group.marks[i]); });
  return marks;
}

/// The share of the tolerance within which reactions are kept. Reactions that have just been found
/// also stopped what moved, and would set it in motion the other way if they came again. So they
/// are kept only once they are the reactions of rest.
double shareToKeep(const Group& group, const Island& island) {
  return marksOf(group, island).isRestless ? polishedShare : keptShare;
}

/// Whether the island needs no W: then `solution` answers it, and its bodies move in `answer`.
bool needsNoSolving(const Group& group, const Island& island, const Economies& economies,
                    Bench& bench, Answer& answer) {
  Solution& solution = bench.solution;
  if (economies.keptIslands) {
    collectGuess(island, answer, solution.r);
    if (solution.r.any() && bench.check.isKept(group.bodies, group.contacts, group.rows, island,
                                               shareToKeep(group, island), answer.bodies, solution))
      return true;
  }
  return economies.freeIslands &&
         bench.check.isFree(group.bodies, group.contacts, group.rows, island, solution);
}

/// Takes no reactions instead of some that spoil the world; the residual says how good that is.
void takeNoReactions(const Problem& problem, const Island& island, Answer& answer,
                     IslandResult& result) {
  island.eachContact([&](int i) { answer.contacts[i].setZero(); });
  for (int i : island.rows) answer.rows[i] = 0;
  const VelocityResidual atRest = naturalResidual(problem, VectorXd::Zero(problem.size()));
  result.status = Status::NonFinite;
  result.residualMax = atRest.max;
  result.residualRms = atRest.rms;
  result.blamed = {atRest.worst};
}

/// Whether the answer left the guess and is far nearer to the law than the guess; tolerance: m/s.
bool leavesGuess(const Solution& solution, double tolerance) {
  constexpr double gain = 10;
  return solution.tier == Tier::Walk && solution.startResidual > keptShare * tolerance &&
         solution.startResidual > gain * solution.residual;
}

/// Whether the search came nowhere near an answer, though it had time enough.
bool isFarOff(const Solution& solution, double demand) {
  constexpr double share = 1e-5;
  return solution.status == Status::OutOfBudget && solution.residual > share * demand;
}

/// Of steps in a row, those in which a whole search is due: each comes after twice as many.
bool isTurnOfWhole(int steps) { return (steps & (steps - 1)) == 0; }

/// Whether the answer of a short search will do. If whole searches have been in vain step after
/// step, the next whole one comes after twice as many steps each time. In between, a short search
/// will do if it leaves not much more.
bool willDo(const Solution& solution, const IslandMarks& last) {
  constexpr double times = 4;
  return last.lostSteps > 0 && !isTurnOfWhole(last.lostSteps + 1) &&
         solution.residual <= times * last.lostResidual;
}

/// Puts on the bench the island's problem as it stands, and the guess from which its search begins.
const Problem& putOnBench(const Group& group, const Island& island, const Answer& answer,
                          Bench& bench) {
  collectGuess(island, answer, bench.guess);
  const Problem& apart = bench.assembler.assemble(group.bodies, group.contacts, group.rows, island);
  return group.articulation.moves(island) ? bench.coupling.couple(group.articulation, apart, island)
                                          : apart;
}

/// An island that jams may be answered this many times as far from the law as what was found.
constexpr double nearly = 2;

constexpr double muchCut = 0.1;  ///< of recovery, that tells of a quarrel

void markLost(const Group& group, const Island& island, bool afterWhole, double residual,
              IslandResult& result) {
  const IslandMarks last = marksOf(group, island);
  IslandMarks& marks = mark(group, island, result);
  marks.lostSteps = last.lostSteps + 1;
  marks.lostResidual = afterWhole ? residual : last.lostResidual;
}

void markQuarrel(const Group& group, const Island& island, IslandResult& result) {
  mark(group, island, result).quarrelSteps = marksOf(group, island).quarrelSteps + 1;
}

/// Answers an island whose exact answer, on the bench, tells of a quarrel. If less recovery does
/// not relieve it, loads strain it, and are likely to do so in the next steps: then it is looked at
/// only now and then. What is wedged is looked at in every step, and if all else fails answered as
/// if contacts gave a little.
bool answerQuarrel(const Group& group, const Island& island, double demand, Bench& bench,
                   Answer& answer, IslandResult& result) {
  constexpr double relieved = 0.1;
  const Quarrel quarrel = quarrelOf(group, island, demand, bench.solution);
  if (quarrel == Quarrel::None) return false;
  const int steps = marksOf(group, island).loadedSteps + 1;
  const bool wedged =
      quarrel == Quarrel::Strained && isWedged(group, island, demand, bench.solution);
  if (isTurnOfWhole(steps) || wedged) {
    const Relief relief{relieved * strainOf(group, island, bench.solution),
                        bench.solution.residual};
    // Friction may strain what can recover.
    const double leastCut = quarrel == Quarrel::Strained ? 0 : muchCut;
    if (answerRecovering(group, island, relief, leastCut, bench, answer, result)) {
      result.marks = {};
      if (bench.solution.status == Status::OutOfBudget) markQuarrel(group, island, result);
      return true;
    }
    if (quarrel == Quarrel::Strained && !island.rows.empty() &&
        answerUnwedged(group, island, relief, bench, answer, result))
      return true;
  }
  if (wedged) {
    answerSoftened(group, island, bench, answer, result);
    return true;
  }
  mark(group, island, result).loadedSteps = steps;
  return false;
}

/// Whether joints hold bodies of the island that contacts ask to recover.
bool mayQuarrel(const Group& group, const Island& island) {
  bool recovers = false;
  island.eachContact([&](int i) { recovers = recovers || group.contacts[i].target[0] > 0; });
  return recovers && std::any_of(island.rows.begin(), island.rows.end(),
                                 [&](int k) { return group.rows[k].governor < 0; });
}

/// Whether a whole search is due where joints and contacts may quarrel: they bear a load, for which
/// there is no other answer; or they have quarrelled for so long that it is looked at anew.
bool isTurnOfSearch(const IslandMarks& last) {
  constexpr int many = 128;
  const bool isLoaded = last.loadedSteps > 0 && !isTurnOfWhole(last.loadedSteps + 1);
  return isLoaded || last.quarrelSteps + 1 >= many;
}

/// How a search ended; answered: otherwise than exactly.
enum class SearchEnd { Whole, Short, Answered };

/// Solves the problem on the bench. A short search comes first
///
///   - where something may squeeze the island, to tell whether it jams, and where whole searches
///     have been in vain. An island that comes near an answer does not jam: the whole search goes
///     on from there;
///   - where joints and contacts may quarrel: if they do, a whole search is in vain.
SearchEnd searchFor(const Group& group, const Island& island, bool mayJam, const Problem& problem,
                    Bench& bench, Answer& answer, IslandResult& result) {
  constexpr double near = 1e-4;  // share of the demands that is left
  Solution& solution = bench.solution;
  const auto solve = [&] {
    bench.solver.solve(problem, bench.guess, solution);
    bench.counts.add(solution);
  };
  const IslandMarks last = marksOf(group, island);
  const bool wasLost = last.lostSteps > 0;
  const auto startAnew = [&] { putOnBench(group, island, answer, bench); };
  const bool isSqueezed = mayJam && (wasLost || mayBeSqueezed(group, island));
  if (mayJam && !isSqueezed && mayQuarrel(group, island) && !isTurnOfSearch(last)) {
    {
      ShortSearch meanwhile(bench.solver);
      meanwhile.sweepLess();
      solve();
    }
    if (solution.status != Status::OutOfBudget) return SearchEnd::Whole;
    if (answerQuarrel(group, island, problem.demand(), bench, answer, result))
      return SearchEnd::Answered;
    result.marks = {};
    startAnew();
  }
  if (isSqueezed) {
    {
      ShortSearch meanwhile(bench.solver);
      if (!wasLost) meanwhile.loosen(near);
      solve();
    }
    const double enough = polishedShare * bench.solver.options().tolerance * problem.demand();
    if (!wasLost && solution.status == Status::Solved && solution.residual > enough) {
      const double startResidual = solution.startResidual;
      bench.guess = solution.r;
      solve();
      solution.startResidual = startResidual;
      return SearchEnd::Whole;
    }
    if (solution.status != Status::OutOfBudget || willDo(solution, last)) return SearchEnd::Short;
    bench.guess.resize(0);
    if (isFarOff(solution, problem.demand()) &&
        answerJam(group, island, nearly * solution.residual, bench, answer, result))
      return SearchEnd::Answered;
    startAnew();
  }
  solve();
  return SearchEnd::Whole;
}

void solveExactly(const Group& group, const Island& island, bool mayJam, Bench& bench,
                  Answer& answer, IslandResult& result) {
  const Problem& problem = putOnBench(group, island, answer, bench);
  const double demand = problem.demand();
  const SearchEnd end = searchFor(group, island, mayJam, problem, bench, answer, result);
  if (end == SearchEnd::Answered) return;
  const Solution& solution = bench.solution;
  note(solution, island, result);
  if (solution.status == Status::OutOfBudget)
    markLost(group, island, end == SearchEnd::Whole, solution.residual, result);
  if (leavesGuess(solution, bench.solver.options().tolerance * demand))
    mark(group, island, result).isRestless = true;
  if (!fitsBullet(solution.r)) {
    takeNoReactions(problem, island, answer, result);
    return;
  }
  keepReactions(island, solution, answer);
  applyReaction(answer.bodies, group.contacts, group.rows, island, solution.r);
  if (group.articulation.moves(island)) {
    bench.coupling.addGain(group.articulation, solution.r, answer.gains);
    return;
  }
  const bool contactsHurry = contactsThrowOne(group, island, demand, answer, suspectReach);
  const bool contactsThrow = contactsHurry && contactsThrowOne(group, island, demand, answer);
  const TargetWork work =
      workOfTargets(group, group.contacts, group.rows, island, problem, solution);
  const bool jointsThrow = work.done > work.allowed;
  const bool isLost = end == SearchEnd::Whole && isFarOff(solution, demand);
  if (answerQuarrel(group, island, demand, bench, answer, result)) return;
  bench.guess.resize(0);
  // Bodies may be pinched between others that overlap them and do not give way. They press, as in
  // stock, or friction would not hold them.
  const bool isPinched =
      solution.status == Status::Incompatible && island.rows.empty() && !isLost && !contactsHurry;
  // Few sweeps prove nothing. But where they end no nearer to the law than they would without
  // reactions, bodies that squeeze each other may be left without a grip.
  constexpr double stuck = 0.9;  // of the demand
  const bool isStuck = bench.solver.options().isHurried() && island.rows.empty() &&
                       solution.status == Status::OutOfBudget && solution.residual > stuck * demand;
  if (isStuck && answerJam(group, island, solution.residual, bench, answer, result)) return;
  const std::vector<int> blamed = isPinched ? solution.blamed : std::vector<int>();
  if (mayJam && !jointsThrow && (isLost || contactsHurry || isPinched) &&
      answerJam(group, island, isLost ? nearly * solution.residual : infinity, bench, answer,
                result)) {
    if (isPinched) {  // the exact search was short, and tells more
      result.blamed = blamed;
      result.marks.isJammed = false;
    }
    return;
  }
  if (jointsThrow)
    answerHeldBack(group, island, work, contactsThrow, bench, answer, result);
  else if (contactsThrow)
    answerSoftened(group, island, bench, answer, result);
}

}  // namespace

void checkIsland(const Group& group, const Island& island, const Economies& economies, Bench& bench,
                 Answer& answer, IslandResult& result) {
  // The check knows single bodies, not articulated trees.
  if (group.articulation.moves(island) || !needsNoSolving(group, island, economies, bench, answer))
    return;
  note(bench.solution, island, result);
  keepReactions(island, bench.solution, answer);
}

void solveIsland(const Group& group, const Island& island, Bench& bench, Answer& answer,
                 IslandResult& result) {
  const bool mayJam = !group.articulation.moves(island) && island.hasContacts() &&
                      bench.solver.options().pathBudget > 0;
  const auto stillJams = [&] {
    collectGuess(island, answer, bench.guess);
    return answerJam(group, island, infinity, bench, answer, result);
  };
  const IslandMarks last = marksOf(group, island);
  const auto stillQuarrels = [&] {
    if (last.quarrelSteps == 0 || isTurnOfWhole(last.quarrelSteps + 1) ||
        group.articulation.moves(island) ||
        !answerRecovering(group, island, {infinity, 0}, muchCut, bench, answer, result))
      return false;
    markQuarrel(group, island, result);
    return true;
  };
  if (!stillQuarrels() && !(mayJam && last.isJammed && stillJams()))
    solveExactly(group, island, mayJam, bench, answer, result);
  for (int unknown : result.blamed)
    if (const int contact = partAt(group, island, unknown).contact; contact >= 0)
      answer.troubles[contact] = troubleOf(result.status);
}

void keepReactions(const Island& island, const Solution& solution, Answer& answer) {
  auto state = solution.activeSet.rows.begin();
  island.eachContactAt([&](int i, int at, int unknowns) {
    if (unknowns == 3) {
      answer.contacts[i] = solution.r.segment<3>(at);
      answer.modes[i] = solution.activeSet.contacts[at / 3];
      return;
    }
    answer.contacts[i] = {solution.r[at], 0, 0};
    // Nothing holds a contact without friction in place: as long as it persists it slides.
    answer.modes[i] = *state++ == RowState::AtLower ? Mode::Open : Mode::Slide;
  });
  island.eachRowAt([&](int i, int at) { answer.rows[i] = solution.r[at]; });
}

void note(const Solution& solution, const Island& island, IslandResult& result) {
  result.status = solution.status;
  result.tier = solution.tier;
  result.residualMax = solution.residual;
  result.residualRms = solution.residualRms;
  result.parts =
      static_cast<int>(island.frictional.size() + island.frictionless.size() + island.rows.size());
  result.isAnswered = true;
  result.isSoftened = false;
  result.blamed = solution.blamed;
}

IslandMarks& mark(const Group& group, const Island& island, IslandResult& result) {
  const std::vector<int>& contacts =
      island.frictional.empty() ? island.frictionless : island.frictional;
  result.markedBody = island.bodies.front();
  if (!contacts.empty()) {
    const Contact& contact = group.contacts[contacts.front()];
    result.markedBody = group.movable(contact.a) ? contact.a : contact.b;
  }
  return result.marks;
}

bool fitsBullet(const VectorXd& r) { return r.size() == 0 || r.cwiseAbs().sum() < SIMD_INFINITY; }

std::string nameOf(const Group& group, const Island& island, int unknown) {
  const Part part = partAt(group, island, unknown);
  if (part.contact >= 0) return nameOf(group.contactSources[part.contact]);
  if (const JointSource* joint = jointOf(group, part.row)) return nameOf(*joint->constraint);
  const auto source =
      std::find_if(group.multiBodyRows.begin(), group.multiBodyRows.end(),
                   [&](const MultiBodyRowSource& candidate) { return candidate.row == part.row; });
  return nameOf(*source->constraint);
}

}  // namespace delassus::bullet
