#include "demos/scenes/step_judge.h"

#include "bullet_ext/btDelassusConstraintSolver.h"

namespace demos {

btConstraintSolver& StepJudge::solver(bool isJudged) {
  if (isJudged && named_.delassus() == nullptr) return judged_;
  return inner_;
}

StepResidual StepJudge::takeResidual() {
  if (named_.delassus() == nullptr) return judged_.takeResidual();
  const delassus::StepReport& report = named_.delassus()->report();
  const long count = report.contacts + report.rows;
  return {report.residualMax, report.residualRms * report.residualRms * double(count), count};
}

}  // namespace demos
