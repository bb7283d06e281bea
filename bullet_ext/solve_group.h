#pragma once

#include <string>
#include <vector>

#include "bullet_ext/contact_event.h"
#include "bullet_ext/obsolete.h"
#include "bullet_ext/workshop.h"
#include "delassus/active_set.h"
#include "delassus/articulation.h"
#include "delassus/body.h"
#include "delassus/economies.h"
#include "delassus/island.h"
#include "delassus/solution.h"

struct btContactSolverInfo;

namespace delassus {
struct StepReport;
}

namespace delassus::bullet {

struct Group;

/// How the solve of one island ended.
struct IslandResult {
  Status status;
  Tier tier;
  double residualMax, residualRms;  ///< m/s
  int parts;                        ///< contacts and rows
  int restless;     ///< one of its bodies, if other reactions were found than those of the last
                    ///< step; or −1
  bool open;        ///< the check has left it to be solved
  bool isSoftened;  ///< the exact answer would throw a body (thrown_bodies.h)
  /// First unknowns of the contacts and rows that keep it from being solved.
  std::vector<int> blamed;
};

/// What the reactions of a group are and what motion they leave.
struct Answer {
  std::vector<Body> bodies;       ///< velocities after the reactions
  std::vector<Vec3> contacts;     ///< reaction of each contact in its frame, N·s
  std::vector<Mode> modes;        ///< of each contact
  std::vector<Trouble> troubles;  ///< the same
  std::vector<double> rows;       ///< reaction of each row, N·s
  std::vector<IslandResult> islands;
  std::vector<int> open;  ///< those that the check has left to be solved
  Assembler assembler;    ///< has split the group
  IslandJoiner joiner;    ///< of the islands, if there are articulated bodies
  bool joined = false;    ///< there are
  TreeGains gains;        ///< of these
  int matrices = 0;       ///< problems whose W was built
  ObsoleteConstraints obsolete;
  int obsoleteConstraints = 0;  ///< that acted

  /// Of the group; trees join what the assembler has split.
  int islandCount() const {
    return joined ? static_cast<int>(joiner.islands().size()) : assembler.islands();
  }
  const Island& island(int i) const { return joined ? joiner.islands()[i] : assembler.island(i); }

  std::size_t bytes() const;
};

/// Finds the islands of the group.
void findIslands(const Group& group, const Economies& economies, Answer& answer);

/// Puts the guess of the group in the place of the reactions.
void startFromGuess(const Group& group, Answer& answer);

/// Answers the islands of the plan that need no solving, starting from the reactions in `answer`.
void checkIslands(const Group& group, Workshop& workshop, Answer& answer);

/// Solves the others, in turns with the constraints that solve themselves.
///
/// These see what the exact reactions did and change the free velocities in `group`; the exact
/// solve follows each of their sweeps, until nothing changes or the sweeps of the step's budget are
/// used up.
void solveIslands(Group& group, const btContactSolverInfo& info, Workshop& workshop, Answer& answer,
                  StepReport& report);

/// How messages call the contact or joint that island `i` of the answer blames by its first
/// unknown.
std::string nameOf(const Group& group, const Answer& answer, int i, int unknown);

}  // namespace delassus::bullet
