#include "bullet_ext/btDelassusMultiBodyConstraintSolver.h"

#include <utility>

#include "bullet_ext/btDelassusConstraintSolver.h"
#include "bullet_ext/group_input.h"
#include "bullet_ext/multi_body_parts.h"

using namespace delassus;
using namespace delassus::bullet;

struct btDelassusMultiBodyConstraintSolver::Parts {
  explicit Parts(const Options& options) : rigid(options) {}

  btDelassusConstraintSolver rigid;
  MultiBodyParts articulated;
};

btDelassusMultiBodyConstraintSolver::btDelassusMultiBodyConstraintSolver(const Options& options,
                                                                         btDelassusPrecision)
    : parts_(std::make_unique<Parts>(options)) {}

btDelassusMultiBodyConstraintSolver::~btDelassusMultiBodyConstraintSolver() = default;

void btDelassusMultiBodyConstraintSolver::prepareSolve(int bodies, int manifolds) {
  parts_->rigid.prepareSolve(bodies, manifolds);
}

btScalar btDelassusMultiBodyConstraintSolver::solveGroup(
    btCollisionObject** bodies, int bodyCount, btPersistentManifold** manifolds, int manifoldCount,
    btTypedConstraint** constraints, int constraintCount, const btContactSolverInfo& info,
    btIDebugDraw* debugDrawer, btDispatcher* dispatcher) {
  solveMultiBodyGroup(bodies, bodyCount, manifolds, manifoldCount, constraints, constraintCount,
                      nullptr, 0, info, debugDrawer, dispatcher);
  return 0;
}

void btDelassusMultiBodyConstraintSolver::solveMultiBodyGroup(
    btCollisionObject** bodies, int bodyCount, btPersistentManifold** manifolds, int manifoldCount,
    btTypedConstraint** constraints, int constraintCount,
    btMultiBodyConstraint** multiBodyConstraints, int multiBodyConstraintCount,
    const btContactSolverInfo& info, btIDebugDraw*, btDispatcher* dispatcher) {
  // For an unsplit group Bullet passes the number of joints here, and the array may be null.
  const int articulatedCount = multiBodyConstraints ? multiBodyConstraintCount : 0;
  const auto work = parts_->rigid.solve(
      {bodies, bodyCount, manifolds, manifoldCount, constraints, constraintCount, &info, dispatcher,
       multiBodyConstraints, articulatedCount},
      &parts_->articulated);

  m_analyticsData.m_islandId = bodyCount > 0 ? bodies[0]->getIslandTag() : -2;
  m_analyticsData.m_numBodies = bodyCount;
  m_analyticsData.m_numContactManifolds = manifoldCount;
  ++m_analyticsData.m_numSolverCalls;
  m_analyticsData.m_numIterationsUsed = work.iterations;
  m_analyticsData.m_remainingLeastSquaresResidual =
      work.residualMax >= 0 ? work.residualMax * work.residualMax : -1;
}

void btDelassusMultiBodyConstraintSolver::setThreads(int threads) {
  parts_->rigid.setThreads(threads);
}

void btDelassusMultiBodyConstraintSolver::setStockRollingFriction(bool on) {
  parts_->rigid.setStockRollingFriction(on);
}

void btDelassusMultiBodyConstraintSolver::setGeometricStiffness(bool on) {
  parts_->rigid.setGeometricStiffness(on);
}

void btDelassusMultiBodyConstraintSolver::reset() {
  parts_->rigid.reset();
  parts_->articulated.release();
  m_analyticsData = {};
}

const StepReport& btDelassusMultiBodyConstraintSolver::report() const {
  return parts_->rigid.report();
}

void btDelassusMultiBodyConstraintSolver::setContactListener(
    std::function<void(const ContactEvent&)> listener) {
  parts_->rigid.setContactListener(std::move(listener));
}

void btDelassusMultiBodyConstraintSolver::setTroubleListener(
    std::function<void(const ContactEvent&)> listener) {
  parts_->rigid.setTroubleListener(std::move(listener));
}

void btDelassusMultiBodyConstraintSolver::setTurningListener(
    std::function<void(const ContactEvent&)> listener) {
  parts_->rigid.setTurningListener(std::move(listener));
}
