#include "delassus/interior_point.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "delassus/residual.h"

namespace delassus {
namespace {

double longestStep(double x, double d) { return d < 0 ? -x / d : infinity; }

}  // namespace

/// Starts in the middle of the cones. Reactions and velocities are as large as all velocities are,
/// including those that demand nothing.
template <class Motion>
void InteriorPoint<Motion>::start(const Problem& problem, const NaturalMap& map) {
  const int n = problem.contacts(), m = problem.rows();
  map.meanDiagonal(scale_);
  // If smaller, reactions that squeeze each other run away; if larger, the last digits come slowly.
  constexpr double proximal = 1e-6;
  weight_ = proximal * scale_;
  if (problem.W.inBodySpace()) weight_ += problem.W.bodySpace().compliance;

  const double speed = std::max(problem.q.lpNorm<Eigen::Infinity>(), 1e-300);
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
    // A bound that no reaction comes near is ignored: its slack alone would make up the gap.
    constexpr double far = 1e30;
    const auto isNear = [push](double bound) { return std::abs(bound) < far * push; };
    double r = 0;
    if (isNear(lo) && isNear(hi))
      r = std::min(std::max(0.0, lo + 0.1 * (hi - lo)), hi - 0.1 * (hi - lo));
    else if (isNear(lo))
      r = std::max(0.0, lo + push);
    else if (isNear(hi))
      r = std::min(0.0, hi - push);
    r_[at] = r;
    if (isNear(lo)) lower_[i] = {true, r - lo, speed, 0, 0, 0}, ++degree_;
    if (isNear(hi)) upper_[i] = {true, hi - r, speed, 0, 0, 0}, ++degree_;
  }
  disks_.resize(problem.disks.size());
  for (std::size_t k = 0; k < disks_.size(); ++k) {
    const Disk& disk = problem.disks[k];
    disks_[k].x = Vec3(disk.radius * r_[disk.governor], 0, 0);
    disks_[k].y = Vec3(speed / disk.radius, 0, 0);
    disks_[k].residual.setZero();
    ++degree_;
  }
  G_.reset(problem);
  dr_.resize(problem.size());
}

/// Computes the gap and residuals at r_, u_ = W r_ + q.
template <class Motion>
void InteriorPoint<Motion>::measure(const Problem& problem) {
  const int n = problem.contacts(), m = problem.rows();
  double gap = 0;
  for (const Cone& c : cones_) gap += c.x.dot(c.y);
  for (const LorentzPair& c : disks_) gap += c.x.dot(c.y);
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
  // y_0 is free: it becomes ‖u_d‖, since y lies in the cone and x ⟂ y.
  for (std::size_t k = 0; k < disks_.size(); ++k)
    disks_[k].residual.tail<2>() = problem.disks[k].of(u_) - disks_[k].y.tail<2>();
}

/// Computes scaling points and −dr/du of every contact and row.
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
    c.scale();
    Mat3 fromY = Mat3::Identity();  // B⁻¹
    fromY.row(0) << mu, -mu * c.slip[0], -mu * c.slip[1];
    Mat3 softness = fromY * c.softness;
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
  for (std::size_t k = 0; k < disks_.size(); ++k) {
    const Disk& disk = problem.disks[k];
    LorentzPair& c = disks_[k];
    c.scale();
    Stiffness::OfDisk& answer = G_.disks[k];
    answer.own =
        (c.softness.bottomRightCorner<2, 2>() + weight_[disk.first] * Mat2::Identity()).inverse();
    answer.governor = -answer.own * c.softness.block<2, 1>(1, 0) * disk.radius * G_.ofNormal(disk);
    G_.rows.segment(disk.first - 3 * n, disk.unknowns).setZero();
  }
}

/// Sets the aim of each contact, row and disk, and from it the right-hand side.
template <class Motion>
void InteriorPoint<Motion>::aim(const Problem& problem, double tau, bool corrector) {
  const int n = problem.contacts(), m = problem.rows();
  for (int i = 0; i < n; ++i) {
    Cone& c = cones_[i];
    const double mu = problem.friction[i];
    if (!(mu > 0)) {
      const double target = tau - c.x[0] * c.y[0] - (corrector ? c.dx[0] * c.dy[0] : 0);
      c.shift = Vec3(target / c.x[0], 0, 0);
      dr_.template segment<3>(3 * i) =
          Vec3(G_.contacts[i](0, 0) * (c.shift[0] - c.residual[0]), 0, 0);
      continue;
    }
    c.aim(tau, corrector);
    const Vec3 y = c.shift - c.residual;
    const Vec3 u(mu * (y[0] - c.slip[0] * y[1] - c.slip[1] * y[2]), y[1], y[2]);
    dr_.template segment<3>(3 * i) = G_.contacts[i] * u;
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
    dr_[3 * n + i] = G_.rows[i] * y;
  }
  for (std::size_t k = 0; k < disks_.size(); ++k) {
    const Disk& disk = problem.disks[k];
    LorentzPair& c = disks_[k];
    c.aim(tau, corrector);
    const Vec2 wider = c.softness.block<2, 1>(1, 0) * (disk.radius * dr_[disk.governor]);
    disk.put(G_.disks[k].own * ((c.shift - c.residual).tail<2>() - wider), dr_);
  }
}

/// Computes the steps of r, x and y from du.
template <class Motion>
void InteriorPoint<Motion>::follow(const Problem& problem) {
  const int n = problem.contacts(), m = problem.rows();
  for (int i = 0; i < n; ++i) {
    Cone& c = cones_[i];
    const double mu = problem.friction[i];
    const Vec3 dr =
        dr_.template segment<3>(3 * i) - G_.contacts[i] * du_.template segment<3>(3 * i);
    dr_.template segment<3>(3 * i) = dr;
    if (mu > 0) {
      c.follow({mu * dr[0], dr[1], dr[2]});
    } else {
      c.dx = Vec3(dr[0], 0, 0);
      c.dy = Vec3(c.shift[0] - c.y[0] / c.x[0] * dr[0], 0, 0);
    }
  }
  for (int i = 0; i < m; ++i) {
    const int at = 3 * n + i;
    const double dr = dr_[at] - G_.rows[i] * du_[at];
    dr_[at] = dr;
    Side &lo = lower_[i], &hi = upper_[i];
    if (lo.bounded) lo.dx = dr, lo.dy = (lo.target - lo.y * dr) / lo.x;
    if (hi.bounded) hi.dx = -dr, hi.dy = (hi.target + hi.y * dr) / hi.x;
  }
  for (std::size_t k = 0; k < disks_.size(); ++k) {
    const Disk& disk = problem.disks[k];
    Vec3 governing(0, 0, 0);  // du of its governor
    const int unknowns = disk.governor < 3 * n ? 3 : 1;
    governing.head(unknowns) = du_.segment(disk.governor, unknowns);
    const Vec2 dr =
        disk.of(dr_) - G_.disks[k].own * disk.of(du_) - G_.disks[k].governor * governing;
    disk.put(dr, dr_);
    disks_[k].follow({disk.radius * dr_[disk.governor], dr[0], dr[1]});
  }
}

template <class Motion>
bool InteriorPoint<Motion>::step(Motion& motion, const Problem& problem, double tau,
                                 bool corrector) {
  aim(problem, tau, corrector);
  motion.impulse(dr_, dv_);
  motion.solve(dv_);
  if (!dv_.allFinite()) return false;
  motion.relativeVelocity(dv_, du_);
  follow(problem);
  return true;
}

template <class Motion>
double InteriorPoint<Motion>::longestStep() const {
  double t = infinity;
  const auto shorten = [&t](const LorentzPair& c) {
    t = std::min({t, lorentz::longestStep(c.x, c.dx), lorentz::longestStep(c.y, c.dy)});
  };
  for (const Cone& c : cones_) shorten(c);
  for (const LorentzPair& c : disks_) shorten(c);
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
  for (const LorentzPair& c : disks_) gap += (c.x + length * c.dx).dot(c.y + length * c.dy);
  for (const auto* sides : {&lower_, &upper_})
    for (const Side& s : *sides)
      if (s.bounded) gap += (s.x + length * s.dx) * (s.y + length * s.dy);
  return degree_ > 0 ? gap / degree_ : 0;
}

template <class Motion>
void InteriorPoint<Motion>::advance(const Problem& problem, double length) {
  r_ += length * dr_;
  for (Cone& c : cones_) c.x += length * c.dx, c.y += length * c.dy;
  for (LorentzPair& c : disks_) c.x += length * c.dx, c.y += length * c.dy;
  for (auto* sides : {&lower_, &upper_})
    for (Side& s : *sides) s.x += length * s.dx, s.y += length * s.dy;
  problem.W.multiply(r_, y_, u_);
  u_ += problem.q;
}

template <class Motion>
bool InteriorPoint<Motion>::solve(Motion& motion, const Problem& problem, const NaturalMap& map,
                                  double tolerance, int budget, Solution& best) {
  constexpr double toBoundary = 0.99, leastCentring = 1e-8;
  constexpr int mostIdle = 8;  // steps that do not halve the residual: then no more will come
  start(problem, map);
  problem.W.multiply(r_, y_, u_);
  u_ += problem.q;
  double mark = infinity;
  int idle = 0;
  for (int k = 0; k < budget; ++k) {
    measure(problem);
    linearise(problem);
    ++best.factorisations;
    ++best.regions;
    if (!motion.factorise(G_) || !step(motion, problem, 0, false)) return false;
    const double predicted = gapAfter(std::min(1.0, longestStep()));
    const double share = gap_ > 0 ? std::clamp(predicted / gap_, 0.0, 1.0) : 0;
    const double centring = share * share * share;
    if (!step(motion, problem, std::max(centring, leastCentring) * gap_, true)) return false;
    const double length = std::min(1.0, toBoundary * longestStep());
    advance(problem, length);

    const VelocityResidual measured = map.error(r_, u_);
    const double now = measured.max;
    if (!std::isfinite(now)) return false;
    const bool halved = now < 0.5 * mark;
    idle = halved ? 0 : idle + 1;
    if (halved) mark = now;
    best.takeIfBetter(r_, u_, measured);
    if (now <= std::max(tolerance, map.roundOff(r_))) return true;
    if (idle > mostIdle) return false;
  }
  return false;
}

template class InteriorPoint<BodyMotion>;
template class InteriorPoint<FactoredMotion>;

}  // namespace delassus
