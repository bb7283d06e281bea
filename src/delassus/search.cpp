#include "delassus/search.h"

#include <algorithm>
#include <cmath>

#include "delassus/pile_kind.h"
#include "delassus/pivoting.h"

namespace delassus {
namespace {

/// A lower bound for the residual of no reactions, as a root mean square over contacts and rows,
/// m/s. An approaching contact has ‖P(−v)‖ ≥ |q_n| / (1 + μ²), which is cheap to compute.
double leastRmsFromNothing(const Problem& problem) {
  const int n = problem.contacts();
  if (n == 0) return 0;
  const double widest = problem.friction.maxCoeff();
  const Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<3>> normal(problem.q.data(), n);
  return std::sqrt(normal.cwiseMin(0).squaredNorm() / problem.parts()) / (1 + widest * widest);
}

constexpr double nearly = 1e-6;  ///< share of the demands that reactions leave open

/// Whether explicit entries are too many for a dense matrix and its factor: then they are only
/// swept over.
bool isTooLargeToFactor(const Problem& problem) {
  constexpr int most = 10000;
  return !problem.W.inBodySpace() && problem.size() > most;
}

}  // namespace

double Search::firstWeight(const Solution& from, double least) const {
  return std::clamp(std::sqrt(from.residual / problem_->demand()), least, weightUnknown);
}

bool Search::isFar(const Solution& from) const {
  constexpr double withinReach = 1e-4;
  return isLargeHeap(*problem_) && from.residual > withinReach * problem_->demand();
}

/// A few regions settle a small island. Where there are many contacts and little time, so few only
/// cost time.
bool Search::hasNoWalk(const Task& task, const Solution& best) const {
  const int least = isHeap(*problem_) || isLargeButNoHeap(*problem_) ? shortWalk : 1;
  return task.isHurried && task.regionsLeft(best) < least;
}

/// In a large heap a budget that is too small for regions goes further with sweeps alone: where
/// spheres wedge in a bin, three hundred to a thousand sweeps take a fifth of the time and leave no
/// more.
bool Search::isHurried(const Options& options) const {
  constexpr int worthRegions = 3000;
  return options.isHurried() ||
         (!isInner_ && isLargeHeap(*problem_) && options.sweepBudget < worthRegions);
}

void Search::measure(Solution& candidate) {
  candidate.setResidual(map_.measure(candidate.r, felt_, candidate.u));
}

void Search::consider(Solution& candidate, Solution& best) {
  measure(candidate);
  const bool takesEnergy = candidate.residual <= mostForEnergy_ && workOf(candidate) < workOf(best);
  if (candidate.residual < best.residual || takesEnergy) best.takeReactions(candidate);
}

void Search::offer(const VectorXd& r, Solution& best) {
  trial_.r = r;
  makeFeasible(*problem_, trial_.r);
  consider(trial_, best);
}

double Search::workOf(const Solution& s) const { return s.r.dot(problem_->q + s.u) / 2; }

void Search::startBetter(const Options& options, Solution& best) {
  constexpr double hopeless = 30;
  constexpr int few = 20;  // sweeps
  const double guessed = best.residualRms;
  const bool drives = options.sweepBudget < few && problem_->rows() == 0 && workOf(best) > 0 &&
                      !slidesNowhere(best.r);
  if (!drives && std::isfinite(guessed) && guessed <= hopeless * leastRmsFromNothing(*problem_))
    return;
  trial_.r.setZero(problem_->size());
  makeFeasible(*problem_, trial_.r);
  measure(trial_);
  const bool isHopeless = !(guessed <= hopeless * trial_.residualRms);
  const bool isBetter = isHopeless || (drives && workOf(best) > workOf(trial_));
  if (isBetter && !(best.residual <= trial_.residual)) best.takeReactions(trial_);
}

void Search::allow(Solution& best) {
  if (makeFeasible(*problem_, best.r)) measure(best);
}

Outcome Search::pivotRows(const Task& task, Solution& best) {
  if (isTooLargeToFactor(*problem_)) return Outcome::Lost;
  const PivotResult result = pivot(problem_->W.dense(), problem_->q, problem_->lower,
                                   problem_->upper, task.regionsLeft(best));
  best.regions += result.regions;
  best.factorisations += result.factorisations;
  trial_.r = result.r;
  consider(trial_, best);
  if (best.residual <= task.tolerance) return Outcome::Reached;
  if (result.status != Status::Incompatible) return Outcome::Lost;
  best.r = result.r;
  best.u = result.u;
  best.setResidual(map_.residual(best.r, best.u));
  best.blamed = result.blamed;
  return Outcome::Incompatible;
}

/// The walk from where quick ways have led. In a large heap it goes on as long as it gains: of 81
/// steps in a wedged bin of 1000 spheres that quick ways do not end, such a walk ends 61; ten
/// regions, or eighty within reach of an answer, end 13.
template <class Motion>
Outcome Search::walkFromHere(Engines<Motion>& engines, const Task& task, Solution& best) {
  const double weight = best.residual <= nearly * problem_->demand()
                            ? weightKnown
                            : firstWeight(best, leastWeightAtFirst);
  if (isLargeHeap(*problem_) && !task.isHurried)
    return engines.walk.walkOn(task.tolerance, weight, patientWalk, task.regionsLeft(best), best);
  // In large piles the other ways to find back are expensive and seldom help.
  const int most =
      task.guess && isLargeButNoHeap(*problem_) && !task.isHurried ? longWalk : fairWalk;
  return engines.walk.walk(task.tolerance, weight, task.regionsLeft(best, most), best);
}

/// The ways to an answer, from the likeliest to the surest.
///
/// Without reactions of a last step:
///   - the paper's forced motion, every approaching contact held, from zero; in large piles, whose
///     contacts share loads in many ways, a search for forced reactions inside the cones (`hold`);
///   - where there is only one region, a walk to it; elsewhere steps in the space of reactions
///     (`react`), on a dense matrix if few contacts touch, and then alternating directions.
/// With them:
///   - in piles, and where nothing slid: `hold`, from the last reactions;
///   - in large piles that are disturbed in few places: patches (`mendPlaces`);
///   - with up to a few hundred contacts, except in large piles; and where the last reactions are
///     nearly right, except in large heaps: steps in the space of reactions;
///   - where much is disturbed: accelerated sweeps as long as they gain, in heaps with patches.
/// Where few sweeps are allowed: `hold` if nothing slid, and all sweeps.
///
/// Then comes a walk: a long one in large piles, one that goes on as long as it gains in large
/// heaps. Where it loses its way, many contacts are at a wall of their region, and there follow
///   - in large heaps plain sweeps, for the slips that accelerated ones run past (`outlast`);
///   - a proof that nothing can meet the demands;
///   - a second walk, except in large islands, as bold as the residual of the first one allows;
///   - an interior point, which comes down between the walls;
///   - a walk from there that goes on as long as it gains; and `wander`.
template <class Motion>
Outcome Search::walkOnce(Engines<Motion>& engines, const Task& task, Solution& best) {
  engines.space.setProblem(*problem_, map_);
  engines.space.keepFactors(task.options.economies.factors);
  const bool isRushed = hasNoWalk(task, best);
  Outcome outcome = startOut(engines, task, best);
  if (outcome != Outcome::Lost || isRushed) return outcome;
  // In a hurry the answer stays where the sweeps have left it.
  if (task.regionsLeft(best) <= 0 || (task.isHurried && isFar(best))) return outcome;
  outcome = walkFromHere(engines, task, best);
  // In small heaps regions cost no more than tens of sweeps: there sweeps by the thousand wait.
  if (outcome == Outcome::Lost && isLargeHeap(*problem_)) outcome = outlast(task, best);
  return outcome == Outcome::Lost ? findBack(engines, task, best) : outcome;
}

template <class Motion>
void Search::polishWith(Engines<Motion>& engines, const Task& task, Solution& best) {
  constexpr double weight = polishedShare;
  const int most = task.regionsLeft(best, fewRegions);
  engines.space.setProblem(*problem_, map_);
  engines.space.keepFactors(task.options.economies.factors);
  engines.walk.polish(task.tolerance, weight, most, best);
}

/// Searches from the last reactions and then, except in large heaps, whose search includes that,
/// from nothing; or, without last reactions, from nothing and then from the answers for less
/// friction. The last resort is a path from softer contacts (`harden`).
template <class Motion>
Outcome Search::walkTwice(Engines<Motion>& engines, const Task& task, Solution& best) {
  if (task.isHurried) return walkOnce(engines, task, best);
  Outcome outcome;
  if (task.guess && !isLargeHeap(*problem_)) {
    // The rest is for the walk from nothing.
    constexpr int coldEighths = 3;
    Task share = task;
    share.reserved = task.options.regionsInVain() / 8 * coldEighths;
    share.options.sweepBudget -= task.options.sweepBudget / 2;
    outcome = walkOnce(engines, share, best);
    if (outcome == Outcome::Lost) outcome = walkCold(engines, task, best);
  } else {
    outcome = walkOnce(engines, task, best);
    // A few more digits are not worth that.
    if (outcome == Outcome::Lost && best.residual > nearly * problem_->demand())
      outcome = addFriction(task, best);
  }
  return outcome == Outcome::Lost ? harden(task, best) : outcome;
}

/// Begins a search apart in apart_, from `guess` or, if this is null, from nothing, on what is left
/// of the budget. So its measure of progress does not depend on earlier answers.
void Search::setOutApart(const VectorXd* guess, Solution& best) {
  apart_.start(problem_->q);
  if (guess) apart_.r = *guess;
  makeFeasible(*problem_, apart_.r);
  consider(apart_, best);
  apart_.takeWork(best);
}

/// Ends the search apart: counts its work, and takes its answer if it is a solution, or better.
Outcome Search::comeBack(Outcome outcome, Solution& best) const {
  best.takeWork(apart_);
  if (outcome == Outcome::Lost && !(apart_.residual < best.residual)) return outcome;
  best.takeReactions(apart_);
  best.blamed = apart_.blamed;
  return outcome;
}

/// Searches as if there were no guess.
template <class Motion>
Outcome Search::walkCold(Engines<Motion>& engines, const Task& task, Solution& best) {
  setOutApart(nullptr, best);
  return comeBack(walkOnce(engines, task.fromNothing(), apart_), best);
}

/// Tries small and simple problems first: explicit entries by sweeps, if these lead far enough, and
/// by Newton's method on a dense W; few contacts that are left once joints are eliminated
/// (`condense`; in a hurry also few contacts without joints). Where there is no room for a factor,
/// or no time for a walk, makes sweeps alone. Leaves all else to `walkTwice`.
Outcome Search::walk(const Task& asked, Solution& best) {
  Task task = asked;
  task.isHurried = isHurried(asked.options);
  // Where bodies lie deep in each other, the residual rises by half, between jaws up to sixfold.
  constexpr double few = 10;
  mostForEnergy_ = task.isHurried && !task.guess ? few * best.residual : 0;
  if (!problem_->W.inBodySpace() && problem_->size() > fewUnknowns &&
      sweepAndLearn(task, task.tolerance, best))
    return Outcome::Reached;
  if (fitsDenseNewton(*problem_, map_) &&
      dense_.solve(*problem_, map_, task.tolerance, task.regionsLeft(best), Start::Best, best))
    return Outcome::Reached;
  if (condense(task, best)) return Outcome::Reached;
  if (isTooLargeToFactor(*problem_) || (hasNoWalk(task, best) && !mayHold(task, best))) {
    sweepAll(task, keptShare * task.tolerance, best);
    return best.residual <= task.tolerance ? Outcome::Reached : Outcome::Lost;
  }
  const Outcome outcome = problem_->W.inBodySpace() ? walkTwice(machines().bodies, task, best)
                                                    : walkTwice(machines().factored, task, best);
  allow(best);
  return outcome;
}

void Search::polish(const Task& task, Solution& best) {
  if (isTooLargeToFactor(*problem_)) return;
  if (problem_->W.inBodySpace())
    polishWith(machines().bodies, task, best);
  else
    polishWith(machines().factored, task, best);
  allow(best);
}

template Outcome Search::walkOnce(Engines<BodyMotion>&, const Task&, Solution&);

}  // namespace delassus
