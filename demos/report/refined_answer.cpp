#include "demos/report/refined_answer.h"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace demos::report {

using namespace delassus;

namespace {

using Long = long double;
using LongVector = Eigen::Matrix<Long, Eigen::Dynamic, 1>;
using LongMatrix = Eigen::Matrix<Long, Eigen::Dynamic, Eigen::Dynamic>;
using Long3 = Eigen::Matrix<Long, 3, 1>;
using LongMat3 = Eigen::Matrix<Long, 3, 3>;

__extension__ typedef __float128 Quad;
using Quad3 = std::array<Quad, 3>;
using QuadVector = std::vector<Quad>;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// One step of Heron's on the root of 64 bits.
Quad root(Quad square) {
  const Quad guess = std::sqrt(Long(square));
  return guess > 0 ? (guess + square / guess) / 2 : guess;
}

Quad3 cross(const Vec3& a, const Vec3& b) {
  const auto minor = [&](int i, int k) { return Quad(a[i]) * b[k] - Quad(a[k]) * b[i]; };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

/// P(x) on Coulomb's cone, and its derivative where the border of the cone is smooth.
Quad3 projectOnCone(const Quad3& x, double mu, LongMat3& derivative) {
  const Quad t = root(x[1] * x[1] + x[2] * x[2]);
  if (mu * t <= -x[0]) {
    derivative.setZero();
    return {0, 0, 0};
  }
  if (t <= mu * x[0]) {
    derivative.setIdentity();
    return x;
  }
  const Quad normal = (x[0] + mu * t) / (1 + Quad(mu) * mu);
  const Quad3 projected{normal, mu * normal * x[1] / t, mu * normal * x[2] / t};
  const Long3 along(0, Long(x[1] / t), Long(x[2] / t));
  const Long3 edge = Long3::UnitX() + Long(mu) * along;
  LongMat3 across = LongMat3::Identity() - along * along.transpose();
  across(0, 0) = 0;
  derivative = edge * edge.transpose() / (1 + Long(mu) * mu) + Long(mu * normal / t) * across;
  return projected;
}

/// A row of J: the effect of one unknown on the two bodies between which it acts.
struct Direction {
  struct Share {
    int body = -1;                      ///< place in the island, or none
    std::array<Quad, 6> J{}, motion{};  ///< J and M⁻¹ Jᵀ
  };
  std::array<Share, 2> shares;
  Quad q = 0, compliance = 0;
};

/// A contact with friction, of three unknowns, or a row of one.
struct Part {
  int first, unknowns;
  double mu, lower, upper;
  Long size = 1;  ///< |W_aa|
};

class QuadProblem {
 public:
  QuadProblem(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
              const std::vector<Row>& rows, const Island& island);

  RefinedAnswer refine(const VectorXd& start) const;

 private:
  int size() const { return int(directions_.size()); }
  void addContact(const Contact& contact, int axes);
  void addRow(const Row& row);
  Direction::Share shareOf(int body, const Quad3& linear, const Quad3& angular, Quad& q) const;
  void findMatrix();

  /// M⁻¹ Jᵀ r
  QuadVector change(const QuadVector& r) const;
  /// u = W r + q
  QuadVector relativeVelocity(const QuadVector& r) const;
  /// F and its derivative by r.
  LongVector naturalMap(const QuadVector& r, LongMatrix& derivative) const;
  double residualOf(const LongVector& naturalMap) const;

  const std::vector<Body>& bodies_;
  const Island& island_;
  std::vector<Direction> directions_;
  std::vector<Part> parts_;
  LongMatrix W_;
  LongVector scale_;  ///< 1/√|W_aa|
};

QuadProblem::QuadProblem(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
                         const std::vector<Row>& rows, const Island& island)
    : bodies_(bodies), island_(island) {
  island.eachContactAt([&](int i, int, int axes) { addContact(contacts[std::size_t(i)], axes); });
  for (const int i : island.rows) addRow(rows[std::size_t(i)]);
  findMatrix();
}

void QuadProblem::addContact(const Contact& contact, int axes) {
  parts_.push_back({size(), axes, contact.friction, 0, infinity});
  for (int axis = 0; axis < axes; ++axis) {
    const Vec3 d = contact.frame.col(axis);
    Direction direction;
    direction.q = -contact.target[axis];
    direction.compliance = axis == 0 ? contact.compliance : contact.slipCompliance;
    direction.shares[0] =
        shareOf(contact.a, {d[0], d[1], d[2]}, cross(contact.armA, d), direction.q);
    direction.shares[1] =
        shareOf(contact.b, {-d[0], -d[1], -d[2]}, cross(d, contact.armB), direction.q);
    directions_.push_back(direction);
  }
}

void QuadProblem::addRow(const Row& row) {
  parts_.push_back({size(), 1, 0, row.lower, row.upper});
  const auto share = [this](int body, const Row6& J, Quad& q) {
    return shareOf(body, {J[0], J[1], J[2]}, {J[3], J[4], J[5]}, q);
  };
  Direction direction;
  direction.q = -row.target;
  direction.compliance = row.compliance;
  direction.shares[0] = share(row.a, row.jacobianA, direction.q);
  direction.shares[1] = share(row.b, row.jacobianB, direction.q);
  directions_.push_back(direction);
}

/// Adds the body's velocity along the row to `q`, also that of an immovable body.
Direction::Share QuadProblem::shareOf(int body, const Quad3& linear, const Quad3& angular,
                                      Quad& q) const {
  Direction::Share share;
  if (body < 0) return share;
  const Body& source = bodies_[std::size_t(body)];
  for (int i = 0; i < 3; ++i)
    q += linear[i] * source.velocity[i] + angular[i] * source.velocity[3 + i];
  if (!source.movable()) return share;
  share.body = int(std::lower_bound(island_.bodies.begin(), island_.bodies.end(), body) -
                   island_.bodies.begin());
  for (int i = 0; i < 3; ++i) {
    share.J[i] = linear[i];
    share.J[3 + i] = angular[i];
    share.motion[i] = source.inverseMass[i] * linear[i];
    for (int k = 0; k < 3; ++k) share.motion[3 + i] += source.inverseInertia(i, k) * angular[k];
  }
  return share;
}

void QuadProblem::findMatrix() {
  const auto product = [](const Direction& a, const Direction& b) {
    Quad sum = 0;
    for (const Direction::Share& ofA : a.shares)
      for (const Direction::Share& ofB : b.shares)
        if (ofA.body >= 0 && ofA.body == ofB.body)
          for (std::size_t i = 0; i < 6; ++i) sum += ofA.J[i] * ofB.motion[i];
    return Long(sum);
  };
  W_.resize(size(), size());
  for (int i = 0; i < size(); ++i) {
    for (int j = 0; j < size(); ++j)
      W_(i, j) = product(directions_[std::size_t(i)], directions_[std::size_t(j)]);
    W_(i, i) += Long(directions_[std::size_t(i)].compliance);
  }
  scale_.resize(size());
  for (Part& part : parts_) {
    const Long norm = W_.block(part.first, part.first, part.unknowns, part.unknowns).norm();
    if (norm > 0) part.size = norm;  // a part that no reaction moves has no scale
    scale_.segment(part.first, part.unknowns).setConstant(1 / std::sqrt(part.size));
  }
}

QuadVector QuadProblem::change(const QuadVector& r) const {
  QuadVector v(6 * island_.bodies.size(), 0);
  for (std::size_t i = 0; i < directions_.size(); ++i)
    for (const Direction::Share& share : directions_[i].shares)
      for (std::size_t k = 0; share.body >= 0 && k < 6; ++k)
        v[6 * std::size_t(share.body) + k] += share.motion[k] * r[i];
  return v;
}

QuadVector QuadProblem::relativeVelocity(const QuadVector& r) const {
  const QuadVector v = change(r);
  QuadVector u(directions_.size());
  for (std::size_t i = 0; i < directions_.size(); ++i) {
    const Direction& direction = directions_[i];
    u[i] = direction.q + direction.compliance * r[i];
    for (const Direction::Share& share : direction.shares)
      for (std::size_t k = 0; share.body >= 0 && k < 6; ++k)
        u[i] += share.J[k] * v[6 * std::size_t(share.body) + k];
  }
  return u;
}

LongVector QuadProblem::naturalMap(const QuadVector& r, LongMatrix& derivative) const {
  const QuadVector u = relativeVelocity(r);
  LongVector F(size());
  derivative = LongMatrix::Zero(size(), size());
  for (const Part& part : parts_) {
    const int at = part.first;
    const auto first = std::size_t(at);
    if (part.unknowns == 1) {
      const Quad x = r[first] - u[first] / part.size;
      const bool within = x >= part.lower && x <= part.upper;
      const Quad projected = within ? x : Quad(x < part.lower ? part.lower : part.upper);
      F[at] = Long(r[first] - projected);
      if (within)
        derivative.row(at) = W_.row(at) / part.size;
      else
        derivative(at, at) = 1;
      continue;
    }
    // De Saxcé's corrected velocity v = u + μ|u_t| n, and its derivative by u.
    Quad3 x{u[first], u[first + 1], u[first + 2]};
    const Quad slip = root(x[1] * x[1] + x[2] * x[2]);
    LongMat3 vByU = LongMat3::Identity(), P;
    for (int i = 1; i < 3 && slip > 0; ++i) vByU(0, i) = Long(part.mu * x[std::size_t(i)] / slip);
    x[0] += part.mu * slip;
    for (std::size_t i = 0; i < 3; ++i) x[i] = r[first + i] - x[i] / part.size;
    const Quad3 projected = projectOnCone(x, part.mu, P);
    for (std::size_t i = 0; i < 3; ++i) F[at + int(i)] = Long(r[first + i] - projected[i]);
    derivative.middleRows<3>(at) = P * vByU / part.size * W_.middleRows<3>(at);
    derivative.block<3, 3>(at, at) += LongMat3::Identity() - P;
  }
  return F;
}

double QuadProblem::residualOf(const LongVector& naturalMap) const {
  Long most = 0, demand = 0;
  for (const Part& part : parts_)
    most = std::max(most, naturalMap.segment(part.first, part.unknowns).norm() * part.size);
  for (const Direction& direction : directions_)
    demand = std::max(demand, std::abs(Long(direction.q)));
  return demand > 0 ? double(most / demand) : 0;
}

RefinedAnswer QuadProblem::refine(const VectorXd& start) const {
  constexpr int mostSteps = 30, mostIdle = 4;
  const auto rounded = [](const QuadVector& numbers) {
    VectorXd x(Eigen::Index(numbers.size()));
    for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = double(numbers[std::size_t(i)]);
    return x;
  };
  const auto power = [this](const LongVector& r) { return std::abs(r.dot(W_ * r)); };

  QuadVector r(start.begin(), start.end()), best = r;
  RefinedAnswer answer{start, {}, infinity, infinity};
  LongMatrix derivative;
  for (int step = 0, idle = 0; step < mostSteps && idle < mostIdle && !answer.certified(); ++step) {
    const LongVector F = naturalMap(r, derivative);
    // Scaled so that masses do not affect the condition: with D = 1/√|W_aa|, D⁻¹ F' D.
    derivative = scale_.cwiseInverse().asDiagonal() * derivative * scale_.asDiagonal();
    const LongVector way = -scale_.cwiseProduct(
        derivative.completeOrthogonalDecomposition().solve(scale_.cwiseInverse().cwiseProduct(F)));
    const double residual = residualOf(F);
    const bool better = residual < answer.residual;
    if (better) {
      const Long left = power(way);
      answer.residual = residual;
      answer.step = left > 0 ? double(std::sqrt(left / power(rounded(r).cast<Long>()))) : 0;
      best = r;
    }
    idle = better ? 0 : idle + 1;
    for (std::size_t i = 0; i < r.size(); ++i) r[i] += way[Eigen::Index(i)];
  }
  if (answer.certified()) best = r;  // the step that was too small to matter costs nothing more
  answer.r = rounded(best);
  QuadVector motion = change(best);
  for (std::size_t i = 0; i < motion.size(); ++i)
    motion[i] += bodies_[std::size_t(island_.bodies[i / 6])].velocity[Eigen::Index(i % 6)];
  answer.motion = rounded(motion);
  return answer;
}

}  // namespace

RefinedAnswer refine(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
                     const std::vector<Row>& rows, const Island& island, const VectorXd& start) {
  return QuadProblem(bodies, contacts, rows, island).refine(start);
}

}  // namespace demos::report
