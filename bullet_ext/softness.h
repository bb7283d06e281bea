#pragma once

#include "LinearMath/btScalar.h"

namespace delassus::bullet {

/// The least softness of joint rows, as a share of their W_ii. Poses are rounded, and axes are
/// often given in few digits. So joints that share a freedom (two hinges of a door) contradict each
/// other a little, and if they were rigid they would lock it. With the softness, a contradiction δ
/// (rad, or relative) slows the freedom by the share δ²/softness a step. A joint that carries M
/// times the mass of its lighter body slips by M times the softness of the velocity that it stops.
/// ODE softens all of its joints alike (its default CFM).
constexpr double leastSoftness = sizeof(btScalar) == sizeof(double) ? 1e-10 : 1e-8;
/// The same where joints close a loop (joint_loops.h): as the mechanism drifts, they contradict
/// each other by far more than the rounding of poses. The reactions to that are inversely
/// proportional to this softness, and act at the drifted pivots: with 1e-8, two boxes on two
/// joints, at rest on the ground, were thrown up at 20 m/s. In float the rounding of poses alone,
/// 1e-7 of their coordinates, asks for 1e-6 m/s in every step: with 1e-8 that would take a hundred
/// newton seconds a kilogram.
constexpr double loopSoftness = 1e-5;

/// The compliance of a row with Bullet's `cfm` and this W_ii; a faulty `cfm` is passed on.
inline double complianceOf(double cfm, double response) {
  return (cfm >= 0 && cfm < leastSoftness ? leastSoftness : cfm) * response;
}

/// The softness of contacts between bodies that a joint holds to each other, as a share of the
/// lesser of the two bodies' parts of W_nn.
constexpr double joinedSoftness = 1e-2;

/// The softness of welds that may break, as a share of their W_ii, and of contacts between the
/// bodies that they hold, as joinedSoftness. So they share loads as one elastic body does: beside
/// rigid welds contacts carry nothing, and a wall that is welded in one line broke 27 of 39 welds
/// under its own weight; beside rigid contacts, what welds ask for that have drifted, by 1e-4 m/s,
/// breaks them.
constexpr double sharedSoftness = 1e-4;
/// Welds that bear much give by less: as fast at most under what breaks them, m/s or rad/s.
constexpr double sharedSlip = 0.02;

}  // namespace delassus::bullet
