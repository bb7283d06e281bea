#include "tests/support/certificate.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace delassus::test {

MotionBound motionBound(const Problem& problem, const VectorXd& r, const VectorXd& u,
                        const VectorXd& largestReaction) {
  assert(r.size() == problem.size() && u.size() == problem.size() && "one number an unknown");
  assert((largestReaction.size() == 0 || largestReaction.size() == problem.size()) &&
         "no reaction is limited, or all are");
  const MotionBound nothingKnown{infinity, 0};
  if ((problem.friction.array() > 0).any() || !problem.disks.empty()) return nothingKnown;

  MotionBound bound;
  for (int i = 0; i < problem.size(); ++i) {
    const Interval allowed = allowedWithoutFriction(problem, i);
    if (!contains(allowed, r[i]) || std::isnan(u[i])) return nothingKnown;
    if (u[i] == 0) continue;

    // How far the true reaction can be on the side where it makes u_i (r_i − r*_i) positive.
    double reach = u[i] > 0 ? r[i] - allowed.lower : allowed.upper - r[i];
    if (largestReaction.size() > 0)
      reach = std::clamp(largestReaction[i] + (u[i] > 0 ? r[i] : -r[i]), 0.0, reach);
    if (std::isinf(reach))
      bound.relaxation = std::max(bound.relaxation, std::abs(u[i]));
    else
      bound.squared += std::abs(u[i]) * reach;
  }
  return bound;
}

EnergyBalance energyBalance(const Problem& problem, const VectorXd& target, const VectorXd& r) {
  assert(target.size() == problem.size() && r.size() == problem.size() && "one number an unknown");
  const VectorXd Wr = problem.W * r;
  const VectorXd u = Wr + problem.q;
  const double soft =
      problem.W.inBodySpace() ? problem.W.bodySpace().compliance.dot(r.cwiseAbs2()) : 0;
  const double jump = 0.5 * (r.dot(Wr) - soft);

  EnergyBalance balance;
  balance.change = r.dot(problem.q + target) + jump;
  balance.targets = r.dot(target);
  for (int a = 0; a < problem.contacts(); ++a)
    balance.friction -= problem.friction[a] * r[3 * a] * std::hypot(u[3 * a + 1], u[3 * a + 2]);
  for (const Disk& disk : problem.disks) balance.friction -= disk.radiusAt(r) * disk.of(u).norm();
  balance.complementarity = r.dot(u) - balance.friction;
  balance.compliance = -soft;
  balance.impact = -jump;
  return balance;
}

}  // namespace delassus::test
