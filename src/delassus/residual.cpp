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

/// The eigenvalues are m + 2 p cos(φ + 2πk/3), with the mean m, 6 p² = ‖S − m I‖², and cos 3φ = det(S − m I) / 2 p³.
double symmetricNorm(const Mat3& S) {
  const double m = S.trace() / 3;
  const double a = S(0, 0) - m, b = S(1, 1) - m, c = S(2, 2) - m;
  const double xy = S(0, 1), xz = S(0, 2), yz = S(1, 2);
  const double p2 = (a * a + b * b + c * c + 2 * (xy * xy + xz * xz + yz * yz)) / 6;
  const double p = std::sqrt(p2), p3 = p * p2;
  if (!(p3 > 0)) return std::abs(m);
  const double halfDet = 0.5 * (a * (b * c - yz * yz) - b * xz * xz - c * xy * xy) + xy * xz * yz;
  const double angle = std::acos(std::clamp(halfDet / p3, -1.0, 1.0)) / 3;
  const double largest = m + 2 * p * std::cos(angle);
  if (p <= 2 * m) return largest;               // none is as far below 0
  constexpr double third = 2.0943951023931953;  // 2π/3
  return std::max(largest, -(m + 2 * p * std::cos(angle + third)));
}

/// ‖W‖₂ = √ λ_max(Wᵀ W), also for blocks that are not symmetric. Scaled first, for squares of tiny masses may vanish.
template <class Block>
double spectralNorm(const Block& W) {
  const double scale = W.cwiseAbs().maxCoeff();
  if (!(scale > 0)) return scale;
  const Block S = W / scale;
  if (S == S.transpose()) return scale * symmetricNorm(S);
  return scale * std::sqrt(symmetricNorm(Block(S.transpose() * S)));
}

/// That of a contact. Where its arms go along its normal, as those of balls do, no normal reaction moves it along its tangents: then
/// two sizes are compared.
double spectralNorm(const Mat3& W) {
  constexpr double rounding = 1e-14;
  const double coupling = W.row(0).tail<2>().cwiseAbs().sum() + W.col(0).tail<2>().cwiseAbs().sum();
  const double difference = W(1, 1) - W(2, 2), across = W(1, 2), normal = std::abs(W(0, 0));
  if (!(coupling <= rounding * normal) || W(2, 1) != across) return spectralNorm<Mat3>(W);
  const double tangential = 0.5 * (std::abs(W(1, 1) + W(2, 2)) + lengthOf(difference, 2 * across));
  return std::max(normal, tangential);
}

/// Nothing compared with nothing is nothing; something compared with nothing is infinite.
double ratio(double part, double whole) { return part == 0 ? 0 : part / whole; }

/// Sizes of the diagonal blocks of W, 1/kg, one a contact or row (both rows of a disk have that of their block): positive,
/// so that 1/size is a step.
///
/// A block that vanishes gives no step. It takes the size of the largest block, which at least has the right unit, or
/// 1 if all vanish: whatever the step, the residual is zero at the same reactions.
template <class ContactSize>
void blockSizes(const Problem& problem, const VectorXd& diagonal, ContactSize contactSize,
                VectorXd& sizes) {
  const int n = problem.contacts(), m = problem.rows();
  sizes.resize(n + m);
  for (int a = 0; a < n; ++a) sizes[a] = contactSize(a);
  sizes.tail(m) = diagonal.tail(m).cwiseAbs();
  for (const Disk& disk : problem.disks)
    if (disk.unknowns == 2)
      sizes.segment<2>(disk.first - 2 * n)
          .setConstant(spectralNorm(problem.W.pairBlock(disk.first)));

  const double largest = sizes.size() > 0 ? sizes.maxCoeff() : 0;
  const double instead = largest > 0 ? largest : 1;
  for (double& size : sizes)
    if (size < std::numeric_limits<double>::min()) size = instead;
}

/// ‖F‖ of a contact with the step s.
double residualOfContact(const Vec3& r, const Vec3& u, double mu, double s) {
  return (r - projectOnCone(r - s * correctedVelocity(u, mu), mu)).norm();
}

/// Calls `visit(k, first, unknowns, ‖F‖)` with F = r − P(r − s v), s = step(k), for each contact and then each row k, or
/// disk whose first row is k, with so many unknowns from `first`.
template <class Step, class Visit>
void visitNaturalMap(const Problem& problem, const VectorXd& r, const VectorXd& u, Step step,
                     Visit visit) {
  const int n = problem.contacts();
  for (int a = 0; a < n; ++a)
    visit(
        a, 3 * a, 3,
        residualOfContact(r.segment<3>(3 * a), u.segment<3>(3 * a), problem.friction[a], step(a)));
  const int plainRows = problem.disksBegin() - 3 * n;
  for (int i = 0; i < plainRows; ++i) {
    const int at = 3 * n + i;
    visit(n + i, at, 1, rowResidual(r[at], u[at], problem.lower[i], problem.upper[i], step(n + i)));
  }
  for (const Disk& disk : problem.disks) {
    const int k = disk.first - 2 * n;
    const Vec2 x = disk.of(r) - step(k) * disk.of(u);
    visit(k, disk.first, disk.unknowns, (disk.of(r) - projectOnDisk(x, disk.radiusAt(r))).norm());
  }
}

}  // namespace

void NaturalMap::setProblem(const Problem& problem) {
  problem_ = &problem;
  problem.W.diagonal(diagonal_);
  blocks_.resize(problem.contacts());
  for (int a = 0; a < problem.contacts(); ++a) blocks_[a] = problem.W.contactBlock(3 * a);
  blockSizes(
      problem, diagonal_, [&](int a) { return spectralNorm(blocks_[a]); }, sizes_);
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
}

void NaturalMap::meanDiagonal(VectorXd& mean) const {
  mean = diagonal_;
  for (int i = 0; i < problem_->contacts(); ++i)
    mean.segment<3>(3 * i).setConstant(mean.segment<3>(3 * i).mean());
  for (const Disk& disk : problem_->disks) {
    auto own = mean.segment(disk.first, disk.unknowns);
    own.setConstant(own.mean());
  }
  constexpr double least = 1e-14, smallest = 1e-300;
  mean = mean.cwiseMax(least * std::max(mean.maxCoeff(), smallest));
}

double NaturalMap::roundOff(const VectorXd& r) const {
  if (r.size() == 0) return 0;
  return 8 * std::numeric_limits<double>::epsilon() *
         diagonal_.cwiseProduct(r).cwiseAbs().maxCoeff();
}

VelocityResidual NaturalMap::residual(const VectorXd& r, const VectorXd& u) const {
  assert(r.size() == problem_->size() && u.size() == problem_->size() && "one number an unknown");
  VelocityResidual residual;
  double squares = 0;
  const auto step = [&](int k) { return 1 / sizes_[k]; };
  visitNaturalMap(*problem_, r, u, step, [&](int k, int first, int, double F) {
    const double velocity = F * sizes_[k];
    // A NaN is the worst of all: it must not pass for a small residual.
    if (residual.worst < 0 || velocity > residual.max || std::isnan(velocity)) {
      residual.max = velocity;
      residual.worst = first;
    }
    squares += velocity * velocity;
  });
  if (sizes_.size() > 0) residual.rms = std::sqrt(squares / static_cast<double>(sizes_.size()));
  return residual;
}

NaturalResidual NaturalMap::residualWithEnergy(const VectorXd& r, const VectorXd& u) const {
  NaturalResidual residual{this->residual(r, u)};
  double energy = 0, freeEnergy = 0;
  const auto step = [&](int k) { return 1 / sizes_[k]; };
  visitNaturalMap(*problem_, r, u, step, [&](int k, int first, int unknowns, double F) {
    energy += F * F * sizes_[k];
    freeEnergy += problem_->q.segment(first, unknowns).squaredNorm() / sizes_[k];
  });
  residual.energy = std::sqrt(ratio(energy, freeEnergy));
  return residual;
}

void NaturalMap::residuals(const VectorXd& r, const VectorXd& u, VectorXd& each) const {
  each.setZero(sizes_.size());
  const auto step = [&](int k) { return 1 / sizes_[k]; };
  visitNaturalMap(*problem_, r, u, step,
                  [&](int k, int, int, double F) { each[k] = F * sizes_[k]; });
}

NaturalResidual naturalResidual(const Problem& problem, const VectorXd& r, const VectorXd& u) {
  NaturalMap map;
  map.setProblem(problem);
  return map.residualWithEnergy(r, u);
}

NaturalResidual naturalResidual(const Problem& problem, const VectorXd& r) {
  VectorXd u = problem.W * r;
  u += problem.q;
  return naturalResidual(problem, r, u);
}

double contactSize(const Mat3& W) { return spectralNorm(W); }

double naturalResidual(double size, double friction, const Vec3& r, const Vec3& u) {
  return size * residualOfContact(r, u, friction, 1 / size);
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
      problem, r, u, [](int) { return 1.0; }, [&](int, int, int, double F) { unscaled2 += F * F; });
  visitNaturalMap(
      problem, r, u, [&](int k) { return 1 / size[k]; },
      [&](int k, int, int, double F) { velocity2 += F * size[k] * F * size[k]; });

  const double unscaled = std::sqrt(unscaled2), q = problem.q.norm();
  FclibMeasures measures;
  measures.rel = ratio(unscaled, q);
  measures.merit1 = unscaled / (1 + std::sqrt(q));
  measures.sic = ratio(unscaled, std::max({q, r.norm(), u.norm()}));
  measures.vel = ratio(std::sqrt(velocity2), q);
  return measures;
}

}  // namespace delassus
