#pragma once

#include <vector>

#include "delassus/problem.h"

namespace delassus {

/// A part of a problem that nothing couples to the rest, and where its unknowns stand in the whole.
struct ProblemPart {
  Problem problem;
  std::vector<int> unknowns;  ///< of the whole problem, in the order of the part's
};

/// Splits a problem with explicit W into its connected components (an entry W_ij or W_ji ≠ 0 connects, and so does a disk
/// its governor), ordered by their first unknown. A problem in body space is an island already and is never split.
std::vector<ProblemPart> splitProblem(const Problem& problem);

}  // namespace delassus
