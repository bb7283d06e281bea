#pragma once

#include <optional>

#include "delassus/region_walk.h"

namespace delassus {

/// Lemke's complementary pivoting with the lexicographic ratio test: the last resort for W that is
/// neither symmetric nor positive definite (Cottle, Pang, Stone, "The Linear Complementarity
/// Problem", §4.4-4.9).
///
/// Bilateral rows are eliminated if their block of W is regular, else split in two signs. Boxes get
/// a slack each. Empty if the method ends on a ray or after `pivotBudget` pivots. `pivots` counts
/// the pivots.
std::optional<VectorXd> lemke(const BoundedRows& problem, int pivotBudget, int& pivots);

}  // namespace delassus
