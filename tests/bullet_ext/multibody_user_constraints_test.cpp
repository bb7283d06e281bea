/// Constraints of articulated bodies that users write themselves.

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/multibody_chain.h"
#include "tests/support/multibody_world.h"

namespace delassus::test {
namespace {

/// A user's motor that keeps no impulses and names itself nowhere, or makes more rows than it says.
class BareMotor : public btMultiBodyConstraint {
 public:
  BareMotor(btMultiBody& tree, bool isUnnamed)
      : btMultiBodyConstraint(&tree, &tree, 0, -1, 1, false, MULTIBODY_CONSTRAINT_1DOF_JOINT_MOTOR),
        isUnnamed_(isUnnamed) {
    if (!isUnnamed) m_data.resize(1);
  }
  static constexpr double speed = 1.5;

  void finalizeMultiDof() override {}
  int getIslandIdA() const override { return m_bodyA->getLinkCollider(0)->getIslandTag(); }
  int getIslandIdB() const override { return getIslandIdA(); }
  void createConstraintRows(btMultiBodyConstraintArray& rows, btMultiBodyJacobianData& data,
                            const btContactSolverInfo& info) override {
    const int dofs = 6 + m_bodyA->getNumDofs();
    std::vector<btScalar> none(dofs, 0);
    const btVector3 zero(0, 0, 0);
    for (int joint = 0; joint < (isUnnamed_ ? 1 : 2); ++joint) {
      std::vector<btScalar> along(dofs, 0);
      along[6 + joint] = 1;
      btMultiBodySolverConstraint& row = rows.expandNonInitializing();
      row.m_orgConstraint = isUnnamed_ ? nullptr : this;
      row.m_orgDofIndex = isUnnamed_ ? -1 : joint;
      row.m_multiBodyA = row.m_multiBodyB = m_bodyA;
      row.m_linkA = joint;
      row.m_linkB = -1;
      fillMultiBodyConstraint(row, data, along.data(), none.data(), zero, zero, zero, zero, 0, info,
                              -1000, 1000, false, 1, false, btScalar(speed));
    }
  }
  void debugDraw(btIDebugDraw*) override {}

 private:
  bool isUnnamed_;
};

TEST(MultiBodyUserConstraints, NeedNotKeepTheirImpulses) {
  for (const bool isUnnamed : {true, false}) {
    DelassusMultiBodyWorld world;
    const Chain chain(world, 2);
    world.finish(*chain.tree);
    auto& motor = world.addConstraint<BareMotor>(*chain.tree, isUnnamed);
    world.advance(2);
    EXPECT_NEAR(chain.tree->getJointVel(0), BareMotor::speed, tolerance(1e-9, 1e-5));
    if (isUnnamed) continue;
    EXPECT_NEAR(chain.tree->getJointVel(1), BareMotor::speed, tolerance(1e-9, 1e-5))
        << "the row beyond those that it said";
    EXPECT_NE(motor.getAppliedImpulse(0), 0);
  }
}

}  // namespace
}  // namespace delassus::test
