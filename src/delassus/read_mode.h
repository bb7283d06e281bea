#pragma once

#include "delassus/active_set.h"
#include "delassus/cone.h"
#include "delassus/disk.h"
#include "delassus/length.h"
#include "delassus/problem.h"

namespace delassus {

/// The mode of a contact, from the point z = r − v/W_aa that the law projects (r alone misleads
/// where contacts graze). `weight` stands for W_aa: the mean of its diagonal, 1/kg.
inline Mode modeOf(const Vec3& r, const Vec3& u, double friction, double weight) {
  const double rho = weight > 0 ? 1 / weight : 0;
  const Vec3 z = r - rho * correctedVelocity(u, friction);
  const double zt = lengthOf(z[1], z[2]);
  return friction * zt <= -z[0] || (z[0] <= 0 && zt == 0) ? Mode::Open
         : zt < friction * z[0]                           ? Mode::Stick
                                                          : Mode::Slide;
}

/// The same for a row, from its z.
inline RowState stateAt(double z, double lower, double upper) {
  return z <= lower ? RowState::AtLower : z >= upper ? RowState::AtUpper : RowState::Free;
}
inline RowState stateOf(double r, double u, double lower, double upper, double weight) {
  return stateAt(r - (weight > 0 ? u / weight : 0), lower, upper);
}

/// The same for a disk with this radius now.
inline Mode diskModeOf(const Vec2& r, const Vec2& u, double radius, double weight) {
  if (!(radius > 0)) return Mode::Open;
  const Vec2 z = r - (weight > 0 ? 1 / weight : 0) * u;
  return lengthOf(z[0], z[1]) < radius ? Mode::Stick : Mode::Slide;
}

/// The region in which the reactions lie, u = W r + q. `diagonal`: that of W.
void readActiveSet(const Problem& problem, const VectorXd& diagonal, const VectorXd& r,
                   const VectorXd& u, ActiveSet& set);

}  // namespace delassus
