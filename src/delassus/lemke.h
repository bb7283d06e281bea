#pragma once

#include <optional>

#include "delassus/region_walk.h"

namespace delassus {

/// Lemke's complementary pivoting with the lexicographic ratio test: the last resort for W that is
/// neither symmetric nor positive definite (Cottle, Pang, Stone, "The Linear Complementarity
/// Problem", §4.4-4.9).
///
/// Bilateral rows are eliminated where their block of W is regular, else split in two signs; boxes
/// get a slack each. Empty if it ends on a ray or after `pivotBudget` pivots. `pivots` counts those
/// made.
std::optional<VectorXd> lemke(const BoundedRows& problem, int pivotBudget, int& pivots);

}  // namespace delassus
