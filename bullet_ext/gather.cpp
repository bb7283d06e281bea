#include "bullet_ext/gather.h"

#include <cmath>

#include "BulletDynamics/ConstraintSolver/btContactSolverInfo.h"
#include "bullet_ext/arcs.h"
#include "bullet_ext/extension.h"
#include "bullet_ext/saturating_sum.h"

namespace delassus::bullet {

void gatherGroup(Group& group, const GroupInput& input, StepReport& report, Extension* extension,
                 const Manner& manner) {
  group.clear();
  group.h = input.info->m_timeStep;
  gatherBodies(group, input, report);
  if (extension) extension->gatherBodies(group, input, report);
  gatherJoined(group, input);
  gatherContacts(group, input, report);
  gatherJoints(group, input, report);
  addTo(report.held, group.held.soften(group, *input.info, manner.leavesOutWelded));
  if (extension) extension->gatherRows(group, input, report);
  gatherTurningFriction(group, manner.rollsAsStock);
  stateAlongArcs(group);
}

const char* faultOfRow(const Row& row) {
  if (!row.jacobianA.allFinite() || !row.jacobianB.allFinite()) return "its axis is not finite";
  if (!std::isfinite(row.target)) return "its target velocity is not finite";
  if (std::isnan(row.lower) || std::isnan(row.upper)) return "a bound is not a number";
  if (row.lower > row.upper) return "its lower bound is above its upper one";
  if (std::isinf(row.lower) && row.lower == row.upper) return "it asks for an infinite impulse";
  if (!std::isfinite(row.compliance) || row.compliance < 0)
    return "its softness is not a number >= 0";
  const double size = row.jacobianA.cwiseAbs().sum() + row.jacobianB.cwiseAbs().sum() +
                      std::abs(row.target) + row.compliance;
  if (!(size <= largestNumber)) return "its numbers are too large";
  return nullptr;
}

}  // namespace delassus::bullet
