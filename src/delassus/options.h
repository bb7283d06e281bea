#pragma once

#include "delassus/economies.h"

namespace delassus {

struct Options {
  double tolerance = 1e-8;  ///< natural residual to reach, relative to the largest |q|; > 0
  int newtonBudget = 800;   ///< most regions visited per island; work, never time
  int sweepBudget = 3000;   ///< most block Gauss-Seidel sweeps per island
  Economies economies;
};

}  // namespace delassus
