#include "delassus/farkas.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delassus {

Problem demandsAlone(const Problem& problem) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Problem demands = problem;
  demands.friction.setZero(problem.contacts());
  const int disksBegin = problem.disksBegin() - 3 * problem.contacts();
  for (int i = 0; i < problem.rows(); ++i) {
    const bool ofDisk = i >= disksBegin;
    demands.lower[i] = !ofDisk && problem.lower[i] == -infinity ? -infinity : 0;
    demands.upper[i] = !ofDisk && problem.upper[i] == infinity ? infinity : 0;
  }
  demands.disks.clear();
  return demands;
}

double leastMotion(const Problem& demands, const VectorXd& r) {
  const double push = -r.dot(demands.q);
  if (!(push > 0)) return 0;
  return push / std::sqrt(std::max(r.dot(demands.W * r), 0.0));
}

double hardestAlone(const Problem& demands, const VectorXd& diagonal) {
  double hardest = 0;
  for (int i = 0; i < demands.size(); ++i)
    if (diagonal[i] > 0)
      hardest = std::max(hardest, std::abs(demands.q[i]) / std::sqrt(diagonal[i]));
  return hardest;
}

}  // namespace delassus
