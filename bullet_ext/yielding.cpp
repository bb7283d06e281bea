#include "bullet_ext/yielding.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bullet_ext/gather.h"
#include "delassus/residual.h"

namespace delassus::bullet {
namespace {

/// W_ii of a scalar row without its compliance, but for what limbs of articulated bodies add.
double responseOf(const Problem& problem, int unknown) {
  const ScalarRow& row = problem.W.bodySpace().rows[unknown - 3 * problem.contacts()];
  return (row.a >= 0 ? row.Ja.squaredNorm() : 0) + (row.b >= 0 ? row.Jb.squaredNorm() : 0);
}

}  // namespace

std::vector<int> whatYields(const Problem& problem, int firstRow, const IslandScales& scales,
                            const VectorXd& r) {
  constexpr double shot = 100, large = 0.1;  // shares of speeds
  // Slip by the masses alone; leaves four digits for levers.
  constexpr double telling = 1e-5;
  constexpr double rounding = 2;
  std::vector<int> yielding;
  if (3 * problem.contacts() >= problem.disksBegin()) return yielding;
  const double demand = problem.q.cwiseAbs().maxCoeff();
  const double fastest = shot * std::max(demand, scales.speed);
  const double mostWork = scales.massRatio * fastest * fastest;
  for (int i = 3 * problem.contacts(); i < firstRow; ++i)
    if (-r[i] * problem.q[i] * responseOf(problem, i) > mostWork) yielding.push_back(i);
  if (scales.massRatio * leastSoftness > telling) return yielding;
  const VectorXd& compliance = problem.W.bodySpace().compliance;
  VectorXd diagonal;
  for (int i = firstRow; i < problem.disksBegin(); ++i) {
    if (!(compliance[i] * std::abs(r[i]) > large * demand)) continue;
    if (diagonal.size() == 0) diagonal = problem.W.diagonal();
    if (compliance[i] <= rounding * leastSoftness * diagonal[i]) yielding.push_back(i);
  }
  return yielding;
}

void letYield(const Problem& problem, const std::vector<int>& yielding, Solver& solver,
              Solution& solution) {
  constexpr double softness = 1e-2, negligible = 0.1;
  const VectorXd diagonal = problem.W.diagonal();
  Problem soft = problem;
  BodySpace& space = soft.W.refill(problem.size());
  space = problem.W.bodySpace();
  for (const int i : yielding) space.compliance[i] = softness * diagonal[i];
  Solution answer;
  solver.solve(soft, {}, answer);

  const VectorXd energy = diagonal.cwiseSqrt().cwiseProduct(answer.r.cwiseAbs());
  double most = 0;
  for (const int i : yielding) most = std::max(most, energy[i]);
  const int contactsEnd = 3 * problem.contacts();
  solution.blamed.clear();
  for (int i = 0; i < problem.disksBegin(); i += i < contactsEnd ? 3 : 1)
    if (energy[i] > negligible * most) solution.blamed.push_back(i);

  solution.r = std::move(answer.r);
  solution.u = problem.W * solution.r + problem.q;
  solution.setResidual(naturalResidual(problem, solution.r, solution.u));
  solution.activeSet = std::move(answer.activeSet);
  solution.status = Status::Incompatible;
  solution.regions += answer.regions;
  solution.factorisations += answer.factorisations;
  solution.sweeps += answer.sweeps;
  solution.patches += answer.patches;
}

}  // namespace delassus::bullet
