#include "delassus/solver.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "delassus/one_contact.h"
#include "delassus/quiet_arithmetic.h"
#include "delassus/read_mode.h"
#include "delassus/search.h"

namespace delassus {
namespace {

/// A contact or a row that is alone has a formula for its reaction. False if there is more.
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
  Search& search = *search_;
  best.start(problem.q);
  if (std::vector<int> unfit = unfitParts(problem); !unfit.empty()) {
    best.blamed = std::move(unfit);
    best.status = Status::NonFinite;
    best.activeSet.contacts.assign(problem.contacts(), Mode::Open);
    best.activeSet.rows.assign(problem.rows(), RowState::Free);
    best.activeSet.disks.assign(problem.disks.size(), Mode::Open);
    return;
  }

  search.setProblem(problem);
  const double demand = problem.size() > 0 ? problem.q.cwiseAbs().maxCoeff() : 0;
  const double widest = problem.contacts() > 0 ? problem.friction.maxCoeff() : 0;
  const double tolerance = std::max(options_.toleranceFor(widest) * demand, problem.roundOff);
  bool warm =
      guess.size() == problem.size() && problem.size() > 0 && guess.any() && guess.allFinite();
  if (warm) search.offer(guess, best);
  best.startResidual = best.residual;
  const Economies& economies = options_.economies;
  if (best.residual <= tolerance && !economies.keptIslands) {
    // What keeps the law is solved again all the same, from nothing.
    warm = false;
    const double startResidual = best.startResidual;
    best.start(problem.q);
    best.startResidual = startResidual;
  }
  const double aim = std::max(options_.guessShare * tolerance, problem.roundOff);
  if (best.residual <= aim) {
    best.tier = Tier::Kept;
  } else if (best.residual > tolerance) {
    search.startBetter(best);
  }
  if (best.residual > aim && economies.closedForms && solveAlone(problem, search.map(), formula_)) {
    ++best.regions;
    best.tier = Tier::ClosedForm;
    search.offer(formula_, best);
  }
  Outcome outcome = Outcome::Lost;
  if (best.residual > tolerance && problem.contacts() == 0 && problem.disks.empty() &&
      !problem.W.inBodySpace()) {
    best.tier = Tier::Pivoting;
    outcome = search.pivotRows({options_, tolerance, nullptr}, best);
  }
  if (best.residual > tolerance && outcome == Outcome::Lost) {
    best.tier = Tier::Walk;
    outcome = search.walk({options_, tolerance, warm ? &guess : nullptr}, best);
  } else if (best.residual > aim && best.tier == Tier::Free) {
    best.tier = Tier::Walk;
    search.polish({options_, aim, nullptr}, best);
  }

  // A compromise that misses no demand by more than the tolerance is none.
  const double attainable = std::max(tolerance, search.map().roundOff(best.r));
  best.status = best.residual <= tolerance         ? Status::Solved
                : outcome == Outcome::Incompatible ? Status::Incompatible
                : best.residual <= attainable      ? Status::Solved
                                                   : Status::OutOfBudget;
  if (best.status == Status::Solved) best.blamed.clear();
  if (best.status == Status::OutOfBudget)
    best.blamed = {search.map().residual(best.r, best.u).worst};
  readActiveSet(problem, search.map().diagonal(), best.r, best.u, best.activeSet);
}

}  // namespace delassus
