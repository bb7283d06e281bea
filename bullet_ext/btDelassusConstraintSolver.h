#pragma once

#include <functional>
#include <memory>

#include "BulletDynamics/ConstraintSolver/btConstraintSolver.h"
#include "LinearMath/btScalar.h"
#include "bullet_ext/contact_event.h"
#include "bullet_ext/precision.h"
#include "bullet_ext/step_report.h"
#include "delassus/options.h"

namespace delassus::bullet {
class Extension;
struct GroupInput;
}  // namespace delassus::bullet

/// Steps a Bullet world on Delassus' regions: contacts with Coulomb's round cone and joints, solved
/// exactly, island by island.
///
///     btDelassusConstraintSolver solver;
///     btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
///
/// Drop-in for btSequentialImpulseConstraintSolver in a world of rigid bodies. One solver a world:
/// it owns its workspace; reactions are kept in Bullet's contact points, and for joints, rolling
/// and spinning friction, points that narrow phase replaced, and the digits that float has no room
/// for, here for one step. That needs prepareSolve, which Bullet's world calls; without it (a
/// solver pool) float worlds are solved in every step.
class btDelassusConstraintSolver : public btConstraintSolver {
 public:
  BT_DECLARE_ALIGNED_ALLOCATOR();

  /// Throws std::invalid_argument where delassus::check(options) does.
  explicit btDelassusConstraintSolver(const delassus::Options& options = {})
      : btDelassusConstraintSolver(options, btDelassusPrecision{}) {}
  ~btDelassusConstraintSolver() override;
  btDelassusConstraintSolver(const btDelassusConstraintSolver&) = delete;
  btDelassusConstraintSolver& operator=(const btDelassusConstraintSolver&) = delete;

  void prepareSolve(int bodies, int manifolds) override;
  btScalar solveGroup(btCollisionObject** bodies, int bodyCount, btPersistentManifold** manifolds,
                      int manifoldCount, btTypedConstraint** constraints, int constraintCount,
                      const btContactSolverInfo& info, btIDebugDraw* debugDrawer,
                      btDispatcher* dispatcher) override;
  /// Has islands that do not touch solved side by side by so many threads, the caller's being one
  /// of them, and one that is most of a group swept over by all of them together if it is large
  /// (coloured_sweeps.h): it starts the others at once, and they sleep between steps. Until then,
  /// and with 1, no thread is started. The motion, the report (but for its seconds and bytes) and
  /// the order of events are the same for any number; below 1 is 1. Storage that is kept from step
  /// to step is given back. Throws std::system_error where no thread is to be had, and
  /// std::bad_alloc where there is no room for so many; the caller is alone then.
  void setThreads(int threads);
  /// Has rolling and spinning friction of rigid bodies bounded as in Bullet's own solver, for
  /// worlds that were tuned with it: |τ| ≤ κ min(r_n, 1 N·s) at each point in each step, and no
  /// spinning friction where there is no rolling friction. What weighs more than 1 N·s of load a
  /// step (6 kg on one point at 60 Hz) then rolls on as it does there. Off at first: |τ| ≤ κ r_n,
  /// whatever the load and the step.
  void setStockRollingFriction(bool on);
  /// Has light bodies in taut joints (a rope of links under a heavy load) turn no faster than the
  /// step can follow: such bodies, and no others, turn as if held by implicit springs of their
  /// geometric stiffness under the last step's forces (geometric_stiffness.h). Joints hold as well;
  /// swings lose some energy, in proportion to the step. Needs SOLVER_USE_WARMSTARTING and a warm
  /// starting factor above 0, has no effect in a solver pool, or where worlds take turns with one
  /// solver; report().stiffened counts. On at first: without it such ropes gain energy and tear,
  /// with any solver that has their joints hold, unless steps are shorter.
  void setGeometricStiffness(bool on);
  /// Forgets the last step's report, the workspace, and the reactions that are kept here; Bullet's
  /// contact points keep theirs. Options, threads, listeners and what was switched on stay. Throws
  /// as setThreads.
  void reset() override;
  /// BT_NNCG_SOLVER, of Bullet's names that of another solver of the whole, for which nobody takes
  /// this one: Bullet casts what answers BT_MULTIBODY_SOLVER, its examples (Hinge2Vehicle,
  /// ForkLift) write into what answers BT_MLCP_SOLVER.
  btConstraintSolverType getSolverType() const override { return BT_NNCG_SOLVER; }

  /// The whole last world step. In a solver pool, which does not announce steps, sums go on until
  /// reset().
  const delassus::StepReport& report() const { return report_; }

  /// Called at the end of each solveGroup with every contact whose mode changed, in the order of
  /// Bullet's manifolds: first those that took part, then those that were left out. The listener
  /// must not add or remove anything in the world, nor reset this solver; it may set listeners, for
  /// the steps to come. An empty function ends it; then nothing is computed for it.
  void setContactListener(std::function<void(const delassus::ContactEvent&)> listener);
  /// The same for every contact in trouble, in every step in which it is, changed or not.
  void setTroubleListener(std::function<void(const delassus::ContactEvent&)> listener);
  /// The same for every contact in which rolling or spinning friction acts, in every step in which
  /// it does, changed or not: Bullet's points have no place for its moment.
  void setTurningListener(std::function<void(const delassus::ContactEvent&)> listener);

 private:
  friend class btDelassusMultiBodyConstraintSolver;
  btDelassusConstraintSolver(const delassus::Options& options, btDelassusPrecision);

  /// What one group took.
  struct Work {
    int iterations = 0;       ///< regions and sweeps, without those of pushes
    double residualMax = -1;  ///< m/s; −1 if nothing was solved
  };
  Work solve(const delassus::bullet::GroupInput& input, delassus::bullet::Extension* extension);
  void gather(const delassus::bullet::GroupInput& input, delassus::bullet::Extension* extension);
  void writeBack(const delassus::Plan& plan, const btContactSolverInfo& info,
                 delassus::bullet::Extension* extension);
  void tellListeners() const;

  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
  delassus::StepReport report_;
  using Listener = std::function<void(const delassus::ContactEvent&)>;
  // Shared, since who listens may end that while it is called; a copy of the function might take
  // memory in every step.
  std::shared_ptr<const Listener> listener_, troubleListener_, turningListener_;
  bool stockRollingFriction_ = false, geometricStiffness_ = true;
};
