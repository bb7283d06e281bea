#pragma once

#include <algorithm>
#include <cmath>

#include "delassus/options.h"
#include "delassus/problem.h"
#include "delassus/proximal_weight.h"
#include "delassus/residual.h"
#include "delassus/solution.h"

namespace delassus {

/// What Newton steps came to.
struct Descent {
  bool isFound;
  int steps;  ///< that were made
};

/// Newton steps of full length until the error is at most `enough`, or `budget` steps are made.
/// Where reactions have far to go along what hardly moves anything, with cones that bend the way, a
/// step that ends nearer to the answer misses the law by more than its beginning: some steps more
/// tell whether it was a good one. If none of these gains, it ends where the error was least.
///
/// `steps` offers error(), step(error), which is false and changes nothing where the matrix is
/// singular, keepLast(), which keeps what the last step began from, and goBack() to what was kept.
template <class Steps>
Descent descend(Steps& steps, double enough, int budget) {
  constexpr int patience = 4;
  constexpr double tooFar = 1e6;
  double error = steps.error(), least = error;
  int made = 0, idle = 0;
  while (made < budget && error > enough) {
    ++made;
    if (!steps.step(error)) break;
    if (error < least) {
      least = error;
      idle = 0;
      continue;
    }
    if (++idle == 1) steps.keepLast();
    if (idle > patience || !(error < tooFar * least)) break;
  }
  if (idle > 0) steps.goBack();
  return {least <= enough, made};
}

/// Moves the center r_k of a proximal method, which takes u + α W_aa (r − r_k) for u: then r_k ← r.
/// The fixed points know nothing of α. It shrinks where that is slow, and grows where no r is
/// found.
///
/// From `best`, until its natural residual is at most `tolerance` (m/s), or some digits less where
/// they come by themselves: found; or until `budget` steps are made, or two moves gain little.
/// `moveOn` is a descent around a center to the next one, which it completes:
///
///     Descent moveOn(const Solution& center, double alpha, double enough, int budget,
///                    Solution& next)
///
/// `next` is room for it.
template <class MoveOn>
Descent moveCenters(const MoveOn& moveOn, const NaturalMap& map, double tolerance, int budget,
                    Solution& next, Solution& best) {
  constexpr double firstWeight = 1e-3, leastWeight = 1e-10, mostWeight = 1e-1;
  constexpr double fine = 1e-2, slow = 1e-2, tooSlow = 0.3;  // shares of the residual
  constexpr double gain = 0.5;
  constexpr int patience = 2;
  ProximalWeight alpha(firstWeight, leastWeight, mostWeight);
  double mark = best.residual;
  int made = 0, idle = 0;
  while (made < budget) {
    const double before = best.residual;
    const double enough =
        std::max(fine * std::max(before, polishedShare * tolerance), map.roundOff(best.r));
    const Descent descent = moveOn(best, alpha.value(), enough, budget - made, next);
    made += descent.steps;
    const double now = next.residual;
    if (now < before) best.takeReactions(next);
    // Some digits more if they come by themselves.
    const double aim = now > tooSlow * before ? tolerance : polishedShare * tolerance;
    if (best.residual <= std::max(aim, map.roundOff(best.r))) return {true, made};
    ++idle;
    if (best.residual < gain * mark) mark = best.residual, idle = 0;
    if (idle >= patience) break;
    if (!descent.isFound || !(now < before)) {
      if (alpha.isMost()) break;
      alpha.grow();
      continue;
    }
    if (now > tooSlow * before && alpha.isLeast()) break;
    alpha.learn(true);
    if (now > slow * before) alpha.shrink();
  }
  return {best.residual <= tolerance, made};
}

}  // namespace delassus
