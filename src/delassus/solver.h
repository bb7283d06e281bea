#pragma once

#include <memory>

#include "delassus/options.h"
#include "delassus/problem.h"
#include "delassus/solution.h"

namespace delassus {

class Hands;
class Search;
enum class Outcome : unsigned char;

/// Finds the reactions of problems by the cheapest way that reaches the tolerance. In their order
/// (search.cpp has it in full) these ways are: the reactions of the last step, a formula, the
/// forced motion, steps and walks from region to region, sweeps. Owns its storage; not thread-safe,
/// one per thread.
class Solver {
 public:
  /// Throws std::invalid_argument where check(options) does. (A budget may have any value; one
  /// below 0 allows nothing.)
  explicit Solver(Options options = {});
  ~Solver();
  Solver(Solver&&) noexcept;
  Solver& operator=(Solver&&) noexcept;

  /// Solves `problem`, starting from the reactions `guess` (N·s, in the order of q). A guess that
  /// is empty, of another size, or not all finite stands for no reactions. The best answer found is
  /// always returned; its status and natural residual (m/s) tell how good it is. With explicit
  /// entries and more than 10 000 unknowns, the answer is that of sweeps alone: there is no room
  /// for a dense factor. Sizes that do not fit each other (Problem) are not detected.
  Solution solve(const Problem& problem, const VectorXd& guess = {});
  /// The same into storage that is used again; `guess` may be the reactions in `into`.
  void solve(const Problem& problem, const VectorXd& guess, Solution& into);

  /// Lends threads for large problems, until another call or null takes them back. The answer is
  /// the same, bit for bit. The threads must live until then, and do no other work while this
  /// solves.
  void setHands(Hands* hands);

  const Options& options() const { return options_; }
  /// Valid from the next call on. If this throws, as the constructor does, nothing has changed.
  void setOptions(const Options& options) {
    check(options);
    options_ = options;
  }
  /// Size of the storage.
  std::size_t bytes() const;

 private:
  /// Natural residuals to reach, m/s.
  struct Aim {
    double tolerance;  ///< of an answer
    double guess;      ///< of a guess that comes back as it is
  };
  Aim aimOf(const Problem& problem) const;
  bool takeGuess(const Problem& problem, const VectorXd& guess, const Aim& aim, Solution& best);
  Outcome answer(const Problem& problem, const VectorXd* guess, const Aim& aim, Solution& best);
  void conclude(const Problem& problem, const Aim& aim, Outcome outcome, Solution& best) const;

  Options options_;
  std::unique_ptr<Search> search_;
  VectorXd formula_;  ///< reactions of a lone contact or row
  VectorXd guess_;    ///< a copy of the guess, where it was in the answer's place
};

/// One-off use: the r with u = W r + q and the laws of Problem. Throws as Solver(Options).
Solution solve(const Problem& problem, const Options& options = {});

}  // namespace delassus
