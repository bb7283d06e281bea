#pragma once

#include "delassus/island.h"

namespace delassus::bullet {

struct Answer;
struct Bench;
struct Group;
struct IslandResult;

// Answers as if contacts, or also joints, gave a little. They are reported as incompatible, with
// the residual of the law without softness.

/// Takes back the exact answer, which throws a body (thrown_bodies.h), and finds the answer for
/// contacts, or also joints, that give a little.
void answerSoftened(const Group& group, const Island& island, bool withJoints, Bench& bench,
                    Answer& answer, IslandResult& result);

/// Answers an island that jams. An island jams if a body that squeezes it does not give way, such
/// as a kinematic wall. Rigid bodies then have no motion at all, or only one that flings out what
/// is pinched, and a search for it takes long. Contacts that give reveal a jam. If each gives by s,
/// 1/kg, the reactions r satisfy
///
///     Σ s r_n² ≤ ¼ |v − w|²_M
///
/// where v is the free motion and w any motion that meets the demands and slides at no contact. For
/// the law of the softer contacts, r·u ≤ −Σ s r_n², gives Σ s r_n² + r·W r ≤ −r·q. The right side
/// is r·J (w − v) less what is not negative, so at most √(r·W r) |v − w|_M. Where contacts take up
/// more, there is no such motion: none that is about as slow as what drives it (`energyAtHand`).
/// Loads, however heavy, only bring the energy that they have.
///
/// An island that jams is answered, and marked as jammed, unless the answer misses the law by more
/// than `most`, m/s. In this answer contacts give by a tenth to a millionth of what they give where
/// bodies are thrown (`soften`): as little as reveals the jam. Where that would throw a body they
/// give by all of it, and joints give, too, if need be. The search begins with `bench.guess`.
/// Otherwise nothing changes, and false is returned.
bool answerJam(const Group& group, const Island& island, double most, Bench& bench, Answer& answer,
               IslandResult& result);

/// A body that leaves more than this many times as fast as anything was before is looked at for a
/// jam.
constexpr double suspectReach = 2;

}  // namespace delassus::bullet
