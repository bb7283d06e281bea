#pragma once

#include <algorithm>

#include "delassus/length.h"
#include "delassus/types.h"

namespace delassus {

/// Rolling friction (two rows, about the tangents of a contact) or spinning friction (one row,
/// about its normal). Another reaction limits its size:
///
///     ‖r_d‖ ≤ κ r_n,   and where u_d ≠ 0:  r_d = −κ r_n u_d/‖u_d‖       (maximum dissipation)
///
/// Where `mostLoad` is finite, it limits the r_n that counts: ‖r_d‖ ≤ κ min(r_n, mostLoad).
///
/// This is Coulomb's law with an unknown of its own. Disks come last among the unknowns, so that
/// r_n is known when a method goes through the unknowns in order. About axes u_d is in rad/s, r_d
/// in N·m·s, and κ in m; along arcs they are in m/s, in N·s, and a number.
struct Disk {
  int first;                   ///< its first unknown, a row
  int unknowns;                ///< 1, or 2 consecutive ones
  int governor;                ///< the unknown r_n, of a contact with friction or a row
  double radius;               ///< κ > 0
  double mostLoad = infinity;  ///< N·s, > 0

  bool operator==(const Disk& other) const {
    return first == other.first && unknowns == other.unknowns && governor == other.governor &&
           radius == other.radius && mostLoad == other.mostLoad;
  }

  /// Its part of a vector of unknowns; a missing second one is 0.
  template <class Vector>
  Vec2 of(const Vector& x) const {
    return {x[first], unknowns == 2 ? x[first + 1] : 0};
  }
  void put(const Vec2& part, VectorXd& x) const {
    x.segment(first, unknowns) = part.head(unknowns);
  }
  /// Its radius under the normal reaction `load`.
  double radiusUnder(double load) const { return radius * std::clamp(load, 0.0, mostLoad); }
  /// Its radius now.
  double radiusAt(const VectorXd& r) const { return radiusUnder(r[governor]); }
  /// Whether its radius grows with r_n.
  bool grows(const VectorXd& r) const { return r[governor] < mostLoad; }
};

/// Euclidean projection on the disk of this radius about 0.
inline Vec2 projectOnDisk(const Vec2& x, double radius) {
  const double length = lengthOf(x[0], x[1]);
  return length <= radius ? x : Vec2(x * (radius / length));
}

}  // namespace delassus
