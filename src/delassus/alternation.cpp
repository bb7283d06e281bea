#include "delassus/alternation.h"

#include "delassus/length.h"

namespace delassus {
namespace {

// With a smaller ρ, squeezed contacts take long to find their reactions; with a larger one, all
// others do.
constexpr double rho = 3e-3;

}  // namespace

template <class Motion>
Alternation<Motion>::Alternation(ProximalSpace<Motion>& space)
    : space_(space),
      scale_(space.scale),
      l_(space.l),
      felt_(space.felt),
      x_(space.ofUnknowns[0]),
      y_(space.ofUnknowns[1]),
      z_(space.ofUnknowns[2]),
      u_(space.ofUnknowns[3]) {}

template <class Motion>
void Alternation<Motion>::alternateOnce() {
  x_ = rho * scale_.cwiseProduct(y_) + z_ - problem().q;
  for (int i = 0; i < problem().contacts(); ++i)
    x_[3 * i] -= problem().friction[i] * lengthOf(z_[3 * i + 1], z_[3 * i + 2]);
  x_ = x_.cwiseProduct(l_);
  space_.motion().impulse(x_, felt_);
  space_.motion().solve(felt_);
  space_.motion().relativeVelocity(felt_, u_);
  x_ -= l_.cwiseProduct(u_);

  y_ = x_ - z_.cwiseQuotient(rho * scale_);
  makeFeasible(problem(), y_);
  z_ -= rho * scale_.cwiseProduct(x_ - y_);
}

template <class Motion>
bool Alternation<Motion>::alternate(double tolerance, int budget, Solution& best) {
  constexpr int between = 5;  // iterations from one measurement of the residual to the next
  // Measurements without a halving of its root mean square; after these little more will come. The
  // largest residual does not tell: it stays the same while a tall pile finds its load layer by
  // layer.
  constexpr int mostIdle = 24;
  if (budget < between) return false;
  space_.setWeights(rho);
  Stiffness& G = space_.G;
  const int n = problem().contacts();
  for (int i = 0; i < n; ++i) G.contacts[i] = l_.segment<3>(3 * i).asDiagonal();
  G.rows = l_.tail(problem().rows());
  for (std::size_t k = 0; k < problem().disks.size(); ++k)
    space_.answerOfDisk(problem().disks[k], static_cast<int>(k), Mode::Stick, Vec2::Zero(), 0,
                        false, G);
  if (!space_.factorise(best)) return false;

  y_ = best.r;
  z_ = best.u;
  for (int i = 0; i < n; ++i)
    z_[3 * i] += problem().friction[i] * lengthOf(z_[3 * i + 1], z_[3 * i + 2]);
  double mark = infinity;
  for (int k = 1, idle = 0; k <= budget && idle < mostIdle; ++k) {
    alternateOnce();
    ++best.sweeps;
    if (k % between != 0) continue;
    const VelocityResidual residual = space_.measure(y_, u_);
    best.takeIfBetter(y_, u_, residual);
    if (best.residual <= tolerance) return true;
    ++idle;
    if (residual.rms < 0.5 * mark) mark = residual.rms, idle = 0;
  }
  return false;
}

template class Alternation<BodyMotion>;
template class Alternation<FactoredMotion>;

}  // namespace delassus
