#include <algorithm>
#include <cmath>

#include "delassus/solver.h"
#include "delassus/split_problem.h"

namespace delassus {

Solution solve(const Problem& problem, const Options& options) {
  Solver solver(options);
  if (problem.W.inBodySpace() || problem.contacts() + problem.rows() == 1)
    return solver.solve(problem);

  // Parts that nothing couples are solved apart.
  Solution whole;
  double squares = 0;  // of residuals, (m/s)²
  int parts = 0;
  whole.r = VectorXd::Zero(problem.size());
  whole.u = whole.r;
  whole.activeSet.contacts.resize(problem.contacts());
  whole.activeSet.rows.resize(problem.rows());
  whole.activeSet.disks.resize(problem.disks.size());
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
    std::size_t disk = 0;  // of the part; the whole has them in the same order
    for (std::size_t k = 0; k < problem.disks.size() && disk < s.activeSet.disks.size(); ++k)
      if (problem.disks[k].first == part.unknowns[part.problem.disks[disk].first])
        whole.activeSet.disks[k] = s.activeSet.disks[disk++];
    whole.status = std::max(whole.status, s.status);
    whole.residual = std::max(whole.residual, s.residual);
    const int size = n + part.problem.rows();
    squares += s.residualRms * s.residualRms * size;
    parts += size;
    whole.regions += s.regions;
    whole.factorisations += s.factorisations;
    whole.sweeps += s.sweeps;
    whole.patches += s.patches;
    for (int blamed : s.blamed) whole.blamed.push_back(part.unknowns[blamed]);
  }
  if (parts > 0) whole.residualRms = std::sqrt(squares / parts);
  return whole;
}

}  // namespace delassus
