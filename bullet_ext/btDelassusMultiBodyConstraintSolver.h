#pragma once

#include <functional>
#include <memory>

#include "BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h"
#include "bullet_ext/contact_event.h"
#include "bullet_ext/precision.h"
#include "bullet_ext/step_report.h"
#include "delassus/options.h"

/// Steps a btMultiBodyDynamicsWorld on Delassus' regions: rigid and articulated bodies, their
/// contacts with Coulomb's round cone, joints, limits and motors in one exact problem an island.
///
///     btDelassusMultiBodyConstraintSolver solver;
///     btMultiBodyDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
///
/// A world without articulated bodies moves as it does with btDelassusConstraintSolver, bit for
/// bit. One solver a world. Bullet accepts only a class there that is derived from its own solver.
/// Nothing of that base is used but m_analyticsData, which describes the last group: its bodies and
/// manifolds; as iterations the regions and sweeps (0: nothing had to be solved); as residual the
/// square of the largest natural residual, (m/s)².
class btDelassusMultiBodyConstraintSolver : public btMultiBodyConstraintSolver {
 public:
  BT_DECLARE_ALIGNED_ALLOCATOR();

  /// Throws std::invalid_argument where delassus::check(options) does.
  explicit btDelassusMultiBodyConstraintSolver(const delassus::Options& options = {})
      : btDelassusMultiBodyConstraintSolver(options, btDelassusPrecision{}) {}
  ~btDelassusMultiBodyConstraintSolver() override;
  btDelassusMultiBodyConstraintSolver(const btDelassusMultiBodyConstraintSolver&) = delete;
  btDelassusMultiBodyConstraintSolver& operator=(const btDelassusMultiBodyConstraintSolver&) =
      delete;

  void prepareSolve(int bodies, int manifolds) override;
  btScalar solveGroup(btCollisionObject** bodies, int bodyCount, btPersistentManifold** manifolds,
                      int manifoldCount, btTypedConstraint** constraints, int constraintCount,
                      const btContactSolverInfo& info, btIDebugDraw* debugDrawer,
                      btDispatcher* dispatcher) override;
  void solveMultiBodyGroup(btCollisionObject** bodies, int bodyCount,
                           btPersistentManifold** manifolds, int manifoldCount,
                           btTypedConstraint** constraints, int constraintCount,
                           btMultiBodyConstraint** multiBodyConstraints,
                           int multiBodyConstraintCount, const btContactSolverInfo& info,
                           btIDebugDraw* debugDrawer, btDispatcher* dispatcher) override;
  // These four, and the listeners below, are as in btDelassusConstraintSolver.
  void setThreads(int threads);
  void setStockRollingFriction(bool on);  ///< of rigid bodies
  void setGeometricStiffness(bool on);    ///< of rigid bodies
  void reset() override;
  btConstraintSolverType getSolverType() const override { return BT_MULTIBODY_SOLVER; }

  /// `rows` counts the rows of both kinds of constraints.
  const delassus::StepReport& report() const;
  void setContactListener(std::function<void(const delassus::ContactEvent&)> listener);
  void setTroubleListener(std::function<void(const delassus::ContactEvent&)> listener);
  void setTurningListener(std::function<void(const delassus::ContactEvent&)> listener);

 private:
  btDelassusMultiBodyConstraintSolver(const delassus::Options& options, btDelassusPrecision);

  struct Parts;
  std::unique_ptr<Parts> parts_;
};
