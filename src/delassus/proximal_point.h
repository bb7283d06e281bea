#pragma once

#include <vector>

#include "delassus/region_walk.h"

namespace delassus {

/// Reactions with the states that gave them, and their natural residual.
struct RowAnswer {
  VectorXd r;
  std::vector<RowState> states;
  double residual = infinity;

  /// Takes the reactions of `walk`, within their bounds, if they are better.
  void offer(const BoundedRows& problem, const RegionWalk& walk);
};

/// The answer of the proximal point method. Where the demands are incompatible, `shift` is the
/// least change of q, in the norm of scaled velocities, that makes them compatible; it is to be
/// added.
struct ProximalAnswer {
  RowAnswer best;
  VectorXd shift;
  std::vector<int> blamed;
};

/// Solves problems with singular W by exact proximal steps from r = 0 (algorithms 5.2-5.5): the
/// motion is that of W itself, and the reactions have least norm. Steps go on while they help. Once
/// the natural residual is within `goodEnough`, slow progress ends them: the data themselves
/// disagree by that much, and to follow them would spoil the shares.
ProximalAnswer proximalPoint(const BoundedRows& problem, RegionWalk& walk, double goodEnough,
                             int regionBudget);

}  // namespace delassus
