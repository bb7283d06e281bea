/// Patches of an island, solved apart: between sweeps, and where little is disturbed.
#include <algorithm>
#include <cmath>

#include "delassus/pile_kind.h"
#include "delassus/search.h"

namespace delassus {
namespace {

/// Takes the whole part of a sum of shares of work.
int takeWhole(double& sum) {
  const double whole = std::floor(sum);
  sum -= whole;
  return static_cast<int>(whole);
}

}  // namespace

/// Finds the patches about the parts that `about` asks for. The threshold doubles until no patch is
/// too large.
void Search::findPatches(const PatchesAbout& about, const Solution& unsettled) {
  map_.residuals(unsettled.r, unsettled.u, residuals_);
  const double largest = about.largestShare * static_cast<double>(residuals_.size());
  const auto areSmall = [&] {
    for (int k = 0; k < patches_.count(); ++k)
      if (patches_.partsOf(k) > largest) return false;
    return true;
  };
  for (double threshold = about.above;; threshold *= 2) {
    patches_.find(*problem_, residuals_, threshold, about.rings);
    if (areSmall()) return;
  }
}

/// Solves the patches, and puts their reactions in the place of those in `unsettled`. Their work is
/// counted in `best`: a sweep by the patch's share of the island, a region by this share to the
/// power 3/2, as a factor costs in a flat pile (George 1973). False if there were no patches, or no
/// work is left. No patches are made in islands of few parts, with explicit W, and within patches
/// or varied problems.
bool Search::mendPatches(const Task& task, const PatchesAbout& about, Solution& unsettled,
                         Solution& best) {
  constexpr int fewParts = 20;  // their walk costs no more than that of patches
  constexpr double mostRegions = 300, mostSweeps = 1000;
  const int parts = problem_->parts();
  if (isInner_ || parts <= fewParts || !problem_->W.inBodySpace()) return false;
  findPatches(about, unsettled);
  if (!patchSearch_) patchSearch_.reset(new Search(machines()));
  int mended = 0;
  for (int k = 0; k < patches_.count(); ++k) {
    const double share = static_cast<double>(patches_.partsOf(k)) / parts;
    const double factorShare = share * std::sqrt(share);
    const double regionsLeft = task.regionsLeft(best) - patchWork_.regions;
    const double sweepsLeft = task.sweepsLeft(best) - patchWork_.sweeps;
    if (!(regionsLeft > 0 && sweepsLeft > 0)) break;
    Task few{task.options, about.accuracy, &patchStart_};
    // A patch that is not mended is tried again with more around it, which costs less than a path.
    few.options.pathBudget = 0;
    few.options.newtonBudget = static_cast<int>(std::min(mostRegions, regionsLeft / factorShare));
    few.options.sweepBudget = static_cast<int>(std::min(mostSweeps, sweepsLeft / share));
    patches_.cutOut(k, *problem_, unsettled.r, unsettled.u, patch_, patchStart_);
    patchSearch_->setProblem(patch_, few.tolerance);
    patchAnswer_.start(patch_.q);
    patchSearch_->offer(patchStart_, patchAnswer_);
    patchSearch_->walk(few, patchAnswer_);
    patches_.putBack(k, *problem_, patchAnswer_.r, unsettled.r);
    patchWork_.regions += factorShare * patchAnswer_.regions;
    patchWork_.factorisations += factorShare * patchAnswer_.factorisations;
    patchWork_.sweeps += share * patchAnswer_.sweeps;
    ++mended;
  }
  best.patches += mended;
  best.regions += takeWhole(patchWork_.regions);
  best.factorisations += takeWhole(patchWork_.factorisations);
  best.sweeps += takeWhole(patchWork_.sweeps);
  return mended > 0;
}

/// Whether a large pile is disturbed in so few places that most of its contacts and rows keep the
/// law as they did. Where half of a heap moves, patches gain nothing from step to step, and after a
/// blow through a whole pile a patch would only spoil what many sweeps or one region mend at once.
/// Joints carry a disturbance through all that they join: in a pile of ragdolls patches doubled the
/// time.
bool Search::isDisturbedInPlaces(const Task& task, const Solution& best) {
  if (!task.guess || task.isHurried || isInner_) return false;
  if (!isLargeButNoHeap(*problem_) || !problem_->W.inBodySpace() ||
      problem_->plainRows() > problem_->contacts())
    return false;
  constexpr double few = 0.2;  // of all contacts and rows
  map_.residuals(best.r, best.u, residuals_);
  const auto disturbed = (residuals_.array() > keptShare * task.tolerance).count();
  return static_cast<double>(disturbed) <= few * static_cast<double>(residuals_.size());
}

/// Mends the places that are disturbed, as by a body that rolls over others at rest; the rest needs
/// no factor. A patch holds the reactions around it, so that its answer moves the error to its rim.
/// Then follow patches about the rim, larger ones as long as that does not help (a Schwarz method).
/// They are solved no further than their surroundings are settled.
///
/// In heaps of 5000 contacts between barrels, most of which rest, this takes a third of the time of
/// regions of the whole heap.
bool Search::mendPlaces(const Task& task, Solution& best) {
  constexpr double outstanding = 0.3;  // of the largest residual
  constexpr double gain = 0.7, largestShare = 0.2;
  constexpr double settled = 1e-3, fine = 0.1;  // of the largest residual, and of the aim
  constexpr int mostRings = 5, patience = 8;
  const double aim = keptShare * task.tolerance;
  trial_.r = best.r;
  measure(trial_);
  double lowest = trial_.residualRms;
  for (int rings = 2, failures = 0; failures < patience && best.residual > aim;) {
    const double error = trial_.residual;
    const PatchesAbout about{std::max(outstanding * error, aim), rings, largestShare,
                             std::max(fine * aim, settled * error)};
    if (!mendPatches(task, about, trial_, best)) break;
    consider(trial_, best);
    if (trial_.residualRms < gain * lowest) {
      lowest = trial_.residualRms;
      failures = 0;
      rings = std::max(1, rings - 1);
    } else {
      ++failures;
      rings = std::min(mostRings, rings + 1);
    }
  }
  return best.residual <= task.tolerance;
}

}  // namespace delassus
