/// Alternating directions, with the vectors of the walk: x is r_, y is center_, z is u_.

#include "delassus/length.h"
#include "delassus/proximal_newton.h"

namespace delassus {
namespace {

// Smaller, and what is squeezed takes long to find its reactions; larger, and all others do.
constexpr double rho = 3e-3;

}  // namespace

template <class Motion>
void ProximalNewton<Motion>::alternateOnce(const Problem& problem) {
  r_ = rho * scale_.cwiseProduct(center_) + u_ - problem.q;
  for (int i = 0; i < problem.contacts(); ++i)
    r_[3 * i] -= problem.friction[i] * lengthOf(u_[3 * i + 1], u_[3 * i + 2]);
  r_ = r_.cwiseProduct(l_);
  motion_.impulse(r_, felt_);
  motion_.solve(felt_);
  motion_.relativeVelocity(felt_, trialU_);
  r_ -= l_.cwiseProduct(trialU_);

  center_ = r_ - u_.cwiseQuotient(rho * scale_);
  makeFeasible(problem, center_);
  u_ -= rho * scale_.cwiseProduct(r_ - center_);
}

template <class Motion>
bool ProximalNewton<Motion>::alternate(const Problem& problem, double tolerance, int budget,
                                       Solution& best) {
  constexpr int between = 5;  // iterations from one look at the residual to the next
  // Looks at which its mean is not halved: then little more will come. The largest is no measure of
  // that: it stays where it is while tall piles find out, layer by layer, what they carry.
  constexpr int mostIdle = 24;
  if (budget < between) return false;
  setWeights(rho);
  const int n = problem.contacts();
  for (int i = 0; i < n; ++i) G_.contacts[i] = l_.segment<3>(3 * i).asDiagonal();
  G_.rows = l_.tail(problem.rows());
  for (std::size_t k = 0; k < problem.disks.size(); ++k)
    answerOfDisk(problem.disks[k], static_cast<int>(k), Mode::Stick, Vec2::Zero(), 0, false, G_);
  if (!factorise(best)) return false;

  center_ = best.r;
  u_ = best.u;
  for (int i = 0; i < n; ++i)
    u_[3 * i] += problem.friction[i] * lengthOf(u_[3 * i + 1], u_[3 * i + 2]);
  double mark = infinity;
  for (int k = 1, idle = 0; k <= budget && idle < mostIdle; ++k) {
    alternateOnce(problem);
    ++best.sweeps;
    if (k % between != 0) continue;
    const VelocityResidual residual = map_->measure(center_, felt_, trialU_);
    if (residual.max < best.residual) {
      best.r = center_;
      best.u = trialU_;
      best.setResidual(residual);
    }
    if (best.residual <= tolerance) return true;
    ++idle;
    if (residual.rms < 0.5 * mark) mark = residual.rms, idle = 0;
  }
  return false;
}

template bool ProximalNewton<BodyMotion>::alternate(const Problem&, double, int, Solution&);
template bool ProximalNewton<FactoredMotion>::alternate(const Problem&, double, int, Solution&);

}  // namespace delassus
