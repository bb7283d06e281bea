#pragma once

#include "demos/scenes/solvers.h"
#include "demos/scenes/timed_solver.h"
#include "demos/scenes/world.h"

namespace demos {

/// While it lives, `named` solves the steps of `world`, timed and with the settings of its name.
/// Afterwards, even after an exception, the world has its own solver and settings back, and no
/// observer is left in it. Both must outlive this.
class SolverInWorld {
 public:
  SolverInWorld(World& world, NamedSolver& named)
      : world_(world),
        own_(*world.dynamics().getConstraintSolver()),
        ownSettings_(world.dynamics().getSolverInfo()),
        timed_(named.solver()) {
    named.configure(world.dynamics().getSolverInfo());
    world.setSolver(timed_);
  }
  ~SolverInWorld() {
    world_.setSolver(own_);
    world_.dynamics().getSolverInfo() = ownSettings_;
  }
  SolverInWorld(const SolverInWorld&) = delete;
  SolverInWorld& operator=(const SolverInWorld&) = delete;

  /// The solver of the world, unless the world is given an observer of it.
  TimedSolver& timed() { return timed_; }
  /// The global CFM of the scene; `named` may add to it.
  btScalar sceneCfm() const { return ownSettings_.m_globalCfm; }

 private:
  World& world_;
  btConstraintSolver& own_;
  const btContactSolverInfo ownSettings_;
  TimedSolver timed_;
};

}  // namespace demos
