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
  demands_.leastDemand = problem.leastDemand;
  for (int i = 0; i < n; ++i) demands_.q.segment<2>(3 * i + 1).setZero();
  for (int i = 0; i < problem.rows(); ++i) {
    const bool ofDisk = 3 * n + i >= problem.disksBegin();
    demands_.lower[i] = !ofDisk && problem.lower[i] == -infinity ? -infinity : 0;
    demands_.upper[i] = !ofDisk && problem.upper[i] == infinity ? infinity : 0;
    if (demands_.lower[i] == demands_.upper[i]) demands_.q[3 * n + i] = 0;
  }
}

FarkasProof::Push FarkasProof::weigh(const VectorXd& r) {
  // From squares of J̃ᵀ r, not as r·W r: where large reactions cancel, the latter is all rounding.
  constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
  const BodySpace& space = demands_.W.bodySpace();
  space.impulse(r, felt_);
  const double compliant = space.compliance.dot(r.cwiseAbs2());
  const double moved = std::sqrt(felt_.squaredNorm() + compliant);
  const double noise = rounding * map_->diagonal().cwiseSqrt().dot(r.cwiseAbs());
  const double doubt =
      demands_.roundOff * r.cwiseAbs().sum() + rounding * demands_.q.cwiseAbs().dot(r.cwiseAbs());
  const double work = -r.dot(demands_.q) - doubt;
  if (!(work > 0)) return {};
  return {work / (moved + noise), work / r.cwiseAbs().sum(), moved <= noise};
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
                       const NaturalMap& map, double tolerance, const VectorXd& start,
                       int& regionBudget, Solution& scratch, WorkDone& count) {
  // Relative to W_aa. Answers for the softest are soon found and lead to those for the hard ones.
  // With the last, reactions that push in vain are larger than those that carry loads, even where
  // demands contradict each other by less than anybody asks for.
  constexpr double compliances[] = {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}, hard = 1e-7;
  setProblem(problem, map);
  walk.space().setProblem(demands_, map);
  last_ = start;
  keepPushes(last_);
  const auto answer = [&](double compliance, const VectorXd& from) {
    scratch.start(demands_.q);
    const bool isFound = walk.answerCompliant(tolerance, compliance, from, regionBudget, scratch);
    count.addWork(scratch);
    return isFound;
  };
  for (const double compliance : compliances) {
    if (!answer(compliance, last_)) {
      reactions_.setZero(problem.size());
      if (!answer(compliance, reactions_)) return false;
    }
    // Reactions that push in vain are in inverse proportion to the compliance. All others hardly
    // depend on it, and vanish in the difference.
    reactions_ = scratch.r - last_;
    last_.swap(scratch.r);
    if (compliance > hard) continue;
    if (isProof() || refine(walk, problem, map, regionBudget, scratch, count)) return true;
  }
  return false;
}

/// Improves reactions_, which still hold a rest of the reactions that carry loads. Where demands
/// contradict each other by little, this rest is as large as the pushes of the contradiction. Steps
/// from there without demands keep only the part that moves nothing, to all digits.
bool FarkasProof::refine(ProximalWalk<BodyMotion>& walk, const Problem& problem,
                         const NaturalMap& map, int& regionBudget, Solution& scratch,
                         WorkDone& count) {
  constexpr double stiff = 1e-8;
  constexpr int most = 3;
  for (int step = 0; step < most; ++step) {
    const double finest = std::numeric_limits<double>::epsilon() *
                          map.diagonal().cwiseProduct(reactions_).lpNorm<Eigen::Infinity>();
    scratch.start(demands_.q);
    scratch.r = reactions_;
    demands_.W.multiply(reactions_, felt_, scratch.u);
    demands_.q.setZero();
    walk.polish(finest, stiff, regionBudget, scratch);
    regionBudget -= scratch.regions;
    count.addWork(scratch);
    setProblem(problem, map);
    reactions_ = scratch.r;
    if (isProof()) return true;
  }
  return false;
}

/// Moves reactions into the bounds: those that push where they may not do not count.
void FarkasProof::keepPushes(VectorXd& r) const {
  for (int i = 0; i < r.size(); ++i) {
    const Interval bounds = allowedWithoutFriction(demands_, i);
    r[i] = std::clamp(r[i], bounds.lower, bounds.upper);
  }
}

bool FarkasProof::isProof() {
  // In units of the motion that the hardest demand alone asks for. Less proves nothing: a wedge of
  // a microradian that holds a ball demands a millionth of what the ball needs. Reactions that move
  // nothing beyond rounding are no wedge.
  constexpr double proportion = 1e8, proportionOfRounding = 1e3;
  keepPushes(reactions_);
  const Push push = weigh(reactions_);
  missed_ = push.missed;
  return push.leastMotion >
         (push.movesNothing ? proportionOfRounding : proportion) * hardestAlone();
}

}  // namespace delassus
