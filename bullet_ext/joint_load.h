#pragma once

#include <vector>

#include "delassus/types.h"

namespace delassus::bullet {

struct Group;
struct JointSource;

/// What the rows of a joint do to its bodies in a step. Unlike their reactions it means the same
/// when limits or motors come or go, or Bullet turns the axes of the rows.
struct JointLoad {
  /// Σ J_iᵀ r_i: impulse, N·s, and moment about the body's centre, N·m·s, in world axes.
  Vec6 onA = Vec6::Zero(), onB = Vec6::Zero();
};

/// The load of these reactions, one for each of the group's rows.
JointLoad loadOf(const Group& group, const JointSource& joint,
                 const std::vector<double>& reactions);

/// Whether the reactions, which are those of the joint's rows, make `load` to within a tenth of
/// what these rows push. As in takeLoad, that on the first of its bodies that moves counts.
bool makesLoad(const Group& group, const JointSource& joint, const double* reactions,
               const JointLoad& load);

/// Sets the reactions of the joint's rows to the smallest that come as near as possible to `load`,
/// whatever their bounds:
///
///     |J̃ᵀ r − f̃|² + ε Σ |J̃_i|² r_i² = min,   J̃ = J S,  f̃ = S f,
///     S = diag(m⁻¹, m⁻¹, m⁻¹, i, i, i)^½,  i = tr(I⁻¹)/3
void takeLoad(const Group& group, const JointSource& joint, const JointLoad& load,
              double* reactions);

}  // namespace delassus::bullet
