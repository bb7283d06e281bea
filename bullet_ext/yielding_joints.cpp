#include "bullet_ext/yielding_joints.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bullet_ext/gather.h"
#include "delassus/residual.h"

namespace delassus::bullet {

std::vector<int> yieldingRows(const Problem& problem, int firstRow, double massRatio,
                              const VectorXd& r) {
  constexpr double telling = 1e-5;  // slip by the masses alone; leaves four digits for levers
  constexpr double large = 0.1;     // share of the demands
  constexpr double rounding = 2;
  std::vector<int> rows;
  if (firstRow >= problem.disksBegin() || massRatio * leastSoftness > telling) return rows;
  const VectorXd& compliance = problem.W.bodySpace().compliance;
  const double slip = large * problem.q.cwiseAbs().maxCoeff();
  VectorXd diagonal;
  for (int i = firstRow; i < problem.disksBegin(); ++i) {
    if (!(compliance[i] * std::abs(r[i]) > slip)) continue;
    if (diagonal.size() == 0) diagonal = problem.W.diagonal();
    if (compliance[i] <= rounding * leastSoftness * diagonal[i]) rows.push_back(i);
  }
  return rows;
}

void letYield(const Problem& problem, const std::vector<int>& rows, Solver& solver,
              Solution& solution) {
  constexpr double softness = 1e-2, negligible = 0.1;
  const VectorXd diagonal = problem.W.diagonal();
  Problem soft = problem;
  BodySpace& space = soft.W.refill(problem.size());
  space = problem.W.bodySpace();
  for (const int i : rows) space.compliance[i] = softness * diagonal[i];
  Solution answer;
  solver.solve(soft, {}, answer);

  const VectorXd energy = diagonal.cwiseSqrt().cwiseProduct(answer.r.cwiseAbs());
  double most = 0;
  for (const int i : rows) most = std::max(most, energy[i]);
  answer.blamed.clear();
  const int contactsEnd = 3 * problem.contacts();
  for (int i = 0; i < problem.disksBegin(); i += i < contactsEnd ? 3 : 1)
    if (energy[i] > negligible * most) answer.blamed.push_back(i);

  solution.takeReactions(answer);
  solution.u = problem.W * solution.r + problem.q;
  solution.setResidual(naturalResidual(problem, solution.r, solution.u));
  solution.blamed = std::move(answer.blamed);
  solution.activeSet = std::move(answer.activeSet);
  solution.status = Status::Incompatible;
  solution.regions += answer.regions;
  solution.factorisations += answer.factorisations;
  solution.sweeps += answer.sweeps;
  solution.patches += answer.patches;
}

}  // namespace delassus::bullet
