#pragma once
/// One contact with Coulomb friction, solved by looking everywhere: slow, sure, and sharing no
/// formula with the library.

#include <vector>

#include "delassus/active_set.h"
#include "delassus/types.h"

namespace delassus::test {

struct ReferenceContact {
  Mode mode = Mode::Open;
  Vec3 r = Vec3::Zero(), u = Vec3::Zero();
};

/// All solutions of u = W r + q, K_μ ∋ r ⟂ u + μ|u_t| n ∈ K_μ*, in the order take-off, stick, slip
/// by ascending |u_t| / |r_t|. W positive definite; not every W has exactly one solution
/// (algorithms §6.2), but each has one.
std::vector<ReferenceContact> allContactSolutions(const Mat3& W, const Vec3& q, double mu);

/// The first of them.
ReferenceContact referenceContact(const Mat3& W, const Vec3& q, double mu);

}  // namespace delassus::test
