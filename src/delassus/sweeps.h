#pragma once

#include <vector>

#include "delassus/problem.h"

namespace delassus {

/// Block Gauss-Seidel: each contact in turn is solved exactly with the others held (algorithms §6.3).
class Sweeps {
 public:
  void setProblem(const Problem& problem);

  /// One sweep over all contacts and rows. Returns the largest change of a relative velocity, m/s.
  double sweep(const Problem& problem, VectorXd& r);

 private:
  double sweepBodies(const Problem& problem, VectorXd& r);
  double sweepEntries(const Problem& problem, VectorXd& r);

  std::vector<Mat3> blocks_;
  VectorXd diagonal_;
  VectorXd y_;
};

}  // namespace delassus
