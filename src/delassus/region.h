#pragma once

#include <optional>

#include "delassus/types.h"

namespace delassus {

/// Delassus' regions for a handful of frictionless contacts: which contacts persist, and with what
/// reaction.
///
///     u = W r + q,   0 ≤ r ⊥ u ≥ 0,   W symmetric positive semi-definite   (paper §6-§8, §11)
///
/// The tests are written in q, not in the forced reactions f = −W⁻¹ q, so that the region is chosen
/// without any division.

/// Most contacts for the release recursion; with more, pivoting visits fewer regions.
constexpr int smallRegionSize = 6;

using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, smallRegionSize, 1>;
using SmallMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, smallRegionSize, smallRegionSize>;

/// What the redundancy of contacts leaves open.
enum class Redundancy : unsigned char {
  None,       ///< the reaction is unique
  Shared,     ///< one constraint stated twice: the load is shared, least norm
  Squeezed,   ///< two contacts push against each other: least-squares compromise
  Dependent,  ///< W is singular to working precision: r and u are not set, ask `pivot`
};

/// The region that holds q, and its motion.
struct RegionAnswer {
  SmallVector r;         ///< reactions, N·s
  SmallVector u;         ///< relative velocities W r + q, m/s
  int regionsTried = 0;  ///< systems whose answer was looked at
  Redundancy redundancy = Redundancy::None;

  bool persists(int contact) const { return r[contact] > 0; }
};

/// n = 1 (paper §6): kept if q < 0, with r = −q/W; released otherwise. W > 0.
double oneContact(double W, double q);

/// n = 2 (paper §7-§8) by the signs of b-type cofactors (algorithms 3.3). Empty if 1 − W01²/(W00
/// W11) is too small for cofactors to keep their digits (at most 1e-4).
std::optional<Eigen::Vector2d> twoContacts(const Eigen::Matrix2d& W, const Eigen::Vector2d& q);

/// n = 3 (paper §11): eight trihedra, by cofactors (algorithms 3.3). Empty where cofactors lose
/// digits: if, of the matrix scaled to unit diagonal, a pivot is at most 1e-4 or the determinant at
/// most 1e-2.
std::optional<Eigen::Vector3d> threeContacts(const Eigen::Matrix3d& W, const Eigen::Vector3d& q);

/// Reactions that `releaseRecursion` found.
struct Recursion {
  SmallVector r;         ///< of contacts scaled to unit diagonal, √J
  int regionsTried = 0;  ///< systems whose answer was looked at
};

/// Any n up to `smallRegionSize`, exact and backward stable whatever the conditioning (algorithms
/// 3.4). W has unit diagonal.
///
/// Hold one contact as a bilateral one while the others stay unilateral. If its reaction is not
/// negative this is the motion; if it is negative, that contact is released. Empty if a pivot shows
/// a dependent contact (3.5).
std::optional<Recursion> releaseRecursion(const SmallMatrix& W, const SmallVector& q);

/// Up to `smallRegionSize` contacts: scales to unit diagonal, then the closed form where it is
/// safe, else the recursion. A redundant pair (n = 2) is answered here as well, see Redundancy.
RegionAnswer solveRegion(const SmallMatrix& W, const SmallVector& q);

}  // namespace delassus
