#pragma once

#include <vector>

#include "bullet_ext/gather.h"
#include "delassus/island.h"
#include "demos/scenes/solver_decorator.h"

namespace demos {

/// The natural residual of one step, over all islands, m/s.
struct StepResidual {
  double max = 0;
  double sumOfSquares = 0;
  long count = 0;  ///< contacts and joint rows judged

  double rms() const;
};

/// Judges any Bullet solver by the law that ours is judged by.
///
/// Before a group is solved, the problem (W, q, friction, bounds) is gathered from the same
/// arguments that the solver gets. Afterwards the reactions that the solver wrote into Bullet's
/// contact points and joint feedback are put into that problem. A joint's feedback is the sum of
/// its rows; least squares tell the rows apart, exactly if they are independent. The reactions of
/// rolling and spinning friction are written nowhere: they are found from the rotations that the
/// others leave unexplained.
class JudgedSolver : public SolverDecorator {
 public:
  /// `cfm` is the global CFM of the scene; anything that a solver adds to it counts as its error.
  JudgedSolver(btConstraintSolver& inner, btScalar cfm) : SolverDecorator(inner), cfm_(cfm) {}

  /// The residual of all groups since the last call.
  StepResidual takeResidual();

 protected:
  void beforeGroup(const GroupInput& group) override;
  void afterGroup(const GroupInput& group) override;

 private:
  void lendFeedback(const GroupInput& arguments);
  std::vector<double> rowReactions(double timeStep) const;
  void addTurning(const delassus::Island& island, const delassus::Problem& problem,
                  delassus::VectorXd& r) const;
  void takeFeedbackBack();

  btScalar cfm_;
  StepResidual residual_;
  delassus::bullet::Group group_;
  std::vector<btJointFeedback> lent_;  ///< for joints without feedback of their own
  std::vector<btTypedConstraint*> borrowers_;
};

}  // namespace demos
