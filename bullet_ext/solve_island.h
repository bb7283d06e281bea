#pragma once

#include <string>

#include "delassus/economies.h"
#include "delassus/island.h"
#include "delassus/solution.h"
#include "delassus/types.h"

namespace delassus::bullet {

struct Answer;
struct Bench;
struct Group;
struct IslandMarks;
struct IslandResult;

/// Answers the island if it needs no solving.
void checkIsland(const Group& group, const Island& island, const Economies& economies, Bench& bench,
                 Answer& answer, IslandResult& result);

/// Solves the island. The exact answer is sought first, and taken unless it throws bodies or
/// strains them (soft_answer.h).
///
/// Where an island quarrels and its exact answer was not found, that is sought only now and then.
/// An island that jammed in the last step is likely to jam again, with much the same reactions.
/// Where work is bounded there is none for this.
void solveIsland(const Group& group, const Island& island, Bench& bench, Answer& answer,
                 IslandResult& result);

/// What one island was solved for: unknowns in the order of the island.
void keepReactions(const Island& island, const Solution& solution, Answer& answer);
void note(const Solution& solution, const Island& island, IslandResult& result);
/// The marks of the island in `result`, to be known again by the contacts of one of its bodies.
IslandMarks& mark(const Group& group, const Island& island, IslandResult& result);
bool fitsBullet(const VectorXd& r);  ///< finite in Bullet's precision

/// How messages call the contact or joint whose first unknown this is, in one of the islands.
std::string nameOf(const Group& group, const Island& island, int unknown);

}  // namespace delassus::bullet
