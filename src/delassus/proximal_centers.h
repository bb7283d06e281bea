#pragma once

#include <algorithm>
#include <cmath>

#include "delassus/options.h"
#include "delassus/problem.h"
#include "delassus/proximal_weight.h"
#include "delassus/residual.h"
#include "delassus/solution.h"

namespace delassus {

/// The result of a series of Newton steps.
struct Descent {
  bool isFound;
  int steps;  ///< number made
};

/// Makes Newton steps of full length until the error is at most `enough`, or `budget` steps are
/// made. Where reactions must go far in directions that hardly move anything, and cones bend the
/// way, a step may end nearer to the answer but with a larger error. A few more steps tell whether
/// it was a good one. If none of these gains, the descent ends where the error was least.
///
/// `steps` offers error(); step(error), which returns false and changes nothing if the matrix is
/// singular; keepLast(), which keeps the point where the last step began; and goBack() to that
/// point.
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

/// Moves the center r_k of a proximal method, which replaces u by u + α W_aa (r − r_k) and then
/// takes r_k ← r. The fixed points do not depend on α. α shrinks where progress is slow, and grows
/// where no r is found.
///
/// Starts from `best`. The answer is found when its natural residual is at most `tolerance` (m/s);
/// some more digits are taken if they come by themselves. Gives up after `budget` steps, or when
/// two moves gain little. `moveOn` is a descent around a center to the next one, whose u and
/// residual it completes:
///
///     Descent moveOn(const Solution& center, double alpha, double enough, int budget,
///                    Solution& next)
///
/// `next` is scratch for it.
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
    // Some more digits if they come by themselves.
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
