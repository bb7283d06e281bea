#pragma once

#include <cstddef>

#include "BulletDynamics/Featherstone/btMultiBodyConstraint.h"
#include "bullet_ext/extension.h"
#include "bullet_ext/multi_body_rows.h"
#include "bullet_ext/multi_body_trees.h"

namespace delassus::bullet {

/// The parts that solveMultiBodyGroup has beside rigid bodies: articulated bodies and their
/// constraints.
class MultiBodyParts : public Extension {
 public:
  MultiBodyParts() = default;
  MultiBodyParts(const MultiBodyParts&) = delete;
  MultiBodyParts& operator=(const MultiBodyParts&) = delete;

  void gatherBodies(Group& group, const GroupInput& input, StepReport& report) override;
  void gatherRows(Group& group, const GroupInput& input, StepReport& report) override;
  void recall(Group& group) const override;
  /// Writes velocities, forces on links for joint feedback, and the impulses of constraints.
  void writeBack(const Group& group, const Answer& answer,
                 const btContactSolverInfo& info) override;
  void release() override;
  std::size_t bytes() const override;

 private:
  btMultiBodyJacobianData data_;
  MultiBodyTrees trees_{data_};
  MultiBodyRows rows_{trees_, data_};
};

}  // namespace delassus::bullet
