#include "delassus/farkas.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delassus {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Bounds of the reaction of one unknown of demandsAlone.
struct Bounds {
  double lower, upper;
};

Bounds boundsOf(const Problem& demands, int unknown) {
  const int row = unknown - 3 * demands.contacts();
  if (row >= 0) return {demands.lower[row], demands.upper[row]};
  return {0, unknown % 3 == 0 ? infinity : 0};
}

}  // namespace

Problem demandsAlone(const Problem& problem) {
  Problem demands = problem;
  const int n = problem.contacts();
  demands.friction.setZero(n);
  for (int i = 0; i < n; ++i) demands.q.segment<2>(3 * i + 1).setZero();
  for (int i = 0; i < problem.rows(); ++i) {
    const bool ofDisk = 3 * n + i >= problem.disksBegin();
    demands.lower[i] = !ofDisk && problem.lower[i] == -infinity ? -infinity : 0;
    demands.upper[i] = !ofDisk && problem.upper[i] == infinity ? infinity : 0;
    if (demands.lower[i] == demands.upper[i]) demands.q[3 * n + i] = 0;
  }
  demands.disks.clear();
  return demands;
}

double leastMotion(const Problem& demands, const VectorXd& r) {
  // Squares of what is felt, not r·W r: where large reactions cancel, that is all rounding.
  constexpr double roundings = 8;
  const BodySpace& space = demands.W.bodySpace();
  VectorXd felt, diagonal;
  space.impulse(r, felt);
  demands.W.diagonal(diagonal);
  const double compliant = space.compliance.dot(r.cwiseAbs2());
  const double noise = roundings * epsilon * diagonal.cwiseSqrt().dot(r.cwiseAbs());
  const double doubt = demands.roundOff * r.cwiseAbs().sum() +
                       roundings * epsilon * demands.q.cwiseAbs().dot(r.cwiseAbs());
  const double push = -r.dot(demands.q) - doubt;
  return push > 0 ? push / (std::sqrt(felt.squaredNorm() + compliant) + noise) : 0;
}

double hardestAlone(const Problem& demands) {
  VectorXd diagonal;
  demands.W.diagonal(diagonal);
  double hardest = 0;
  for (int i = 0; i < demands.size(); ++i) {
    const Bounds bounds = boundsOf(demands, i);
    const double missing = std::max(bounds.upper > 0 ? -demands.q[i] : 0,  //
                                    bounds.lower < 0 ? demands.q[i] : 0);
    if (missing > 0 && diagonal[i] > 0)
      hardest = std::max(hardest, missing / std::sqrt(diagonal[i]));
  }
  return hardest;
}

VectorXd findQuarrel(ProximalNewton<BodyMotion>& newton, const Problem& problem, double tolerance,
                     int& regionBudget, Solution& count) {
  // Times the motion that the hardest demand alone asks for. Less proves nothing: a wedge of a microradian that holds a ball
  // demands a millionth of what the ball needs.
  constexpr double proportion = 1e8;
  constexpr double compliances[] = {1e-6, 1e-8};  // relative to W_aa
  const Problem demands = demandsAlone(problem);
  NaturalMap map;
  map.setProblem(demands);
  newton.setProblem(demands, map);
  // What pushes in vain is in inverse proportion to the compliance; all else hardly depends on it, and is gone in the difference.
  VectorXd pushes[2];
  for (int k = 0; k < 2; ++k) {
    Solution compliant;
    compliant.start(demands.q);
    const bool found = newton.yield(demands, tolerance, compliances[k], regionBudget, compliant);
    count.regions += compliant.regions;
    count.factorisations += compliant.factorisations;
    if (!found) return {};
    pushes[k] = compliant.r;
  }
  VectorXd quarrel = pushes[1] - pushes[0];
  for (int i = 0; i < quarrel.size(); ++i) {
    const Bounds bounds = boundsOf(demands, i);
    quarrel[i] = std::clamp(quarrel[i], bounds.lower, bounds.upper);
  }
  if (!(leastMotion(demands, quarrel) > proportion * hardestAlone(demands))) return {};
  return quarrel;
}

}  // namespace delassus
