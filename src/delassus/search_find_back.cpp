/// What the search does after a walk that has lost its way.
#include <algorithm>
#include <type_traits>

#include "delassus/pile_kind.h"
#include "delassus/search.h"

namespace delassus {

template <class Motion>
Outcome Search::findBack(Engines<Motion>& engines, const Problem& problem, const Options& options,
                         double tolerance, const VectorXd* guess, Solution& best) {
  constexpr int proof = 90, interiorSteps = 40, longWalk = 400;
  const bool isSmall = !isLargeHeap(problem) && !isLargePile(problem);
  ProximalNewton<Motion>& newton = engines.walk;
  const auto left = [&](int most) { return std::min(most, options.newtonBudget - best.regions); };
  if (left(1) <= 0) return Outcome::Lost;
  if (compromise(engines, problem, tolerance, left(proof), best)) return Outcome::Incompatible;
  const auto walk = [&](int most) {
    return newton.walk(problem, tolerance, proximalWeight(problem, best, 1e-4), left(most), best);
  };
  Outcome outcome = isSmall ? walk(fairWalk) : Outcome::Lost;
  if (outcome != Outcome::Lost || left(1) <= 0) return outcome;
  if (engines.interior.solve(newton.motion(), problem, map_, tolerance, left(interiorSteps), best))
    return Outcome::Reached;
  outcome = walk(longWalk);
  return outcome == Outcome::Lost ? wander(engines, problem, options, tolerance, guess, best)
                                  : outcome;
}

/// The answer, in softAnswer_, for bodies that are as little compliant where they touch as sweeps and a short walk can find it;
/// returns how compliant, in W_aa, or 0 if they find none.
double Search::soften(const Problem& problem, const Options& options, Solution& best) {
  constexpr double softest = 1, hardest = 1e-5, finer = 0.3162, tolerance = 1e-10;
  constexpr int sweeps = 1000, regions = 60;
  Options few = options;
  few.sweepBudget = sweeps;
  few.newtonBudget = regions;
  few.pathBudget = 0;
  soft_.q = problem.q;
  soft_.friction = problem.friction;
  soft_.lower = problem.lower;
  soft_.upper = problem.upper;
  soft_.disks = problem.disks;
  soft_.roundOff = problem.roundOff;
  BodySpace& space = soft_.W.refill(problem.size());
  space = problem.W.bodySpace();
  map_.meanDiagonal(felt_);
  const double demand = problem.q.cwiseAbs().maxCoeff();
  if (!softSearch_) softSearch_.reset(new Search(machines()));
  double found = 0;
  for (double compliance = softest; compliance > hardest; compliance *= finer) {
    space.compliance = problem.W.bodySpace().compliance + compliance * felt_;
    softSearch_->setProblem(soft_);
    softAnswer_.start(soft_.q);
    softSearch_->offer(soft_, softStart_, softAnswer_);
    const Outcome outcome =
        softSearch_->walk(soft_, few, tolerance * demand, &softStart_, softAnswer_);
    best.factorisations += softAnswer_.factorisations;
    best.sweeps += softAnswer_.sweeps;
    if (outcome != Outcome::Reached) break;
    softStart_ = softAnswer_.r;
    found = compliance;
  }
  return found;
}

/// Stands on the path of compliance: at bodies that are so compliant where they touch that their answer is found. In islands of
/// thousands that one compliance would have to turn back and forth for each of the places where something is wedged, whatever the others
/// do; there it begins at the best answer so far.
bool Search::setOutOnPath(ProximalNewton<BodyMotion>& newton, const Problem& problem,
                          const Options& options, int budget, const VectorXd* guess,
                          Solution& best) {
  constexpr double moderate = 1e-2, soft = 1;
  const bool isLarge = isLargeHeap(problem);
  double softness = moderate;
  if (!isLarge) {
    softStart_.setZero(problem.size());
    if (guess) softStart_ = *guess;
    softness = soften(problem, options, best);
    if (softness == 0) return false;
  }
  newton.setProblem(problem, map_);
  CompliancePath& path = machines().path;
  path.setProblem(newton.motion(), problem, map_);
  if (!isLarge) return path.setOut(softStart_, softness, budget, best);
  path.setCenter(best);
  return path.setOut(best.r, softness, budget, best) || path.setOut(best.r, soft, budget, best);
}

/// Along the path of compliance to rigid bodies, and a walk from the answers of those that are nearly rigid. Not in large piles, where it
/// takes ten thousands of factors and gains next to nothing.
template <class Motion>
Outcome Search::harden(ProximalNewton<Motion>& newton, const Problem& problem,
                       const Options& options, double tolerance, const VectorXd* guess,
                       Solution& best) {
  constexpr double nearlyRigid = 1e-5, rigid = 1e-8, finest = 1e-7;
  constexpr int few = 600, regions = 60;
  if constexpr (std::is_same_v<Motion, BodyMotion>) {
    const int parts = problem.contacts() + problem.rows();
    const int budget = static_cast<int>(options.pathBudget * std::min(1.0, double(few) / parts));
    if (budget <= 0 || isLargePile(problem) || !CompliancePath::canFollow(problem))
      return Outcome::Lost;
    const int begun = best.factorisations, walked = best.regions;
    if (!setOutOnPath(newton, problem, options, budget, guess, best)) return Outcome::Lost;
    CompliancePath& path = machines().path;
    for (double compliance = nearlyRigid; compliance >= rigid; compliance *= 0.1) {
      if (!path.descend(compliance, budget - (best.factorisations - begun), best))
        return Outcome::Lost;
      wandering_.r = path.reactions();
      consider(wandering_, best);
      newton.motion();  // its factor is that of the path
      const double weight = std::max(compliance, finest);
      const Outcome outcome =
          newton.walkFrom(wandering_, problem, tolerance, weight, regions, best);
      best.regions = walked;
      if (outcome != Outcome::Lost) return outcome;
    }
  }
  return Outcome::Lost;
}

/// Plain sweeps by the thousand from where the step began, or from nothing, and a walk from where they come to; then on from where that
/// walk came to, if it is nearer than any before it.
///
/// A heap of spheres has as many contacts as motions, and stresses that grow by the same little in every sweep until a contact
/// slips; which one is next depends on all that slipped before. What hurries sweeps runs past that order and ends far from any
/// answer, though its residual is small. Plain sweeps go through it slip after slip, as the heap does. Where those from the last
/// reactions go round for ever, those from nothing, which squeezes nowhere, may come to an end.
template <class Motion>
Outcome Search::outlast(ProximalNewton<Motion>& newton, const Problem& problem,
                        const Options& options, double tolerance, const VectorXd* guess,
                        Solution& best) {
  constexpr int manySweeps = 2000, regions = 50;
  setOutApart(problem, guess, best);
  wandering_.r = apart_.r;
  Outcome outcome = Outcome::Lost;
  // The first residual may be small and far from any answer.
  apart_.residual = infinity;
  while (outcome == Outcome::Lost) {
    const int sweepsLeft = std::min(manySweeps, options.sweepBudget - apart_.sweeps);
    const int regionsLeft = std::min(regions, options.newtonBudget - apart_.regions);
    if (sweepsLeft <= 0 || regionsLeft <= 0) break;
    if (setSweeps(problem, true))
      machines().coloured.sweepPlainly(problem, sweepsLeft, wandering_.r);
    else
      machines().sweeps.sweepPlainly(problem, sweepsLeft, wandering_.r);
    apart_.sweeps += sweepsLeft;
    consider(wandering_, apart_);
    const double before = apart_.residual;
    newton.setProblem(problem, map_);
    outcome = newton.walkFrom(wandering_, problem, tolerance,
                              proximalWeight(problem, wandering_, 1e-4), regionsLeft, apart_);
    if (apart_.residual < before) wandering_.r = apart_.r;
  }
  return comeBack(outcome, best);
}

/// Where demands are proven incompatible, `best` is the compromise, that of bodies a little compliant where they touch, friction
/// included, and names those that quarrel. Explicit entries tell it by reactions that grow (ProximalNewton::converge).
template <class Motion>
bool Search::compromise(Engines<Motion>& engines, const Problem& problem, double tolerance,
                        int regionBudget, Solution& best) {
  constexpr double compliances[] = {1e-6, 1e-4, 1e-2};  // relative to W_aa
  constexpr double negligible = 0.1;  // share of the largest push, in the norm of its energy
  if constexpr (std::is_same_v<Motion, BodyMotion>) {
    ProximalNewton<Motion>& newton = engines.walk;
    const bool areIncompatible =
        quarrel_.find(newton, problem, map_, tolerance, regionBudget, trial_, best);
    newton.setProblem(problem, map_);
    if (!areIncompatible) return false;
    for (const double compliance : compliances)
      if (newton.yield(problem, tolerance, compliance, regionBudget, best)) break;
    // In the mean over its directions: what moves nothing along its normal may be asked to, and is named then.
    map_.meanDiagonal(felt_);
    felt_ = felt_.cwiseSqrt().cwiseProduct(quarrel_.reactions()).cwiseAbs();
    const double least = negligible * felt_.maxCoeff();
    best.blamed.clear();
    for (int at = 0; at < problem.size(); ++at)
      if (felt_[at] > least) best.blamed.push_back(at);
    // Who cannot be moved at all is not felt.
    if (best.blamed.empty()) best.blamed.push_back(map_.residual(best.r, best.u).worst);
    return true;
  }
  return false;
}

/// Two ways on, in turn. Sweeps and patches mend the best answer and the walk goes on from there. And since what is near in
/// residual may be far from any answer, sweeps set out anew from where the step began, go on whether or not they better
/// the best answer, further each time, and a short walk is tried from wherever they are.
template <class Motion>
Outcome Search::wander(Engines<Motion>& engines, const Problem& problem, const Options& options,
                       double tolerance, const VectorXd* guess, Solution& best) {
  ProximalNewton<Motion>& newton = engines.walk;
  constexpr int shortest = 100, longest = 3200, longWalk = 400, tryFromAfar = 40;
  const auto sweepsLeft = [&](int most) {
    return std::min(most, options.sweepBudget - best.sweeps);
  };
  const auto regionsLeft = [&](int most) {
    return std::min(most, options.newtonBudget - best.regions);
  };
  wandering_.r.setZero(problem.size());
  if (guess) wandering_.r = *guess;
  makeFeasible(problem, wandering_.r);
  for (int length = shortest; sweepsLeft(1) > 0 && regionsLeft(1) > 0;
       length = std::min(2 * length, longest)) {
    if (isLargePile(problem))
      sweepWhileItGains(problem, options, keptShare * tolerance, best);
    else
      settle(problem, options, keptShare * tolerance, best);
    if (best.residual <= tolerance) return Outcome::Reached;
    newton.setProblem(problem, map_);
    Outcome outcome = newton.walk(problem, tolerance, unknownRegion, regionsLeft(longWalk), best);
    if (outcome != Outcome::Lost) return outcome;

    const int count = sweepsLeft(length);
    machines().sweeps.setProblem(problem, map_);
    machines().sweeps.sweep(problem, count, wandering_.r);
    best.sweeps += count;
    consider(wandering_, best);
    outcome =
        newton.walkFrom(wandering_, problem, tolerance, proximalWeight(problem, wandering_, 1e-4),
                        regionsLeft(tryFromAfar), best);
    if (outcome != Outcome::Lost) return outcome;
  }
  return Outcome::Lost;
}

template Outcome Search::findBack(Engines<BodyMotion>&, const Problem&, const Options&, double,
                                  const VectorXd*, Solution&);
template Outcome Search::findBack(Engines<FactoredMotion>&, const Problem&, const Options&, double,
                                  const VectorXd*, Solution&);
template Outcome Search::harden(ProximalNewton<BodyMotion>&, const Problem&, const Options&, double,
                                const VectorXd*, Solution&);
template Outcome Search::harden(ProximalNewton<FactoredMotion>&, const Problem&, const Options&,
                                double, const VectorXd*, Solution&);
template Outcome Search::outlast(ProximalNewton<BodyMotion>&, const Problem&, const Options&,
                                 double, const VectorXd*, Solution&);
template Outcome Search::outlast(ProximalNewton<FactoredMotion>&, const Problem&, const Options&,
                                 double, const VectorXd*, Solution&);

}  // namespace delassus
