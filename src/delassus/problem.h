#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "delassus/delassus_matrix.h"
#include "delassus/disk.h"

namespace delassus {

/// The problem of one island. Unknown reactions r: three per contact (normal, t1, t2), then one per
/// row.
///
///     u = W r + q
///     contacts:  K_μ ∋ r ⟂ u + μ‖u_t‖ n ∈ K_μ*          (Signorini and Coulomb; De Saxcé's form)
///     rows:      lower ≤ r ≤ upper, u ≥ 0 at lower, u ≤ 0 at upper, u = 0 in between
///     disks:     ‖r_d‖ ≤ κ r_n, r_d opposite to u_d and on the rim where u_d ≠ 0 (disk.h)
///
/// A contact without friction is a row with bounds [0, ∞). Impulses N·s, velocities m/s.
struct Problem {
  std::string name;
  DelassusMatrix W;         ///< square, of size 3 n + m; 1/kg
  VectorXd q;               ///< relative velocity without reactions, size 3 n + m
  VectorXd friction;        ///< μ, size n
  VectorXd lower, upper;    ///< bounds of the rows, size m; infinite for those of disks
  std::vector<Disk> disks;  ///< their rows are the last, in this order, without gaps
  double roundOff = 0;      ///< error of q from velocities that cancel in it, m/s
  /// What counts as little is little beside this, even where nothing asks for as much, m/s. Where
  /// nothing but each other holds the bodies, it is the least speed that forces give one in the
  /// step: as these fall together, what they ask of each other may be next to nothing. (Where the
  /// world holds them, a small demand may be what keeps a wedge from sliding.)
  double leastDemand = 0;

  int contacts() const { return static_cast<int>(friction.size()); }
  int rows() const { return static_cast<int>(lower.size()); }
  int parts() const { return contacts() + rows(); }  ///< rows of disks included
  int size() const { return 3 * contacts() + rows(); }
  /// The first unknown of a part; contacts come before rows.
  int unknownOf(int part) const { return part < contacts() ? 3 * part : 2 * contacts() + part; }
  int partAt(int unknown) const {
    return unknown < 3 * contacts() ? unknown / 3 : unknown - 2 * contacts();
  }
  /// Of W only the storage of the body space is counted.
  std::size_t bytes() const { return W.bytes() + bytesOf(q, friction, lower, upper, disks); }
  int disksBegin() const { return disks.empty() ? size() : disks.front().first; }
  int plainRows() const { return disksBegin() - 3 * contacts(); }  ///< those of no disk
  /// The largest demand, m/s: contactDemand, and of rows demandOf; no less than leastDemand.
  double demand() const;
};

/// What a contact asks for, m/s: how fast it approaches or, with friction, slides at q.
inline double contactDemand(const Vec3& q, double friction) {
  return friction > 0 ? std::max({-q[0], std::abs(q[1]), std::abs(q[2])}) : -q[0];
}

/// Whether a row presses whatever it asks for, as a spring does: its bounds exclude 0.
inline bool isForced(double lower, double upper) { return lower > 0 || upper < 0; }

/// The most that a row can ask for, m/s: |q|, but no more than its own reaction could change if the
/// row were alone,
///
///     min(|q|, W_aa b),   b = upper if q < 0, else −lower
///
/// An open limit asks for nothing. A motor of little force asks for little, whatever its speed. A
/// row that is forced asks at least for what its least reaction f changes, max(|q|, W_aa |f|). If
/// W_aa < 0 the answer is |q|. `ownSize()` returns W_aa, which only few rows need.
template <class OwnSize>
double demandOf(double q, double lower, double upper, const OwnSize& ownSize) {
  if (isForced(lower, upper)) return std::max(std::abs(q), ownSize() * std::max(lower, -upper));
  const double bound = q < 0 ? upper : -lower;
  if (bound == infinity) return std::abs(q);
  const double change = bound > 0 ? ownSize() * bound : 0;
  return change < 0 ? std::abs(q) : std::min(std::abs(q), change);
}

/// The interval in which the reaction of one unknown may lie.
struct Interval {
  double lower, upper;
};

/// The interval of an unknown of a contact, as if it had no friction, or of a row.
Interval allowedWithoutFriction(const Problem& problem, int unknown);

/// First unknowns of the contacts, rows and disks for which no law can be stated, ascending. These
/// are parts
///   - whose q, μ, κ, W or bounds are not numbers, or are so large (1e100) that squares overflow;
///   - with μ < 0, lower > upper, κ ≤ 0, or most load ≤ 0;
///   - disks whose r_n does not come before the disks, or whose rows have bounds of their own.
std::vector<int> unfitParts(const Problem& problem);

/// Moves reactions into the cones, bounds and disks: each to the nearest allowed value, those of
/// disks last. True if that changes any of them.
bool makeFeasible(const Problem& problem, VectorXd& r);

}  // namespace delassus
