#pragma once

#include <vector>

#include "delassus/problem.h"

namespace delassus {

/// Block Gauss-Seidel: each contact, row and disk in turn is solved exactly with the others held (algorithms §6.3).
class Sweeps {
 public:
  void setProblem(const Problem& problem);

  /// `count` sweeps over all contacts and rows, each but the last followed by a step along the nonlinear conjugate gradient
  /// of the sweeps (Silcowitz-Hansen, Niebe, Erleben 2010; algorithms §7.3). The reactions stay in their cones and bounds.
  void sweep(const Problem& problem, int count, VectorXd& r);

  std::size_t bytes() const {
    return bytesOf(blocks_, diskBlocks_, diagonal_, y_, before_, change_, direction_);
  }

 private:
  void sweepOnce(const Problem& problem, VectorXd& r);
  void sweepBodies(const Problem& problem, VectorXd& r);
  void sweepEntries(const Problem& problem, VectorXd& r);
  /// The reaction of disk `k` with the others held: u is what it sees with r.
  Vec2 nextOnDisk(const Problem& problem, int k, const VectorXd& r, const Vec2& u) const;

  std::vector<Mat3> blocks_;
  std::vector<Mat2> diskBlocks_;
  VectorXd diagonal_;
  VectorXd y_;
  VectorXd before_, change_, direction_;
};

}  // namespace delassus
