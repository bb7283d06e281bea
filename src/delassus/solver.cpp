#include "delassus/solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "delassus/cone.h"
#include "delassus/interior_point.h"
#include "delassus/one_contact.h"
#include "delassus/pivoting.h"
#include "delassus/proximal_newton.h"
#include "delassus/residual.h"
#include "delassus/split_problem.h"
#include "delassus/sweeps.h"

namespace delassus {
namespace {

/// Reads the modes from the point z = r − v/W_aa that the law projects (from r alone grazing contacts lie).
void readActiveSet(const Problem& problem, const VectorXd& diagonal, const VectorXd& r,
                   const VectorXd& u, ActiveSet& set) {
  const int n = problem.contacts();
  set.contacts.resize(n);
  for (int i = 0; i < n; ++i) {
    const int at = 3 * i;
    const double mu = problem.friction[i];
    const double mean = diagonal.segment<3>(at).mean();
    const double rho = mean > 0 ? 1 / mean : 0;
    const Vec3 z = r.segment<3>(at) - rho * correctedVelocity(u.segment<3>(at), mu);
    const double zt = std::hypot(z[1], z[2]);
    set.contacts[i] = mu * zt <= -z[0] || (z[0] <= 0 && zt == 0) ? Mode::Open
                      : zt < mu * z[0]                           ? Mode::Stick
                                                                 : Mode::Slide;
  }
  set.rows.resize(problem.rows());
  for (int i = 0; i < problem.rows(); ++i) {
    const int at = 3 * n + i;
    const double z = r[at] - (diagonal[at] > 0 ? u[at] / diagonal[at] : 0);
    set.rows[i] = z <= problem.lower[i]   ? RowState::AtLower
                  : z >= problem.upper[i] ? RowState::AtUpper
                                          : RowState::Free;
  }
}

/// The paper's forced motion: all that approach are held, whatever the sign of their reactions will be.
ActiveSet forcedActiveSet(const Problem& problem) {
  // Bodies that fall together touch with q_n = 0 up to round-off: they are held too.
  const double touching = 1e-6 * problem.q.cwiseAbs().maxCoeff();
  ActiveSet set;
  for (int i = 0; i < problem.contacts(); ++i)
    set.contacts.push_back(problem.q[3 * i] <= touching ? Mode::Stick : Mode::Open);
  for (int i = 0; i < problem.rows(); ++i) {
    const double q = problem.q[3 * problem.contacts() + i];
    set.rows.push_back(q > touching && std::isfinite(problem.lower[i])    ? RowState::AtLower
                       : q < -touching && std::isfinite(problem.upper[i]) ? RowState::AtUpper
                                                                          : RowState::Free);
  }
  return set;
}

/// Moves reactions into the cones and bounds.
void makeFeasible(const Problem& problem, VectorXd& r) {
  const int n = problem.contacts();
  for (int i = 0; i < n; ++i)
    r.segment<3>(3 * i) = projectOnCone(r.segment<3>(3 * i), problem.friction[i]);
  for (int i = 0; i < problem.rows(); ++i)
    r[3 * n + i] = std::clamp(r[3 * n + i], problem.lower[i], problem.upper[i]);
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
  VectorXd trial, trialU, felt;

  /// Takes r as the best answer if its residual is smaller.
  void consider(const Problem& problem, const VectorXd& r, Solution& best);

  template <class Motion>
  Outcome walk(Engines<Motion>& engines, const Problem& problem, const Options& options,
               double tolerance, bool warm, Solution& best);
  Outcome pivotRows(const Problem& problem, const Options& options, double tolerance,
                    Solution& best);
  void sweep(const Problem& problem, int count, Solution& best);
  void sweepWhileItGains(const Problem& problem, const Options& options, double tolerance,
                         Solution& best);
};

void Solver::Workspace::consider(const Problem& problem, const VectorXd& r, Solution& best) {
  problem.W.multiply(r, felt, trialU);
  trialU += problem.q;
  const NaturalResidual residual = map.residual(r, trialU);
  if (!(residual.max < best.residual)) return;
  best.r = r;
  best.u.swap(trialU);
  best.residual = residual.max;
  best.residualRms = residual.rms;
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
  consider(problem, result.r, best);
  if (result.status != Status::Incompatible)
    return best.residual <= tolerance ? Outcome::Reached : Outcome::Lost;
  best.r = result.r;
  best.u = result.u;
  const NaturalResidual residual = map.residual(best.r, best.u);
  best.residual = residual.max;
  best.residualRms = residual.rms;
  best.blamed = result.blamed;
  return Outcome::Incompatible;
}

void Solver::Workspace::sweep(const Problem& problem, int count, Solution& best) {
  trial = best.r;
  sweeps.setProblem(problem);
  sweeps.sweep(problem, count, trial);
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
                                const Options& options, double tolerance, bool warm,
                                Solution& best) {
  constexpr double knownRegion = 1e-6, unknownRegion = 1e-1;
  constexpr double disturbed = 1e-3;  // share of the demands that the last reactions leave open
  constexpr int interiorSteps = 40, moreSweeps = 50;
  const int firstTry = options.newtonBudget / 12;
  const double demand = problem.q.cwiseAbs().maxCoeff();
  const auto settled = [](Outcome outcome) { return outcome != Outcome::Lost; };
  const auto left = [&] { return options.newtonBudget - best.regions; };
  // What is left to correct says how far the walk must look.
  const auto weight = [&](double least) {
    return std::clamp(std::sqrt(best.residual / demand), least, unknownRegion);
  };

  ProximalNewton<Motion>& newton = engines.walk;
  newton.setProblem(problem, map);
  if (!warm) {
    best.activeSet = forcedActiveSet(problem);
    const Outcome outcome =
        newton.walkFromRegion(problem, tolerance, knownRegion, firstTry / 2, best);
    if (settled(outcome)) return outcome;
  }
  if (best.residual > disturbed * demand) sweepWhileItGains(problem, options, tolerance, best);
  if (best.residual <= tolerance) return Outcome::Reached;
  Outcome outcome = newton.walk(problem, tolerance, weight(1e-2), std::min(firstTry, left()), best);
  if (settled(outcome)) return outcome;

  if (engines.interior.solve(newton.motion(), problem, map, tolerance,
                             std::min(interiorSteps, left()), best))
    return Outcome::Reached;
  outcome = newton.walk(problem, tolerance, weight(1e-4), left() / 4, best);
  if (settled(outcome)) return outcome;

  while (best.sweeps < options.sweepBudget && left() > 0) {
    sweep(problem, std::min(moreSweeps, options.sweepBudget - best.sweeps), best);
    outcome = newton.walk(problem, tolerance, unknownRegion, left(), best);
    if (settled(outcome)) return outcome;
  }
  return Outcome::Lost;
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
  w.map.setProblem(problem);
  best.r.setZero(problem.size());
  best.u = problem.q;
  best.residual = best.residualRms = std::numeric_limits<double>::infinity();
  best.regions = best.factorisations = best.sweeps = 0;
  best.blamed.clear();

  const double demand = problem.size() > 0 ? problem.q.cwiseAbs().maxCoeff() : 0;
  const double tolerance = std::max(options_.tolerance * demand, problem.roundOff);
  const bool warm = guess.size() == problem.size() && problem.size() > 0 && guess.any();
  if (warm) {
    w.trial = guess;
    makeFeasible(problem, w.trial);
    w.consider(problem, w.trial, best);
  }
  if (!(best.residual <= tolerance)) {
    w.trial.setZero(problem.size());
    makeFeasible(problem, w.trial);
    w.consider(problem, w.trial, best);
  }
  if (best.residual > tolerance && problem.contacts() == 1 && problem.rows() == 0) {
    ++best.regions;
    w.trial = solveOneContact(problem.W.contactBlock(0), problem.q, problem.friction[0]);
    w.consider(problem, w.trial, best);
  }
  Outcome outcome = Outcome::Lost;
  if (best.residual > tolerance && problem.contacts() == 0 && !problem.W.inBodySpace())
    outcome = w.pivotRows(problem, options_, tolerance, best);
  if (best.residual > tolerance && outcome == Outcome::Lost) {
    outcome = problem.W.inBodySpace()
                  ? w.walk(w.bodies, problem, options_, tolerance, warm, best)
                  : w.walk(w.factored, problem, options_, tolerance, warm, best);
    best.residualRms = w.map.residual(best.r, best.u).rms;
  }

  const double attainable = std::max(tolerance, w.map.roundOff(best.r));
  best.status = outcome == Outcome::Incompatible ? Status::Incompatible
                : best.residual <= attainable    ? Status::Solved
                                                 : Status::OutOfBudget;
  readActiveSet(problem, w.map.diagonal(), best.r, best.u, best.activeSet);
}

Solution solve(const Problem& problem, const Options& options) {
  Solver solver(options);
  if (problem.W.inBodySpace()) return solver.solve(problem);

  // Parts that nothing couples are solved apart.
  Solution whole;
  double squares = 0;  // of residuals, (m/s)²
  int parts = 0;
  whole.r = VectorXd::Zero(problem.size());
  whole.u = whole.r;
  whole.activeSet.contacts.resize(problem.contacts());
  whole.activeSet.rows.resize(problem.rows());
  for (const ProblemPart& part : splitProblem(problem)) {
    const Solution s = solver.solve(part.problem);
    const int n = part.problem.contacts();
    for (int k = 0; k < part.problem.size(); ++k) {
      whole.r[part.unknowns[k]] = s.r[k];
      whole.u[part.unknowns[k]] = s.u[k];
    }
    for (int i = 0; i < n; ++i)
      whole.activeSet.contacts[part.unknowns[3 * i] / 3] = s.activeSet.contacts[i];
    for (int i = 0; i < part.problem.rows(); ++i)
      whole.activeSet.rows[part.unknowns[3 * n + i] - 3 * problem.contacts()] = s.activeSet.rows[i];
    whole.status = std::max(whole.status, s.status);
    whole.residual = std::max(whole.residual, s.residual);
    const int size = n + part.problem.rows();
    squares += s.residualRms * s.residualRms * size;
    parts += size;
    whole.regions += s.regions;
    whole.factorisations += s.factorisations;
    whole.sweeps += s.sweeps;
    for (int blamed : s.blamed) whole.blamed.push_back(part.unknowns[blamed]);
  }
  if (parts > 0) whole.residualRms = std::sqrt(squares / parts);
  return whole;
}

}  // namespace delassus
