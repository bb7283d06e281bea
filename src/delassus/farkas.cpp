#include "delassus/farkas.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delassus {

void FarkasProof::setProblem(const Problem& problem, const NaturalMap& map) {
  const int n = problem.contacts();
  map_ = &map;
  demands_.W.refer(problem.W);
  demands_.q = problem.q;
  demands_.friction.setZero(n);
  demands_.lower = problem.lower;
  demands_.upper = problem.upper;
  demands_.roundOff = problem.roundOff;
  for (int i = 0; i < n; ++i) demands_.q.segment<2>(3 * i + 1).setZero();
  for (int i = 0; i < problem.rows(); ++i) {
    const bool ofDisk = 3 * n + i >= problem.disksBegin();
    demands_.lower[i] = !ofDisk && problem.lower[i] == -infinity ? -infinity : 0;
    demands_.upper[i] = !ofDisk && problem.upper[i] == infinity ? infinity : 0;
    if (demands_.lower[i] == demands_.upper[i]) demands_.q[3 * n + i] = 0;
  }
}

double FarkasProof::leastMotion(const VectorXd& r) {
  // Squares of what is felt, not r·W r: where large reactions cancel, that is all rounding.
  constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
  const BodySpace& space = demands_.W.bodySpace();
  space.impulse(r, felt_);
  const double compliant = space.compliance.dot(r.cwiseAbs2());
  const double noise = rounding * map_->diagonal().cwiseSqrt().dot(r.cwiseAbs());
  const double doubt =
      demands_.roundOff * r.cwiseAbs().sum() + rounding * demands_.q.cwiseAbs().dot(r.cwiseAbs());
  const double push = -r.dot(demands_.q) - doubt;
  return push > 0 ? push / (std::sqrt(felt_.squaredNorm() + compliant) + noise) : 0;
}

double FarkasProof::hardestAlone() const {
  double hardest = 0;
  for (int i = 0; i < demands_.size(); ++i) {
    const Interval bounds = allowedWithoutFriction(demands_, i);
    const double missing = std::max(bounds.upper > 0 ? -demands_.q[i] : 0,  //
                                    bounds.lower < 0 ? demands_.q[i] : 0);
    const double diagonal = map_->diagonal()[i];
    if (missing > 0 && diagonal > 0) hardest = std::max(hardest, missing / std::sqrt(diagonal));
  }
  return hardest;
}

bool FarkasProof::find(ProximalWalk<BodyMotion>& walk, const Problem& problem,
                       const NaturalMap& map, double tolerance, int& regionBudget,
                       Solution& scratch, WorkDone& count) {
  // Times the motion that the hardest demand alone asks for. Less proves nothing: a wedge of a
  // microradian that holds a ball demands a millionth of what the ball needs.
  constexpr double proportion = 1e8;
  constexpr double coarse = 1e-6, fine = 1e-8;  // compliances relative to W_aa
  constexpr double exactly = 1e-3;
  setProblem(problem, map);
  walk.space().setProblem(demands_, map);
  const auto answer = [&](double compliance) {
    scratch.start(demands_.q);
    const bool found = walk.answerCompliant(tolerance, compliance, regionBudget, scratch);
    count.regions += scratch.regions;
    count.factorisations += scratch.factorisations;
    return found;
  };
  // What pushes in vain is in inverse proportion to the compliance; all else hardly depends on it,
  // and is gone in the difference.
  if (!answer(coarse)) return false;
  reactions_ = scratch.r;
  if (!answer(fine)) return false;
  reactions_ = scratch.r - reactions_;
  const auto areProof = [&] {
    for (int i = 0; i < reactions_.size(); ++i) {
      const Interval bounds = allowedWithoutFriction(demands_, i);
      reactions_[i] = std::clamp(reactions_[i], bounds.lower, bounds.upper);
    }
    return leastMotion(reactions_) > proportion * hardestAlone();
  };
  if (areProof()) return true;
  // Nearly gone, and where demands contradict each other by little, what is left is as much as
  // these push. A step from there without demands keeps what moves nothing, to all digits.
  scratch.start(demands_.q);
  scratch.r = reactions_;
  demands_.W.multiply(reactions_, felt_, scratch.u);
  demands_.q.setZero();
  walk.polish(exactly * tolerance, fine, regionBudget, scratch);
  count.regions += scratch.regions;
  count.factorisations += scratch.factorisations;
  setProblem(problem, map);
  reactions_ = scratch.r;
  return areProof();
}

}  // namespace delassus
