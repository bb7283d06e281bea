#include "delassus/residual.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "delassus/cone.h"
#include "delassus/disk.h"

namespace delassus {
namespace {

/// ‖S‖₂ of a symmetric S whose eigenvalues are of any sign.
double symmetricNorm(const Mat2& S) {
  return 0.5 * (std::abs(S(0, 0) + S(1, 1)) + lengthOf(S(0, 0) - S(1, 1), 2 * S(0, 1)));
}

/// The largest root of y³ − 3y = 2x, |x| ≤ 1: 2 cos(⅔ arccos s) with s = √((1 + x) / 2). Starts
/// from the cubic in s with the same values and slopes at s = 0 and 1, then takes two steps of
/// Halley's method, each of which triples the digits: two fifths of the time of cos and arccos.
double largestRoot(double x) {
  constexpr double slope0 = 1.1547005383792515, slope1 = 8.0 / 9;  // 2/√3
  constexpr double c3 = slope0 + slope1 - 2, c2 = 1 - slope0 - c3;
  const double s = std::sqrt(std::max(0.5 * (1 + x), 0.0));
  double y = 1 + s * (slope0 + s * (c2 + s * c3));
  constexpr double nearlyDouble = 1e-6;  // where f would be all rounding
  for (int k = 0; k < 2 && s > nearlyDouble; ++k) {
    const double f = y * (y * y - 3) - 2 * x, slope = 3 * (y * y - 1);
    y -= f * slope / (slope * slope - 3 * y * f);
  }
  return y;
}

/// The eigenvalues are m + p y, with the mean m, 6 p² = ‖S − m I‖², and the roots of y³ − 3y =
/// det(S − m I) / p³.
double symmetricNorm(const Mat3& S) {
  const double m = S.trace() / 3;
  const double a = S(0, 0) - m, b = S(1, 1) - m, c = S(2, 2) - m;
  const double xy = S(0, 1), xz = S(0, 2), yz = S(1, 2);
  const double p2 = (a * a + b * b + c * c + 2 * (xy * xy + xz * xz + yz * yz)) / 6;
  const double p = std::sqrt(p2), p3 = p * p2;
  if (!(p3 > 0)) return std::abs(m);
  const double halfDet = 0.5 * (a * (b * c - yz * yz) - b * xz * xz - c * xy * xy) + xy * xz * yz;
  const double y = largestRoot(std::clamp(halfDet / p3, -1.0, 1.0)), largest = m + p * y;
  if (p <= 2 * m) return largest;  // no eigenvalue is as far below 0
  const double least = -0.5 * (y + std::sqrt(std::max(12 - 3 * y * y, 0.0)));
  return std::max(largest, -(m + p * least));
}

/// ‖W‖₂ = √ λ_max(Wᵀ W), also for blocks that are not symmetric. Scales first, since squares of
/// tiny masses may vanish.
template <class Block>
double spectralNorm(const Block& W) {
  const double scale = W.cwiseAbs().maxCoeff();
  if (!(scale > 0)) return scale;
  const Block S = W / scale;
  if (S == S.transpose()) return scale * symmetricNorm(S);
  return scale * std::sqrt(symmetricNorm(Block(S.transpose() * S)));
}

/// The same for a contact. If its arms lie along its normal, as those of balls do, a normal
/// reaction does not move it along its tangents: then it compares the sizes of two blocks.
double spectralNorm(const Mat3& W) {
  constexpr double rounding = 1e-14;
  const double coupling = W.row(0).tail<2>().cwiseAbs().sum() + W.col(0).tail<2>().cwiseAbs().sum();
  const double difference = W(1, 1) - W(2, 2), across = W(1, 2), normal = std::abs(W(0, 0));
  if (!(coupling <= rounding * normal) || W(2, 1) != across) return spectralNorm<Mat3>(W);
  const double tangential = 0.5 * (std::abs(W(1, 1) + W(2, 2)) + lengthOf(difference, 2 * across));
  return std::max(normal, tangential);
}

/// part/whole, where 0/0 is 0, and any other part over 0 is infinite.
double ratio(double part, double whole) { return part == 0 ? 0 : part / whole; }

/// Sizes of the diagonal blocks of W, 1/kg, one per contact or row (both rows of a disk have the
/// size of their block). They are positive, so that 1/size is a step.
///
/// A block that vanishes gives no step. It gets the size of the largest block, which at least has
/// the right unit, or 1 if all vanish. The residual is zero at the same reactions for any step.
template <class ContactSize>
void blockSizes(const Problem& problem, const VectorXd& diagonal, ContactSize contactSize,
                VectorXd& sizes) {
  const int n = problem.contacts(), m = problem.rows();
  sizes.resize(n + m);
  for (int a = 0; a < n; ++a) sizes[a] = contactSize(a);
  sizes.tail(m) = diagonal.tail(m).cwiseAbs();
  for (const Disk& disk : problem.disks)
    if (disk.unknowns == 2)
      sizes.segment<2>(problem.partAt(disk.first))
          .setConstant(spectralNorm(problem.W.pairBlock(disk.first)));

  const double largest = sizes.size() > 0 ? sizes.maxCoeff() : 0;
  const double instead = largest > 0 ? largest : 1;
  for (double& size : sizes)
    if (size < std::numeric_limits<double>::min()) size = instead;
}

/// (‖F‖/ρ)² of a contact with 1/ρ = size: since K_μ is a cone, F/ρ = x − P(x − v) with x = size r.
/// Case by case (projectOnCone), so that a large r does not swallow v.
double squareOfContact(const Vec3& r, const Vec3& u, double mu, double size) {
  const Vec3 x = size * r, v = correctedVelocity(u, mu), z = x - v;
  const double t = lengthOf(z[1], z[2]);
  if (z[0] >= 0 && t <= mu * z[0]) return v.squaredNorm();
  if (mu * t <= -z[0]) return x.squaredNorm();
  const double n = (z[0] + mu * t) / (1 + mu * mu), share = mu * n / t;
  return Vec3(x[0] - n, x[1] - share * z[1], x[2] - share * z[2]).squaredNorm();
}

constexpr double muchFriction = 2;

/// (‖G‖/ρ)² of a contact with 1/ρ = size.
double squareOfLawsApart(const Vec3& r, const Vec3& u, double mu, double size) {
  const Vec2 x = size * r.tail<2>(), slip = u.tail<2>(), z = x - slip;
  const double normal = std::min(size * r[0], u[0]), most = mu * size * r[0], t = z.norm();
  const Vec2 tangential = t > most ? Vec2(x - most / t * z) : slip;
  return normal * normal + tangential.squaredNorm();
}

/// Calls `visit(k, first, (‖F‖/ρ)²)` with F = r − P(r − ρ v), 1/ρ = size(k), for each contact and
/// then each row k, or disk whose first row is k; its first unknown is `first`. Of a contact,
/// `ofContact(r, u, μ, size)` stands for (‖F‖/ρ)².
template <class Size, class OfContact, class Visit>
void visitNaturalMap(const Problem& problem, const VectorXd& r, const VectorXd& u, Size size,
                     OfContact ofContact, Visit visit) {
  const int n = problem.contacts();
  for (int a = 0; a < n; ++a)
    visit(a, 3 * a,
          ofContact(r.segment<3>(3 * a), u.segment<3>(3 * a), problem.friction[a], size(a)));
  const int plainRows = problem.disksBegin() - 3 * n;
  for (int i = 0; i < plainRows; ++i) {
    const int at = 3 * n + i;
    const double whole = size(n + i),
                 part = rowResidual(r[at], u[at], problem.lower[i], problem.upper[i], 1 / whole);
    visit(n + i, at, (whole * part) * (whole * part));
  }
  for (const Disk& disk : problem.disks) {
    const int k = problem.partAt(disk.first);
    const double whole = size(k);
    const Vec2 part =
        disk.of(r) - projectOnDisk(disk.of(r) - 1 / whole * disk.of(u), disk.radiusAt(r));
    visit(k, disk.first, (whole * part).squaredNorm());
  }
}

}  // namespace

void NaturalMap::setProblem(const Problem& problem) {
  problem_ = &problem;
  blocks_.resize(problem.contacts());
  for (int a = 0; a < problem.contacts(); ++a) blocks_[a] = problem.W.contactBlock(3 * a);
  problem.W.diagonal(blocks_, diagonal_);
  blockSizes(
      problem, diagonal_, [&](int a) { return spectralNorm(blocks_[a]); }, sizes_);
  isGrippy_ = false;
}

void NaturalMap::setProblem(const Problem& problem, std::vector<Mat3> blocks,
                            const VectorXd& norms) {
  assert(problem.rows() == 0);
  problem_ = &problem;
  blocks_ = std::move(blocks);
  diagonal_.resize(problem.size());
  for (int a = 0; a < problem.contacts(); ++a) diagonal_.segment<3>(3 * a) = blocks_[a].diagonal();
  blockSizes(
      problem, diagonal_, [&](int a) { return norms[a]; }, sizes_);
  isGrippy_ = false;
}

void NaturalMap::aimAt(double tolerance) {
  constexpr double times = 1e3;
  isGrippy_ = problem_->contacts() > 0 && problem_->friction.maxCoeff() > muchFriction;
  near_ = times * tolerance;
}

void NaturalMap::meanDiagonal(VectorXd& mean) const {
  mean = diagonal_;
  for (int i = 0; i < problem_->contacts(); ++i)
    mean.segment<3>(3 * i).setConstant(mean.segment<3>(3 * i).mean());
  for (const Disk& disk : problem_->disks) {
    auto own = mean.segment(disk.first, disk.unknowns);
    own.setConstant(own.mean());
  }
  constexpr double least = 1e-14, smallest = 1e-290;
  const double largest = mean.size() > 0 ? mean.maxCoeff() : 0;
  mean = mean.cwiseMax(largest > 0 ? std::max(least * largest, smallest) : 1);
}

double NaturalMap::roundOff(const VectorXd& r) const {
  if (r.size() == 0) return 0;
  return 8 * std::numeric_limits<double>::epsilon() *
         diagonal_.cwiseProduct(r).cwiseAbs().maxCoeff();
}

template <class OfContact>
VelocityResidual NaturalMap::summary(const VectorXd& r, const VectorXd& u,
                                     OfContact ofContact) const {
  assert(r.size() == problem_->size() && u.size() == problem_->size() && "one number an unknown");
  VelocityResidual residual;
  double largest = 0, sum = 0;
  const auto size = [&](int k) { return sizes_[k]; };
  visitNaturalMap(*problem_, r, u, size, ofContact, [&](int, int first, double square) {
    // A NaN is the worst of all: it must not pass for a small residual.
    if (residual.worst < 0 || square > largest || std::isnan(square)) {
      largest = square;
      residual.worst = first;
    }
    sum += square;
  });
  residual.max = std::sqrt(largest);
  if (sizes_.size() > 0) residual.rms = std::sqrt(sum / static_cast<double>(sizes_.size()));
  return residual;
}

VelocityResidual NaturalMap::residual(const VectorXd& r, const VectorXd& u) const {
  return summary(r, u, squareOfContact);
}

VelocityResidual NaturalMap::error(const VectorXd& r, const VectorXd& u) const {
  if (!isGrippy_) return residual(r, u);
  const double most = near_ * near_;
  return summary(r, u, [&](const Vec3& own, const Vec3& velocity, double mu, double size) {
    const double square = squareOfContact(own, velocity, mu, size);
    if (mu <= muchFriction) return square;
    return std::max(std::min(square, most), squareOfLawsApart(own, velocity, mu, size));
  });
}

VelocityResidual NaturalMap::measure(const VectorXd& r, VectorXd& y, VectorXd& u) const {
  if (r.any()) {
    problem_->W.multiply(r, y, u);
    u += problem_->q;
  } else {
    u = problem_->q;
  }
  return error(r, u);
}

void NaturalMap::residuals(const VectorXd& r, const VectorXd& u, VectorXd& each) const {
  each.setZero(sizes_.size());
  const auto size = [&](int k) { return sizes_[k]; };
  visitNaturalMap(*problem_, r, u, size, squareOfContact,
                  [&](int k, int, double square) { each[k] = std::sqrt(square); });
}

VelocityResidual naturalResidual(const Problem& problem, const VectorXd& r, const VectorXd& u) {
  NaturalMap map;
  map.setProblem(problem);
  return map.residual(r, u);
}

VelocityResidual naturalResidual(const Problem& problem, const VectorXd& r) {
  VectorXd u = problem.W * r;
  u += problem.q;
  return naturalResidual(problem, r, u);
}

double contactSize(const Mat3& W) { return spectralNorm(W); }

double naturalResidual(double size, double friction, const Vec3& r, const Vec3& u) {
  return std::sqrt(squareOfContact(r, u, friction, size));
}

FclibMeasures fclibMeasures(const Problem& problem, const VectorXd& r) {
  assert(r.size() == problem.size() && "one number an unknown");
  const VectorXd u = problem.W * r + problem.q;
  VectorXd size;
  const VectorXd diagonal = problem.W.diagonal();
  const auto meanDiagonal = [&](int a) { return std::abs(diagonal.segment<3>(3 * a).sum()) / 3; };
  blockSizes(problem, diagonal, meanDiagonal, size);

  double unscaled2 = 0, velocity2 = 0;
  visitNaturalMap(
      problem, r, u, [](int) { return 1.0; }, squareOfContact,
      [&](int, int, double square) { unscaled2 += square; });
  visitNaturalMap(
      problem, r, u, [&](int k) { return size[k]; }, squareOfContact,
      [&](int, int, double square) { velocity2 += square; });

  const double q = problem.q.norm();
  return {ratio(std::sqrt(unscaled2), q), ratio(std::sqrt(velocity2), q)};
}

}  // namespace delassus
