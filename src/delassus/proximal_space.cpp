#include "delassus/proximal_space.h"

namespace delassus {

template <class Motion>
void ProximalSpace<Motion>::setProblem(const Problem& problem, const NaturalMap& map) {
  problem_ = &problem;
  map_ = &map;
  motion_.setProblem(problem);
  map.meanDiagonal(scale);
  if (problem.W.inBodySpace())
    compliance = problem.W.bodySpace().compliance;
  else
    compliance.setZero(problem.size());
  G.reset(problem);
  // These are sized at once; otherwise some later step would be the first to allocate.
  for (const int seldom : seldomUsed) ofUnknowns[seldom].resize(problem.size());
  forgetFactor();
}

template <class Motion>
void ProximalSpace<Motion>::setWeights(double alpha) {
  l = (compliance + alpha * scale).cwiseInverse();
}

template <class Motion>
bool ProximalSpace<Motion>::factorise(WorkDone& count) {
  if (keepsFactors_ && hasFactor_ && factored_ == G) return true;
  ++count.factorisations;
  hasFactor_ = motion_.factorise(G);
  if (hasFactor_) factored_ = G;
  return hasFactor_;
}

template <class Motion>
void ProximalSpace<Motion>::answerOfDisk(const Disk& disk, int k, Mode mode, const Vec2& direction,
                                         double turn, bool grows, Stiffness& G) const {
  Stiffness::OfDisk& answer = G.disks[k];
  answer = {};
  G.rows.segment(disk.first - 3 * static_cast<int>(G.contacts.size()), disk.unknowns).setZero();
  if (mode == Mode::Stick) answer.own.diagonal().setConstant(l[disk.first]);
  if (mode != Mode::Slide) return;
  const Vec2 along = direction.normalized();
  answer.own = turn * (Mat2::Identity() - along * along.transpose());
  if (grows) answer.governor = disk.radius * along * G.ofNormal(disk);
}

template class ProximalSpace<BodyMotion>;
template class ProximalSpace<FactoredMotion>;

}  // namespace delassus
