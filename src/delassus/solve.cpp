#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "delassus/cone.h"
#include "delassus/one_contact.h"
#include "delassus/quick_answer.h"
#include "delassus/quiet_arithmetic.h"
#include "delassus/read_mode.h"
#include "delassus/residual.h"
#include "delassus/solver.h"
#include "delassus/split_problem.h"
#include "delassus/tolerance.h"

namespace delassus {
namespace {

/// Collects the answer of a whole problem from those of its parts.
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
    std::size_t disk = 0;  // index in the part; the whole has its disks in the same order
    for (std::size_t k = 0; k < problem_.disks.size() && disk < s.activeSet.disks.size(); ++k)
      if (problem_.disks[k].first == parts.unknown(part, p.disks[disk].first))
        solution_.activeSet.disks[k] = s.activeSet.disks[disk++];
    solution_.status = std::max(solution_.status, s.status);
    solution_.tier = std::max(solution_.tier, s.tier);
    solution_.addWork(s);
    for (const int blamed : s.blamed) solution_.blamed.push_back(parts.unknown(part, blamed));
    count(s.residual, s.residualRms, n + p.rows());
  }

  /// Puts a part that the quick answer of the whole problem solves.
  void put(const ProblemParts& parts, int part, const QuickAnswer& quick) {
    for (int k = 0; k < parts.sizeOf(part); k += 3) {
      const int at = parts.unknown(part, k);
      solution_.r.segment<3>(at) = quick.best().r.segment<3>(at);
      solution_.u.segment<3>(at) = quick.best().u.segment<3>(at);
      solution_.activeSet.contacts[at / 3] = quick.modeOf(at / 3);
      count(quick.residualOf(at / 3), quick.residualOf(at / 3), 1);
    }
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
  double squares_ = 0;  ///< sum of squared residuals, (m/s)²
  int counted_ = 0;     ///< contacts and rows
};

/// If the budget of a part has run out, takes its reactions from the quick answer if they are
/// better.
void takeBetter(const ProblemParts& parts, int part, const QuickAnswer& quick, Solution& solution) {
  if (solution.status != Status::OutOfBudget) return;
  const int contacts = parts.sizeOf(part) / 3;
  double residual = 0, squares = 0;
  int worst = 0;
  for (int i = 0; i < contacts; ++i) {
    const double own = quick.residualOf(parts.unknown(part, 3 * i) / 3);
    if (own > residual) residual = own, worst = i;
    squares += own * own;
  }
  if (!(residual < solution.residual)) return;
  for (int i = 0; i < contacts; ++i) {
    const int at = parts.unknown(part, 3 * i);
    solution.r.segment<3>(3 * i) = quick.best().r.segment<3>(at);
    solution.u.segment<3>(3 * i) = quick.best().u.segment<3>(at);
    solution.activeSet.contacts[i] = quick.modeOf(at / 3);
  }
  solution.residual = residual;
  solution.residualRms = std::sqrt(squares / contacts);
  solution.blamed = {3 * worst};
}

/// Whether the problem can be split: no disk points out of it.
bool disksAreInside(const Problem& problem) {
  const auto isInside = [&](int unknown) { return unknown >= 0 && unknown < problem.size(); };
  return std::all_of(problem.disks.begin(), problem.disks.end(), [&](const Disk& disk) {
    return isInside(disk.governor) && isInside(disk.first) && disk.unknowns >= 1 &&
           disk.unknowns <= 2 && isInside(disk.first + disk.unknowns - 1);
  });
}

/// Solves a single contact by its formula. False if that does not reach the tolerance.
bool answerByFormula(const Problem& problem, const Options& options, Solution& answer) {
  const double mu = problem.friction[0];
  const Mat3 W = problem.W.contactBlock(0);
  const Vec3 q = problem.q, r = projectOnCone(solveOneContact(W, q, mu), mu), u = W * r + q;
  const double residual = naturalResidual(contactSize(W), mu, r, u);
  if (!(residual <= toleranceOf(options, problem))) return false;
  answer.start(problem.q);
  answer.r = r;
  answer.u = u;
  answer.residual = answer.residualRms = residual;
  answer.activeSet.contacts.assign(1, modeOf(r, u, mu, W.diagonal().mean()));
  answer.tier = Tier::ClosedForm;
  answer.regions = 1;
  return true;
}

}  // namespace

Solution solve(const Problem& problem, const Options& options) {
  check(options);  // many answers need no Solver
  const QuietArithmetic quiet;
  if (problem.W.inBodySpace() || !disksAreInside(problem)) return Solver(options).solve(problem);
  Solution solution;
  std::optional<QuickAnswer> quick;
  if (options.economies.closedForms && problem.contacts() > 0 && problem.rows() == 0 &&
      unfitParts(problem).empty()) {
    if (problem.contacts() == 1 && answerByFormula(problem, options, solution)) return solution;
    quick.emplace(problem, options);
    if (quick->find(solution)) return solution;
  }
  Options left = options;
  if (quick) {
    left.newtonBudget -= quick->best().regions;
    left.sweepBudget -= quick->best().sweeps;
  }
  const ProblemParts parts(problem);
  if (parts.count() == 1) {
    Solver(left).solve(problem, {}, solution);
    if (quick) takeBetter(parts, 0, *quick, solution);
  } else {
    Whole whole(problem);
    std::optional<Solver> solver;  // made once a part needs it
    for (int k = 0; k < parts.count(); ++k) {
      if (quick && quick->answers(parts, k)) {
        whole.put(parts, k, *quick);
        continue;
      }
      if (!solver) solver.emplace(left);
      const Problem part = parts.problemOf(k);
      solver->solve(part, {}, solution);
      if (quick) takeBetter(parts, k, *quick, solution);
      whole.put(parts, k, part, solution);
    }
    solution = whole.take();
  }
  if (quick) solution.addWork(quick->best());
  return solution;
}

}  // namespace delassus
