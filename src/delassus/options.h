#pragma once

#include <algorithm>

#include "delassus/economies.h"

namespace delassus {

/// Shares of the tolerance. Reactions that are kept act again in every step, and unless it is at
/// rest (island_check.h) a tall pile doubles the error of each step in the next one. So reactions
/// are kept only as long as they are better than those of a new solution (keptShare), and a new
/// solution goes on for some digits more where these come by themselves (polishedShare).
constexpr double keptShare = 1e-1, polishedShare = 1e-4;

struct Options {
  /// Options for a step of little time: this many sweeps an island, and one region for every twenty
  /// sweeps, at least one. (Twenty sweeps are what a region costs in small piles; in large ones it
  /// costs more.) No path of compliance.
  static Options bounded(int sweeps) {
    constexpr int sweepsOfRegion = 20;
    Options options;
    options.sweepBudget = sweeps;
    options.newtonBudget = std::max(1, sweeps / sweepsOfRegion);
    options.pathBudget = 0;
    return options;
  }

  /// Natural residual to reach, relative to the island's largest demand (Problem::demand, m/s), but
  /// no less than the rounding of q (Problem::roundOff); > 0, < 1. Where friction is more than 1,
  /// toleranceFor(friction) takes its place.
  double tolerance = 1e-8;
  /// Most regions visited per island. Budgets count work, never time: the same input takes the same
  /// work everywhere. Work in a patch of an island counts by the patch's share of what the island
  /// costs. As for all budgets, 0 or less allows none; but a lone contact or row, which has a
  /// formula, takes its one region all the same.
  int newtonBudget = 14400;
  /// Most regions, unless the residual is still falling (ProximalWalk::walkOn).
  int regionsInVain() const {
    constexpr int enough = 1800;
    return std::clamp(newtonBudget, 0, std::max(enough, newtonBudget / 8));
  }
  /// Most block Gauss-Seidel sweeps, alternations, and steps on few contacts without their joints
  /// (condensed_newton.h), per island. Below 300 (isHurried), and in large heaps (pile_kind.h)
  /// below 3000, exactness gives way to time:
  ///   - A few contacts, without joints or once these are eliminated, are solved outright; in piles
  ///     where nothing slid all contacts are held at once. Either counts as one region.
  ///   - Where that is no answer, all sweeps are made, as sequential impulses make theirs, and then
  ///     the regions that are left; in large heaps only if the sweeps have come near an answer.
  ///   - There are no alternations, no second start and no path of compliance.
  /// (search_start_out.cpp has the numbers.)
  int sweepBudget = 64000;
  bool isHurried() const { return sweepBudget < 300; }
  /// Most factorisations along a path of compliance (compliance_path.h), the last resort; 0 or
  /// less: no path. The number is for an island of up to 600 contacts and rows. Larger islands,
  /// where each factorisation costs more, get fewer: a quarter at twice the size. The budget is
  /// checked between strides, of which one may make a hundred factorisations. The start of a path
  /// takes up to 10 000 sweeps and 600 regions, and its end up to 240 regions; no other budget
  /// limits these.
  ///
  /// No path is followed with rolling or spinning friction, where W is explicit, nor in large piles
  /// (pile_kind.h). A large pile that has no reactions to start from, and is left with more than
  /// 1e-6 of its demands, sets out from the answers for less friction instead, within newtonBudget
  /// (in proportion less for more than 1000 contacts and rows).
  int pathBudget = 30000;
  /// A guess whose residual is within this share of the tolerance is returned as it is, but for
  /// what is outside of cones and bounds; > 0, ≤ 1.
  /// The Bullet solvers set it to at most polishedShare; but before they solve, they keep the last
  /// reactions where these are within keptShare.
  double guessShare = 1;
  Economies economies;

  /// With a wide cone an approach may be up to μ times as fast as the residual shows: without
  /// reactions, and with ‖u_t‖ = −u_n, the residual is −u_n/√(1 + μ²). With this tolerance nothing
  /// approaches by a larger share of the demands than the tolerance, or 1e-5 if that is more:
  ///
  ///     min(tolerance, max(tolerance, 1e-5)/μ)
  double toleranceFor(double friction) const {
    constexpr double harmless = 1e-5;
    return friction > 1 ? std::min(tolerance, std::max(tolerance, harmless) / friction) : tolerance;
  }
};

/// Throws std::invalid_argument where the tolerance or guessShare is out of its range.
void check(const Options& options);

}  // namespace delassus
