#pragma once

#include <cstddef>

#include "BulletDynamics/Featherstone/btMultiBodyConstraint.h"
#include "bullet_ext/extension.h"
#include "bullet_ext/group_input.h"
#include "delassus/articulation.h"
#include "delassus/kept_list.h"
#include "delassus/row.h"

class btMultiBodyLinkCollider;

namespace delassus::bullet {

/// What solveMultiBodyGroup brings beside rigid bodies: articulated bodies and their constraints.
///
/// A btMultiBody is a tree whose velocities are those of its base (angular, linear) and of its
/// joints, the forces of the step included. M⁻¹ is read from its articulated-body algorithm, one
/// unit force at a time; links that touch something are its limbs.
///
/// A btMultiBodyConstraint answers with rows made for sequential impulses, d = 1/W_ii and
/// rhs = (wanted − relative velocity) d. Here they mean
///
///     J v⁺ + (cfm/d) r = J v_before + rhs/d,   lower ≤ r ≤ upper
///
/// with the velocity of rigid partners before forces, as these constraints see it. Positional parts
/// that Bullet would split are taken as velocities, since an articulated body cannot be pushed. A
/// row that its constraint has switched off (d = 0) has no part.
class MultiBodyParts : public Extension {
 public:
  /// Those that were passed with the group; good until its end.
  void setConstraints(btMultiBodyConstraint** constraints, int count) {
    constraints_ = constraints;
    // Of an unsplit group Bullet passes as many as there are joints, of an array that may be none.
    constraintCount_ = constraints ? count : 0;
  }

  void gatherBodies(Group& group, const GroupInput& input, StepReport& report) override;
  void gatherRows(Group& group, const GroupInput& input, StepReport& report) override;
  void recall(Group& group) const override;
  /// Velocities, forces on links for joint feedback, and the impulses of constraints.
  void writeBack(const Group& group, const Answer& answer,
                 const btContactSolverInfo& info) override;
  void release() override;
  std::size_t bytes() const override;

 private:
  struct TreeSource {
    btMultiBody* body;
    int tree;  ///< in the articulation, or leftOut
    int stem;  ///< body that stands for the tree
    MatrixXd inverseMass;
    RootFinder root;
  };
  struct LimbSource {
    btMultiBody* body;
    int link;    ///< −1 for the base
    Matrix6X L;  ///< velocity of the limb = L v
  };

  const TreeSource& treeOf(Group& group, btMultiBody& body);
  int addTree(Group& group, TreeSource& source);
  int addLimb(Group& group, int tree, const LimbSource& source);
  void findMotion(const btMultiBodyLinkCollider& collider, Matrix6X& L);
  void addLink(Group& group, const btMultiBodyLinkCollider& collider, StepReport& report);

  void lendCompanionIds(const Group& group, const GroupInput& input);
  void takeBackCompanionIds(const Group& group, const GroupInput& input);
  void askRows(btMultiBodyConstraint& constraint, const btContactSolverInfo& info);
  const char* faultOfInput(Group& group, const btMultiBodySolverConstraint& row);
  void addRow(Group& group, btMultiBodyConstraint& constraint, int asked, int dof,
              StepReport& report);

  btMultiBodyConstraint** constraints_ = nullptr;
  int constraintCount_ = 0;
  KeptList<TreeSource> trees_;
  KeptList<LimbSource> limbs_;  ///< as in the articulation; stems have no body
  btMultiBodyConstraintArray rows_;
  btMultiBodyJacobianData data_;
  /// Two fixed ones, those of the group, a fixed one, the one that is left out.
  btAlignedObjectArray<btSolverBody> solverBodies_;
  /// The same without the first two; owns nothing.
  btAlignedObjectArray<btSolverBody> solverBodyPool_;
  btAlignedObjectArray<btScalar> unit_, response_;
};

}  // namespace delassus::bullet
