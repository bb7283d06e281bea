#include "bullet_ext/multi_body_parts.h"

#include "BulletDynamics/ConstraintSolver/btContactSolverInfo.h"
#include "bullet_ext/solve_group.h"

namespace delassus::bullet {

void MultiBodyParts::gatherBodies(Group& group, const GroupInput& input, StepReport& report) {
  trees_.gather(group, input, report);
}

void MultiBodyParts::gatherRows(Group& group, const GroupInput& input, StepReport& report) {
  rows_.gather(group, input, report);
}

void MultiBodyParts::recall(Group& group) const { MultiBodyRows::recall(group); }

void MultiBodyParts::writeBack(const Group& group, const Answer& answer,
                               const btContactSolverInfo& info) {
  trees_.writeForces(group, answer, info.m_timeStep);
  rows_.writeBack(group, answer, info);
  trees_.writeGains(answer.gains);
}

void MultiBodyParts::release() {
  trees_.release();
  rows_.release();
  data_.m_jacobians.clear();
  data_.m_deltaVelocitiesUnitImpulse.clear();
  data_.m_deltaVelocities.clear();
  data_.scratch_r.clear();
  data_.scratch_v.clear();
  data_.scratch_m.clear();
}

std::size_t MultiBodyParts::bytes() const {
  const auto of = [](const auto&... lists) {
    return (std::size_t{0} + ... + (lists.capacity() * sizeof(lists[0])));
  };
  return trees_.bytes() + rows_.bytes() +
         of(data_.m_jacobians, data_.m_deltaVelocitiesUnitImpulse, data_.m_deltaVelocities,
            data_.scratch_r, data_.scratch_v, data_.scratch_m);
}

}  // namespace delassus::bullet
