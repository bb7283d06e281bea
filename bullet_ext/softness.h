#pragma once

#include "LinearMath/btScalar.h"

namespace delassus::bullet {

/// How much rows of joints give at least, as a share of their W_ii. Poses are rounded, and axes are
/// often given in few digits, so that joints which share a freedom (two hinges of a door)
/// contradict each other a little; taken at their word they would lock it. A contradiction δ (rad,
/// or relative) slows the freedom by δ²/softness of itself a step, and a joint that carries M times
/// the mass of its lighter body slips by M times this of what it stops. ODE softens all of its
/// joints alike (its default CFM).
constexpr double leastSoftness = sizeof(btScalar) == sizeof(double) ? 1e-10 : 1e-8;
/// The same where joints close a loop (joint_loops.h): as the mechanism drifts, they contradict
/// each other by far more than poses are rounded. What meets that is in inverse proportion to this,
/// and acts where the pivots have drifted to: with 1e-8 two boxes on two joints, at rest on the
/// ground, were thrown up at 20 m/s. In float the rounding of poses alone, 1e-7 of where they are,
/// asks for 1e-6 m/s in every step: of 1e-8 that would be a hundred newton seconds a kilogram.
constexpr double loopSoftness = 1e-5;

/// The compliance of a row with Bullet's `cfm` (a fault of which stays one) and this W_ii.
inline double complianceOf(double cfm, double response) {
  return (cfm >= 0 && cfm < leastSoftness ? leastSoftness : cfm) * response;
}

/// How much contacts of bodies give that a joint holds to each other, as a share of what the one of
/// them adds to W_nn that adds less.
constexpr double joinedSoftness = 1e-2;

}  // namespace delassus::bullet
