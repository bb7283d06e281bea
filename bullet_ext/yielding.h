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
///   - a contact without friction that does work beyond measure, −r_i q_i W_ii > (100 v)²: a ball is pinched between faces that lean against
///     each other by less than 0.01 rad, of which it is to be shot out a hundred times as fast as anything moves or is asked to. In such a
///     wedge a ball that is pressed into it and overlaps neither side is held.
///
/// A load of M times the mass of what carries it takes reactions M times as large. Of joints, where masses differ by so much that this
/// might be taken for a contradiction, none yields; of contacts M times as much work is allowed.

/// By what the reactions of an island are measured.
struct IslandScales {
  double massRatio;  ///< of the heaviest body to the lightest
  double speed;      ///< of the fastest body before the reactions, m/s
};

/// The unknowns that yield in reactions r. Rows of joints are those from `firstRow` on, after contacts without friction.
std::vector<int> whatYields(const Problem& problem, int firstRow, const IslandScales& scales,
                            const VectorXd& r);

/// The answer, in `solution`, if these gave by a hundredth of what moves them. Incompatible; to blame are they and all that pushes a tenth
/// as hard, in the norm of its energy. The residual is that of the problem as it is.
void letYield(const Problem& problem, const std::vector<int>& yielding, Solver& solver,
              Solution& solution);

}  // namespace delassus::bullet
