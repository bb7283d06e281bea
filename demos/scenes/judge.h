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
/// arguments that the solver gets; after it, the reactions that the solver wrote into Bullet's
/// contact points and joint feedback are put into that problem. A joint's feedback is all rows
/// together; they are told apart by least squares, exact where the rows are independent. What
/// rolling and spinning friction did is written nowhere: it is what the others leave unexplained of
/// the rotations.
class JudgedSolver : public SolverDecorator {
 public:
  /// `cfm` is the global CFM of the scene: what a solver adds to it for its own sake counts as its
  /// error.
  JudgedSolver(btConstraintSolver& inner, btScalar cfm) : SolverDecorator(inner), cfm_(cfm) {}

  /// That of all groups since the last call.
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
  std::vector<btJointFeedback> lent_;  ///< for joints whose user asked for none
  std::vector<btTypedConstraint*> borrowers_;
};

}  // namespace demos
