#include "delassus/solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "delassus/cone.h"
#include "delassus/interior_point.h"
#include "delassus/one_contact.h"
#include "delassus/proximal_newton.h"
#include "delassus/residual.h"
#include "delassus/split_problem.h"
#include "delassus/sweeps.h"

namespace delassus {
namespace {

/// Reads the modes from the point z = r − v/W_aa that the law projects (from r alone grazing contacts lie).
ActiveSet readActiveSet(const Problem& problem, const VectorXd& r, const VectorXd& u) {
  const int n = problem.contacts();
  const VectorXd diagonal = problem.W.diagonal();
  ActiveSet set;
  set.contacts.reserve(n);
  for (int i = 0; i < n; ++i) {
    const int at = 3 * i;
    const double mu = problem.friction[i];
    const double mean = diagonal.segment<3>(at).mean();
    const double rho = mean > 0 ? 1 / mean : 0;
    const Vec3 z = r.segment<3>(at) - rho * correctedVelocity(u.segment<3>(at), mu);
    const double zt = std::hypot(z[1], z[2]);
    set.contacts.push_back(mu * zt <= -z[0] || (z[0] <= 0 && zt == 0) ? Mode::Open
                           : zt < mu * z[0]                           ? Mode::Stick
                                                                      : Mode::Slide);
  }
  set.rows.reserve(problem.rows());
  for (int i = 0; i < problem.rows(); ++i) {
    const int at = 3 * n + i;
    const double z = r[at] - (diagonal[at] > 0 ? u[at] / diagonal[at] : 0);
    set.rows.push_back(z <= problem.lower[i]   ? RowState::AtLower
                       : z >= problem.upper[i] ? RowState::AtUpper
                                               : RowState::Free);
  }
  return set;
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

/// Moves a guess into the cones and bounds.
VectorXd feasible(const Problem& problem, VectorXd r) {
  const int n = problem.contacts();
  for (int i = 0; i < n; ++i)
    r.segment<3>(3 * i) = projectOnCone(r.segment<3>(3 * i), problem.friction[i]);
  for (int i = 0; i < problem.rows(); ++i)
    r[3 * n + i] = std::clamp(r[3 * n + i], problem.lower[i], problem.upper[i]);
  return r;
}

/// Takes r as the best answer if its residual is smaller.
void consider(const Problem& problem, const VectorXd& r, Solution& best) {
  VectorXd u = problem.W * r + problem.q;
  const double residual = naturalResidual(problem, r, u).max;
  if (best.r.size() == r.size() && !(residual < best.residual)) return;
  best.r = r;
  best.u = std::move(u);
  best.residual = residual;
}

}  // namespace

struct Solver::Workspace {
  template <class Motion>
  struct Engines {
    ProximalNewton<Motion> walk;
    InteriorPoint<Motion> interior;
  };
  Sweeps sweeps;
  Engines<BodyMotion> bodies;
  Engines<FactoredMotion> factored;

  template <class Motion>
  Outcome walk(Engines<Motion>& engines, const Problem& problem, const Options& options,
               double tolerance, bool warm, Solution& best);
  void sweep(const Problem& problem, int count, VectorXd& r, Solution& best);
};

void Solver::Workspace::sweep(const Problem& problem, int count, VectorXd& r, Solution& best) {
  sweeps.setProblem(problem);
  for (int k = 0; k < count; ++k) sweeps.sweep(problem, r);
  best.sweeps += count;
  consider(problem, r, best);
}

/// From the likeliest start to the surest: the reactions of the last step, which few sweeps mend where contacts came or
/// went; without them the paper's forced motion, every approaching contact held, with reactions that start from zero. Where
/// the walk loses its way, many contacts are at a wall of their region: an interior point comes down between the walls.
template <class Motion>
Outcome Solver::Workspace::walk(Engines<Motion>& engines, const Problem& problem,
                                const Options& options, double tolerance, bool warm,
                                Solution& best) {
  constexpr double knownRegion = 1e-6, warmRegion = 1e-2, unknownRegion = 1e-1;
  constexpr double disturbed = 1e-3;  // share of the demands that the last reactions leave open
  constexpr int mendingSweeps = 10, interiorSteps = 40;
  const int firstTry = options.newtonBudget / 6;
  const double demand = problem.q.cwiseAbs().maxCoeff();
  const VectorXd start = best.r;
  const auto settled = [](Outcome outcome) { return outcome != Outcome::Lost; };
  const auto left = [&] { return options.newtonBudget - best.regions; };
  // What is left to correct says how far the walk must look.
  const auto weight = [&] {
    return std::clamp(std::sqrt(best.residual / demand), 1e-4, unknownRegion);
  };

  ProximalNewton<Motion>& newton = engines.walk;
  newton.setProblem(problem);
  Outcome outcome;
  if (warm) {
    VectorXd r = start;
    if (best.residual > disturbed * demand) sweep(problem, mendingSweeps, r, best);
    outcome = newton.walk(problem, tolerance, warmRegion, std::min(firstTry, left()), best);
  } else {
    best.activeSet = forcedActiveSet(problem);
    outcome = newton.walkFromRegion(problem, tolerance, knownRegion, firstTry / 2, best);
  }
  if (settled(outcome)) return outcome;

  if (engines.interior.solve(newton.motion(), problem, tolerance, std::min(interiorSteps, left()),
                             best))
    return Outcome::Reached;
  outcome = newton.walk(problem, tolerance, weight(), left() / 2, best);
  if (settled(outcome)) return outcome;

  VectorXd r = start;
  for (int count = mendingSweeps; best.sweeps < options.sweepBudget && left() > 0; count *= 2) {
    sweep(problem, count, r, best);
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
  Solution best;
  consider(problem, feasible(problem, VectorXd::Zero(problem.size())), best);
  const double largestDemand = problem.size() > 0 ? problem.q.cwiseAbs().maxCoeff() : 0;
  const double tolerance = std::max(options_.tolerance * largestDemand, problem.roundOff);

  const bool warm = guess.size() == problem.size() && problem.size() > 0 && guess.any();
  if (best.residual > tolerance && warm) consider(problem, feasible(problem, guess), best);

  Outcome outcome = Outcome::Lost;
  if (best.residual > tolerance) {
    if (problem.contacts() == 1 && problem.rows() == 0) {
      ++best.regions;
      consider(problem, solveOneContact(problem.W.contactBlock(0), problem.q, problem.friction[0]),
               best);
    }
    if (best.residual > tolerance) {
      Workspace& w = *workspace_;
      outcome = problem.W.inBodySpace()
                    ? w.walk(w.bodies, problem, options_, tolerance, warm, best)
                    : w.walk(w.factored, problem, options_, tolerance, warm, best);
    }
  }
  const double attainable = std::max(tolerance, roundOff(problem.W.diagonal(), best.r));
  best.status = outcome == Outcome::Incompatible ? Status::Incompatible
                : best.residual <= attainable    ? Status::Solved
                                                 : Status::OutOfBudget;
  best.activeSet = readActiveSet(problem, best.r, best.u);
  return best;
}

Solution solve(const Problem& problem, const Options& options) {
  Solver solver(options);
  if (problem.W.inBodySpace()) return solver.solve(problem);

  // Parts that nothing couples are solved apart.
  Solution whole;
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
    whole.regions += s.regions;
    whole.factorisations += s.factorisations;
    whole.sweeps += s.sweeps;
    for (int blamed : s.blamed) whole.blamed.push_back(part.unknowns[blamed]);
  }
  return whole;
}

}  // namespace delassus
