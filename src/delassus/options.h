#pragma once

#include "delassus/economies.h"

namespace delassus {

struct Options {
  double tolerance = 1e-8;  ///< natural residual to reach, relative to the largest |q|; > 0
  int newtonBudget = 1200;  ///< most regions visited per island; work, never time
  int sweepBudget = 4000;   ///< most block Gauss-Seidel sweeps per island
  Economies economies;
};

}  // namespace delassus
