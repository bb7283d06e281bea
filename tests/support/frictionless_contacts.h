#pragma once

#include <algorithm>
#include <cmath>

#include "delassus/pivoting.h"

namespace delassus {

/// Solves 0 ≤ r ⊥ W r + q ≥ 0 by pivoting: only contacts without friction.
inline PivotResult pivotContacts(const MatrixXd& W, const VectorXd& q) {
  const auto n = q.size();
  return pivot(W, q, VectorXd::Zero(n), VectorXd::Constant(n, infinity));
}

/// |r − s|_W: the difference of the two motions, √J.
inline double motionDistance(const MatrixXd& W, const VectorXd& r, const VectorXd& s) {
  return std::sqrt(std::max(0.0, (r - s).dot(W * (r - s))));
}

}  // namespace delassus
