#include "delassus/solver.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "delassus/one_contact.h"
#include "delassus/quiet_arithmetic.h"
#include "delassus/read_mode.h"
#include "delassus/search.h"
#include "delassus/tolerance.h"

namespace delassus {
namespace {

/// Solves a lone contact or row by its formula. False if there is more than one, or if nothing
/// moves the row.
bool solveAlone(const Problem& problem, const NaturalMap& map, VectorXd& r) {
  if (problem.contacts() == 1 && problem.rows() == 0) {
    r = solveOneContact(problem.W.contactBlock(0), problem.q, problem.friction[0]);
    return true;
  }
  if (problem.contacts() > 0 || problem.rows() != 1 || !(map.diagonal()[0] > 0)) return false;
  r.resize(1);
  r[0] = std::clamp(-problem.q[0] / map.diagonal()[0], problem.lower[0], problem.upper[0]);
  return true;
}

/// Whether no law can be stated for some part. The answer is then no reactions, and these parts are
/// blamed.
bool isUnfit(const Problem& problem, Solution& best) {
  std::vector<int> unfit = unfitParts(problem);
  if (unfit.empty()) return false;
  best.blamed = std::move(unfit);
  best.status = Status::NonFinite;
  best.activeSet.contacts.assign(problem.contacts(), Mode::Open);
  best.activeSet.rows.assign(problem.rows(), RowState::Free);
  best.activeSet.disks.assign(problem.disks.size(), Mode::Open);
  return true;
}

}  // namespace

Solver::Solver(Options options) : options_(options), search_(std::make_unique<Search>()) {
  check(options);
}
Solver::~Solver() = default;
Solver::Solver(Solver&&) noexcept = default;
Solver& Solver::operator=(Solver&&) noexcept = default;

void Solver::setHands(Hands* hands) { search_->setHands(hands); }

std::size_t Solver::bytes() const { return search_->bytes() + bytesOf(formula_, guess_); }

Solution Solver::solve(const Problem& problem, const VectorXd& guess) {
  Solution solution;
  solve(problem, guess, solution);
  return solution;
}

void Solver::solve(const Problem& problem, const VectorXd& guess, Solution& best) {
  if (&guess == &best.r) {
    guess_ = guess;
    return solve(problem, guess_, best);
  }
  const QuietArithmetic quiet;
  best.start(problem.q);
  if (isUnfit(problem, best)) return;
  const Aim aim = aimOf(problem);
  search_->setProblem(problem, aim.tolerance);
  const bool isWarm = takeGuess(problem, guess, aim, best);
  const Outcome outcome = answer(problem, isWarm ? &guess : nullptr, aim, best);
  conclude(problem, aim, outcome, best);
}

Solver::Aim Solver::aimOf(const Problem& problem) const {
  const double tolerance = toleranceOf(options_, problem);
  return {tolerance, std::max(options_.guessShare * tolerance, problem.roundOff)};
}

/// Takes the guess as the best answer if it is a valid one. True if a search may begin from it.
bool Solver::takeGuess(const Problem& problem, const VectorXd& guess, const Aim& aim,
                       Solution& best) {
  const bool isGuess =
      guess.size() == problem.size() && problem.size() > 0 && guess.any() && guess.allFinite();
  if (isGuess) search_->offer(guess, best);
  const double startResidual = best.startResidual = best.residual;
  if (best.residual > aim.tolerance || options_.economies.keptIslands) return isGuess;
  // A guess that keeps the law is solved again all the same, from nothing.
  best.start(problem.q);
  best.startResidual = startResidual;
  return false;
}

/// Improves the best answer by the cheapest way possible. `guess`: where a search may begin, or
/// null.
Outcome Solver::answer(const Problem& problem, const VectorXd* guess, const Aim& aim,
                       Solution& best) {
  if (best.residual <= aim.guess) {
    best.tier = Tier::Kept;
    return Outcome::Reached;
  }
  if (best.residual > aim.tolerance) search_->startBetter(options_, best);
  if (best.residual > aim.guess && options_.economies.closedForms &&
      solveAlone(problem, search_->map(), formula_)) {
    ++best.regions;
    best.tier = Tier::ClosedForm;
    search_->offer(formula_, best);
  }
  Outcome outcome = Outcome::Lost;
  if (best.residual > aim.tolerance && problem.contacts() == 0 && problem.disks.empty() &&
      !problem.W.inBodySpace()) {
    best.tier = Tier::Pivoting;
    outcome = search_->pivotRows({options_, aim.tolerance, nullptr}, best);
  }
  if (best.residual > aim.tolerance && outcome == Outcome::Lost) {
    best.tier = Tier::Walk;
    outcome = search_->walk({options_, aim.tolerance, guess}, best);
  } else if (best.residual > aim.guess && best.tier == Tier::Free) {
    best.tier = Tier::Walk;
    search_->polish({options_, aim.guess, nullptr}, best);
  }
  return outcome;
}

/// Completes the best answer: its status, the parts to blame, and its modes.
void Solver::conclude(const Problem& problem, const Aim& aim, Outcome outcome,
                      Solution& best) const {
  const NaturalMap& map = search_->map();
  if (map.isGrippy()) best.setResidual(map.residual(best.r, best.u));
  // An answer that misses no demand by more than the tolerance, or than rounding, is no compromise.
  const double attainable = std::max(aim.tolerance, map.roundOff(best.r));
  best.status = best.residual <= attainable        ? Status::Solved
                : outcome == Outcome::Incompatible ? Status::Incompatible
                                                   : Status::OutOfBudget;
  if (best.status == Status::Solved) best.blamed.clear();
  if (best.status == Status::OutOfBudget) best.blamed = {map.residual(best.r, best.u).worst};
  readActiveSet(problem, map.diagonal(), best.r, best.u, best.activeSet);
}

}  // namespace delassus
