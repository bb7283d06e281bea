#pragma once

#include "delassus/island.h"
#include "delassus/problem.h"
#include "delassus/solution.h"

namespace delassus::bullet {

struct Bench;
struct Group;

// Contacts and joints that ask for what no motion gives. A plate lies two millimetres deep in the
// floor and is pinned at its middle: no corner can rise unless another one sinks, though no single
// contact is held (held_contacts.h). Or a body lies so in the floor that its joint and friction
// wedge it. To rest breaks no law. But what joints give by (softness.h) is so little that they
// would press with 1e10 N, and Coulomb's law may answer a small demand with reactions of any size.

/// How far contacts and joints of the island strain each other: the largest velocity, m/s, that one
/// normal reaction, or that of one row of a joint, would give its bodies if nothing else held them;
/// the lesser of the two. Neither springs count nor what drives joints. In islands without joints
/// that of contacts.
double strainOf(const Group& group, const Island& island, const Solution& solution);

/// What a solution may tell of a quarrel. Loads can do the same, but less recovery does not relieve
/// them.
enum class Quarrel {
  None,
  Breaking,  ///< a joint that holds reaches the threshold at which it breaks
  /// The demands are incompatible; or contacts and joints, or contacts and locked axes, strain each
  /// other by a thousand times what the island demands, m/s, and what the rounding of poses may ask
  /// for. Incompatible contacts without joints do not count: with less recovery, jaws would let go
  /// of what they pinch.
  Strained
};
Quarrel quarrelOf(const Group& group, const Island& island, double demand,
                  const Solution& solution);

/// Whether contacts and joints strain each other by more than any load explains: ten million times
/// what the island demands, and ten times what springs give their bodies and drives could. So does
/// friction that wedges bodies between joints, as limbs on both sides of a thin wall.
bool isWedged(const Group& group, const Island& island, double demand, const Solution& solution);

/// The problem of recovery alone: what contacts and joints ask for, of bodies that do not move and
/// feel no force, without friction and motors, where contacts and joints give a little.
const Problem& recoveryProblem(const Group& group, const Island& island, Bench& bench);
/// Gives bench.softBodies, which are at rest, the motion of its solution r: a compromise between
/// all that is asked for. They go more slowly if that has more energy than is at hand
/// (energyAtHand).
void recover(const Group& group, const Island& island, const VectorXd& r, Bench& bench);

/// What friction opposes: all slip; or slip other than that of the recovery, which it may wedge.
enum class Friction { OfAllSlip, OfOtherSlip };
/// The island's problem, if contacts and joints ask for no more than what the recovery of
/// bench.softBodies reaches. (Springs ask for what they ask for.) These demands do not contradict
/// each other: the recovery meets them.
const Problem& recoveringProblem(const Group& group, const Island& island, Friction friction,
                                 Bench& bench);
/// By how much it asks for less, as a share of the most that is asked for. What is asked for is
/// negligible below 1e-5 of the island's demand, m/s.
double shareCut(const Group& group, const Island& island, double demand, const Bench& bench);

}  // namespace delassus::bullet
