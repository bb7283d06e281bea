/// Answers to easier problems, from which the search sets out: for bodies that are soft where they
/// touch, and for less friction.
#include <algorithm>

#include "delassus/pile_kind.h"
#include "delassus/search.h"

namespace delassus {

/// Makes varied_ the same problem, to be varied; its W is yet to come.
void Search::vary() {
  varied_.q = problem_->q;
  varied_.friction = problem_->friction;
  varied_.lower = problem_->lower;
  varied_.upper = problem_->upper;
  varied_.disks = problem_->disks;
  varied_.roundOff = problem_->roundOff;
  varied_.leastDemand = problem_->leastDemand;
}

/// Solves varied_ from variedStart_; the answer is in variedAnswer_.
Outcome Search::answerVaried(const Task& task, Solution& best) {
  if (!variedSearch_) variedSearch_.reset(new Search(machines()));
  variedSearch_->setProblem(varied_, task.tolerance);
  variedAnswer_.start(varied_.q);
  variedSearch_->offer(variedStart_, variedAnswer_);
  const Outcome outcome = variedSearch_->walk(task, variedAnswer_);
  best.factorisations += variedAnswer_.factorisations;
  best.sweeps += variedAnswer_.sweeps;
  return outcome;
}

/// Finds the answer, in variedStart_, for bodies that are as little compliant where they touch as
/// sweeps and a short walk can solve. Returns how compliant, in W_aa, or 0 if they find none.
double Search::soften(const Task& task, Solution& best) {
  constexpr double softest = 1, hardest = 1e-5, finer = 0.3162, tolerance = 1e-10;
  constexpr int sweeps = 1000, regions = 60;
  vary();
  BodySpace& space = varied_.W.refill(problem_->size());
  space = problem_->W.bodySpace();
  map_.meanDiagonal(felt_);
  Task few{task.options, tolerance * problem_->demand(), &variedStart_};
  few.options.sweepBudget = sweeps;
  few.options.newtonBudget = regions;
  few.options.pathBudget = 0;
  double found = 0;
  for (double compliance = softest; compliance > hardest; compliance *= finer) {
    space.compliance = problem_->W.bodySpace().compliance + compliance * felt_;
    if (answerVaried(few, best) != Outcome::Reached) break;
    variedStart_ = variedAnswer_.r;
    found = compliance;
  }
  return found;
}

/// For large piles without reactions of a last step, where a walk was lost: sets out from the
/// answers for less friction, one after the other, as long as there are regions.
///
/// With much friction an answer may repel what comes near it. Linearised there, an outer step of
/// the walk multiplies errors by (1 + P' l W)⁻¹ P', l = 1/(α W_aa). This may be no contraction
/// unless α is small, and for small α there is no way from afar. That is one reason why walks are
/// lost, not the only one (renders/report/piles.md). The answer for less friction is another place
/// to come from. In body space, as on the path of compliance: explicit entries are too expensive.
Outcome Search::addFriction(const Task& task, Solution& best) {
  constexpr double shares[] = {0.8, 0.95, 0.6};
  constexpr double few = 1000;  // contacts and rows; with more, each region costs more
  if (task.guess || task.options.pathBudget <= 0 || !isLargeButNoHeap(*problem_) ||
      !problem_->W.inBodySpace() ||
      !(problem_->contacts() > 0 && problem_->friction.maxCoeff() > 0))
    return Outcome::Lost;
  const int budget =
      static_cast<int>(task.options.newtonBudget * std::min(1.0, few / problem_->parts()));
  const auto rest = [&](const VectorXd* guess) {
    Task apart{task.options, task.tolerance, guess};
    apart.options.newtonBudget = budget - best.regions;
    apart.options.sweepBudget -= best.sweeps;
    apart.options.pathBudget = 0;
    return apart;
  };
  for (const double share : shares) {
    if (best.regions >= budget) break;
    vary();
    varied_.friction *= share;
    varied_.W.refer(problem_->W);
    variedStart_.setZero(problem_->size());
    answerVaried(rest(nullptr), best);
    best.regions += variedAnswer_.regions;

    variedStart_ = variedAnswer_.r;
    const Task whole = rest(&variedStart_);
    const WorkDone before = best;
    best.takeWork({});
    setOutApart(&variedStart_, best);
    const Outcome outcome = comeBack(walkOnce(machines().bodies, whole, apart_), best);
    best.addWork(before);
    if (outcome != Outcome::Lost) return outcome;
  }
  return Outcome::Lost;
}

}  // namespace delassus
