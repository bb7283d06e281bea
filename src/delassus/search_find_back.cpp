/// What the search does after a walk that has lost its way.
#include <algorithm>

#include "delassus/pile_kind.h"
#include "delassus/search.h"

namespace delassus {

template <class Motion>
Outcome Search::findBack(Engines<Motion>& engines, const Task& task, Solution& best) {
  constexpr int proof = 90, interiorSteps = 40, longInPiles = 1000;
  const bool isSmall = !isLargeHeap(*problem_) && !isLargeButNoHeap(*problem_);
  if (task.regionsLeft(best) <= 0) return Outcome::Lost;
  if (proveIncompatible(task.tolerance, task.regionsLeft(best, proof), best))
    return Outcome::Incompatible;
  const auto walk = [&](int most) {
    return engines.walk.walk(task.tolerance, firstWeight(best, leastWeightAfar),
                             task.regionsLeft(best, most), best);
  };
  Outcome outcome = isSmall ? walk(fairWalk) : Outcome::Lost;
  if (outcome != Outcome::Lost || task.regionsLeft(best) <= 0) return outcome;
  if (engines.interior.solve(engines.space.lendMotion(), *problem_, map_, task.tolerance,
                             task.regionsLeft(best, interiorSteps), best))
    return Outcome::Reached;
  const int patience = isLargeButNoHeap(*problem_) ? longInPiles : longWalk;
  outcome = engines.walk.walkOn(task.tolerance, firstWeight(best, leastWeightAfar),
                                task.regionsLeft(best, patience),
                                task.options.newtonBudget - best.regions, best);
  return outcome == Outcome::Lost ? wander(engines, task, best) : outcome;
}

/// Makes plain sweeps by the thousand, from nothing and then from half and from all of the last
/// reactions, and walks from where they lead.
///
/// A heap of spheres has as many contacts as motions. Its stresses grow by the same small amount in
/// every sweep until a contact slips, and which contact slips next depends on all slips before.
/// Accelerated sweeps run past that order and end far from any answer, though their residual is
/// small. Plain sweeps go through it slip after slip, as the heap does. The last reactions may
/// squeeze it so that sweeps go round for ever: of 20 steps in a wedged bin whose first walk was
/// lost, sweeps from nothing ended 10 and those from the last reactions 5. In another sample, of 25
/// steps that both a walk and the last reactions had lost, half of these ended 6. For body space
/// only, as plain sweeps are. Without last reactions it uses no more than its first third: `wander`
/// has the rest.
Outcome Search::outlast(const Task& task, Solution& best) {
  constexpr double shares[] = {0, 0.5, 1};
  int startsLeft = 3;
  for (const double share : shares) {
    if ((share > 0 && !task.guess) || task.sweepsLeft(best) <= 0) break;
    wandering_.r.setZero(problem_->size());
    if (share > 0) wandering_.r = share * *task.guess;
    setOutApart(&wandering_.r, best);
    Task one = task;
    one.options.sweepBudget = best.sweeps + task.sweepsLeft(best) / startsLeft--;
    const Outcome outcome = comeBack(sweepAndWalk(one), best);
    if (outcome != Outcome::Lost) return outcome;
  }
  return Outcome::Lost;
}

/// Goes on from the end of a walk if that is nearer than any before. Few of the walks that set out
/// from far off meet an answer (4 of 158 with 50 regions in a wedged bin, but 16 of 35 from within
/// reach), and there a few regions lead as far as many.
Outcome Search::sweepAndWalk(const Task& task) {
  constexpr int manySweeps = 2000, regions = 50, aNudge = 10;
  Engines<BodyMotion>& engines = machines().bodies;
  wandering_.r = apart_.r;
  Outcome outcome = Outcome::Lost;
  // The first residual may be small and far from any answer.
  apart_.residual = infinity;
  while (outcome == Outcome::Lost) {
    const int sweepsLeft = task.sweepsLeft(apart_, manySweeps);
    const int regionsLeft = task.regionsLeft(apart_, regions);
    if (sweepsLeft <= 0 || regionsLeft <= 0) break;
    if (setSweeps(true))
      machines().coloured.sweepPlainly(sweepsLeft, wandering_.r);
    else
      machines().sweeps.sweepPlainly(sweepsLeft, wandering_.r);
    apart_.sweeps += sweepsLeft;
    consider(wandering_, apart_);
    const double before = apart_.residual;
    const int most = isFar(wandering_) ? std::min(regionsLeft, aNudge) : regionsLeft;
    outcome = engines.walk.walkFrom(wandering_, task.tolerance,
                                    firstWeight(wandering_, leastWeightAfar), most, apart_);
    if (apart_.residual < before) wandering_.r = apart_.r;
  }
  return outcome;
}

/// Where demands are proven incompatible, `best` becomes a compromise and names the parts that
/// quarrel. Explicit entries have no proof: there growing reactions tell it
/// (ProximalWalk::converge).
bool Search::proveIncompatible(double tolerance, int regionBudget, Solution& best) {
  constexpr double negligible = 0.1;  // share of the largest push, in the norm of its energy
  if (!problem_->W.inBodySpace()) return false;
  Engines<BodyMotion>& engines = machines().bodies;
  const bool areIncompatible =
      proof_.find(engines.walk, *problem_, map_, tolerance, best.r, regionBudget, trial_, best);
  takeBack(engines);
  if (!areIncompatible) return false;
  compromise(tolerance, regionBudget, best);
  // Weighted by the mean over the directions of each part: so a contact is also named if it is
  // asked to move along its normal, where nothing moves it.
  map_.meanDiagonal(felt_);
  felt_ = felt_.cwiseSqrt().cwiseProduct(proof_.reactions()).cwiseAbs();
  const double least = negligible * felt_.maxCoeff();
  best.blamed.clear();
  for (int at = 0; at < problem_->size(); ++at)
    if (felt_[at] > least) best.blamed.push_back(at);
  // A part that cannot be moved at all does not show here.
  if (best.blamed.empty()) best.blamed.push_back(map_.error(best.r, best.u).worst);
  return true;
}

/// Takes the reactions of bodies that are a little compliant where they touch, friction included,
/// instead of those that the search was left with, which may be of any size. The compliance is so
/// small that the bodies give less under their loads than under the quarrel. If these reactions are
/// found neither from the motion that the search was left with nor from the free one, softer bodies
/// lead to them. They are not taken if they are much further from the law.
void Search::compromise(double tolerance, int regionBudget, Solution& best) {
  constexpr double share = 0.1, least = 1e-9, most = 1e-6, softest = 1e-2;  // relative to W_aa
  constexpr double harder = 0.1, nearly = 10;
  Engines<BodyMotion>& engines = machines().bodies;
  const double wanted = std::clamp(share * proof_.missed() / problem_->demand(), least, most);
  const double leastFound = best.residual;
  const auto find = [&](double compliance, const VectorXd& start) {
    trial_.start(problem_->q);
    const bool isFound =
        engines.walk.answerCompliant(tolerance, compliance, start, regionBudget, trial_);
    best.addWork(trial_);
    return isFound;
  };
  const auto take = [&] {
    if (trial_.residual > nearly * leastFound) return false;
    best.takeReactions(trial_);
    return true;
  };
  if (find(wanted, best.r) && take()) return;
  wandering_.r.setZero(problem_->size());
  if (find(wanted, wandering_.r) && take()) return;
  for (double compliance = softest; find(compliance, wandering_.r) && compliance > wanted;) {
    take();
    wandering_.r = trial_.r;
    compliance = std::max(wanted, harder * compliance);
  }
  take();
  // If none of these reactions are near, the search had not come near either, and walks on.
  if (best.residual > nearly * proof_.missed())
    engines.walk.walk(tolerance, firstWeight(best, leastWeightAfar),
                      std::min(fairWalk, regionBudget), best);
}

/// Goes on in two ways, by turns. In one, sweeps and patches mend the best answer, and the walk
/// goes on from there. But an answer of small residual may be far from any solution. So in the
/// other, sweeps set out anew from where the step began and go on, further each time, whether or
/// not they better the best answer; a short walk is tried from wherever they are.
template <class Motion>
Outcome Search::wander(Engines<Motion>& engines, const Task& task, Solution& best) {
  constexpr int shortest = 100, longest = 3200, tryFromAfar = 40;
  const auto sweepsLeft = [&](int most) { return task.sweepsLeft(best, most); };
  const auto regionsLeft = [&](int most) { return task.regionsLeft(best, most); };
  wandering_.r.setZero(problem_->size());
  if (task.guess) wandering_.r = *task.guess;
  makeFeasible(*problem_, wandering_.r);
  for (int length = shortest; sweepsLeft(1) > 0 && regionsLeft(1) > 0;
       length = std::min(2 * length, longest)) {
    if (isLargeButNoHeap(*problem_))
      sweepWhileItGains(task, keptShare * task.tolerance, best);
    else
      settle(task, keptShare * task.tolerance, best);
    if (best.residual <= task.tolerance) return Outcome::Reached;
    takeBack(engines);
    Outcome outcome = engines.walk.walk(task.tolerance, weightUnknown, regionsLeft(longWalk), best);
    if (outcome != Outcome::Lost) return outcome;

    const int count = sweepsLeft(length);
    machines().sweeps.setProblem(*problem_, map_);
    machines().sweeps.sweep(count, wandering_.r);
    best.sweeps += count;
    consider(wandering_, best);
    outcome =
        engines.walk.walkFrom(wandering_, task.tolerance, firstWeight(wandering_, leastWeightAfar),
                              regionsLeft(tryFromAfar), best);
    if (outcome != Outcome::Lost) return outcome;
  }
  return Outcome::Lost;
}

template Outcome Search::findBack(Engines<BodyMotion>&, const Task&, Solution&);
template Outcome Search::findBack(Engines<FactoredMotion>&, const Task&, Solution&);

}  // namespace delassus
