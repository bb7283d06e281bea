#include "delassus/reaction_steps.h"

#include "delassus/cone.h"
#include "delassus/proximal_centers.h"
#include "delassus/reaction_error.h"

namespace delassus {

/// The steps around one center, for `descend`. r and v are those of `at`.
template <class Motion>
class ReactionSteps<Motion>::AroundCenter {
 public:
  AroundCenter(ProximalSpace<Motion>& space, double alpha, Solution& at)
      : space_(space),
        problem_(space.problem()),
        motion_(space.motion()),
        scale_(space.scale),
        l_(space.l),
        perScale_(1 + alpha),
        r_(at.r),
        v_(at.u),
        F_(space.ofUnknowns[0]),
        change_(space.ofUnknowns[1]),
        delta_(space.ofMotion[0]),
        felt_(space.ofUnknowns[2]),
        last_(space.ofUnknowns[3]),
        kept_(space.ofUnknowns[4]),
        G_(space.G) {}

  double error();
  bool step(double& error);
  // v is not kept, since it is not used afterwards.
  void keepLast() { kept_.swap(last_); }
  void goBack() { r_.swap(kept_); }

 private:
  double rho(int at) const { return perScale_ * scale_[at]; }
  void answer(int contact);
  void answer(const Disk& disk, int k);
  void answerAll();

  ProximalSpace<Motion>& space_;
  const Problem& problem_;
  Motion& motion_;
  const VectorXd &scale_, &l_;
  double perScale_;
  VectorXd &r_, &v_;
  VectorXd& F_;
  VectorXd& change_;         ///< B F, and then Δr
  VectorXd &delta_, &felt_;  ///< δ and J̃ δ
  VectorXd &last_, &kept_;   ///< r before the last step; r to go back to
  Stiffness& G_;
};

/// Computes F at r and v. Returns ‖ρ F‖, m/s.
template <class Motion>
double ReactionSteps<Motion>::AroundCenter::error() {
  F_.resize(problem_.size());
  return reactionError(
      ReactionBounds::of(problem_), r_, v_, [this](int at) { return rho(at); }, F_);
}

/// Computes G and B F of a contact in the region of r and v.
template <class Motion>
void ReactionSteps<Motion>::AroundCenter::answer(int contact) {
  const int at = 3 * contact;
  const double mu = problem_.friction[contact], rho = this->rho(at);
  const Vec3 z = r_.segment<3>(at) - v_.segment<3>(at) / rho, F = F_.segment<3>(at);
  const Vec3 l = l_.segment<3>(at);
  Mat3& G = G_.contacts[contact];
  auto forced = change_.segment<3>(at);
  if (z[0] <= 0) {
    G.setZero();
    forced = F;
    return;
  }
  const double zt = lengthOf(z[1], z[2]);
  if (mu > 0 && zt <= mu * z[0]) {
    G = l.asDiagonal();
    forced = rho * l.cwiseProduct(F);
    return;
  }
  // P' = [1, 0; μ d, turn (1 − d dᵀ)] with d = z_t/‖z_t‖.
  const double c = zt > 0 ? z[1] / zt : 0, s = zt > 0 ? z[2] / zt : 0;
  const double turn = mu > 0 ? mu * z[0] / zt : 0;
  const double stays = turn * (1 - 2 / (rho * (l[1] + l[2])));
  const double along = mu * l[0], across = turn / ((1 - stays) * rho);
  G = slidingBlock(l[0], along, across, c, s);
  const double normal = rho * l[0] * F[0], rim = mu * (normal - F[0]);
  const double turned = stays / (1 - stays) * (c * F[2] - s * F[1]);
  forced = Vec3(normal, F[1] + rim * c - turned * s, F[2] + rim * s + turned * c);
}

/// The same for disk k, once its governor has answered.
template <class Motion>
void ReactionSteps<Motion>::AroundCenter::answer(const Disk& disk, int k) {
  const double rho = this->rho(disk.first), l = l_[disk.first];
  const double load = r_[disk.governor] + F_[disk.governor];
  const Vec2 z = disk.of(r_) - disk.of(v_) / rho, F = disk.of(F_);
  const double radius = disk.radiusUnder(load), length = z.norm();
  if (!(radius > 0)) {
    space_.answerOfDisk(disk, k, Mode::Open, z, 0, false, G_);
    disk.put(F, change_);
  } else if (length <= radius) {
    space_.answerOfDisk(disk, k, Mode::Stick, z, 0, false, G_);
    disk.put(rho * l * F, change_);
  } else {
    const bool grows = load < disk.mostLoad;
    const double turn = radius / length, stays = turn * (1 - 1 / (rho * l));
    space_.answerOfDisk(disk, k, Mode::Slide, z, turn / ((1 - stays) * rho), grows, G_);
    const Vec2 t = z / length;
    const double along = t.dot(F);
    const double rim = grows ? disk.radius * (change_[disk.governor] - F_[disk.governor]) : 0;
    disk.put((along + rim) * t + (F - along * t) / (1 - stays), change_);
  }
}

template <class Motion>
void ReactionSteps<Motion>::AroundCenter::answerAll() {
  const int contactsEnd = 3 * problem_.contacts();
  change_.resize(problem_.size());
  for (int i = 0; i < problem_.contacts(); ++i) answer(i);
  for (int at = contactsEnd; at < problem_.disksBegin(); ++at) {
    const int row = at - contactsEnd;
    const double z = r_[at] - v_[at] / rho(at), l = l_[at], F = F_[at];
    const bool isFree = z > problem_.lower[row] && z < problem_.upper[row];
    G_.rows[row] = isFree ? l : 0;
    change_[at] = isFree ? rho(at) * l * F : F;
  }
  for (std::size_t k = 0; k < problem_.disks.size(); ++k)
    answer(problem_.disks[k], static_cast<int>(k));
}

/// Goes to the zero of F in this region; `error` is afterwards that at the new r and v.
template <class Motion>
bool ReactionSteps<Motion>::AroundCenter::step(double& error) {
  const int contactsEnd = 3 * problem_.contacts();
  answerAll();
  if (!motion_.factorise(G_)) return false;
  motion_.impulse(change_, delta_);
  motion_.solve(delta_);
  motion_.relativeVelocity(delta_, felt_);
  for (int at = 0; at < contactsEnd; at += 3)
    change_.segment<3>(at).noalias() -= G_.contacts[at / 3] * felt_.segment<3>(at);
  const int rows = problem_.rows();
  change_.tail(rows) -= G_.rows.cwiseProduct(felt_.tail(rows));
  for (std::size_t k = 0; k < problem_.disks.size(); ++k) {
    const Disk& disk = problem_.disks[k];
    disk.put(disk.of(change_) - G_.disks[k].times(disk, felt_, contactsEnd), change_);
  }
  if (!change_.allFinite()) return false;
  last_ = r_;
  r_ += change_;
  v_ += felt_ + change_.cwiseQuotient(l_);
  error = this->error();
  return true;
}

template <class Motion>
bool ReactionSteps<Motion>::solve(double tolerance, int budget, Solution& next, Solution& best) {
  space_.forgetFactor();
  const auto moveOn = [&](const Solution& from, double alpha, double enough, int most,
                          Solution& to) {
    space_.setWeights(alpha);
    to.takeReactions(from);
    AroundCenter steps(space_, alpha, to);
    const Descent descent = descend(steps, enough, most);
    makeFeasible(space_.problem(), to.r);
    to.setResidual(space_.measure(to.r, to.u));
    return descent;
  };
  const Descent descent = moveCenters(moveOn, space_.map(), tolerance, budget, next, best);
  best.regions += descent.steps;
  best.factorisations += descent.steps;
  return descent.isFound;
}

template class ReactionSteps<BodyMotion>;
template class ReactionSteps<FactoredMotion>;

}  // namespace delassus
