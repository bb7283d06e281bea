#include "delassus/solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "delassus/cone.h"
#include "delassus/interior_point.h"
#include "delassus/one_contact.h"
#include "delassus/pivoting.h"
#include "delassus/proximal_newton.h"
#include "delassus/read_mode.h"
#include "delassus/residual.h"
#include "delassus/sweeps.h"

namespace delassus {
namespace {

/// The region that the answer lies in.
void readActiveSet(const Problem& problem, const VectorXd& diagonal, const VectorXd& r,
                   const VectorXd& u, ActiveSet& set) {
  const int n = problem.contacts();
  set.contacts.resize(n);
  for (int i = 0; i < n; ++i) {
    const int at = 3 * i;
    set.contacts[i] = modeOf(r.segment<3>(at), u.segment<3>(at), problem.friction[i],
                             diagonal.segment<3>(at).mean());
  }
  set.rows.resize(problem.rows());
  for (int i = 0; i < problem.rows(); ++i) {
    const int at = 3 * n + i;
    set.rows[i] = stateOf(r[at], u[at], problem.lower[i], problem.upper[i], diagonal[at]);
  }
  set.disks.clear();
  for (const Disk& disk : problem.disks)
    set.disks.push_back(diskModeOf(disk.of(r), disk.of(u), disk.radiusAt(r),
                                   diagonal.segment(disk.first, disk.unknowns).mean()));
}

/// The paper's forced motion: all that approach are held, whatever the sign of their reactions will be.
void forceActiveSet(const Problem& problem, ActiveSet& set) {
  // Bodies that fall together touch with q_n = 0 up to round-off: they are held too.
  const double touching = 1e-6 * problem.q.cwiseAbs().maxCoeff();
  set.contacts.clear();
  set.rows.clear();
  for (int i = 0; i < problem.contacts(); ++i)
    set.contacts.push_back(problem.q[3 * i] <= touching ? Mode::Stick : Mode::Open);
  for (int i = 0; i < problem.rows(); ++i) {
    const double q = problem.q[3 * problem.contacts() + i];
    set.rows.push_back(q > touching && std::isfinite(problem.lower[i])    ? RowState::AtLower
                       : q < -touching && std::isfinite(problem.upper[i]) ? RowState::AtUpper
                                                                          : RowState::Free);
  }
  set.disks.assign(problem.disks.size(), Mode::Stick);
}

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

/// Joints alone, without limits and motors: there is one region.
bool hasOneRegion(const Problem& problem) {
  return problem.contacts() == 0 && problem.lower.array().isInf().all() &&
         problem.upper.array().isInf().all();
}

/// Moves reactions into the cones, bounds and disks.
void makeFeasible(const Problem& problem, VectorXd& r) {
  const int n = problem.contacts();
  for (int i = 0; i < n; ++i)
    r.segment<3>(3 * i) = projectOnCone(r.segment<3>(3 * i), problem.friction[i]);
  for (int i = 0; i < problem.rows(); ++i)
    r[3 * n + i] = std::clamp(r[3 * n + i], problem.lower[i], problem.upper[i]);
  for (const Disk& disk : problem.disks) disk.put(projectOnDisk(disk.of(r), disk.radiusAt(r)), r);
}

constexpr double unknownRegion = 1e-1;  ///< proximal weight

/// How far a walk from here must look, by what is left to correct; at least `least`.
double proximalWeight(const Problem& problem, const Solution& from, double least) {
  return std::clamp(std::sqrt(from.residual / problem.q.cwiseAbs().maxCoeff()), least,
                    unknownRegion);
}

}  // namespace

struct Solver::Workspace {
  template <class Motion>
  struct Engines {
    ProximalNewton<Motion> walk;
    InteriorPoint<Motion> interior;
  };
  NaturalMap map;
  Sweeps sweeps;
  Engines<BodyMotion> bodies;
  Engines<FactoredMotion> factored;
  Solution trial, wandering, cold;
  VectorXd felt;

  /// Completes u and the residuals of a candidate r.
  void measure(const Problem& problem, Solution& candidate);
  static void take(const Solution& candidate, Solution& best);
  void startBetter(const Problem& problem, Solution& best);
  /// Measures it, and takes it as the best answer if its residual is smaller.
  void consider(const Problem& problem, Solution& candidate, Solution& best);

  /// Puts the answer of a walk back into the cones and bounds that rounding, or a compromise, left.
  void allow(const Problem& problem, Solution& best);

  /// `guess`: reactions to start from, or null.
  template <class Motion>
  Outcome search(Engines<Motion>& engines, const Problem& problem, const Options& options,
                 double tolerance, const VectorXd* guess, Solution& best);
  template <class Motion>
  Outcome walk(Engines<Motion>& engines, const Problem& problem, const Options& options,
               double tolerance, const VectorXd* guess, Solution& best);
  template <class Motion>
  Outcome wander(Engines<Motion>& engines, const Problem& problem, const Options& options,
                 double tolerance, const VectorXd* guess, Solution& best);
  template <class Motion>
  void polish(Engines<Motion>& engines, const Problem& problem, const Options& options, double aim,
              Solution& best);
  Outcome pivotRows(const Problem& problem, const Options& options, double tolerance,
                    Solution& best);
  void sweep(const Problem& problem, int count, Solution& best);
  void sweepWhileItGains(const Problem& problem, const Options& options, double tolerance,
                         Solution& best);
};

void Solver::Workspace::measure(const Problem& problem, Solution& candidate) {
  problem.W.multiply(candidate.r, felt, candidate.u);
  candidate.u += problem.q;
  const NaturalResidual residual = map.residual(candidate.r, candidate.u);
  candidate.residual = residual.max;
  candidate.residualRms = residual.rms;
}

void Solver::Workspace::consider(const Problem& problem, Solution& candidate, Solution& best) {
  measure(problem, candidate);
  if (candidate.residual < best.residual) take(candidate, best);
}

/// Starts from no reactions at all if those in `best` are no start. They are compared as a whole: where few contacts came or
/// went, a guess is far wrong only there, and what was learnt of all the others is worth more.
void Solver::Workspace::startBetter(const Problem& problem, Solution& best) {
  constexpr double hopeless = 30;
  const double guessed = best.residualRms;
  trial.r.setZero(problem.size());
  makeFeasible(problem, trial.r);
  measure(problem, trial);
  if (!(guessed <= hopeless * trial.residualRms)) take(trial, best);
}

void Solver::Workspace::take(const Solution& candidate, Solution& best) {
  best.r = candidate.r;
  best.u = candidate.u;
  best.residual = candidate.residual;
  best.residualRms = candidate.residualRms;
}

void Solver::Workspace::allow(const Problem& problem, Solution& best) {
  makeFeasible(problem, best.r);
  measure(problem, best);
}

/// Rows alone are the paper's own ground: regions of any W, symmetric or not.
Outcome Solver::Workspace::pivotRows(const Problem& problem, const Options& options,
                                     double tolerance, Solution& best) {
  PivotOptions pivoting;
  pivoting.regionBudget = options.newtonBudget;
  const PivotResult result =
      pivot(problem.W.dense(), problem.q, problem.lower, problem.upper, {}, pivoting);
  best.regions += result.regions;
  best.factorisations += result.factorisations;
  trial.r = result.r;
  consider(problem, trial, best);
  if (best.residual <= tolerance) return Outcome::Reached;
  if (result.status != Status::Incompatible) return Outcome::Lost;
  best.r = result.r;
  best.u = result.u;
  const NaturalResidual residual = map.residual(best.r, best.u);
  best.residual = residual.max;
  best.residualRms = residual.rms;
  best.blamed = result.blamed;
  return Outcome::Incompatible;
}

void Solver::Workspace::sweep(const Problem& problem, int count, Solution& best) {
  trial.r = best.r;
  sweeps.setProblem(problem);
  sweeps.sweep(problem, count, trial.r);
  best.sweeps += count;
  consider(problem, trial, best);
}

void Solver::Workspace::sweepWhileItGains(const Problem& problem, const Options& options,
                                          double tolerance, Solution& best) {
  constexpr int burst = 20;
  constexpr double gain = 0.7;
  double before = std::numeric_limits<double>::infinity();
  while (best.residual < gain * before && best.residual > tolerance &&
         best.sweeps + burst <= options.sweepBudget) {
    before = best.residual;
    sweep(problem, burst, best);
  }
}

/// From the likeliest start to the surest: the reactions of the last step, or without them the paper's forced motion, every
/// approaching contact held, with reactions that start from zero. Sweeps mend what came and went, as long as they gain; the
/// walk finishes. Where it loses its way, many contacts are at a wall of their region: an interior point comes down between
/// the walls, and the walk goes on from there.
template <class Motion>
Outcome Solver::Workspace::walk(Engines<Motion>& engines, const Problem& problem,
                                const Options& options, double tolerance, const VectorXd* guess,
                                Solution& best) {
  constexpr double knownRegion = 1e-6;
  // Shares of the demands that the last reactions leave open.
  constexpr double disturbed = 1e-3, nearly = 1e-7;
  constexpr int firstTry = 32, interiorSteps = 40, secondTry = 90;
  const double demand = problem.q.cwiseAbs().maxCoeff();
  const auto settled = [](Outcome outcome) { return outcome != Outcome::Lost; };
  const auto left = [&] { return options.newtonBudget - best.regions; };

  ProximalNewton<Motion>& newton = engines.walk;
  newton.setProblem(problem, map);
  newton.keepFactors(options.economies.factors);
  if (!guess) {
    forceActiveSet(problem, best.activeSet);
    const Outcome outcome = newton.walkFromRegion(problem, tolerance, knownRegion,
                                                  std::min(firstTry / 2, left()), best);
    if (settled(outcome)) return outcome;
  }
  if (options.economies.oneRegion && hasOneRegion(problem)) {
    const Outcome outcome =
        newton.walk(problem, tolerance, knownRegion, std::min(firstTry / 2, left()), best);
    if (settled(outcome)) return outcome;
  }
  if (best.residual > disturbed * demand)
    sweepWhileItGains(problem, options, keptShare * tolerance, best);
  if (best.residual <= tolerance) return Outcome::Reached;
  const double weight =
      best.residual <= nearly * demand ? knownRegion : proximalWeight(problem, best, 1e-2);
  Outcome outcome = newton.walk(problem, tolerance, weight, std::min(firstTry, left()), best);
  if (settled(outcome)) return outcome;

  if (engines.interior.solve(newton.motion(), problem, map, tolerance,
                             std::min(interiorSteps, left()), best))
    return Outcome::Reached;
  outcome = newton.walk(problem, tolerance, proximalWeight(problem, best, 1e-4),
                        std::min(secondTry, left()), best);
  if (settled(outcome)) return outcome;

  return wander(engines, problem, options, tolerance, guess, best);
}

/// Two ways on, in turn. Sweeps from the best answer mend it and the walk goes on from there. And since what is near in
/// residual may be far from any answer, sweeps set out anew from where the step began, go on whether or not they better
/// the best answer, further each time, and a short walk is tried from wherever they are.
template <class Motion>
Outcome Solver::Workspace::wander(Engines<Motion>& engines, const Problem& problem,
                                  const Options& options, double tolerance, const VectorXd* guess,
                                  Solution& best) {
  constexpr int mending = 50, shortest = 100, longWalk = 100, shortWalk = 40;
  const auto sweepsLeft = [&](int most) {
    return std::min(most, options.sweepBudget - best.sweeps);
  };
  const auto regionsLeft = [&](int most) {
    return std::min(most, options.newtonBudget - best.regions);
  };
  wandering.r.setZero(problem.size());
  if (guess) wandering.r = *guess;
  makeFeasible(problem, wandering.r);
  for (int length = shortest; sweepsLeft(1) > 0 && regionsLeft(1) > 0; length *= 2) {
    sweep(problem, sweepsLeft(mending), best);
    Outcome outcome =
        engines.walk.walk(problem, tolerance, unknownRegion, regionsLeft(longWalk), best);
    if (outcome != Outcome::Lost) return outcome;

    const int count = sweepsLeft(length);
    sweeps.sweep(problem, count, wandering.r);
    best.sweeps += count;
    consider(problem, wandering, best);
    outcome = engines.walk.walkFrom(wandering, problem, tolerance,
                                    proximalWeight(problem, wandering, 1e-4),
                                    regionsLeft(shortWalk), best);
    if (outcome != Outcome::Lost) return outcome;
  }
  return Outcome::Lost;
}

/// A short walk from reactions that keep the law already.
template <class Motion>
void Solver::Workspace::polish(Engines<Motion>& engines, const Problem& problem,
                               const Options& options, double aim, Solution& best) {
  constexpr double weight = 1e-4;
  constexpr int regions = 8;
  engines.walk.setProblem(problem, map);
  engines.walk.keepFactors(options.economies.factors);
  engines.walk.walk(problem, aim, weight, regions, best);
}

/// Walks from the guess; if that is lost, with what is left of the budget as if there were none.
template <class Motion>
Outcome Solver::Workspace::search(Engines<Motion>& engines, const Problem& problem,
                                  const Options& options, double tolerance, const VectorXd* guess,
                                  Solution& best) {
  if (!guess) return walk(engines, problem, options, tolerance, nullptr, best);
  Options share = options;
  share.newtonBudget -= 3 * options.newtonBudget / 8;
  share.sweepBudget -= options.sweepBudget / 2;
  Outcome outcome = walk(engines, problem, share, tolerance, guess, best);
  if (outcome != Outcome::Lost) return outcome;

  cold.r.setZero(problem.size());
  makeFeasible(problem, cold.r);
  cold.residual = std::numeric_limits<double>::infinity();
  consider(problem, cold, best);
  cold.regions = best.regions;
  cold.factorisations = best.factorisations;
  cold.sweeps = best.sweeps;
  outcome = walk(engines, problem, options, tolerance, nullptr, cold);
  best.regions = cold.regions;
  best.factorisations = cold.factorisations;
  best.sweeps = cold.sweeps;
  if (outcome == Outcome::Lost && !(cold.residual < best.residual)) return outcome;
  best.r = cold.r;
  best.u = cold.u;
  best.residual = cold.residual;
  best.blamed = cold.blamed;
  return outcome;
}

Solver::Solver(Options options) : options_(options), workspace_(std::make_unique<Workspace>()) {}
Solver::~Solver() = default;
Solver::Solver(Solver&&) noexcept = default;
Solver& Solver::operator=(Solver&&) noexcept = default;

Solution Solver::solve(const Problem& problem, const VectorXd& guess) {
  Solution solution;
  solve(problem, guess, solution);
  return solution;
}

void Solver::solve(const Problem& problem, const VectorXd& guess, Solution& best) {
  Workspace& w = *workspace_;
  best.r.setZero(problem.size());
  best.u = problem.q;
  best.residual = best.residualRms = std::numeric_limits<double>::infinity();
  best.regions = best.factorisations = best.sweeps = 0;
  best.tier = Tier::Free;
  best.blamed = unfitParts(problem);
  if (!best.blamed.empty()) {
    best.status = Status::NonFinite;
    best.activeSet.contacts.assign(problem.contacts(), Mode::Open);
    best.activeSet.rows.assign(problem.rows(), RowState::Free);
    best.activeSet.disks.assign(problem.disks.size(), Mode::Open);
    return;
  }

  w.map.setProblem(problem);
  const double demand = problem.size() > 0 ? problem.q.cwiseAbs().maxCoeff() : 0;
  const double tolerance = std::max(options_.tolerance * demand, problem.roundOff);
  bool warm = guess.size() == problem.size() && problem.size() > 0 && guess.any();
  if (warm) {
    w.trial.r = guess;
    makeFeasible(problem, w.trial.r);
    w.consider(problem, w.trial, best);
  }
  best.startResidual = best.residual;
  const Economies& economies = options_.economies;
  if (best.residual <= tolerance && !economies.keptIslands) {
    // What keeps the law is solved again all the same, from nothing.
    warm = false;
    best.residual = std::numeric_limits<double>::infinity();
  }
  const double aim = std::max(options_.guessShare * tolerance, problem.roundOff);
  if (best.residual <= aim) {
    best.tier = Tier::Kept;
  } else if (best.residual > tolerance) {
    w.startBetter(problem, best);
  }
  if (best.residual > aim && economies.closedForms && solveAlone(problem, w.map, w.trial.r)) {
    ++best.regions;
    best.tier = Tier::ClosedForm;
    w.consider(problem, w.trial, best);
  }
  Outcome outcome = Outcome::Lost;
  if (best.residual > tolerance && problem.contacts() == 0 && problem.disks.empty() &&
      !problem.W.inBodySpace()) {
    best.tier = Tier::Pivoting;
    outcome = w.pivotRows(problem, options_, tolerance, best);
  }
  const VectorXd* start = warm ? &guess : nullptr;
  if (best.residual > tolerance && outcome == Outcome::Lost) {
    best.tier = Tier::Walk;
    outcome = problem.W.inBodySpace()
                  ? w.search(w.bodies, problem, options_, tolerance, start, best)
                  : w.search(w.factored, problem, options_, tolerance, start, best);
    w.allow(problem, best);
  } else if (best.residual > aim && best.tier == Tier::Free) {
    best.tier = Tier::Walk;
    if (problem.W.inBodySpace())
      w.polish(w.bodies, problem, options_, aim, best);
    else
      w.polish(w.factored, problem, options_, aim, best);
    w.allow(problem, best);
  }

  // A compromise that misses no demand by more than the tolerance is none.
  const double attainable = std::max(tolerance, w.map.roundOff(best.r));
  best.status = best.residual <= tolerance         ? Status::Solved
                : outcome == Outcome::Incompatible ? Status::Incompatible
                : best.residual <= attainable      ? Status::Solved
                                                   : Status::OutOfBudget;
  if (best.status == Status::Solved) best.blamed.clear();
  if (best.status == Status::OutOfBudget) best.blamed = {w.map.residual(best.r, best.u).worst};
  readActiveSet(problem, w.map.diagonal(), best.r, best.u, best.activeSet);
}

}  // namespace delassus
