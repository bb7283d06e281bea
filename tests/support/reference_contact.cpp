#include "tests/support/reference_contact.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace delassus::test {
namespace {

/// Slip by its direction: d = (cos θ, sin θ) is the direction of u_t, so that with μ > 0
///
///     r = r_n (1, −μ d),   u_n = 0  =>  r_n = −q_n / a,   a = W_nn − μ W_nt d
///
/// and u_t is parallel to d where the cross product G(θ) = a d × u_t vanishes: a trigonometric
/// polynomial of degree two, with at most four zeros. (The library instead looks for the sliding
/// speed, algorithms §6.2.)
class SlipDirections {
 public:
  using Real = long double;
  using Vector = Eigen::Matrix<Real, 3, 1>;
  using Matrix = Eigen::Matrix<Real, 3, 3>;

  SlipDirections(const Mat3& W, const Vec3& q, double mu)
      : W_(W.cast<Real>()), q_(q.cast<Real>()), mu_(mu) {}

  /// All slips, sorted by sliding speed over friction force, |u_t| / |r_t|.
  std::vector<ReferenceContact> find() const {
    const Real step = 2 * std::acos(Real(-1)) / cells;
    std::vector<Real> g;  // G at the corners of the cells, one cell beyond the full turn
    for (int i = 0; i < cells + 2; ++i) g.push_back(G(i * step));

    std::vector<Real> angles;
    for (int i = 0; i < cells; ++i) {
      const Real a = i * step, b = (i + 1) * step, c = (i + 2) * step;
      if (oppositeSigns(g[i], g[i + 1])) {
        angles.push_back(bisect(a, b));
      } else if (!oppositeSigns(g[i + 1], g[i + 2]) && std::abs(g[i + 1]) <= std::abs(g[i]) &&
                 std::abs(g[i + 1]) <= std::abs(g[i + 2])) {
        // There are two zeros between a and c, or none: if two, the extremum is between them.
        const Real top = extremum(a, c);
        if (!oppositeSigns(g[i], G(top))) continue;
        angles.push_back(bisect(a, top));
        angles.push_back(bisect(top, c));
      }
    }
    return slipsAt(angles);
  }

 private:
  static constexpr int cells = 1440;

  Vector direction(Real angle) const { return {1, -mu_ * std::cos(angle), -mu_ * std::sin(angle)}; }

  /// a (u_t) = (a q_t − q_n (W_tn − μ W_tt d)).
  Vector scaledVelocity(Real angle) const {
    const Vector Wd = W_ * direction(angle);
    return Wd[0] * q_ - q_[0] * Wd;
  }

  Real G(Real angle) const {
    const Vector u = scaledVelocity(angle);
    return std::cos(angle) * u[2] - std::sin(angle) * u[1];
  }

  /// Central difference, wide enough to give the sign of the slope and narrow against a cell.
  Real slope(Real angle) const { return G(angle + 1e-7L) - G(angle - 1e-7L); }

  static bool oppositeSigns(Real a, Real b) { return (a > 0) != (b > 0); }

  template <class F>
  static Real bisectSign(Real a, Real b, F f) {
    const bool positive = f(a) > 0;
    for (int i = 0; i < 80; ++i) {
      const Real middle = (a + b) / 2;
      ((f(middle) > 0) == positive ? a : b) = middle;
    }
    return (a + b) / 2;
  }
  Real bisect(Real a, Real b) const {
    return bisectSign(a, b, [this](Real angle) { return G(angle); });
  }
  Real extremum(Real a, Real b) const {
    return bisectSign(a, b, [this](Real angle) { return slope(angle); });
  }

  std::vector<ReferenceContact> slipsAt(const std::vector<Real>& angles) const {
    std::vector<std::pair<Real, ReferenceContact>> slips;
    for (const Real angle : angles) {
      const Vector d = direction(angle);
      const Real rn = -q_[0] / W_.row(0).dot(d);
      const Vector r = rn * d;
      Vector u = W_ * r + q_;
      const Real speed = u[1] * std::cos(angle) + u[2] * std::sin(angle);
      // G is also zero where u_t points against d: friction that drives is no solution.
      if (!(rn > 0) || !std::isfinite(rn) || speed < 0) continue;
      u[0] = 0;
      slips.push_back({speed / (mu_ * rn), {Mode::Slide, r.cast<double>(), u.cast<double>()}});
    }
    std::sort(slips.begin(), slips.end(),
              [](const auto& x, const auto& y) { return x.first < y.first; });
    std::vector<ReferenceContact> sorted;
    for (const auto& slip : slips) sorted.push_back(slip.second);
    return sorted;
  }

  Matrix W_;
  Vector q_;
  Real mu_;
};

}  // namespace

std::vector<ReferenceContact> allContactSolutions(const Mat3& W, const Vec3& q, double mu) {
  std::vector<ReferenceContact> solutions;
  if (q[0] >= 0) solutions.push_back({Mode::Open, Vec3::Zero(), q});

  if (mu == 0) {
    if (q[0] < 0) {
      const Vec3 r(-q[0] / W(0, 0), 0, 0);
      Vec3 u = W * r + q;
      u[0] = 0;
      solutions.push_back({Mode::Slide, r, u});
    }
    return solutions;
  }

  const SlipDirections slips(W, q, mu);
  const SlipDirections::Vector stuck =
      -W.cast<long double>().fullPivLu().solve(q.cast<long double>());
  if (stuck[0] > 0 && std::hypot(stuck[1], stuck[2]) <= mu * stuck[0])
    solutions.push_back({Mode::Stick, stuck.cast<double>(), Vec3::Zero()});
  for (const ReferenceContact& slip : slips.find()) solutions.push_back(slip);
  return solutions;
}

ReferenceContact referenceContact(const Mat3& W, const Vec3& q, double mu) {
  return allContactSolutions(W, q, mu).at(0);
}

}  // namespace delassus::test
