#pragma once

#include <algorithm>

#include "delassus/economies.h"

namespace delassus {

/// Shares of the tolerance. Reactions that are kept act again in every step, and a tall pile makes
/// twice the error of each step in the next, unless it is at rest (island_check.h). So they are
/// kept only as long as they are better than what is solved (keptShare), and solving again goes on
/// for some digits more where these come by themselves (polishedShare).
constexpr double keptShare = 1e-1, polishedShare = 1e-4;

struct Options {
  /// For who has little time: so many sweeps an island, and a region for every twenty, which is
  /// what one costs in small piles (in large ones more); at least one. No path of compliance.
  static Options bounded(int sweeps) {
    constexpr int sweepsOfRegion = 20;
    Options options;
    options.sweepBudget = sweeps;
    options.newtonBudget = std::max(1, sweeps / sweepsOfRegion);
    options.pathBudget = 0;
    return options;
  }

  /// Natural residual to reach, relative to the largest demand of the island (Problem::demand; m/s,
  /// rad/s), but no less than the rounding of q (Problem::roundOff); > 0. Where friction is more
  /// than 1 it is toleranceFor(friction).
  double tolerance = 1e-8;
  /// Most regions visited per island. Budgets count work, never time: the same input takes the same
  /// work everywhere. Work in a patch of an island counts by its share of what the island costs. 0
  /// or less is none, as for all budgets; what has a formula (one contact, one row) takes its
  /// region all the same.
  int newtonBudget = 14400;
  /// No more than these, unless what is left is still getting less (ProximalWalk::walkOn).
  int regionsInVain() const {
    constexpr int enough = 1800;
    return std::min(newtonBudget, std::max(enough, newtonBudget / 8));
  }
  /// Most block Gauss-Seidel sweeps, alternations, and steps on few contacts without their joints
  /// (condensed_newton.h), per island. Below 300 (isHurried), and in large heaps (pile_kind.h)
  /// below 3000, exactness gives way to time. Few contacts, as they are or as joints leave them,
  /// are solved outright, and of piles in which nothing slid all contacts are held at once; either
  /// is counted as one region. Where that is no answer, all sweeps are made, as sequential impulses
  /// make theirs, and the regions that are left come after them; in large heaps only where the
  /// sweeps have come near an answer. There are no alternations, no second start and no path of
  /// compliance. (search_start_out.cpp has the numbers.)
  int sweepBudget = 64000;
  bool isHurried() const { return sweepBudget < 300; }
  /// The last resort; 0 or less: there is none. Most factorisations along a path of compliance
  /// (compliance_path.h), of an island of up to 600 contacts and rows; of larger ones, in which
  /// each costs more, as many fewer. It is looked at between strides, of which one may make a
  /// hundred. A path's start takes up to 10 000 sweeps and 600 regions, and its end up to 240
  /// regions, that no other budget holds. There is none with rolling or spinning friction, nor in
  /// large piles (pile_kind.h): those that have no reactions to start from, and are left with more
  /// than 1e-6 of their demands, set out from the answers for less friction instead, within
  /// newtonBudget (of more than 1000 contacts and rows as many fewer). Nor is there either where W
  /// is explicit.
  int pathBudget = 30000;
  /// A guess whose residual is within this share of the tolerance comes back as it is; > 0, ≤ 1.
  /// The Bullet solvers take no more than polishedShare; before, they keep the last reactions where
  /// these are within keptShare.
  double guessShare = 1;
  Economies economies;

  /// A wide cone hides an approach of up to μ times the residual: without reactions, and with ‖u_t‖
  /// = −u_n, that is −u_n/√(1 + μ²). With this tolerance nothing approaches by a larger share of
  /// the demands than the tolerance, or 1e-5 if that is more:
  ///
  ///     min(tolerance, max(tolerance, 1e-5)/μ)
  double toleranceFor(double friction) const {
    constexpr double harmless = 1e-5;
    return friction > 1 ? std::min(tolerance, std::max(tolerance, harmless) / friction) : tolerance;
  }
};

/// Throws std::invalid_argument where the tolerance or the guess' share is out of its range.
void check(const Options& options);

}  // namespace delassus
