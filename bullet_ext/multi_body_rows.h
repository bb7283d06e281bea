#pragma once

#include <cstddef>

#include "BulletDynamics/Featherstone/btMultiBodyConstraint.h"
#include "delassus/row.h"

struct btContactSolverInfo;

namespace delassus {
struct StepReport;
}

namespace delassus::bullet {

struct Answer;
struct Group;
struct GroupInput;
class MultiBodyTrees;

/// Rows of the constraints of articulated bodies.
///
/// A btMultiBodyConstraint gives rows made for sequential impulses, with d = 1/W_ii and
/// rhs = (wanted − relative velocity) d. Here they mean
///
///     J v⁺ + (cfm/d) r = J v_before + rhs/d,   lower ≤ r ≤ upper
///
/// where rigid partners have their velocity before forces, as these constraints see it. Positional
/// parts that Bullet would split are taken as velocities, since articulated bodies cannot be
/// pushed. A row that its constraint has switched off (d = 0) takes no part.
class MultiBodyRows {
 public:
  /// Rows act on `trees`; constraints write their Jacobians into `data`. Both outlive this.
  MultiBodyRows(MultiBodyTrees& trees, btMultiBodyJacobianData& data)
      : trees_(trees), data_(data) {}

  /// Asks the constraints for their rows and adds these to the group. The impulses of the
  /// constraints become guesses, and are cleared. Rows that are not finite are left out, and the
  /// report names them.
  void gather(Group& group, const GroupInput& input, StepReport& report);
  /// Fills the guesses.
  static void recall(Group& group);
  /// Writes the impulses of the constraints, and the forces on their links for joint feedback.
  void writeBack(const Group& group, const Answer& answer, const btContactSolverInfo& info) const;

  void release();
  std::size_t bytes() const;

 private:
  struct Side;

  void fillSolverBodies(const Group& group);
  void gatherConstraint(Group& group, btMultiBodyConstraint& constraint,
                        const btContactSolverInfo& info, StepReport& report);
  void askRows(btMultiBodyConstraint& constraint, const btContactSolverInfo& info);
  void addRow(Group& group, btMultiBodyConstraint& constraint, int asked, int dof,
              StepReport& report);
  const char* faultOfInput(Group& group, const btMultiBodySolverConstraint& row);
  Row toRow(Group& group, const btMultiBodySolverConstraint& asked);
  int addSide(Group& group, const Side& side, Row6& jacobian, double& target);
  int addJointRow(Group& group, btMultiBody& body, int jacobian);

  MultiBodyTrees& trees_;
  btMultiBodyJacobianData& data_;
  btMultiBodyConstraintArray asked_;  ///< all rows that the constraints made
  /// Numbers −2 and −1: fixed; then the bodies of the group, the fixed world, the one for bodies
  /// left out.
  btAlignedObjectArray<btSolverBody> solverBodies_;
  /// A view of the same from number 0 on; owns nothing.
  btAlignedObjectArray<btSolverBody> solverBodyPool_;
};

}  // namespace delassus::bullet
