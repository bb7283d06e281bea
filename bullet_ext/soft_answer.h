#pragma once

#include "delassus/island.h"

namespace delassus::bullet {

struct Answer;
struct Bench;
struct Group;
struct IslandResult;
struct TargetWork;

// Answers as if contacts gave a little, or joints asked for less. They are told as incompatible,
// with the residual of the law as it stands.

/// Takes the exact answer back, whose contacts throw a body (thrown_bodies.h), and finds that of
/// contacts that give a little.
void answerSoftened(const Group& group, const Island& island, Bench& bench, Answer& answer,
                    IslandResult& result);

/// The same where joints throw, doing the work `exact`: all that holds asks for the same share of
/// what it does, so small that its work is fair. (It grows with the square of what is asked; what
/// asks for nothing does none.) Joints stay as rigid as they are, whatever they carry, and correct
/// their errors in more steps. Contacts give a little if they throw, too, or where else nothing is
/// found soon.
void answerHeldBack(const Group& group, const Island& island, const TargetWork& exact,
                    bool contactsThrow, Bench& bench, Answer& answer, IslandResult& result);

/// An island jams if what squeezes it does not give way, as a kinematic wall: rigid bodies then
/// have no motion at all, or none but one that flings out what is pinched, and a search for it
/// takes long. What gives tells it. Where contacts give by s, 1/kg, each, the reactions r let
///
///     Σ s r_n² ≤ ¼ |v − w|²_M
///
/// v the free motion and w any motion that meets the demands and slides at no contact: the law of
/// the softer contacts, r·u ≤ −Σ s r_n², leaves Σ s r_n² + r·W r ≤ −r·q, and that is r·J (w − v)
/// less what is not negative, at most √(r·W r) |v − w|_M. Where more is taken up, there is no such
/// motion: none that is about as slow as what drives it (`energyAtHand`). Loads, however heavy,
/// only bring what they have.
///
/// The island is then answered, and marked as jammed, unless this misses the law by more than
/// `most`, m/s: contacts give by a tenth to a millionth of what they do where bodies are
/// thrown (`soften`), as little as tells it, or by all of that where they would throw. The search
/// begins with `bench.guess`. Else nothing changes.
bool answerJam(const Group& group, const Island& island, double most, Bench& bench, Answer& answer,
               IslandResult& result);

/// How many times as fast as anything was before a body may leave, and not be looked at for a jam.
constexpr double suspectReach = 2;

}  // namespace delassus::bullet
