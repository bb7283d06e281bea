#pragma once

#include "demos/scenes/judge.h"
#include "demos/scenes/solvers.h"

namespace demos {

/// The residual of a world's steps: from our solver's own report, or from the judge of other
/// solvers.
class StepJudge {
 public:
  /// `inner` is the solver of `named`, or an observer of it. Both must outlive the judge. `cfm` is
  /// the global CFM of the scene.
  StepJudge(btConstraintSolver& inner, const NamedSolver& named, btScalar cfm)
      : inner_(inner), named_(named), judged_(inner, cfm) {}

  /// The solver for the world's next step. Judging costs about as much as a solve; a step that is
  /// not judged has a residual only if the solver is ours.
  btConstraintSolver& solver(bool isJudged = true);

  /// The residual of the last step; call it after each judged step. Its count is 0 if nothing was
  /// solved: all bodies sleep, or nothing touches.
  StepResidual takeResidual();

 private:
  btConstraintSolver& inner_;
  const NamedSolver& named_;
  JudgedSolver judged_;
};

}  // namespace demos
