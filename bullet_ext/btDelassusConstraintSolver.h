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
/// it owns its workspace. Reactions are kept in Bullet's contact points. Some have no room there:
/// those of joints, of rolling and spinning friction, of points that the narrow phase replaced, and
/// the digits that float cannot hold. The solver itself keeps these for one step. For that it needs
/// prepareSolve, which Bullet's world calls; without it (a solver pool) float worlds are solved in
/// every step.
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
  /// Solves islands that do not touch side by side on this many threads, the caller's being one of
  /// them. A large island that makes up most of a group is swept over and factored by all threads
  /// together (coloured_sweeps.h, block_factor.h). This call starts the other threads at once; they
  /// sleep between steps. No thread is started before it, nor by setThreads(1); a number below 1
  /// counts as 1. The motion, the report (but for its seconds and bytes) and the order of events
  /// are the same for any number. Storage that is kept from step to step is given back. Threads do
  /// not come along when a process forks: a child must not use or delete a solver that has some,
  /// and sets up its own. Throws std::system_error where no thread is to be had, and std::bad_alloc
  /// where there is no room for so many; then the caller works alone.
  void setThreads(int threads);
  /// Bounds rolling and spinning friction of rigid bodies as Bullet's own solver does, for worlds
  /// that were tuned with it: |τ| ≤ κ min(r_n, 1 N·s) at each point in each step, and no spinning
  /// friction where there is no rolling friction. A body with more than 1 N·s of load a step on a
  /// point (6 kg at 60 Hz) then rolls on, as it does there. Off at first: |τ| ≤ κ r_n, whatever the
  /// load and the step.
  void setStockRollingFriction(bool on);
  /// Lets light bodies in taut joints (a rope of links under a heavy load) turn no faster than the
  /// step can follow: these bodies, and no others, turn as if held by implicit springs of their
  /// geometric stiffness under the last step's forces (geometric_stiffness.h). Their joints hold as
  /// exactly as others; their swings lose some energy, in proportion to the step. Needs
  /// SOLVER_USE_WARMSTARTING and a warm starting factor above 0. Has no effect in a solver pool, or
  /// where several worlds use one solver in turn. report().stiffened counts the bodies. On at
  /// first: without it such ropes gain energy and tear with any solver whose joints hold, unless
  /// steps are shorter.
  void setGeometricStiffness(bool on);
  /// Forgets the last step's report, the workspace, and the reactions that the solver itself keeps;
  /// Bullet's contact points keep theirs. Options, threads, listeners and switches stay. Throws as
  /// setThreads does.
  void reset() override;
  /// BT_NNCG_SOLVER, because no code casts a solver that answers so. Bullet casts one that answers
  /// BT_MULTIBODY_SOLVER, and its examples (Hinge2Vehicle, ForkLift) write into one that answers
  /// BT_MLCP_SOLVER.
  btConstraintSolverType getSolverType() const override { return BT_NNCG_SOLVER; }

  /// The report of the whole last world step. A solver pool does not announce steps: there the sums
  /// go on until reset().
  const delassus::StepReport& report() const { return report_; }

  /// Calls the listener at the end of each solveGroup with every contact whose mode changed, in the
  /// order of Bullet's manifolds: first those that took part, then those that were left out. The
  /// listener must not add or remove anything in the world, nor reset this solver, nor throw
  /// (Bullet would keep pointers to bodies that may be gone); it may set listeners, for the steps
  /// to come. An empty function ends the calls; then no events are made.
  void setContactListener(std::function<void(const delassus::ContactEvent&)> listener);
  /// The same for every contact in trouble, in every step in which it is in trouble, whether or not
  /// its mode changed.
  void setTroubleListener(std::function<void(const delassus::ContactEvent&)> listener);
  /// The same for every contact in which rolling or spinning friction acts, in every step in which
  /// it acts, whether or not its mode changed: Bullet's points have no place for its moment.
  void setTurningListener(std::function<void(const delassus::ContactEvent&)> listener);

 private:
  friend class btDelassusMultiBodyConstraintSolver;
  btDelassusConstraintSolver(const delassus::Options& options, btDelassusPrecision);

  /// The work that one group took.
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
  // Shared, since a listener may end itself while it is called; a copy of the function might
  // allocate memory in every step.
  std::shared_ptr<const Listener> listener_, troubleListener_, turningListener_;
  bool stockRollingFriction_ = false, geometricStiffness_ = true;
};
