#pragma once

#include <vector>

#include "delassus/bytes.h"
#include "delassus/problem.h"

namespace delassus {

/// Loads of whole levels of a pile at once: a sweep carries a load by a level or so, and a blow on a pile of n levels takes some n²
/// of them until it has reached the ground.
///
/// The level of a body is how many contacts and rows it is from the fixed world, that of a contact or row the higher of its two
/// bodies'. All reactions of a level l are multiplied by one factor α_l, so that they stay in their cones and bounds, with
///
///     Σ_{i in l} r_i · u_i = 0,   u = W (α r) + q
///
/// over the normals of contacts and over rows: what contacts and joints keep together (friction, which takes energy, is not in the
/// sum). As a level shares bodies with its two neighbours only, that is a tridiagonal system.
class LevelScaling {
 public:
  /// Finds the levels. False, and nothing is to be scaled, if W is explicit or has articulated bodies, or if reactions have bounds that
  /// do not grow with them: of motors and joints that may break, and disks.
  bool setProblem(const Problem& problem);

  /// Scales r, or leaves it as it is where the factors are not all positive. y becomes J̃ᵀ r.
  void scale(const Problem& problem, VectorXd& r, VectorXd& y);

  std::size_t bytes() const {
    return bytesOf(levelOfBody_, levelOf_, equations_) +
           bytesOf(below_, above_, probeBelow_, probeAbove_);
  }

 private:
  /// Σ_m W_lm α_m + q_l = 0 over the levels m = l − 1, l, l + 1.
  struct Equation {
    double lower, diagonal, upper, q, factor;
  };

  void findLevels(const BodySpace& space);
  void collect(const Problem& problem, const VectorXd& r);
  bool solve();

  int levels_ = 0;
  std::vector<int> levelOfBody_;
  std::vector<int> levelOf_;  ///< of contacts, then of rows
  // J̃ᵀ r of a body's own level and of the one above it; the same of what is in the sums (normals and rows).
  VectorXd below_, above_, probeBelow_, probeAbove_;
  std::vector<Equation> equations_;
};

}  // namespace delassus
