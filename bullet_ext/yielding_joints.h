#pragma once

#include <vector>

#include "delassus/problem.h"
#include "delassus/solution.h"
#include "delassus/solver.h"

namespace delassus::bullet {

/// Joints at odds with what else holds their bodies: a box that is bolted to a wall and collides with it. Since all joints give a little
/// (leastSoftness), there is a motion all the same, and reactions of 1e9 N·s in double precision: exact, and of use to nobody. A row
/// whose slip is a tenth of the largest demand, though nothing soft was asked of it, is taken to yield.

///
/// A load of M times the mass of what hangs it makes joints slip by M leastSoftness of what they stop: where masses differ by so much that
/// this might be taken for it, none is.

/// The unknowns of such rows in reactions r, of those from `firstRow` on; `massRatio`: of the heaviest body to the lightest.
std::vector<int> yieldingRows(const Problem& problem, int firstRow, double massRatio,
                              const VectorXd& r);

/// The answer, in `solution`, if these rows gave by a hundredth of what moves them. Incompatible; to blame are they and all that pushes a
/// tenth as hard, in the norm of its energy. The residual is that of the problem as it is.
void letYield(const Problem& problem, const std::vector<int>& rows, Solver& solver,
              Solution& solution);

}  // namespace delassus::bullet
