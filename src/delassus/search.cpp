#include "delassus/search.h"

#include <algorithm>
#include <cmath>

#include "delassus/length.h"
#include "delassus/pile_kind.h"
#include "delassus/pivoting.h"

namespace delassus {
namespace {

/// A bound from below for what no reactions leave, as a root mean square over contacts and rows, m/s: of an approaching contact
/// ‖P(−v)‖ ≥ |q_n| / (1 + μ²), which is worked out at once.
double leastRmsFromNothing(const Problem& problem) {
  const int n = problem.contacts();
  if (n == 0) return 0;
  const double widest = problem.friction.maxCoeff();
  const Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<3>> normal(problem.q.data(), n);
  return std::sqrt(normal.cwiseMin(0).squaredNorm() / (n + problem.rows())) / (1 + widest * widest);
}

constexpr double nearly = 1e-6;  ///< share of the demands that reactions leave open
constexpr int pileWalk = 400;

/// Explicit entries that are too many for a dense matrix and its factor are swept over, and no more.
bool isTooLargeToFactor(const Problem& problem) {
  constexpr int most = 10000;
  return !problem.W.inBodySpace() && problem.size() > most;
}

}  // namespace

double Search::proximalWeight(const Problem& problem, const Solution& from, double least) {
  return std::clamp(std::sqrt(from.residual / problem.q.cwiseAbs().maxCoeff()), least,
                    unknownRegion);
}

/// A few regions settle a small island; where there are many contacts, and no time, they only take some.
bool Search::hasNoWalk(const Problem& problem, const Options& options, const Solution& best) const {
  const int least = isHeap(problem) || isLargePile(problem) ? shortWalk : 1;
  return isHurried_ && options.newtonBudget - best.regions < least;
}

void Search::measure(Solution& candidate) {
  candidate.setResidual(map_.measure(candidate.r, felt_, candidate.u));
}

void Search::consider(Solution& candidate, Solution& best) {
  measure(candidate);
  if (candidate.residual < best.residual) best.takeReactions(candidate);
}

void Search::offer(const Problem& problem, const VectorXd& r, Solution& best) {
  trial_.r = r;
  makeFeasible(problem, trial_.r);
  consider(trial_, best);
}

void Search::startBetter(const Problem& problem, Solution& best) {
  constexpr double hopeless = 30;
  const double guessed = best.residualRms;
  if (guessed <= hopeless * leastRmsFromNothing(problem)) return;
  trial_.r.setZero(problem.size());
  makeFeasible(problem, trial_.r);
  measure(trial_);
  const bool isHopeless = !(guessed <= hopeless * trial_.residualRms);
  if (isHopeless && !(best.residual <= trial_.residual)) best.takeReactions(trial_);
}

void Search::allow(const Problem& problem, Solution& best) {
  makeFeasible(problem, best.r);
  measure(best);
}

Outcome Search::pivotRows(const Problem& problem, const Options& options, double tolerance,
                          Solution& best) {
  if (isTooLargeToFactor(problem)) return Outcome::Lost;
  const PivotResult result =
      pivot(problem.W.dense(), problem.q, problem.lower, problem.upper, options.newtonBudget);
  best.regions += result.regions;
  best.factorisations += result.factorisations;
  trial_.r = result.r;
  consider(trial_, best);
  if (best.residual <= tolerance) return Outcome::Reached;
  if (result.status != Status::Incompatible) return Outcome::Lost;
  best.r = result.r;
  best.u = result.u;
  best.setResidual(map_.residual(best.r, best.u));
  best.blamed = result.blamed;
  return Outcome::Incompatible;
}

/// From the likeliest way to the surest, where joints leave more than few contacts (`condense` comes before).
///
/// Without reactions of a last step:
///   - the paper's forced motion, every approaching contact held, from zero; in large piles, whose contacts share loads in many ways,
///     with a search for forced reactions that lie inside their cones (`hold`);
///   - where there is but one region, a walk to it; elsewhere steps in the space of reactions (`react`), on a dense matrix if few touch,
///     and alternating directions.
/// With them:
///   - piles, and what slid nowhere: `hold`, from the last reactions;
///   - up to some hundred contacts, but for large piles: steps in the space of reactions;
///   - much is disturbed: accelerated sweeps as long as they gain, in heaps with patches.
/// Where few sweeps are allowed: `hold` if nothing slid, and all sweeps.
/// Then a walk, in large piles a long one. Where it loses its way, many contacts are at a wall of their region:
///   - in large heaps plain sweeps, to outlast what hurried ones run past;
///   - a proof that nothing can meet the demands; a second walk, but in large islands, as bold as what the first has left allows;
///     an interior point, which comes down between the walls; a longer walk from there; and `wander`.
template <class Motion>
Outcome Search::walkOnce(Engines<Motion>& engines, const Problem& problem, const Options& options,
                         double tolerance, const VectorXd* guess, Solution& best) {
  const auto left = [&](int most) { return std::min(most, options.newtonBudget - best.regions); };
  ProximalNewton<Motion>& newton = engines.walk;
  newton.setProblem(problem, map_);
  newton.keepFactors(options.economies.factors);
  const bool isRushed = hasNoWalk(problem, options, best);
  Outcome outcome = startOut(newton, problem, options, tolerance, guess, best);
  if (outcome != Outcome::Lost || isRushed || left(1) <= 0) return outcome;
  const double weight = best.residual <= nearly * problem.q.cwiseAbs().maxCoeff()
                            ? knownRegion
                            : proximalWeight(problem, best, 1e-2);
  // In large piles what else finds back is dear and seldom helps.
  const int most = guess && isLargePile(problem) && !isHurried_ ? pileWalk : fairWalk;
  outcome = newton.walk(problem, tolerance, weight, left(most), best);
  // In small heaps regions cost no more than tens of sweeps: there that is left for the end.
  if (outcome == Outcome::Lost && isLargeHeap(problem))
    outcome = outlast(newton, problem, options, tolerance, guess, best);
  return outcome == Outcome::Lost ? findBack(engines, problem, options, tolerance, guess, best)
                                  : outcome;
}

template <class Motion>
void Search::polishWith(Engines<Motion>& engines, const Problem& problem, const Options& options,
                        double aim, Solution& best) {
  constexpr double weight = polishedShare;
  const int most = std::min(fewRegions, options.newtonBudget - best.regions);
  engines.walk.setProblem(problem, map_);
  engines.walk.keepFactors(options.economies.factors);
  engines.walk.polish(problem, aim, weight, most, best);
}

/// From the last reactions, then from nothing. In large heaps the path of compliance comes between, as far as it is short: it is
/// where what sweeps have left is small, and costs less then than to begin anew.
template <class Motion>
Outcome Search::walkTwice(Engines<Motion>& engines, const Problem& problem, const Options& options,
                          double tolerance, const VectorXd* guess, Solution& best) {
  if (isHurried_) return walkOnce(engines, problem, options, tolerance, guess, best);
  constexpr int shortPath = 8;  // one part in so many
  Options rest = options;
  Outcome outcome;
  if (guess) {
    Options share = options;
    share.newtonBudget -= options.newtonBudget / 8 * 3;
    share.sweepBudget -= options.sweepBudget / 2;
    outcome = walkOnce(engines, problem, share, tolerance, guess, best);
    if (outcome == Outcome::Lost && isLargeHeap(problem)) {
      share.pathBudget = options.pathBudget / shortPath;
      rest.pathBudget -= share.pathBudget;
      outcome = harden(engines.walk, problem, share, tolerance, guess, best);
      if (outcome == Outcome::Lost)
        outcome = outlast(engines.walk, problem, options, tolerance, nullptr, best);
    } else if (outcome == Outcome::Lost) {
      outcome = walkCold(engines, problem, options, tolerance, best);
    }
  } else {
    outcome = walkOnce(engines, problem, options, tolerance, nullptr, best);
  }
  return outcome == Outcome::Lost ? harden(engines.walk, problem, rest, tolerance, guess, best)
                                  : outcome;
}

/// A way of its own begins in apart_, from `guess`, or without one (null) from nothing, on what is left of the budget: what it takes for
/// progress does not depend on what was found before.
void Search::setOutApart(const Problem& problem, const VectorXd* guess, Solution& best) {
  apart_.start(problem.q);
  if (guess) apart_.r = *guess;
  makeFeasible(problem, apart_.r);
  consider(apart_, best);
  apart_.regions = best.regions;
  apart_.factorisations = best.factorisations;
  apart_.sweeps = best.sweeps;
  apart_.patches = best.patches;
}

/// And ends: its work is counted, and its answer is taken if it is one, or better.
Outcome Search::comeBack(Outcome outcome, Solution& best) const {
  best.regions = apart_.regions;
  best.factorisations = apart_.factorisations;
  best.sweeps = apart_.sweeps;
  best.patches = apart_.patches;
  if (outcome == Outcome::Lost && !(apart_.residual < best.residual)) return outcome;
  best.takeReactions(apart_);
  best.blamed = apart_.blamed;
  return outcome;
}

/// As if there were no guess.
template <class Motion>
Outcome Search::walkCold(Engines<Motion>& engines, const Problem& problem, const Options& options,
                         double tolerance, Solution& best) {
  setOutApart(problem, nullptr, best);
  return comeBack(walkOnce(engines, problem, options, tolerance, nullptr, apart_), best);
}

Outcome Search::walk(const Problem& problem, const Options& options, double tolerance,
                     const VectorXd* guess, Solution& best) {
  isHurried_ = options.sweepBudget < alternations;
  if (!problem.W.inBodySpace() && problem.size() > fewUnknowns &&
      sweepAndLearn(problem, options, tolerance, best))
    return Outcome::Reached;
  if (fitsDenseNewton(problem, map_) &&
      dense_.solve(problem, map_, tolerance, options.newtonBudget - best.regions, Start::Best,
                   best))
    return Outcome::Reached;
  if (condense(problem, options, tolerance, best)) return Outcome::Reached;
  if (isTooLargeToFactor(problem) ||
      (hasNoWalk(problem, options, best) && !mayHold(problem, options, guess, best))) {
    sweepAll(problem, options, keptShare * tolerance, guess, best);
    return best.residual <= tolerance ? Outcome::Reached : Outcome::Lost;
  }
  const Outcome outcome =
      problem.W.inBodySpace()
          ? walkTwice(machines().bodies, problem, options, tolerance, guess, best)
          : walkTwice(machines().factored, problem, options, tolerance, guess, best);
  allow(problem, best);
  return outcome;
}

void Search::polish(const Problem& problem, const Options& options, double aim, Solution& best) {
  if (isTooLargeToFactor(problem)) return;
  if (problem.W.inBodySpace())
    polishWith(machines().bodies, problem, options, aim, best);
  else
    polishWith(machines().factored, problem, options, aim, best);
  allow(problem, best);
}

}  // namespace delassus
