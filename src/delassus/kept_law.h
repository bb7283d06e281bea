#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "delassus/disk.h"
#include "delassus/island.h"
#include "delassus/options.h"
#include "delassus/solution.h"

namespace delassus {

/// Collects the natural residuals of an island, one contact or row after the other, until one is
/// too large.
class Residuals {
 public:
  explicit Residuals(double tolerance) : tolerance_(tolerance) {}

  bool add(double residual) {
    if (!(residual <= tolerance_)) return false;
    max_ = std::max(max_, residual);
    squares_ += residual * residual;
    ++count_;
    return true;
  }
  void write(Solution& solution) const {
    solution.residual = max_;
    solution.residualRms = count_ > 0 ? std::sqrt(squares_ / count_) : 0;
  }

 private:
  double tolerance_, max_ = 0, squares_ = 0;
  int count_ = 0;
};

/// The disk that ends with the k-th row of the island; the rows begin at the unknown `rowsBegin`.
inline Disk diskAt(const std::vector<Row>& rows, const Island& island, int k, int rowsBegin) {
  const Row& last = rows[island.rows[k]];
  const bool pair = k > 0 && rows[island.rows[k - 1]].paired;
  const int unknowns = pair ? 2 : 1;
  return {rowsBegin + k + 1 - unknowns, unknowns, island.normalOf(last.governor), last.upper,
          last.mostLoad};
}

/// Checks the law at the reactions solution.r of one island, without a W. The bodies must have
/// their velocities after these reactions. Also writes velocities, modes and the residual to the
/// solution.
class KeptLaw {
 public:
  /// `share`: of the tolerance that may be used; `demand`: the largest, m/s.
  KeptLaw(const std::vector<Body>& moved, const std::vector<Contact>& contacts,
          const std::vector<Row>& rows, const Island& island, const Options& options, double share,
          double demand, Solution& solution);

  /// Whether the law is kept. Stops at the first part that misses it.
  bool holds();

 private:
  bool isWithin(double residual, double friction);
  bool keepsCone(int k);
  bool keepsNormal(int k);
  bool keepsRow(int k);
  bool keepsDisk(int k);
  bool keepsBounds(int state, double u, double lower, double upper, double ownSize);
  int rowsBegin() const { return normalsBegin_ + normals_; }

  const std::vector<Body>& moved_;
  const std::vector<Contact>& contacts_;
  const std::vector<Row>& rows_;
  const Island& island_;
  const Options& options_;
  const double share_, demand_;
  const int normalsBegin_, normals_;  ///< first unknown of contacts without friction, their number
  Solution& solution_;
  Residuals residuals_;
};

}  // namespace delassus
