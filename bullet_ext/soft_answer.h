#pragma once

#include "delassus/island.h"

namespace delassus::bullet {

struct Answer;
struct Bench;
struct Group;
struct IslandResult;
struct TargetWork;

// Answers as if contacts gave a little, or contacts and joints asked for less. They are reported
// as incompatible, with the residual of the law as it stands.

/// Takes back the exact answer, whose contacts throw a body (thrown_bodies.h), and finds the answer
/// for contacts that give a little.
void answerSoftened(const Group& group, const Island& island, Bench& bench, Answer& answer,
                    IslandResult& result);

/// The same where joints throw and do the work `exact`. All that holds then asks for the same share
/// of what it asks for now, a share so small that the work is fair. (The work grows with the square
/// of what is asked; parts that ask for nothing do none.) Joints stay as rigid as they are,
/// whatever they carry, and correct their errors in more steps. Contacts give a little if they
/// throw, too, or where nothing is found soon without that.
void answerHeldBack(const Group& group, const Island& island, const TargetWork& exact,
                    bool contactsThrow, Bench& bench, Answer& answer, IslandResult& result);

/// What relieves an island that quarrels (quarrels.h).
struct Relief {
  double mostStrain;  ///< by which contacts and joints may strain each other still, m/s
  /// Residual that an answer may leave where the budget ends before it is exact, m/s: that of the
  /// answer in whose place it comes.
  double mostMissed;
};

/// Answers an island that quarrels, if it does so because it asks for more recovery than any motion
/// gives: it then asks for what a compromise reaches. That is an answer if it is a relief, if
/// `leastCut` of the most that is asked for is cut, and if it throws no body. Returns whether it
/// is; otherwise nothing changes.
bool answerRecovering(const Group& group, const Island& island, const Relief& relief,
                      double leastCut, Bench& bench, Answer& answer, IslandResult& result);

/// Answers an island that quarrels as if contacts gave a little, as those of bodies that a joint
/// links, if this is a relief. It does where a body lands so that its joint and
/// friction at one corner wedge it, but not under a load. Returns whether it does; otherwise
/// nothing changes.
bool answerUnwedged(const Group& group, const Island& island, const Relief& relief, Bench& bench,
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
/// bodies are thrown (`soften`): as little as reveals the jam. Where contacts would throw a body
/// they give by all of it; joints that would throw one are held back, too. The search begins with
/// `bench.guess`. Otherwise nothing changes, and false is returned.
bool answerJam(const Group& group, const Island& island, double most, Bench& bench, Answer& answer,
               IslandResult& result);

/// A body that leaves more than this many times as fast as anything was before is looked at for a
/// jam.
constexpr double suspectReach = 2;

}  // namespace delassus::bullet
