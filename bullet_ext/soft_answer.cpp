#include "bullet_ext/soft_answer.h"

#include <cmath>
#include <tuple>
#include <utility>

#include "bullet_ext/quarrels.h"
#include "bullet_ext/response.h"
#include "bullet_ext/softness.h"
#include "bullet_ext/solve_group.h"
#include "bullet_ext/solve_island.h"
#include "bullet_ext/thrown_bodies.h"
#include "bullet_ext/workshop.h"
#include "delassus/contact_motion.h"
#include "delassus/residual.h"

namespace delassus::bullet {
namespace {

constexpr double roughly = 1e-2;  ///< of the demands

/// Takes this solution, of an easier problem, as the answer.
void take(const Group& group, const Island& island, const Solution& solution,
          const VelocityResidual& residual, Answer& answer, IslandResult& result) {
  for (const int body : island.bodies) answer.bodies[body] = group.bodies[body];
  keepReactions(island, solution, answer);
  applyReaction(answer.bodies, group.contacts, group.rows, island, solution.r);
  note(solution, island, result);
  result.tier = Tier::Walk;
  result.isSoftened = true;
  result.status = Status::Incompatible;
  result.residualMax = residual.max;
  result.residualRms = residual.rms;
  result.blamed = {residual.worst};
}

/// How far the reactions miss the law without softness.
VelocityResidual residualOf(const Group& group, const Island& island, const VectorXd& r,
                            Bench& bench) {
  return naturalResidual(bench.assembler.assemble(group.bodies, group.contacts, group.rows, island),
                         r);
}

/// The island's problem if its contacts give by this share of what `soften` gives.
const Problem& softProblem(const Group& group, const Island& island, double share, Bench& bench) {
  bench.changeContacts(group.contacts, island,
                       [&](Contact& contact) { soften(group.bodies, contact, share); });
  return bench.assembler.assemble(group.bodies, bench.softContacts, group.rows, island);
}

/// The island's problem if joints that hold, and contacts that are to part, ask for this share of
/// what they ask for now, and contacts perhaps give. Springs, and contacts that are as soft, ask
/// for all: what they ask for is their force.
const Problem& heldBackProblem(const Group& group, const Island& island, double share,
                               bool contactsGive, Bench& bench) {
  bench.changeRows(group.rows, island, [&](Row& row, int k) {
    if (row.governor >= 0 || drives(group, k, row.target > 0)) return;
    if (!isSpring(group, row)) row.target *= share;
  });
  bench.changeContacts(group.contacts, island, [&](Contact& contact) {
    double& asked = contact.target[0];
    if (asked > 0 && !isSpring(group, contact)) asked *= share;
    if (contactsGive) soften(group.bodies, contact);
  });
  return bench.assembler.assemble(group.bodies, bench.softContacts, bench.softRows, island);
}

/// Solves a problem as the trial, and returns whether that has a solution, or whether one is found
/// with a residual of at most `mostMissed`, m/s. Any motion that is near to it will do as a
/// recovery.
bool solveTrial(const Problem& problem, bool isRecovery, double mostMissed, Bench& bench) {
  ShortSearch search(bench.solver);
  if (isRecovery) search.takeAnyNear();
  const Solution& trial = bench.trial;
  bench.solver.solve(problem, VectorXd(), bench.trial);
  bench.counts.add(trial);
  const bool isFound = trial.status == Status::Solved ||
                       (trial.status == Status::OutOfBudget && trial.residual <= mostMissed);
  return isFound && fitsBullet(trial.r);
}

/// The same, whether this solution strains the island no more than it may, and tells of no quarrel.
bool relieves(const Group& group, const Island& island, const Problem& problem,
              const Relief& relief, Bench& bench) {
  return solveTrial(problem, false, relief.mostMissed, bench) &&
         strainOf(group, island, bench.trial) <= relief.mostStrain &&
         quarrelOf(group, island, problem.demand(), bench.trial) == Quarrel::None;
}

/// Whether the trial gives the bodies more energy than there is.
bool throwsBodies(const Group& group, const Island& island, Bench& bench) {
  constexpr double times = 2;  // what the bodies have, and what recovery gives
  std::vector<Body>& bodies = bench.trialBodies;
  bodies.resize(group.bodies.size());
  for (const int body : island.bodies) bodies[body] = group.bodies[body];
  applyReaction(bodies, group.contacts, group.rows, island, bench.trial.r);
  return energyOf(group, island, bodies) > times * energyAtHand(group, island);
}

/// The energy that contacts take up as they give, J; less what the residual of their law leaves
/// open.
double takenUp(const Group& group, const Island& island, const Solution& soft, const Bench& bench) {
  double sum = -soft.r.lpNorm<1>() * soft.residual / 2;
  island.eachContactAt([&](int k, int at, int) {
    const double give = bench.softContacts[k].compliance - group.contacts[k].compliance;
    sum += give / 2 * soft.r[at] * soft.r[at];
  });
  return sum;
}

}  // namespace

void answerSoftened(const Group& group, const Island& island, Bench& bench, Answer& answer,
                    IslandResult& result) {
  Solution& solution = bench.solution;
  bench.solver.solve(softProblem(group, island, 1, bench), VectorXd(), solution);
  bench.counts.add(solution);
  if (!fitsBullet(solution.r)) return;
  take(group, island, solution, residualOf(group, island, solution.r, bench), answer, result);
}

void answerHeldBack(const Group& group, const Island& island, const TargetWork& exact,
                    bool contactsThrow, Bench& bench, Answer& answer, IslandResult& result) {
  constexpr double aim = 0.9, enough = 0.5, little = 0.01;  // of what is fair
  constexpr int mostTries = 4;
  const ShortSearch search(bench.solver);
  Solution& solution = bench.solution;
  bool contactsGive = contactsThrow;
  const auto solve = [&](double share) {
    const Problem& problem = heldBackProblem(group, island, share, contactsGive, bench);
    const auto workFrom = [&](const VectorXd& guess) {
      bench.solver.solve(problem, guess, solution);
      bench.counts.add(solution);
      return workOfTargets(group, bench.softContacts, bench.softRows, island, problem, solution)
          .done;
    };
    const auto isFound = [&] { return solution.residual <= roughly * problem.demand(); };
    double done = workFrom(solution.r);
    // With little work allowed, the search may not leave reactions that threw a body.
    if (!isFound() && done > exact.fair) done = workFrom(VectorXd());
    return std::make_pair(isFound(), done);
  };
  // The squares of a share that is fair and of one that is not, with their work, which is about
  // linear in between.
  double fair = 0, doneFair = 0, unfair = 1, doneUnfair = exact.done;
  for (int tries = 1;; ++tries) {
    const bool isLast = tries > mostTries;
    const double reached = (aim * exact.fair - doneFair) / (doneUnfair - doneFair);
    const double square = isLast ? fair : fair + (unfair - fair) * reached;
    auto [isFound, done] = solve(std::sqrt(square));
    // Where bodies are so wedged that this is not found soon, contacts give, too.
    if (!isFound && !contactsGive) {
      contactsGive = true;
      std::tie(isFound, done) = solve(std::sqrt(square));
    }
    if (!fitsBullet(solution.r)) return;
    const bool isFair = done <= exact.fair;
    const bool isStuck = tries > 1 && std::abs(done - doneFair) <= little * exact.fair;
    const bool isEnough = done >= enough * exact.fair || tries == mostTries || isStuck;
    if (isLast || (isFair && isEnough)) break;
    (isFair ? fair : unfair) = square;
    (isFair ? doneFair : doneUnfair) = done;
  }
  take(group, island, solution, residualOf(group, island, solution.r, bench), answer, result);
}

bool answerRecovering(const Group& group, const Island& island, const Relief& relief,
                      double leastCut, Bench& bench, Answer& answer, IslandResult& result) {
  const Solution& trial = bench.trial;
  const Problem& recovery = recoveryProblem(group, island, bench);
  if (!solveTrial(recovery, true, roughly * recovery.demand(), bench)) return false;
  recover(group, island, trial.r, bench);
  for (const Friction friction : {Friction::OfAllSlip, Friction::OfOtherSlip}) {
    const Problem& problem = recoveringProblem(group, island, friction, bench);
    if (shareCut(group, island, problem.demand(), bench) < leastCut) return false;
    if (!relieves(group, island, problem, relief, bench)) continue;
    const TargetWork work =
        workOfTargets(group, bench.softContacts, bench.softRows, island, problem, trial);
    if (work.done > work.allowed || throwsBodies(group, island, bench)) continue;
    take(group, island, trial, residualOf(group, island, trial.r, bench), answer, result);
    result.isSoftened = false;
    return true;
  }
  return false;
}

bool answerUnwedged(const Group& group, const Island& island, const Relief& relief, Bench& bench,
                    Answer& answer, IslandResult& result) {
  const auto assemble = [&](const auto& change) -> const Problem& {
    bench.changeContacts(group.contacts, island, change);
    return bench.assembler.assemble(group.bodies, bench.softContacts, group.rows, island);
  };
  // A load strains without friction, too.
  const Problem& slippery = assemble([](Contact& contact) { contact.friction = 0; });
  if (!relieves(group, island, slippery, relief, bench)) return false;
  // By the lesser response: a heavy body does not sink into a light one.
  const Problem& problem = assemble([&](Contact& contact) {
    contact.compliance += joinedSoftness * lesserResponse(group, contact);
  });
  if (!relieves(group, island, problem, relief, bench)) return false;
  const Solution& trial = bench.trial;
  const TargetWork work =
      workOfTargets(group, bench.softContacts, group.rows, island, problem, trial);
  take(group, island, trial, residualOf(group, island, trial.r, bench), answer, result);
  if (work.done > work.allowed) answerHeldBack(group, island, work, true, bench, answer, result);
  return true;
}

bool answerJam(const Group& group, const Island& island, double most, Bench& bench, Answer& answer,
               IslandResult& result) {
  constexpr double shares[] = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6};
  const double atHand = energyAtHand(group, island);
  ShortSearch search(bench.solver);
  search.takeAnyNear();
  Solution& solution = bench.solution;
  double demand = 0;
  TargetWork work;
  const auto isFound = [&](double share, const VectorXd& guess) {
    const Problem& problem = softProblem(group, island, share, bench);
    bench.solver.solve(problem, guess, solution);
    bench.counts.add(solution);
    demand = problem.demand();
    work = workOfTargets(group, bench.softContacts, group.rows, island, problem, solution);
    return solution.residual <= roughly * demand && fitsBullet(solution.r);
  };
  VectorXd& guess = bench.guess;
  for (const double share : shares) {
    if (!isFound(share, guess)) return false;
    guess = solution.r;
    if (takenUp(group, island, solution, bench) <= atHand / 4) continue;
    VelocityResidual residual = residualOf(group, island, solution.r, bench);
    if (residual.max > most) continue;
    take(group, island, solution, residual, answer, result);
    // Joints that throw look like a jam, too, where the search for the exact answer was in vain.
    if (work.done > work.allowed)
      answerHeldBack(group, island, work, true, bench, answer, result);
    else if (contactsThrowOne(group, island, demand, answer, suspectReach) && isFound(1, guess))
      take(group, island, solution, residualOf(group, island, solution.r, bench), answer, result);
    mark(group, island, result).isJammed = true;
    return true;
  }
  return false;
}

}  // namespace delassus::bullet
