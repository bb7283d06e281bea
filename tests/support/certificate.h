#pragma once
/// What can be proven of reactions without knowing the answer.

#include "delassus/problem.h"

namespace delassus::test {

/// Whether a reaction is allowed.
inline bool contains(const Interval& allowed, double reaction) {
  return allowed.lower <= reaction && reaction <= allowed.upper;
}

/// How far the motion v that the reactions r make can be from the true motion v* (algorithms §9.4):
///
///     |v − v*|²_M + |r − r*|²_R  ≤  squared
///
/// holds for the problem as given if `relaxation` is 0. Otherwise it holds for the problem in which
/// the demands that r misses are relaxed, each by at most `relaxation`: q_i + δ_i in place of q_i,
/// |δ_i| ≤ relaxation.
///
/// Valid if all of these hold (then, and only then, is a finite number returned):
///   - no contact has friction, and there are no disks: Coulomb's law is not associated, and the
///     bound is false for it;
///   - the reactions are allowed: lower ≤ r ≤ upper, to the last bit; tangential reactions of μ = 0
///     are zero.
/// It is assumed, too, that u = W r + q, that the symmetric part of W is positive semi-definite,
/// and that the bounded problem has a solution. Round-off in u, about ε (|W||r| + |q|) an entry, is
/// not counted.
struct MotionBound {
  double squared = 0;     ///< kg (m/s)², twice an energy; ∞ where the bound is not valid
  double relaxation = 0;  ///< m/s
};

/// From the monotonicity of the law: (r − r*)·(u − u*) = |v − v*|²_M + |r − r*|²_R and (r − r*)·u*
/// ≥ 0, so that
///
///     squared = Σ_{u_i > 0} u_i (r_i − lower_i) + Σ_{u_i < 0} |u_i| (upper_i − r_i)
///
/// For unilateral rows with u ≥ 0 that is r·u. An entry whose bound is infinite is relaxed by |u_i|
/// instead. `largestReaction`, if not empty, states |r*_i| ≤ largestReaction_i and so narrows the
/// bounds: then nothing is relaxed. For unilateral rows `squared` is then
/// r·u + largestReaction·max(0, −u), as long as r keeps to the statement too.
MotionBound motionBound(const Problem& problem, const VectorXd& r, const VectorXd& u,
                        const VectorXd& largestReaction = {});

/// Where the kinetic energy goes in one step (algorithms §9.5), in joules. With v = v_f + M⁻¹Jᵀr, J
/// v_f = q + target and u = J v − target + R r, for any reactions r:
///
///     E(v) − E(v_f) = targets + friction + complementarity + compliance + impact
///
/// `change` is computed from the free velocity, the right side from u. So comparing them tests
/// u = W r + q.
struct EnergyBalance {
  double change = 0;   ///< E(v) − E(v_f) = r·(q + target) + ½ |v − v_f|²_M
  double targets = 0;  ///< r·target: fed in by restitution, push-out, belts and motors
  double friction = 0;  ///< −Σ μ r_n |u_t| − Σ κ r_n |u_d|: lost by sliding, rolling and spinning
  /// R·u − friction: 0 for contacts and limits that obey their law, ≤ 0 for motors.
  double complementarity = 0;
  double compliance = 0;  ///< −r·R r: lost in, or stored by, soft constraints
  double impact = 0;      ///< −½ |v − v_f|²_M ≤ 0: Carnot's loss

  double sum() const { return targets + friction + complementarity + compliance + impact; }
};

/// `target` in the order of q, m/s. R is known for W in body space; an explicit W counts as R = 0.
EnergyBalance energyBalance(const Problem& problem, const VectorXd& target, const VectorXd& r);

}  // namespace delassus::test
