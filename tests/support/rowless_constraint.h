#pragma once

#include <btBulletDynamicsCommon.h>
#include <gtest/gtest.h>

namespace delassus::test {

/// A constraint without rows: what it does it does in solveConstraintObsolete.
class RowlessConstraint : public btTypedConstraint {
 public:
  explicit RowlessConstraint(btRigidBody& a, btRigidBody& b = getFixedBody())
      : btTypedConstraint(MAX_CONSTRAINT_TYPE, a, b) {}
  void getInfo1(btConstraintInfo1* info) override { info->m_numConstraintRows = info->nub = 0; }
  void getInfo2(btConstraintInfo2*) override {
    ADD_FAILURE() << "a constraint without rows is not asked for them";
  }
  void setParam(int, btScalar, int) override {}
  btScalar getParam(int, int) const override { return 0; }

 protected:
  /// The velocity of the body with all that has been done to it so far.
  static btVector3 velocityOf(const btSolverBody& body) {
    return body.m_linearVelocity + body.m_externalForceImpulse + body.m_deltaLinearVelocity;
  }
};

/// Keeps a body from falling faster than `speed`, m/s.
class FallBrake : public RowlessConstraint {
 public:
  FallBrake(btRigidBody& body, btScalar speed) : RowlessConstraint(body), speed_(speed) {}
  void solveConstraintObsolete(btSolverBody& body, btSolverBody&, btScalar) override {
    ++calls;
    const btScalar missing = -speed_ - velocityOf(body).y();
    if (missing > 0)
      body.internalApplyImpulse(btVector3(0, 1, 0) * body.internalGetInvMass(), {0, 0, 0},
                                missing / body.internalGetInvMass().y());
  }
  int calls = 0;

 private:
  btScalar speed_;
};

}  // namespace delassus::test
