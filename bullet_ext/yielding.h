#pragma once

#include <vector>

#include "delassus/problem.h"
#include "delassus/solution.h"
#include "delassus/solver.h"

namespace delassus::bullet {

/// Exact answers that are of use to nobody: what is asked is a contradiction, but for rounding or for how little joints give, and met all
/// the same, by reactions many times as large as any that the bodies' motion accounts for. Who makes such ones is taken to yield:
///
///   - a row of a joint that slips by a tenth of the largest demand, though nothing soft was asked of it: a box is bolted to a wall and
///     collides with it. (All joints give by leastSoftness.)
///   - a contact without friction that pushes W_ii r_i > 1e4 times the largest demand: a ball is pinched between faces that lean against
///     each other by less than 1e-2 rad, of which it is to be shot out at 100 times what was asked.
///
/// A load of M times the mass of what carries it takes reactions M times as large. Of joints, where masses differ by so much that this
/// might be taken for a contradiction, none yields; of contacts M times as much is allowed.

/// The unknowns that yield in reactions r. Rows of joints are those from `firstRow` on, after contacts without friction; `massRatio`: of the
/// heaviest body to the lightest.
std::vector<int> whatYields(const Problem& problem, int firstRow, double massRatio,
                            const VectorXd& r);

/// The answer, in `solution`, if these gave by a hundredth of what moves them. Incompatible; to blame are they and all that pushes a tenth
/// as hard, in the norm of its energy. The residual is that of the problem as it is.
void letYield(const Problem& problem, const std::vector<int>& yielding, Solver& solver,
              Solution& solution);

}  // namespace delassus::bullet
