#pragma once

#include "delassus/economies.h"

namespace delassus {

/// Shares of the tolerance. Reactions that are kept act again in every step, and a tall pile makes twice the error of each
/// step in the next. So they are kept only as long as they are better than what is solved (keptShare), and solving again
/// goes on for some digits more where these come by themselves (polishedShare).
constexpr double keptShare = 1e-1, polishedShare = 1e-4;

struct Options {
  double tolerance = 1e-8;  ///< natural residual to reach, relative to the largest |q|; > 0
  /// Most regions visited per island. Budgets count work, never time; that in a patch of an island by what it costs beside the island's.
  int newtonBudget = 1800;
  /// Most block Gauss-Seidel sweeps, and alternations, per island. Below 300 there are no alternations: all sweeps are made, before
  /// the walk, as sequential impulses make theirs.
  int sweepBudget = 64000;
  /// Most factorisations along a path of compliance, of an island of up to 600 contacts and rows; of larger ones, in which each
  /// costs more, as many fewer; none beyond 200 but in heaps, with disks, or where W is explicit. Its start takes up to 11 000 sweeps
  /// that no other budget holds.
  int pathBudget = 30000;
  double guessShare = 1;  ///< a guess within this share of the tolerance is kept as it is; > 0
  Economies economies;
};

}  // namespace delassus
