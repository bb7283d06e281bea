#pragma once
/// One contact with Coulomb friction, solved by looking everywhere: slow, reliable, and without any
/// formula of the library.

#include <vector>

#include "delassus/active_set.h"
#include "delassus/types.h"

namespace delassus::test {

struct ReferenceContact {
  Mode mode = Mode::Open;
  Vec3 r = Vec3::Zero(), u = Vec3::Zero();
};

/// All solutions of u = W r + q, K_μ ∋ r ⟂ u + μ|u_t| n ∈ K_μ*, in the order take-off, stick, slip
/// by ascending |u_t| / |r_t|. W positive definite. Each W has a solution, but not every W has
/// exactly one (algorithms §6.2).
std::vector<ReferenceContact> allContactSolutions(const Mat3& W, const Vec3& q, double mu);

/// The first of these solutions.
ReferenceContact referenceContact(const Mat3& W, const Vec3& q, double mu);

}  // namespace delassus::test
