#pragma once

#include <vector>

#include "bullet_ext/contact_event.h"
#include "bullet_ext/group.h"
#include "bullet_ext/group_islands.h"
#include "bullet_ext/obsolete.h"
#include "delassus/active_set.h"
#include "delassus/articulation.h"
#include "delassus/body.h"
#include "delassus/island.h"
#include "delassus/solution.h"

struct btContactSolverInfo;

namespace delassus {
struct StepReport;
}

namespace delassus::bullet {

class Workshop;

/// How the solve of one island ended.
struct IslandResult {
  Status status;
  Tier tier;
  double residualMax, residualRms;  ///< m/s
  int parts;                        ///< contacts and rows
  IslandMarks marks;  ///< restless: other reactions were found than those of the last step
  int markedBody;     ///< one of its bodies, if there are any marks
  bool isAnswered;    ///< or else among Answer::unanswered
  bool isSoftened;    ///< its contacts gave, or its joints asked for less (soft_answer.h)
  /// First unknowns of the contacts and rows that keep it from being solved.
  std::vector<int> blamed;
};

/// What the reactions of a group are and what motion they leave.
struct Answer {
  GroupIslands islands;
  std::vector<IslandResult> results;  ///< of each island
  std::vector<int> unanswered;        ///< the islands that are to be answered yet

  std::vector<Body> bodies;       ///< velocities after the reactions
  std::vector<Vec3> contacts;     ///< reaction of each contact in its frame, N·s
  std::vector<Mode> modes;        ///< of each contact
  std::vector<Trouble> troubles;  ///< the same
  std::vector<double> rows;       ///< reaction of each row, N·s
  TreeGains gains;                ///< of articulated bodies

  int matrices = 0;  ///< problems whose W was built
  ObsoleteConstraints obsolete;
  int obsoleteConstraints = 0;  ///< that acted

  std::size_t bytes() const;
};

/// Before anything is solved, the islands being found: reactions are the guess of the group, bodies
/// move as if there were none, and no island is answered.
void startAnswer(const Group& group, Answer& answer);

/// Answers the islands that need no solving; the others stay unanswered.
void checkIslands(const Group& group, Workshop& workshop, Answer& answer);

/// Solves the others, in turns with the constraints that solve themselves.
///
/// These see what the exact reactions did and change the free velocities in `group`; the exact
/// solve follows each of their sweeps, until nothing changes or the sweeps of the step's budget are
/// used up.
void solveIslands(Group& group, const btContactSolverInfo& info, Workshop& workshop, Answer& answer,
                  StepReport& report);

}  // namespace delassus::bullet
