#pragma once

#include <vector>

#include "delassus/island.h"
#include "delassus/options.h"
#include "delassus/solution.h"

namespace delassus {

/// Checks, contact by contact, whether an island needs no solving. It builds no W and factors
/// nothing.
class IslandCheck {
 public:
  explicit IslandCheck(const Options& options) : options_(options) {}

  /// Whether the free motion keeps the law: r = 0 and u = q, up to the round-off of the velocities
  /// that cancel in q,
  ///
  ///     contacts:  q_n ≥ 0
  ///     rows:      lower ≤ 0 ≤ upper,  q ≤ 0 if lower < 0,  q ≥ 0 if upper > 0
  ///
  /// Stops at the first contact that approaches.
  bool isFree(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
              const std::vector<Row>& rows, const Island& island, Solution& solution) const;

  /// Whether the reactions in `solution.r`, moved into their cones and bounds, keep the law:
  /// whether their natural residual, ‖r − P(r − ρ v)‖/ρ with ρ = 1/trace W_aa for contacts, is
  /// within the tolerance. (A shorter ρ makes it larger: it bounds the one with ρ = 1/‖W_aa‖.)
  /// `share` is how much of the tolerance may be used. `moved` must be a copy of `bodies` at first.
  /// If the law is kept, `moved` then holds the velocities v_f + M⁻¹ Jᵀ r; otherwise `moved` and
  /// `solution.r` are as before, except for that projection.
  ///
  /// If no body is left faster than `share` of 1e-8 of the largest demand (of the tolerance, if
  /// that is less), `moved` is set to rest; u and the residual keep their values. Kept reactions do
  /// not respond to motion: the rounding of one step would grow in all later steps, in a pile by a
  /// third per step, until the reactions are solved anew and the narrow phase replaces the points
  /// on which the pile stands. An effect that accelerates a body by less per step, as that of a
  /// slope of 1e-9 rad on a ball, does not move it.
  bool isKept(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
              const std::vector<Row>& rows, const Island& island, double share,
              std::vector<Body>& moved, Solution& solution);

  std::size_t bytes() const { return bytesOf(impulses_); }

 private:
  double move(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
              const std::vector<Row>& rows, const Island& island, std::vector<Body>& moved,
              VectorXd& r);

  Options options_;
  std::vector<Vec6> impulses_;  ///< on each body, N·s and N·m·s
};

}  // namespace delassus
