#pragma once

#include <string>
#include <vector>

#include "bullet_ext/gather.h"
#include "delassus/active_set.h"
#include "delassus/articulation.h"
#include "delassus/island.h"
#include "delassus/island_check.h"
#include "delassus/solution.h"
#include "delassus/solver.h"

namespace delassus::bullet {

/// In single precision the points round their reactions by more than the tolerance: there are no digits to gain.
constexpr bool keepsDigits = sizeof(btScalar) == sizeof(double);
constexpr double worldKeptShare = keepsDigits ? keptShare : 1,
                 worldPolishedShare = keepsDigits ? polishedShare : 1;

/// How the solve of one island ended.
struct IslandResult {
  Status status;
  Tier tier;
  double residualMax, residualRms;  ///< m/s
  int parts;                        ///< contacts and rows
  int restless;  ///< one of its bodies, if other reactions were found than those of the last
                 ///< step; or −1
  std::vector<std::string>
      blamed;  ///< names of the contacts and joints that keep it from being solved
};

/// What the reactions of a group are and what motion they leave.
struct Answer {
  explicit Answer(const Options& options) : check(options) {}

  std::vector<Body> bodies;       ///< velocities after the reactions
  std::vector<Vec3> contacts;     ///< reaction of each contact in its frame, N·s
  std::vector<Mode> modes;        ///< of each contact
  std::vector<Trouble> troubles;  ///< the same
  std::vector<double> rows;       ///< reaction of each row, N·s
  std::vector<IslandResult> islands;
  std::vector<Solution> seen;  ///< of each island what the check saw; as many as there ever were
  std::vector<int> open;       ///< islands that the check has left to be solved
  VectorXd guess;              ///< of the island that is being solved
  Solution solution;           ///< the same
  Assembler assembler;         ///< of the islands
  Coupling coupling;           ///< of those with articulated bodies, and the gains of these
  IslandJoiner joiner;         ///< of the islands, if there are articulated bodies
  IslandCheck check;
  int matrices = 0;  ///< problems whose W was built
  int regions = 0, factorisations = 0, sweeps = 0, obsoleteConstraints = 0;

  std::size_t bytes() const;
};

/// Puts the guess of the group in the place of the reactions.
void startFromGuess(const Group& group, Answer& answer);

/// Answers the islands of the plan that need no solving, starting from the reactions in `answer`.
void checkIslands(const Group& group, const Economies& economies, Answer& answer);

/// Solves the others, in turns with the constraints that solve themselves.
///
/// These see what the exact reactions did and change the free velocities in `group`; the exact
/// solve follows each of their sweeps, until nothing changes or the sweeps of the step's budget are
/// used up.
void solveIslands(Group& group, const btContactSolverInfo& info, Solver& solver, Answer& answer,
                  StepReport& report);

}  // namespace delassus::bullet
