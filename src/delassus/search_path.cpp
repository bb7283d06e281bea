/// The last resort of the search: bodies that are soft where they touch, and the path of compliance
/// from them to rigid ones.
#include <algorithm>

#include "delassus/pile_kind.h"
#include "delassus/search.h"

namespace delassus {

/// Moves onto the path of compliance, where bodies are so compliant at their contacts that their
/// answer is found. In islands of thousands of contacts one compliance for all would have to turn
/// back and forth for each place where something is wedged, whatever the other places do. There the
/// path begins at the best answer so far.
bool Search::setOutOnPath(const Task& task, int budget, Solution& best) {
  constexpr double moderate = 1e-2, soft = 1;
  Engines<BodyMotion>& engines = machines().bodies;
  const bool isLarge = isLargeHeap(*problem_);
  double softness = moderate;
  if (!isLarge) {
    variedStart_.setZero(problem_->size());
    if (task.guess) variedStart_ = *task.guess;
    softness = soften(task, best);
    if (softness == 0) return false;
  }
  takeBack(engines);
  CompliancePath& path = machines().path;
  path.setProblem(engines.space.lendMotion(), *problem_, map_);
  if (!isLarge) return path.setOut(variedStart_, softness, budget, best);
  path.setCenter(best);
  return path.setOut(best.r, softness, budget, best) || path.setOut(best.r, soft, budget, best);
}

/// Follows the path of compliance to rigid bodies, and walks from the answers for those that are
/// nearly rigid. Not in large piles, where the path takes tens of thousands of factors and gains
/// next to nothing.
Outcome Search::harden(const Task& task, Solution& best) {
  constexpr double nearlyRigid = 1e-5, rigid = 1e-8, finest = 1e-7;
  constexpr int few = 600, regions = 60;
  const double smaller = std::min(1.0, double(few) / problem_->parts());
  const int budget = static_cast<int>(task.options.pathBudget * smaller * smaller);
  if (budget <= 0 || isLargeButNoHeap(*problem_) || !CompliancePath::canFollow(*problem_))
    return Outcome::Lost;
  const int begun = best.factorisations, walked = best.regions;
  if (!setOutOnPath(task, budget, best)) return Outcome::Lost;
  Engines<BodyMotion>& engines = machines().bodies;
  CompliancePath& path = machines().path;
  for (double compliance = nearlyRigid; compliance >= rigid; compliance *= 0.1) {
    if (!path.descend(compliance, budget - (best.factorisations - begun), best))
      return Outcome::Lost;
    wandering_.r = path.reactions();
    consider(wandering_, best);
    engines.space.forgetFactor();  // the path has factored in the same space
    const double weight = std::max(compliance, finest);
    const Outcome outcome =
        engines.walk.walkFrom(wandering_, task.tolerance, weight, regions, best);
    best.regions = walked;
    if (outcome != Outcome::Lost) return outcome;
  }
  return Outcome::Lost;
}

}  // namespace delassus
