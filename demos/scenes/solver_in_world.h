#pragma once

#include "demos/scenes/solvers.h"
#include "demos/scenes/timed_solver.h"
#include "demos/scenes/world.h"

namespace demos {

/// Has `named` solve the steps of `world`, timed and with the settings that its name stands for, as
/// long as this lives. Then, be it by an exception, the world has its own solver and settings back:
/// nothing that looked on is left in it. Both must outlive this.
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

  /// What the world solves with, unless it is given something else that looks on at it.
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
