#include "delassus/search.h"

#include <algorithm>
#include <cmath>

#include "delassus/length.h"
#include "delassus/pile_kind.h"
#include "delassus/pivoting.h"

namespace delassus {
namespace {

/// The paper's forced motion: all that approach are held, whatever the sign of their reactions will be.
void forceActiveSet(const Problem& problem, ActiveSet& set) {
  // Bodies that fall together touch with q_n = 0 up to round-off: they are held too.
  const double touching = 1e-6 * problem.q.cwiseAbs().maxCoeff();
  set.contacts.clear();
  set.rows.clear();
  for (int i = 0; i < problem.contacts(); ++i)
    set.contacts.push_back(problem.q[3 * i] <= touching ? Mode::Stick : Mode::Open);
  for (int i = 0; i < problem.rows(); ++i) {
    const double q = problem.q[3 * problem.contacts() + i];
    set.rows.push_back(q > touching && std::isfinite(problem.lower[i])    ? RowState::AtLower
                       : q < -touching && std::isfinite(problem.upper[i]) ? RowState::AtUpper
                                                                          : RowState::Free);
  }
  set.disks.assign(problem.disks.size(), Mode::Stick);
}

/// The same where reactions tell more: what pressed in the last step is held, too.
void holdActiveSet(const Problem& problem, const VectorXd& r, ActiveSet& set) {
  forceActiveSet(problem, set);
  for (int i = 0; i < problem.contacts(); ++i)
    if (r[3 * i] > 0) set.contacts[i] = Mode::Stick;
  for (int i = 0; i < problem.rows(); ++i) {
    const double push = r[3 * problem.contacts() + i];
    if (push > problem.lower[i] && push < problem.upper[i]) set.rows[i] = RowState::Free;
  }
}

/// A bound from below for what no reactions leave, as a root mean square over contacts and rows, m/s: of an approaching contact
/// ‖P(−v)‖ ≥ |q_n| / (1 + μ²), which is worked out at once.
double leastRmsFromNothing(const Problem& problem) {
  const int n = problem.contacts();
  if (n == 0) return 0;
  const double widest = problem.friction.maxCoeff();
  const Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<3>> normal(problem.q.data(), n);
  return std::sqrt(normal.cwiseMin(0).squaredNorm() / (n + problem.rows())) / (1 + widest * widest);
}

/// Whether no contact presses with all the friction that it has.
bool slidesNowhere(const Problem& problem, const VectorXd& r) {
  constexpr double all = 1 - 1e-6;
  for (int i = 0; i < problem.contacts(); ++i)
    if (r[3 * i] > 0 &&
        lengthOf(r[3 * i + 1], r[3 * i + 2]) >= all * problem.friction[i] * r[3 * i])
      return false;
  return true;
}

/// Joints alone, without limits and motors: there is one region.
bool hasOneRegion(const Problem& problem) {
  return problem.contacts() == 0 && problem.disks.empty() && problem.lower.array().isInf().all() &&
         problem.upper.array().isInf().all();
}

// Proximal weights. From nothing a smaller one needs fewer steps; and were it smaller still, the first would end just within the
// tolerance, and none would follow that takes more digits.
constexpr double knownRegion = 1e-6, forcedRegion = 1e-7;
constexpr double disturbed = 1e-3,
                 nearly = 1e-6;  ///< shares of the demands that reactions leave open
constexpr int shortWalk = 16, pileWalk = 400, fewRegions = 8;
constexpr int alternations = 300;  ///< what brings a large pile to rest

/// Explicit entries that are too many for a dense matrix and its factor are swept over, and no more.
bool isTooLargeToFactor(const Problem& problem) {
  constexpr int most = 10000;
  return !problem.W.inBodySpace() && problem.size() > most;
}

/// Has the reactions of `candidate` as the best answer.
void take(const Solution& candidate, Solution& best) {
  best.r = candidate.r;
  best.u = candidate.u;
  best.residual = candidate.residual;
  best.residualRms = candidate.residualRms;
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

void Search::measure(const Problem& problem, Solution& candidate) {
  candidate.u = problem.q;
  if (candidate.r.any()) {
    problem.W.multiply(candidate.r, felt_, candidate.u);
    candidate.u += problem.q;
  }
  const VelocityResidual residual = map_.residual(candidate.r, candidate.u);
  candidate.residual = residual.max;
  candidate.residualRms = residual.rms;
}

void Search::consider(const Problem& problem, Solution& candidate, Solution& best) {
  measure(problem, candidate);
  if (candidate.residual < best.residual) take(candidate, best);
}

void Search::offer(const Problem& problem, const VectorXd& r, Solution& best) {
  trial_.r = r;
  makeFeasible(problem, trial_.r);
  consider(problem, trial_, best);
}

void Search::startBetter(const Problem& problem, Solution& best) {
  constexpr double hopeless = 30;
  const double guessed = best.residualRms;
  if (guessed <= hopeless * leastRmsFromNothing(problem)) return;
  trial_.r.setZero(problem.size());
  makeFeasible(problem, trial_.r);
  measure(problem, trial_);
  const bool isHopeless = !(guessed <= hopeless * trial_.residualRms);
  if (isHopeless && !(best.residual <= trial_.residual)) take(trial_, best);
}

void Search::allow(const Problem& problem, Solution& best) {
  makeFeasible(problem, best.r);
  measure(problem, best);
}

Outcome Search::pivotRows(const Problem& problem, const Options& options, double tolerance,
                          Solution& best) {
  if (isTooLargeToFactor(problem)) return Outcome::Lost;
  const PivotResult result =
      pivot(problem.W.dense(), problem.q, problem.lower, problem.upper, options.newtonBudget);
  best.regions += result.regions;
  best.factorisations += result.factorisations;
  trial_.r = result.r;
  consider(problem, trial_, best);
  if (best.residual <= tolerance) return Outcome::Reached;
  if (result.status != Status::Incompatible) return Outcome::Lost;
  best.r = result.r;
  best.u = result.u;
  const VelocityResidual residual = map_.residual(best.r, best.u);
  best.residual = residual.max;
  best.residualRms = residual.rms;
  best.blamed = result.blamed;
  return Outcome::Incompatible;
}

/// From the likeliest way to the surest.
///
/// Without reactions of a last step:
///   - the paper's forced motion, every approaching contact held, from zero; in large piles, whose contacts share loads in many ways,
///     with a search for forced reactions that lie inside their cones (`hold`);
///   - where there is but one region, a walk to it; elsewhere alternating directions.
/// With them:
///   - piles, and what slid nowhere: `hold`, from the last reactions;
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

/// What comes before the first walk. Lost: the walk finishes.
template <class Motion>
Outcome Search::startOut(ProximalNewton<Motion>& newton, const Problem& problem,
                         const Options& options, double tolerance, const VectorXd* guess,
                         Solution& best) {
  const double demand = problem.q.cwiseAbs().maxCoeff(), aim = keptShare * tolerance;
  const auto left = [&](int most) { return std::min(most, options.newtonBudget - best.regions); };
  const auto isReached = [&] { return best.residual <= tolerance; };
  wandering_.residual = infinity;  // of what a hold leaves
  if (isHurried_ && hold(newton, problem, options, tolerance, guess, best)) return Outcome::Reached;
  if (!guess && !isLargePile(problem)) {
    forceActiveSet(problem, best.activeSet);
    const Outcome outcome =
        newton.walkFromRegion(problem, tolerance, forcedRegion, left(shortWalk), best);
    if (outcome != Outcome::Lost) return outcome;
  }
  if (!isHurried_ && hold(newton, problem, options, tolerance, guess, best))
    return Outcome::Reached;
  if (options.economies.oneRegion && hasOneRegion(problem)) {
    const Outcome outcome = newton.walk(problem, tolerance, knownRegion, left(shortWalk), best);
    if (outcome != Outcome::Lost) return outcome;
  } else if (!guess && alternate(newton, problem, options, tolerance, best)) {
    return Outcome::Reached;
  }
  if (isHurried_) {
    sweepAll(problem, options, aim, guess, best);
    if (wandering_.residual < best.residual) take(wandering_, best);
    if (isReached()) return Outcome::Reached;
  } else if (best.residual > disturbed * demand && isHeap(problem)) {
    settle(problem, options, aim, best);
    newton.setProblem(problem, map_);  // patches were at work here
    if (isReached())
      return isLargeHeap(problem) ? Outcome::Reached
                                  : finish(newton, problem, options, tolerance, best);
  } else if (best.residual > disturbed * demand) {
    if (isLargePile(problem))
      sweepWhileItGains(problem, options, aim, best);
    else
      sweepAndLearn(problem, options, aim, best);
    if (isReached()) return Outcome::Reached;
  }
  return Outcome::Lost;
}

/// Whether it is worth a region to hold all that touches. Not where the last reactions slid somewhere and regions are cheap, or few:
/// then something will again.
bool Search::mayHold(const Problem& problem, const Options& options, const VectorXd* guess,
                     const Solution& best) const {
  constexpr int fewContacts = 12;
  if (isHeap(problem) || best.regions >= options.newtonBudget) return false;
  // Explicit entries of this size cost more to factor than few sweeps are worth.
  if (isHurried_ && isLargePile(problem) && !problem.W.inBodySpace()) return false;
  if (!isHurried_ && isLargePile(problem)) return true;
  // Small islands without reactions of a last step hold all in their first region, if there may be others.
  return (guess || isHurried_) && problem.contacts() > fewContacts &&
         slidesNowhere(problem, best.r);
}

/// Holds all that touches. Who has few sweeps pays a region for it and no sweeps; these are made as if it had not been tried, and what it
/// has come to waits in wandering_.
template <class Motion>
bool Search::hold(ProximalNewton<Motion>& newton, const Problem& problem, const Options& options,
                  double tolerance, const VectorXd* guess, Solution& best) {
  constexpr int mostSteps = 40;
  const int sweeps = best.sweeps;
  const int most = isHurried_ ? mostSteps : std::min(mostSteps, options.sweepBudget - sweeps);
  if (most <= 0 || !mayHold(problem, options, guess, best)) return false;
  if (isHurried_) take(best, trial_);
  holdActiveSet(problem, best.r, best.activeSet);
  const bool isHeld = newton.holdAll(problem, tolerance, most, best);
  if (!isHurried_) return isHeld;
  best.sweeps = sweeps;
  if (!isHeld && best.residual < trial_.residual) {
    take(best, wandering_);
    take(trial_, best);
  }
  return isHeld;
}

/// Newton's method on what is left without the joints, in few contacts. Who has few sweeps pays a region for it, and no sweeps, as for
/// `hold`.
bool Search::condense(const Problem& problem, const Options& options, double tolerance,
                      Solution& best) {
  constexpr int worthCondensing = 10;  // sweeps; they cost as much
  const int sweeps = best.sweeps, most = options.sweepBudget - sweeps;
  if (most < worthCondensing || best.regions >= options.newtonBudget ||
      !CondensedNewton::fits(problem))
    return false;
  const bool isReached = machines().condensed.solve(problem, map_, tolerance, most, best);
  if (isHurried_) best.sweeps = sweeps;
  return isReached;
}

/// Alternating directions. False if they do not reach the tolerance.
template <class Motion>
bool Search::alternate(ProximalNewton<Motion>& newton, const Problem& problem,
                       const Options& options, double tolerance, Solution& best) {
  if (isHurried_) return false;
  const int most = std::min(alternations, options.sweepBudget - best.sweeps);
  if (!newton.alternate(problem, keptShare * tolerance, most, best)) return false;
  finish(newton, problem, options, tolerance, best);
  return true;
}

/// What first-order methods leave is slow; one step in the region that they have found takes it away.
template <class Motion>
Outcome Search::finish(ProximalNewton<Motion>& newton, const Problem& problem,
                       const Options& options, double tolerance, Solution& best) {
  const int most = std::min(fewRegions, options.newtonBudget - best.regions);
  newton.polish(problem, polishedShare * tolerance, knownRegion, most, best);
  return Outcome::Reached;
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
  consider(problem, apart_, best);
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
  take(apart_, best);
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
