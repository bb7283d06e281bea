#pragma once

#include <Eigen/LU>

#include "delassus/residual.h"
#include "delassus/solution.h"

namespace delassus {

/// Newton's method on Coulomb's law as it stands, with all entries of W, for few unknowns (Alart and Curnier 1991; algorithms
/// §6.10):
///
///     F(r) = P(r − u/ρ) − r = 0,    u = W r + q,    ρ = mean of the diagonal of W_ii
///
/// P as in `reactionTo`, for rows the projection on their bounds. Each step solves F in one region, without anything to hold
/// reactions apart that W does not tell from each other: where it is singular in that region the method gives up.
class DenseNewton {
 public:
  /// Whether a problem is small enough, and made of contacts and rows that can move.
  static bool fits(const Problem& problem, const NaturalMap& map);

  /// From the reactions of `best` to some with a natural residual of at most `tolerance` (m/s): true, and they are the best; or
  /// until `budget` regions are spent, or they lead nowhere. `map` is that of the problem.
  bool solve(const Problem& problem, const NaturalMap& map, double tolerance, int budget,
             Solution& best);

  std::size_t bytes() const { return bytesOf(W_, K_, K_, rho_, r_, u_, error_, trialR_, trialU_); }

 private:
  void start(const Problem& problem, const NaturalMap& map, const Solution& best);
  /// F in error_ for reactions and velocities, and if asked −dF/dr in K_. Returns |ρ F|² (m/s)².
  double evaluate(const Problem& problem, const VectorXd& r, const VectorXd& u, bool differentiate);
  bool isSingular() const;

  MatrixXd W_, K_;
  Eigen::PartialPivLU<MatrixXd> lu_;
  VectorXd rho_, r_, u_, error_, trialR_, trialU_;
};

}  // namespace delassus
