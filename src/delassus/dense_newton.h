#pragma once

#include "delassus/newton_steps.h"
#include "delassus/residual.h"
#include "delassus/solution.h"

namespace delassus {

/// Where a search sets out: from the best answer so far, or from no reactions.
enum class Start : unsigned char { Best, Rest };

/// Newton's method on Coulomb's law (NewtonSteps), for few unknowns. It adds no term to tell
/// reactions apart where W does not: where F is singular in a region, the method gives up.
template <int Most>
class DenseNewton {
 public:
  /// Starts from the reactions of `best`, or from none. True if it finds reactions with a natural
  /// residual of at most `tolerance` (m/s): these become `best`. Gives up after `budget` regions,
  /// or where the steps lead nowhere. `map` belongs to the problem, which has entries and no disks.
  bool solve(const Problem& problem, const NaturalMap& map, double tolerance, int budget,
             Start from, Solution& best);

  std::size_t bytes() const { return steps_.bytes() + candidate_.bytes(); }

 private:
  using Vector = typename NewtonSteps<Most>::Vector;

  void start(const Problem& problem, const NaturalMap& map, Start from, const Solution& best);
  bool judge(const Problem& problem, const NaturalMap& map, double tolerance, Solution& best);

  NewtonSteps<Most> steps_;
  Vector allowed_, felt_;
  Solution candidate_;
};

/// Whether a problem is small enough, and all its contacts and rows can move.
bool fitsDenseNewton(const Problem& problem, const NaturalMap& map);

}  // namespace delassus
