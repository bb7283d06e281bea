#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "delassus/cone.h"
#include "delassus/disk.h"
#include "delassus/problem.h"
#include "delassus/types.h"

namespace delassus {

/// The limits of the reactions of contacts, rows and disks, as in Problem.
struct ReactionBounds {
  const VectorXd &friction, &lower, &upper;
  const std::vector<Disk>& disks;

  static ReactionBounds of(const Problem& problem) {
    return {problem.friction, problem.lower, problem.upper, problem.disks};
  }
  int contacts() const { return static_cast<int>(friction.size()); }
  /// Rows that belong to no disk.
  int rows() const {
    const int contactsEnd = 3 * contacts();
    return disks.empty() ? static_cast<int>(lower.size()) : disks.front().first - contactsEnd;
  }
};

/// The error of Alart and Curnier (1991) of reactions r with velocities u: for each contact, row
/// and disk
///
///     F = P(r − u/ρ) − r
///
/// P moves into the cone (reactionTo), the bounds, or the disk whose radius is that of the moved
/// governor. `rho(a)`: ρ of the part whose first unknown is a, 1/kg. Writes F, and returns ‖ρ F‖,
/// m/s.
template <class Vector, class Rho>
double reactionError(const ReactionBounds& bounds, const Vector& r, const Vector& u, const Rho& rho,
                     Vector& F) {
  const int contactsEnd = 3 * bounds.contacts();
  double sum = 0;
  for (int i = 0; i < bounds.contacts(); ++i) {
    const int at = 3 * i;
    const Vec3 own = r.template segment<3>(at);
    const Vec3 z = own - u.template segment<3>(at) / rho(at);
    const Vec3 f = reactionTo(z, bounds.friction[i], nullptr) - own;
    F.template segment<3>(at) = f;
    sum += (rho(at) * f).squaredNorm();
  }
  for (int i = 0; i < bounds.rows(); ++i) {
    const int at = contactsEnd + i;
    F[at] = std::clamp(r[at] - u[at] / rho(at), bounds.lower[i], bounds.upper[i]) - r[at];
    sum += rho(at) * F[at] * rho(at) * F[at];
  }
  for (const Disk& disk : bounds.disks) {
    const Vec2 own = disk.of(r), z = own - disk.of(u) / rho(disk.first);
    const double load = r[disk.governor] + F[disk.governor];
    const Vec2 f = projectOnDisk(z, disk.radiusUnder(load)) - own;
    for (int j = 0; j < disk.unknowns; ++j) F[disk.first + j] = f[j];
    sum += (rho(disk.first) * f).squaredNorm();
  }
  return std::sqrt(sum);
}

}  // namespace delassus
