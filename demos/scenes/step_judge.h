#pragma once

#include "demos/scenes/judge.h"
#include "demos/scenes/solvers.h"

namespace demos {

/// The residual of a world's steps, by our solver's own report or by the judge of the others.
class StepJudge {
 public:
  /// `inner` is the solver of `named`, or looks on at it. Both must outlive the judge. `cfm` is the
  /// global CFM of the scene.
  StepJudge(btConstraintSolver& inner, const NamedSolver& named, btScalar cfm)
      : inner_(inner), named_(named), judged_(inner, cfm) {}

  /// What the world is to solve its next step with. Judging costs about a solve; a step that is not
  /// judged leaves no residual but our own.
  btConstraintSolver& solver(bool isJudged = true);

  /// That of the last step, to be called after each that is judged. Its count is 0 if nothing was
  /// solved: all sleep, or nothing touches.
  StepResidual takeResidual();

 private:
  btConstraintSolver& inner_;
  const NamedSolver& named_;
  JudgedSolver judged_;
};

}  // namespace demos
