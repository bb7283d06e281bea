#pragma once

#include <vector>

#include "delassus/contact.h"
#include "delassus/row.h"

namespace delassus {

/// Friction against the relative rotation ω = ω_a − ω_b of two bodies in contact, with r_n the
/// normal reaction of contact `index`:
///
///     spinning:  |τ_n| ≤ κ_s r_n              opposite to n·ω
///     rolling:   ‖(τ_1, τ_2)‖ ≤ κ_r r_n       opposite to (a_1·ω, a_2·ω)
///
/// with min(r_n, mostLoad) in place of r_n, about the normal and about two `axes`: unit vectors in
/// the tangent plane, or shorter ones where the body resists less.
struct TurningFriction {
  double spinning = 0, rolling = 0;  ///< κ_s and κ_r, m
  Eigen::Matrix<double, 3, 2> axes;
  double mostLoad = infinity;  ///< N·s
};

/// Appends the rows, but none for a coefficient that is not positive.
inline void addRows(const TurningFriction& friction, const Contact& contact, int index,
                    std::vector<Row>& rows) {
  const auto add = [&](const Vec3& axis, double coefficient, bool paired) {
    Row row;
    row.a = contact.a;
    row.b = contact.b;
    row.jacobianA.tail<3>() = axis.transpose();
    row.jacobianB.tail<3>() = -axis.transpose();
    row.upper = coefficient;
    row.governor = index;
    row.mostLoad = friction.mostLoad;
    row.paired = paired;
    rows.push_back(row);
  };
  if (friction.spinning > 0) add(contact.frame.col(0), friction.spinning, false);
  if (friction.rolling > 0) {
    add(friction.axes.col(0), friction.rolling, true);
    add(friction.axes.col(1), friction.rolling, false);
  }
}

}  // namespace delassus
