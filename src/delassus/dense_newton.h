#pragma once

#include "delassus/elimination.h"
#include "delassus/residual.h"
#include "delassus/solution.h"

namespace delassus {

/// Where a search sets out: from the best answer so far, or from no reactions.
enum class Start : unsigned char { Best, Rest };

/// Newton's method on Coulomb's law as it stands, with all entries of W, for few unknowns (Alart and Curnier 1991; algorithms
/// §6.10):
///
///     F(r) = P(r − u/ρ) − r = 0,    u = W r + q,    ρ = mean of the diagonal of W_ii
///
/// P as in `reactionTo`, for rows the projection on their bounds. Each step solves F in one region, without anything to hold
/// reactions apart that W does not tell from each other: where it is singular in that region the method gives up. `Most` unknowns
/// or fewer, or any number (Eigen::Dynamic).
template <int Most>
class DenseNewton {
 public:
  /// From the reactions of `best`, or none, to some with a natural residual of at most `tolerance` (m/s): true, and they are the best; or
  /// until `budget` regions are spent, or they lead nowhere. `map` is that of the problem, which has entries and no disks.
  bool solve(const Problem& problem, const NaturalMap& map, double tolerance, int budget,
             Start from, Solution& best);

  std::size_t bytes() const {
    std::size_t sum = candidate_.bytes();
    if constexpr (Most == Eigen::Dynamic)  // its factors are as large as K_
      sum += bytesOf(W_, K_, K_, rho_, r_, u_, step_, error_, trialR_, trialU_);
    return sum;
  }

 private:
  using Matrix = typename Elimination<Most>::Matrix;
  using Vector = typename Elimination<Most>::Vector;

  void start(const Problem& problem, const NaturalMap& map, Start from, const Solution& best);
  /// u = W r + q
  void feel(const Problem& problem, const Vector& r, Vector& u) const;
  /// F in error_ for these reactions and velocities, and if asked −dF/dr in K_. Returns ‖ρ F‖ (m/s).
  double evaluate(const Problem& problem, const Vector& r, const Vector& u, bool differentiate);
  bool judge(const Problem& problem, const NaturalMap& map, double tolerance, Solution& best);

  Elimination<Most> elimination_;
  Matrix W_, K_;
  Vector rho_, r_, u_, step_, error_, trialR_, trialU_;
  Solution candidate_;
};

/// So few that they are solved without a workspace.
constexpr int fewUnknowns = 15;

/// Whether a problem is small enough, and made of contacts and rows that can move.
bool fitsDenseNewton(const Problem& problem, const NaturalMap& map);

}  // namespace delassus
