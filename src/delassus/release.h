#pragma once

#include <vector>

#include "delassus/solution.h"
#include "delassus/types.h"

namespace delassus {

/// A wall of the region that holds q, by the number of contacts whose reaction or opening velocity
/// vanishes there.
enum class Wall : unsigned char {
  Face,    ///< one contact: behind the wall exactly this one changes (paper §11)
  Edge,    ///< several contacts: the region behind is not known in advance, it must be computed
  Vertex,  ///< all contacts (two or more): the region behind must be computed, too
};

/// The paper's question and its answer: of n unilateral constraints that all touch, which will the
/// motion keep?
///
///     u = W r + q,   0 ≤ r ⊥ u ≥ 0
///
/// The distance is measured between forced motions in the norm of W, ‖f‖² = fᵀ W f = qᵀ W⁻¹ q, in
/// √J: half its square is the kinetic energy (paper §4) of the smallest change of the forced motion
/// that reaches the wall. With S the persisting contacts, G = W_SS⁻¹ and R the released ones, the
/// walls and their distances are
///
///     r_i = 0, i ∈ S:   r_i / √G_ii               u_j = 0, j ∈ R:   u_j / √(W_jj − W_jS G W_Sj)
///
/// and every wall of the first kind is orthogonal to every one of the second.
struct ReleaseAnalysis {
  VectorXd forced;  ///< f = −W⁻¹ q, the paper's μ: reactions if all contacts were held (§3), N·s
  std::vector<bool> persisting;  ///< the region (§8, §11): true if the contact is kept
  VectorXd r;                    ///< reduced reactions, the paper's μ' (§5): zero where released
  VectorXd u;                    ///< opening velocities: zero where kept, m/s
  double distance = infinity;    ///< to the nearest wall, √J; infinite if there is none
  Wall wall = Wall::Face;        ///< what that wall is at its nearest point; Face if there is none
  /// Contacts whose reaction or opening velocity vanishes there: they may change from kept to
  /// released or back. Empty if there is no wall.
  std::vector<int> changing;
  Status status = Status::Solved;
  std::vector<int> blamed;  ///< if incompatible, as in PivotResult
};

/// Answers for any number n of contacts. W: n × n, symmetric positive semi-definite (not checked),
/// 1/kg; q: size n, m/s. If status is not Solved, r and u are the best found, and the walls are
/// those of this r and u only. If numbers are not finite, status is NonFinite and no other member
/// is to be read. Where contacts are redundant, f and r are the shares of least norm, Σ W_ii f_i²,
/// and the distances are those at which these shares lose a contact. Throws std::invalid_argument
/// if W is not n × n.
ReleaseAnalysis analyseRelease(const MatrixXd& W, const VectorXd& q);

}  // namespace delassus
