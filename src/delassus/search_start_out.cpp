/// What the search does before its first walk.
#include <algorithm>
#include <cmath>

#include "delassus/length.h"
#include "delassus/pile_kind.h"
#include "delassus/search.h"

namespace delassus {
namespace {

/// The paper's forced motion: all that approach are held, whatever sign their reactions will have.
/// A row with bounds is held unless it would be at one of them if it were alone, r = −q / W_aa: the
/// rows of a joint that could break are held, and a motor that is too weak gives all it has.
void forceActiveSet(const Problem& problem, const VectorXd& diagonal, ActiveSet& set) {
  // Bodies that fall together touch with q_n = 0 up to round-off: they are held too.
  const double touching = 1e-6 * problem.demand();
  set.contacts.clear();
  set.rows.clear();
  set.contacts.reserve(problem.contacts());
  set.rows.reserve(problem.rows());
  for (int i = 0; i < problem.contacts(); ++i)
    set.contacts.push_back(problem.q[3 * i] <= touching ? Mode::Stick : Mode::Open);
  for (int i = 0; i < problem.rows(); ++i) {
    const int at = 3 * problem.contacts() + i;
    const double q = problem.q[at], lower = problem.lower[i], upper = problem.upper[i];
    set.rows.push_back(q > touching && -q <= lower * diagonal[at]    ? RowState::AtLower
                       : q < -touching && -q >= upper * diagonal[at] ? RowState::AtUpper
                                                                     : RowState::Free);
  }
  set.disks.assign(problem.disks.size(), Mode::Stick);
}

/// The same, and contacts that pressed in the last step are held, too.
void holdActiveSet(const Problem& problem, const VectorXd& diagonal, const VectorXd& r,
                   ActiveSet& set) {
  forceActiveSet(problem, diagonal, set);
  for (int i = 0; i < problem.contacts(); ++i)
    if (r[3 * i] > 0) set.contacts[i] = Mode::Stick;
  for (int i = 0; i < problem.rows(); ++i) {
    const double push = r[3 * problem.contacts() + i];
    if (push > problem.lower[i] && push < problem.upper[i]) set.rows[i] = RowState::Free;
  }
}

/// Joints alone, without limits and motors: there is one region.
bool hasOneRegion(const Problem& problem) {
  return problem.contacts() == 0 && problem.disks.empty() && problem.lower.array().isInf().all() &&
         problem.upper.array().isInf().all();
}

/// A proximal weight for a start from nothing. A small one needs few steps. But with one smaller
/// still, the first step would end just within the tolerance, and no other would follow that gains
/// more digits.
constexpr double weightForced = 1e-7;
constexpr double disturbed = 1e-3;  ///< share of the demands that reactions leave open
constexpr int mostHolds = 40;       ///< steps of a hold
/// Unknowns whose dense matrix costs no more than the factor of their bodies.
constexpr int fewAlone = 36;

}  // namespace

/// All that comes before the first walk. Lost: the walk goes on from here.
template <class Motion>
Outcome Search::startOut(Engines<Motion>& engines, const Task& task, Solution& best) {
  const double demand = problem_->demand(), aim = keptShare * task.tolerance;
  const auto isReached = [&] { return best.residual <= task.tolerance; };
  held_.residual = infinity;
  if (task.isHurried && holdApart(engines, task, best)) return Outcome::Reached;
  if (!task.guess && !isLargeButNoHeap(*problem_)) {
    forceActiveSet(*problem_, map_.diagonal(), best.activeSet);
    const Outcome outcome = engines.walk.walkFromRegion(task.tolerance, weightForced,
                                                        task.regionsLeft(best, shortWalk), best);
    if (outcome != Outcome::Lost) return outcome;
  }
  if (!task.isHurried && hold(engines, task, best)) return Outcome::Reached;
  if (isDisturbedInPlaces(task, best)) {
    if (mendPlaces(task, best)) return Outcome::Reached;
    takeBack(engines);
  }
  if (task.options.economies.oneRegion && hasOneRegion(*problem_)) {
    const Outcome outcome =
        engines.walk.walk(task.tolerance, weightKnown, task.regionsLeft(best, shortWalk), best);
    if (outcome != Outcome::Lost) return outcome;
  } else if (react(engines, task, best)) {
    return Outcome::Reached;
  } else if (!task.guess && alternate(engines, task, best)) {
    return finish(engines, task, best);
  }
  if (task.isHurried) {
    sweepAll(task, aim, best);
    if (held_.residual < best.residual) best.takeReactions(held_);
    if (isReached()) return Outcome::Reached;
  } else if (best.residual > disturbed * demand && isHeap(*problem_)) {
    settle(task, aim, best);
    takeBack(engines);
    if (isReached()) return isLargeHeap(*problem_) ? Outcome::Reached : finish(engines, task, best);
  } else if (best.residual > disturbed * demand) {
    if (isLargeButNoHeap(*problem_))
      sweepWhileItGains(task, aim, best);
    else
      sweepAndLearn(task, aim, best);
    if (isReached()) return Outcome::Reached;
  }
  return Outcome::Lost;
}

/// Whether no contact presses with all the friction that it has.
bool Search::slidesNowhere(const VectorXd& r) const {
  constexpr double all = 1 - 1e-6;
  for (int i = 0; i < problem_->contacts(); ++i)
    if (r[3 * i] > 0 &&
        lengthOf(r[3 * i + 1], r[3 * i + 2]) >= all * problem_->friction[i] * r[3 * i])
      return false;
  return true;
}

/// Whether it is worth a region to hold all that touches. It is not where the last reactions slid
/// somewhere and regions are cheap, or few: then something will slide again.
bool Search::mayHold(const Task& task, const Solution& best) const {
  constexpr int fewContacts = 12;
  if (isHeap(*problem_) || task.regionsLeft(best) <= 0) return false;
  // Explicit entries of this size cost more to factor than few sweeps are worth.
  if (task.isHurried && isLargeButNoHeap(*problem_) && !problem_->W.inBodySpace()) return false;
  if (!task.isHurried && isLargeButNoHeap(*problem_)) return true;
  // Small islands without reactions of a last step hold all in their first region anyway, if there
  // may be others.
  return (task.guess || task.isHurried) && problem_->contacts() > fewContacts &&
         slidesNowhere(best.r);
}

/// Holds all that touches.
template <class Motion>
bool Search::hold(Engines<Motion>& engines, const Task& task, Solution& best) {
  const int most = task.sweepsLeft(best, mostHolds);
  if (most <= 0 || !mayHold(task, best)) return false;
  holdActiveSet(*problem_, map_.diagonal(), best.r, best.activeSet);
  return engines.forced.hold(task.tolerance, most, best);
}

/// The same for a budget of few sweeps. It costs a region and none of the sweeps: these are made as
/// if the hold had not been tried, and its result waits in held_.
template <class Motion>
bool Search::holdApart(Engines<Motion>& engines, const Task& task, Solution& best) {
  if (!mayHold(task, best)) return false;
  held_.takeReactions(best);
  held_.takeWork(best);
  holdActiveSet(*problem_, map_.diagonal(), held_.r, held_.activeSet);
  const bool isHeld = engines.forced.hold(task.tolerance, mostHolds, held_);
  best.regions = held_.regions;
  best.factorisations = held_.factorisations;
  if (isHeld) best.takeReactions(held_);
  return isHeld;
}

/// Newton's method on the few contacts that are left once joints are eliminated. With a budget of
/// few sweeps it costs a region and no sweeps, as `hold` does, and is used without joints, too;
/// with joints it then also sets out from nothing, since nothing else could take back reactions
/// that are far off, as those are that set a motor going.
bool Search::condense(const Task& task, Solution& best) {
  constexpr int few = 60;  // unknowns that joints leave
  const int sweeps = best.sweeps;
  const int most = task.isHurried ? CondensedNewton::mostSteps : task.sweepsLeft(best);
  if (most <= 0 || task.regionsLeft(best) <= 0) return false;
  CondensedNewton& newton = machines().condensed;
  if (!newton.setProblem(*problem_, map_, best.r, few)) return false;
  const bool isWorthIt = newton.hasHeld() ? task.options.economies.joints
                                          : task.isHurried && problem_->size() <= fewAlone;
  if (!isWorthIt) return false;
  bool isReached = newton.solve(task.tolerance, most, best);
  if (!isReached && task.isHurried && task.guess && newton.hasHeld()) {
    setOutApart(nullptr, best);
    isReached = newton.goOn(task.tolerance, most, apart_);
    comeBack(isReached ? Outcome::Reached : Outcome::Lost, best);
  }
  if (task.isHurried) best.sweeps = sweeps;
  return isReached;
}

/// Newton's method on reactions. If nothing is known, and so few contacts touch that a dense matrix
/// costs no more than the factor of their bodies, it uses that matrix. Otherwise it uses such
/// factors, unless there are so many contacts that some of them are always in a wrong region. Of
/// many contacts few are in a wrong one where the last reactions are nearly right, as those of a
/// pile that is carried along. Large heaps are left to sweeps and patches. Bodies that roll on
/// press nearly as in the last step: a few sweeps then cost less than a region.
template <class Motion>
bool Search::react(Engines<Motion>& engines, const Task& task, Solution& best) {
  constexpr int mostContacts = 300, fewSteps = 30, manySteps = 40, fewSweeps = 3;
  constexpr double nearlyRight = 0.1;  // share of the demands that the reactions leave open
  if (task.isHurried || task.regionsLeft(best) <= 0) return false;
  CondensedNewton& condensed = machines().condensed;
  if (!task.guess && condensed.setProblem(*problem_, map_, best.r, fewAlone))
    return condensed.solve(task.tolerance, task.sweepsLeft(best), best);
  // Contacts of large piles share loads in many ways; joints leave fewer.
  const bool hasMany = problem_->contacts() > mostContacts ||
                       (isLargeButNoHeap(*problem_) &&
                        (!task.guess || problem_->plainRows() < problem_->contacts()));
  const bool isNearlyRight =
      task.guess && best.residual <= nearlyRight * problem_->demand() && !isLargeHeap(*problem_);
  if (hasMany && !isNearlyRight) return false;
  if (!problem_->disks.empty() && task.guess &&
      sweepAndLearn(task, keptShare * task.tolerance, best, fewSweeps))
    return true;
  return engines.reactions.solve(
      task.tolerance, task.regionsLeft(best, task.guess ? fewSteps : manySteps), trial_, best);
}

/// Alternating directions. False if they do not reach the tolerance.
template <class Motion>
bool Search::alternate(Engines<Motion>& engines, const Task& task, Solution& best) {
  constexpr int alternations = 300;  // bring a large pile to rest
  if (task.isHurried) return false;
  const int most = task.sweepsLeft(best, alternations);
  return engines.alternation.alternate(keptShare * task.tolerance, most, best);
}

/// The error that is left after a few steps shrinks slowly; one step in the region that has been
/// found removes it.
template <class Motion>
Outcome Search::finish(Engines<Motion>& engines, const Task& task, Solution& best) {
  const int most = task.regionsLeft(best, fewRegions);
  const double aim = polishedShare * task.tolerance;
  if (best.residual > aim) engines.walk.polish(aim, weightKnown, most, best);
  return Outcome::Reached;
}

template Outcome Search::startOut(Engines<BodyMotion>&, const Task&, Solution&);
template Outcome Search::startOut(Engines<FactoredMotion>&, const Task&, Solution&);

}  // namespace delassus
