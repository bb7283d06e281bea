#include "delassus/interior_point.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "delassus/residual.h"

namespace delassus {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// x ∘ y in the Jordan algebra of the Lorentz cone.
Vec3 product(const Vec3& x, const Vec3& y) {
  return {x.dot(y), x[0] * y[1] + y[0] * x[1], x[0] * y[2] + y[0] * x[2]};
}

/// c with x ∘ c = b.
Vec3 quotient(const Vec3& x, const Vec3& b) {
  const double tail = std::hypot(x[1], x[2]);
  const double c = (x[0] * b[0] - x[1] * b[1] - x[2] * b[2]) / ((x[0] - tail) * (x[0] + tail));
  return {c, (b[1] - c * x[1]) / x[0], (b[2] - c * x[2]) / x[0]};
}

/// √(x_0² − ‖x_1‖²) for x in the interior of the cone.
double cornerDistance(const Vec3& x) {
  const double tail = std::hypot(x[1], x[2]);
  return std::sqrt(std::max((x[0] - tail) * (x[0] + tail), 1e-300));
}

/// Largest t with x + t d in the Lorentz cone.
double longestStep(const Vec3& x, const Vec3& d) {
  const double a = d[0] * d[0] - d[1] * d[1] - d[2] * d[2];
  const double b = x[0] * d[0] - x[1] * d[1] - x[2] * d[2];
  const double corner = cornerDistance(x), c = corner * corner;
  // The first positive root of a t² + 2 b t + c, if there is one.
  const double discriminant = b * b - a * c;
  double t = infinity;
  if (a < 0) {
    t = c / (-b + std::sqrt(std::max(discriminant, 0.0)));
    if (b > 0) t = (b + std::sqrt(std::max(discriminant, 0.0))) / -a;
  } else if (b < 0 && discriminant >= 0) {
    t = c / (-b + std::sqrt(discriminant));
  }
  if (d[0] < 0) t = std::min(t, -x[0] / d[0]);
  return t;
}

double longestStep(double x, double d) { return d < 0 ? -x / d : infinity; }

}  // namespace

/// Reactions and velocities of the size of the demands, in the middle of their cones.
template <class Motion>
void InteriorPoint<Motion>::start(const Problem& problem, const NaturalMap& map) {
  const int n = problem.contacts(), m = problem.rows();
  scale_ = map.diagonal();
  for (int i = 0; i < n; ++i)
    scale_.template segment<3>(3 * i).setConstant(scale_.template segment<3>(3 * i).mean());
  scale_ = scale_.cwiseMax(1e-14 * std::max(scale_.maxCoeff(), 1e-300));
  // Smaller, and reactions that squeeze each other run away; larger, and the last digits come slowly.
  constexpr double proximal = 1e-6;
  weight_ = proximal * scale_;
  if (problem.W.inBodySpace()) weight_ += problem.W.bodySpace().compliance;

  const double speed = std::max(problem.q.cwiseAbs().maxCoeff(), 1e-300);
  r_ = VectorXd::Zero(problem.size());
  cones_.resize(n);
  degree_ = 0;
  for (int i = 0; i < n; ++i) {
    const double mu = problem.friction[i];
    const double push = speed / scale_[3 * i];
    cones_[i].x = Vec3(mu > 0 ? mu * push : push, 0, 0);
    cones_[i].y = Vec3(mu > 0 ? speed / mu : speed, 0, 0);
    r_[3 * i] = push;
    ++degree_;
  }
  lower_.assign(m, {});
  upper_.assign(m, {});
  rowResidual_.resize(m);
  for (int i = 0; i < m; ++i) {
    const int at = 3 * n + i;
    const double lo = problem.lower[i], hi = problem.upper[i];
    if (!(lo < hi)) {
      r_[at] = lo;
      continue;
    }
    const double push = speed / scale_[at];
    double r = 0;
    if (std::isfinite(lo) && std::isfinite(hi))
      r = std::clamp(0.0, lo + 0.1 * (hi - lo), hi - 0.1 * (hi - lo));
    else if (std::isfinite(lo))
      r = std::max(0.0, lo + push);
    else if (std::isfinite(hi))
      r = std::min(0.0, hi - push);
    r_[at] = r;
    if (std::isfinite(lo)) lower_[i] = {true, r - lo, speed, 0, 0, 0}, ++degree_;
    if (std::isfinite(hi)) upper_[i] = {true, hi - r, speed, 0, 0, 0}, ++degree_;
  }
  G_.contacts.resize(n);
  G_.rows.resize(m);
  b_.resize(problem.size());
}

/// Gap and residuals at r_, u_ = W r_ + q.
template <class Motion>
void InteriorPoint<Motion>::measure(const Problem& problem) {
  const int n = problem.contacts(), m = problem.rows();
  double gap = 0;
  for (const Cone& c : cones_) gap += c.x.dot(c.y);
  for (int i = 0; i < m; ++i) {
    if (lower_[i].bounded) gap += lower_[i].x * lower_[i].y;
    if (upper_[i].bounded) gap += upper_[i].x * upper_[i].y;
  }
  gap_ = degree_ > 0 ? gap / degree_ : 0;

  for (int i = 0; i < n; ++i) {
    Cone& c = cones_[i];
    const Vec3 u = u_.template segment<3>(3 * i);
    const double mu = problem.friction[i];
    if (mu > 0) {
      const double smoothing = std::sqrt(gap_ * scale_[3 * i]);
      const double slip = std::hypot(std::hypot(u[1], u[2]), smoothing);
      c.slip = u.tail<2>() / slip;
      c.residual = Vec3(u[0] / mu + slip, u[1], u[2]) - c.y;
    } else {
      c.slip.setZero();
      c.residual = Vec3(u[0] - c.y[0], 0, 0);
    }
  }
  for (int i = 0; i < m; ++i)
    rowResidual_[i] = u_[3 * n + i] - ((lower_[i].bounded ? lower_[i].y : 0) -
                                       (upper_[i].bounded ? upper_[i].y : 0));
}

/// Scaling points and −dr/du of every contact and row.
template <class Motion>
void InteriorPoint<Motion>::linearise(const Problem& problem) {
  const int n = problem.contacts(), m = problem.rows();
  for (int i = 0; i < n; ++i) {
    Cone& c = cones_[i];
    const double mu = problem.friction[i];
    const Vec3 weight = weight_.template segment<3>(3 * i);
    if (!(mu > 0)) {
      G_.contacts[i].setZero();
      G_.contacts[i](0, 0) = 1 / (c.y[0] / c.x[0] + weight[0]);
      continue;
    }
    const double cornerX = cornerDistance(c.x), cornerY = cornerDistance(c.y);
    const Vec3 x = c.x / cornerX, y = c.y / cornerY;
    const double gamma = std::sqrt(0.5 * (1 + x.dot(y)));
    const Vec3 w = Vec3(x[0] + y[0], x[1] - y[1], x[2] - y[2]) / (2 * gamma);
    const double beta = std::sqrt(cornerX / cornerY);
    const Vec3 v = Vec3(w[0] + 1, w[1], w[2]) / std::sqrt(2 * (w[0] + 1));
    const Vec3 jv(v[0], -v[1], -v[2]);
    const Vec3 J(1, -1, -1);
    c.scaling = 2 * beta * v * v.transpose();
    c.scaling -= (beta * J).asDiagonal().toDenseMatrix();
    c.inverse = (2 / beta) * jv * jv.transpose();
    c.inverse -= (J / beta).asDiagonal().toDenseMatrix();
    c.scaled = c.scaling * c.y;

    Mat3 fromY = Mat3::Identity();  // B⁻¹
    fromY.row(0) << mu, -mu * c.slip[0], -mu * c.slip[1];
    const Vec3 jw(w[0], -w[1], -w[2]);
    Mat3 inverse2 = 2 * jw * jw.transpose();  // W⁻² β²
    inverse2.diagonal() -= J;
    Mat3 softness = fromY * (inverse2 / (beta * beta));
    softness.col(0) *= mu;
    softness.diagonal() += weight;
    G_.contacts[i] = softness.inverse();
  }
  for (int i = 0; i < m; ++i) {
    const int at = 3 * n + i;
    double softness = weight_[at];
    if (lower_[i].bounded) softness += lower_[i].y / lower_[i].x;
    if (upper_[i].bounded) softness += upper_[i].y / upper_[i].x;
    G_.rows[i] = problem.lower[i] < problem.upper[i] ? 1 / softness : 0;
  }
}

template <class Motion>
bool InteriorPoint<Motion>::step(Motion& motion, const Problem& problem, double tau,
                                 bool corrector) {
  const int n = problem.contacts(), m = problem.rows();
  for (int i = 0; i < n; ++i) {
    Cone& c = cones_[i];
    const double mu = problem.friction[i];
    if (!(mu > 0)) {
      const double target = tau - c.x[0] * c.y[0] - (corrector ? c.dx[0] * c.dy[0] : 0);
      c.shift = Vec3(target / c.x[0], 0, 0);
      b_.template segment<3>(3 * i) =
          Vec3(G_.contacts[i](0, 0) * (c.shift[0] - c.residual[0]), 0, 0);
      continue;
    }
    // W⁻¹ (λ \ (τ e − λ ∘ λ)), in the form that keeps its digits at the boundary of the cone.
    const double corner = cornerDistance(c.x);
    c.shift = (tau / (corner * corner)) * Vec3(c.x[0], -c.x[1], -c.x[2]) - c.y;
    if (corrector)
      c.shift -= c.inverse * quotient(c.scaled, product(c.inverse * c.dx, c.scaling * c.dy));
    const Vec3 y = c.shift - c.residual;
    const Vec3 u(mu * (y[0] - c.slip[0] * y[1] - c.slip[1] * y[2]), y[1], y[2]);
    b_.template segment<3>(3 * i) = G_.contacts[i] * u;
  }
  for (int i = 0; i < m; ++i) {
    double y = -rowResidual_[i];
    Side &lo = lower_[i], &hi = upper_[i];
    if (lo.bounded) {
      lo.target = tau - lo.x * lo.y - (corrector ? lo.dx * lo.dy : 0);
      y += lo.target / lo.x;
    }
    if (hi.bounded) {
      hi.target = tau - hi.x * hi.y - (corrector ? hi.dx * hi.dy : 0);
      y -= hi.target / hi.x;
    }
    b_[3 * n + i] = G_.rows[i] * y;
  }

  motion.impulse(b_, dv_);
  motion.solve(dv_);
  if (!dv_.allFinite()) return false;
  motion.relativeVelocity(dv_, du_);

  for (int i = 0; i < n; ++i) {
    Cone& c = cones_[i];
    const double mu = problem.friction[i];
    const Vec3 dr = b_.template segment<3>(3 * i) - G_.contacts[i] * du_.template segment<3>(3 * i);
    b_.template segment<3>(3 * i) = dr;
    if (mu > 0) {
      c.dx = Vec3(mu * dr[0], dr[1], dr[2]);
      c.dy = c.shift - c.inverse * (c.inverse * c.dx);
    } else {
      c.dx = Vec3(dr[0], 0, 0);
      c.dy = Vec3(c.shift[0] - c.y[0] / c.x[0] * dr[0], 0, 0);
    }
  }
  for (int i = 0; i < m; ++i) {
    const int at = 3 * n + i;
    const double dr = b_[at] - G_.rows[i] * du_[at];
    b_[at] = dr;
    Side &lo = lower_[i], &hi = upper_[i];
    if (lo.bounded) lo.dx = dr, lo.dy = (lo.target - lo.y * dr) / lo.x;
    if (hi.bounded) hi.dx = -dr, hi.dy = (hi.target + hi.y * dr) / hi.x;
  }
  return true;
}

template <class Motion>
double InteriorPoint<Motion>::longestStep() const {
  double t = infinity;
  for (const Cone& c : cones_)
    t = std::min({t, delassus::longestStep(c.x, c.dx), delassus::longestStep(c.y, c.dy)});
  for (const auto* sides : {&lower_, &upper_})
    for (const Side& s : *sides)
      if (s.bounded)
        t = std::min({t, delassus::longestStep(s.x, s.dx), delassus::longestStep(s.y, s.dy)});
  return t;
}

template <class Motion>
double InteriorPoint<Motion>::gapAfter(double length) const {
  double gap = 0;
  for (const Cone& c : cones_) gap += (c.x + length * c.dx).dot(c.y + length * c.dy);
  for (const auto* sides : {&lower_, &upper_})
    for (const Side& s : *sides)
      if (s.bounded) gap += (s.x + length * s.dx) * (s.y + length * s.dy);
  return degree_ > 0 ? gap / degree_ : 0;
}

template <class Motion>
void InteriorPoint<Motion>::advance(const Problem& problem, double length) {
  r_ += length * b_;
  for (Cone& c : cones_) c.x += length * c.dx, c.y += length * c.dy;
  for (auto* sides : {&lower_, &upper_})
    for (Side& s : *sides) s.x += length * s.dx, s.y += length * s.dy;
  problem.W.multiply(r_, y_, u_);
  u_ += problem.q;
}

template <class Motion>
bool InteriorPoint<Motion>::solve(Motion& motion, const Problem& problem, const NaturalMap& map,
                                  double tolerance, int budget, Solution& best) {
  constexpr double toBoundary = 0.99, leastCentring = 1e-8;
  constexpr int mostIdle = 8;
  start(problem, map);
  problem.W.multiply(r_, y_, u_);
  u_ += problem.q;
  double own = infinity;  // best residual on this path
  int idle = 0;           // steps without gain
  for (int k = 0; k < budget; ++k) {
    measure(problem);
    linearise(problem);
    ++best.factorisations;
    ++best.regions;
    if (!motion.factorise(G_) || !step(motion, problem, 0, false)) return false;
    const double predicted = gapAfter(std::min(1.0, longestStep()));
    const double centring =
        gap_ > 0 ? std::pow(std::clamp(predicted / gap_, 0.0, 1.0), 3) : leastCentring;
    if (!step(motion, problem, std::max(centring, leastCentring) * gap_, true)) return false;
    const double length = std::min(1.0, toBoundary * longestStep());
    advance(problem, length);

    const double now = map.residual(r_, u_).max;
    if (!std::isfinite(now)) return false;
    const bool gains = now < 0.9 * own;
    idle = gains ? 0 : idle + 1;
    own = std::min(own, now);
    if (now < best.residual) {
      best.r = r_;
      best.u = u_;
      best.residual = now;
    }
    if (now <= std::max(tolerance, map.roundOff(r_))) return true;
    if (idle > mostIdle) return false;
  }
  return false;
}

template class InteriorPoint<BodyMotion>;
template class InteriorPoint<FactoredMotion>;

}  // namespace delassus
