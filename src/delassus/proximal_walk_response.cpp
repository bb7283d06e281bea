/// How contacts, rows and disks answer the motion in a walk: by the law, or as in one given region.
#include <algorithm>
#include <cmath>

#include "delassus/cone.h"
#include "delassus/length.h"
#include "delassus/proximal_walk.h"

namespace delassus {

/// Stores the reaction `r` to center + step. Where the law leaves center + step as it is, the
/// change is the step with all its digits; the difference of two large reactions would keep few of
/// them.
template <class Motion>
void ProximalWalk<Motion>::answer(int at, double step, double r) {
  r_[at] = r;
  change_[at] = r == center_[at] + step ? step : r - center_[at];
}

/// r = P(z), the change r − r_k and, if asked, its derivative, for relative velocities u = u_k +
/// J̃ δ.
template <class Motion>
void ProximalWalk<Motion>::respond(const VectorXd& u, Stiffness* G) {
  const Problem& problem = this->problem();
  change_.resize(problem.size());
  const int n = problem.contacts(), m = problem.rows();
  for (int i = 0; i < n; ++i) {
    const int at = 3 * i;
    const double mu = problem.friction[i];
    const Vec3 l = l_.segment<3>(at);
    const Vec3 step = -l.cwiseProduct(u.segment<3>(at));
    const Vec3 r = reactionTo(center_.segment<3>(at) + step, mu, G ? &G->contacts[i] : nullptr);
    for (int k = 0; k < 3; ++k) answer(at + k, step[k], r[k]);
    if (G) G->contacts[i] *= l.asDiagonal();
  }
  for (int i = 0; i < m; ++i) {
    const int at = 3 * n + i;
    const double step = -l_[at] * u[at], z = center_[at] + step;
    answer(at, step, std::clamp(z, problem.lower[i], problem.upper[i]));
    if (G) G->rows[i] = z > problem.lower[i] && z < problem.upper[i] ? l_[at] : 0;
  }
  for (std::size_t k = 0; k < problem.disks.size(); ++k) {
    const Disk& disk = problem.disks[k];
    const Vec2 step = -l_[disk.first] * disk.of(u), z = disk.of(center_) + step;
    const double length = z.norm(), radius = disk.radiusAt(r_);
    const Mode mode = !(radius > 0) ? Mode::Open : length <= radius ? Mode::Stick : Mode::Slide;
    const Vec2 r = projectOnDisk(z, radius);
    for (int j = 0; j < disk.unknowns; ++j) answer(disk.first + j, step[j], r[j]);
    if (G)
      space_.answerOfDisk(disk, static_cast<int>(k), mode, z, radius * l_[disk.first] / length,
                          disk.grows(r_), *G);
  }
}

/// The same in one given region, that of `from`: an affine answer, right if the region is.
template <class Motion>
void ProximalWalk<Motion>::respondInRegion(const Solution& from) {
  const Problem& problem = this->problem();
  const int n = problem.contacts(), m = problem.rows();
  for (int i = 0; i < n; ++i) {
    const int at = 3 * i;
    const double mu = problem.friction[i];
    const Vec3 g = from.r.segment<3>(at), l = l_.segment<3>(at);
    const Vec3 held = center_.segment<3>(at) - l.cwiseProduct(u_.segment<3>(at));
    auto r = r_.segment<3>(at);
    switch (from.activeSet.contacts[i]) {
      case Mode::Open:
        r.setZero();
        G_.contacts[i].setZero();
        break;
      case Mode::Stick:
        r = held;
        G_.contacts[i] = l.asDiagonal();
        break;
      case Mode::Slide: {
        const double length = lengthOf(g[1], g[2]);
        const double c = length > 0 ? g[1] / length : 0, s = length > 0 ? g[2] / length : 0;
        // The direction may turn as it does at the guess: by μ r_n over the sliding speed.
        const double speed = lengthOf(from.u[at + 1], from.u[at + 2]);
        const double turn = length > 0 ? length / (length / l[1] + speed) : 0;
        r = held[0] * Vec3(1, mu * c, mu * s);
        const double across = turn * (-s * u_[at + 1] + c * u_[at + 2]);
        r[1] += s * across;
        r[2] -= c * across;
        G_.contacts[i] = slidingBlock(l[0], mu * l[0], turn, c, s);
        break;
      }
    }
  }
  for (int i = 0; i < m; ++i) {
    const int at = 3 * n + i;
    const RowState state = from.activeSet.rows[i];
    const bool free = state == RowState::Free;
    r_[at] = free                         ? center_[at] - l_[at] * u_[at]
             : state == RowState::AtLower ? problem.lower[i]
                                          : problem.upper[i];
    G_.rows[i] = free ? l_[at] : 0;
  }
  for (std::size_t k = 0; k < problem.disks.size(); ++k) {
    const Disk& disk = problem.disks[k];
    const Mode mode = from.activeSet.disks[k];
    const Vec2 g = disk.of(from.r), u = disk.of(u_);
    const double l = l_[disk.first], length = g.norm();
    // Turns as a contact does.
    const double turn = length > 0 ? length / (length / l + disk.of(from.u).norm()) : 0;
    const bool grows = disk.grows(from.r);
    space_.answerOfDisk(disk, static_cast<int>(k), mode, g, turn, grows, G_);
    const Vec2 held = disk.of(center_) - l * u;
    const double load = grows ? r_[disk.governor] : disk.mostLoad;
    const Vec2 rim = disk.radius * load * g.normalized() - G_.disks[k].own * u;
    disk.put(mode == Mode::Stick ? held : mode == Mode::Slide ? rim : Vec2(Vec2::Zero()), r_);
  }
}

template void ProximalWalk<BodyMotion>::respond(const VectorXd&, Stiffness*);
template void ProximalWalk<BodyMotion>::respondInRegion(const Solution&);
template void ProximalWalk<FactoredMotion>::respond(const VectorXd&, Stiffness*);
template void ProximalWalk<FactoredMotion>::respondInRegion(const Solution&);

}  // namespace delassus
