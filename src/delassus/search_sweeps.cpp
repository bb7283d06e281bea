/// The sweeps of the search, before and between walks, and patches in between.
#include <algorithm>
#include <cmath>

#include "delassus/pile_kind.h"
#include "delassus/search.h"

namespace delassus {

/// Makes sweeps that remember a few steps, at most `most`, as long as they soon halve the residual:
/// a factor costs as much as tens of sweeps, where W is explicit as hundreds. With a longer memory
/// more regions are needed after a blow. True if the sweeps reach the tolerance.
bool Search::sweepAndLearn(const Task& task, double tolerance, Solution& best, int most) {
  constexpr int shortest = 3, longest = 10;  // from one look at the residual to the next
  constexpr int patience = 20, memory = 5;
  constexpr double gain = 0.5;
  machines().sweeps.setProblem(*problem_, map_);
  trial_.r = best.r;
  double mark = best.residualRms;
  int idle = 0, made = 0;
  for (int burst = shortest; burst <= task.sweepsLeft(best, most - made) && idle < patience;
       burst = std::min(2 * burst, longest)) {
    machines().sweeps.sweepOn(burst, memory, trial_.r);
    best.sweeps += burst;
    made += burst;
    consider(trial_, best);
    if (best.residual <= tolerance) return true;
    idle += burst;
    if (trial_.residualRms < gain * mark) mark = trial_.residualRms, idle = 0;
  }
  return false;
}

/// Makes all sweeps of the budget, one after the other, whether or not they gain, as sequential
/// impulses do. Like these, it begins from a little less than the reactions of the last step, if
/// nothing has bettered them yet: with the full reactions, errors that remain would let a pile
/// swing for ever. Many contacts go by colour.
///
/// A single sweep leaves reactions that the single sweep of the next step does not mend. It begins
/// from nothing if that is nearer to an answer and there are no joints to hold. With two or more
/// sweeps the last reactions are worth more.
void Search::sweepAll(const Task& task, double tolerance, Solution& best) {
  constexpr int burst = 10, many = 50, worthColours = 3;
  constexpr double trusted = 0.8, spoilt = 1.5;
  const auto beginFrom = [&](double share) {
    trial_.r = share * best.r;
    trial_.u = problem_->q + share * (best.u - problem_->q);
  };
  const auto errorFrom = [&](double share) {
    beginFrom(share);
    return map_.error(trial_.r, trial_.u).rms;
  };
  double share =
      task.guess && best.sweeps == 0 && !(best.residual < best.startResidual) ? trusted : 1;
  if (share < 1 && task.sweepsLeft(best) == 1 && problem_->rows() == 0 &&
      errorFrom(share) > spoilt * errorFrom(0))
    share = 0;
  beginFrom(share);
  const bool byColour =
      setSweeps(problem_->contacts() > many && task.sweepsLeft(best) >= worthColours);
  while (task.sweepsLeft(best) > 0 && best.residual > tolerance) {
    const int count = task.sweepsLeft(best, burst);
    if (byColour)
      machines().coloured.sweep(count, 0, trial_.u, trial_.r);
    else
      machines().sweeps.sweep(count, trial_.r);
    best.sweeps += count;
    consider(trial_, best);
  }
}

/// By colour where possible: such sweeps cost a third.
void Search::sweepWhileItGains(const Task& task, double tolerance, Solution& best) {
  constexpr int fewSweeps = 20, manySweeps = 100;
  constexpr double gain = 0.7;
  const bool byColour = setSweeps(true);
  const int burst = byColour ? manySweeps : fewSweeps;
  double before = infinity;
  while (best.residual < gain * before && best.residual > tolerance &&
         burst <= task.sweepsLeft(best)) {
    before = best.residual;
    trial_.r = best.r;
    int made = burst;
    if (byColour)
      made = machines().coloured.sweep(burst, tolerance, best.u, trial_.r);
    else
      machines().sweeps.sweep(burst, trial_.r);
    best.sweeps += made;
    consider(trial_, best);
  }
}

/// Makes sweeps as long as they gain, and where they do not, solves patches: an island that settles
/// in this way needs no factor of the whole. The residual may rise on the way, since a contact that
/// meets a wall lets others go. In heaps of many contacts the sweeps go by colour.
void Search::settle(const Task& task, double tolerance, Solution& best) {
  constexpr int patience = 6, fewSweeps = 20, manySweeps = 100, many = 200, rings = 1;
  constexpr double gain = 0.7, outstanding = 3, largestShare = 0.25, fine = 0.1;
  // The longest memory halves the sweeps; outside heaps its storage is worth more than that time.
  const int memory = isHeap(*problem_) ? Anderson::longest : 4;
  const bool byColour = setSweeps(isHeap(*problem_) && problem_->contacts() > many);
  const int burst = byColour ? manySweeps : fewSweeps;
  double change = tolerance;  // of a velocity, for which a sweep by colour is worth while
  trial_.r = best.r;
  measure(trial_);
  double lowest = infinity;
  for (int failures = 0; failures < patience;) {
    bool gains;
    do {
      if (burst > task.sweepsLeft(best)) return;
      const double before = trial_.residualRms;
      int made = burst;
      if (byColour)
        made = machines().coloured.sweep(burst, change, trial_.u, trial_.r);
      else
        machines().sweeps.sweepOn(burst, memory, trial_.r);
      best.sweeps += made;
      consider(trial_, best);
      if (best.residual <= tolerance) return;
      if (made < burst) change *= gain * gain;
      gains = trial_.residualRms < gain * before;
    } while (gains);
    failures = trial_.residualRms < gain * lowest ? 0 : failures + 1;
    lowest = std::min(lowest, trial_.residualRms);
    // Patches that do not help are tried with more around them.
    const double above = outstanding / (1 + failures) * trial_.residualRms;
    const PatchesAbout about{std::max(above, tolerance), rings, largestShare, fine * tolerance};
    if (!mendPatches(task, about, trial_, best)) return;
    setSweeps(byColour);  // since patches may have been swept
    consider(trial_, best);
  }
}

/// Prepares sweeps by colour, if these are allowed and possible, or else other sweeps. True: by
/// colour.
bool Search::setSweeps(bool mayGoByColour) {
  if (mayGoByColour && machines().coloured.setProblem(*problem_, map_)) return true;
  machines().sweeps.setProblem(*problem_, map_);
  return false;
}

}  // namespace delassus
