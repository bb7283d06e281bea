#pragma once

#include "delassus/economies.h"

namespace delassus {

/// Shares of the tolerance. Reactions that are kept act again in every step, so that their errors add up, and what tall
/// piles make of an error grows by half in each step: they are kept as long as they are better than what is solved, and
/// solving aims at some digits more where these come by themselves.
constexpr double keptShare = 1e-1, polishedShare = 1e-4;

struct Options {
  double tolerance = 1e-8;  ///< natural residual to reach, relative to the largest |q|; > 0
  int newtonBudget = 1200;  ///< most regions visited per island; work, never time
  int sweepBudget = 4000;   ///< most block Gauss-Seidel sweeps per island
  double guessShare = 1;    ///< a guess within this share of the tolerance is kept as it is
  Economies economies;
};

}  // namespace delassus
