#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "delassus/cone.h"
#include "delassus/one_contact.h"
#include "delassus/read_mode.h"
#include "delassus/residual.h"
#include "delassus/solver.h"
#include "delassus/split_problem.h"

namespace delassus {
namespace {

/// The answer of a whole problem, from those of its parts.
class Whole {
 public:
  explicit Whole(const Problem& problem) : problem_(problem) {
    solution_.start(problem.q);
    solution_.residual = solution_.residualRms = 0;
    solution_.activeSet.contacts.resize(problem.contacts());
    solution_.activeSet.rows.resize(problem.rows());
    solution_.activeSet.disks.resize(problem.disks.size());
  }

  void put(const ProblemParts& parts, int part, const Problem& p, const Solution& s) {
    const int n = p.contacts(), frictional = 3 * problem_.contacts();
    for (int k = 0; k < p.size(); ++k) {
      solution_.r[parts.unknown(part, k)] = s.r[k];
      solution_.u[parts.unknown(part, k)] = s.u[k];
    }
    for (int i = 0; i < n; ++i)
      solution_.activeSet.contacts[parts.unknown(part, 3 * i) / 3] = s.activeSet.contacts[i];
    for (int i = 0; i < p.rows(); ++i)
      solution_.activeSet.rows[parts.unknown(part, 3 * n + i) - frictional] = s.activeSet.rows[i];
    std::size_t disk = 0;  // of the part; the whole has them in the same order
    for (std::size_t k = 0; k < problem_.disks.size() && disk < s.activeSet.disks.size(); ++k)
      if (problem_.disks[k].first == parts.unknown(part, p.disks[disk].first))
        solution_.activeSet.disks[k] = s.activeSet.disks[disk++];
    solution_.status = std::max(solution_.status, s.status);
    solution_.tier = std::max(solution_.tier, s.tier);
    solution_.regions += s.regions;
    solution_.factorisations += s.factorisations;
    solution_.sweeps += s.sweeps;
    solution_.patches += s.patches;
    for (const int blamed : s.blamed) solution_.blamed.push_back(parts.unknown(part, blamed));
    count(s.residual, s.residualRms, n + p.rows());
  }

  void putOpen(const ProblemParts& parts, int part) {
    for (int k = 0; k < parts.sizeOf(part); k += 3)
      solution_.activeSet.contacts[parts.unknown(part, k) / 3] = Mode::Open;
    count(0, 0, parts.sizeOf(part) / 3);
  }

  /// Of one contact, whose reaction a formula gave: exact but for rounding.
  void put(int contact, const Vec3& r, const Vec3& u, double residual, double size) {
    solution_.r.segment<3>(3 * contact) = r;
    solution_.u.segment<3>(3 * contact) = u;
    solution_.activeSet.contacts[contact] = modeOf(r, u, problem_.friction[contact], size);
    solution_.tier = std::max(solution_.tier, Tier::ClosedForm);
    ++solution_.regions;
    count(residual, residual, 1);
  }

  Solution take() {
    if (counted_ > 0) solution_.residualRms = std::sqrt(squares_ / counted_);
    return std::move(solution_);
  }

 private:
  void count(double residual, double rms, int size) {
    solution_.residual = std::max(solution_.residual, residual);
    squares_ += rms * rms * size;
    counted_ += size;
  }

  const Problem& problem_;
  Solution solution_;
  double squares_ = 0;  ///< of residuals, (m/s)²
  int counted_ = 0;     ///< contacts and rows
};

/// Whether parts can be told: no disk points out of the problem.
bool disksAreInside(const Problem& problem) {
  const auto isInside = [&](int unknown) { return unknown >= 0 && unknown < problem.size(); };
  return std::all_of(problem.disks.begin(), problem.disks.end(), [&](const Disk& disk) {
    return isInside(disk.governor) && isInside(disk.first) && disk.unknowns >= 1 &&
           disk.unknowns <= 2 && isInside(disk.first + disk.unknowns - 1);
  });
}

/// Whether a part has contacts alone, none of which approaches: then there are no reactions.
bool isOpen(const Problem& problem, const ProblemParts& parts, int part) {
  for (int k = 0; k < parts.sizeOf(part); k += 3) {
    const int first = parts.unknown(part, k);
    if (first >= 3 * problem.contacts() || !(problem.q[first] >= 0)) return false;
  }
  return true;
}

/// A contact that nothing couples to others has a formula for its reaction. False if that does not reach the tolerance.
bool answerByFormula(const Problem& problem, const Options& options, int contact, Whole& whole) {
  const double mu = problem.friction[contact];
  const Vec3 q = problem.q.segment<3>(3 * contact);
  const Mat3 W = problem.W.contactBlock(3 * contact);
  const Vec3 r = projectOnCone(solveOneContact(W, q, mu), mu);
  const Vec3 u = W * r + q;
  const double residual = naturalResidual(W, mu, r, u);
  if (!(residual <= options.tolerance * q.cwiseAbs().maxCoeff())) return false;
  whole.put(contact, r, u, residual, W.diagonal().mean());
  return true;
}

}  // namespace

Solution solve(const Problem& problem, const Options& options) {
  if (problem.W.inBodySpace() || !disksAreInside(problem)) return Solver(options).solve(problem);
  const bool fit = unfitParts(problem).empty();
  const bool formulas = fit && options.economies.closedForms;
  Whole whole(problem);
  if (formulas && problem.contacts() == 1 && problem.rows() == 0 &&
      answerByFormula(problem, options, 0, whole))
    return whole.take();
  const ProblemParts parts(problem);
  if (parts.count() == 1) return Solver(options).solve(problem);
  std::optional<Solver> solver;  // made when a part needs it
  Solution solution;
  for (int k = 0; k < parts.count(); ++k) {
    if (options.economies.freeIslands && fit && isOpen(problem, parts, k)) {
      whole.putOpen(parts, k);
      continue;
    }
    if (formulas && parts.isOneContact(k) &&
        answerByFormula(problem, options, parts.unknown(k, 0) / 3, whole))
      continue;
    if (!solver) solver.emplace(options);
    const Problem part = parts.problemOf(k);
    solver->solve(part, {}, solution);
    whole.put(parts, k, part, solution);
  }
  return whole.take();
}

}  // namespace delassus
