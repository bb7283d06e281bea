#include "delassus/compliance_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "delassus/cone.h"
#include "delassus/read_mode.h"

namespace delassus {
namespace {

/// Coulomb's answer r = P(z) in one given mode, even if z has another mode, and its derivative
/// dr/dz.
Vec3 reactionIn(Mode mode, const Vec3& z, double mu, Mat3& derivative) {
  if (mode == Mode::Open) {
    derivative.setZero();
    return Vec3::Zero();
  }
  if (mode == Mode::Stick) {
    derivative.setIdentity();
    return z;
  }
  const double zt = lengthOf(z[1], z[2]);
  if (!(zt > 0)) {  // on the axis of the cone any direction will do
    derivative << 1, 0, 0, mu, 0, 0, 0, 0, 0;
    return {z[0], mu * z[0], 0};
  }
  return slidingReaction(z, zt, mu, &derivative);
}

/// Lengths whose squares are numbers.
const double smallestRoot = std::sqrt(std::numeric_limits<double>::min());

Mode modeAt(const Vec3& z, double mu) {
  return z[0] <= 0 ? Mode::Open : lengthOf(z[1], z[2]) <= mu * z[0] ? Mode::Stick : Mode::Slide;
}

}  // namespace

void CompliancePath::setProblem(BodyMotion& motion, const Problem& problem, const NaturalMap& map) {
  constexpr double negligible = 1e-12;
  motion_ = &motion;
  problem_ = &problem;
  map.meanDiagonal(scale_);
  own_ = problem.W.bodySpace().compliance;
  center_.setZero(problem.size());
  u0_ = problem.q;
  const double most = std::sqrt(problem.q.cwiseAbs2().cwiseQuotient(scale_).maxCoeff());
  least_ = smallestFelt_ = std::max(negligible * most, smallestRoot);
  G_.reset(problem);
  region_.contacts.resize(problem.contacts());
  region_.rows.resize(problem.rows());
}

void CompliancePath::setCenter(const Solution& center) {
  // A share of the size of the reactions. In smaller changes, rounding in r − r_k leaves fewer
  // digits than E needs.
  constexpr double share = 1e-5;
  center_ = center.r;
  u0_ = center.u;
  const double squeeze = std::sqrt(scale_.dot(center_.cwiseAbs2()));
  smallestFelt_ = std::max(share * squeeze, smallestRoot);
}

double CompliancePath::compliance() const { return std::exp(here_.tau); }

const VectorXd& CompliancePath::reactions() {
  respond(false);
  return r_;
}

/// Computes l, u, z, r and G at this point, in the modes of region_ or in those of z.
void CompliancePath::respond(bool inRegion) {
  const int n = problem_->contacts(), m = problem_->rows();
  l_ = (own_ + compliance() * scale_).cwiseInverse();
  motion_->relativeVelocity(here_.delta, u_);
  u_ += u0_;
  z_ = center_ - l_.cwiseProduct(u_);
  r_.resize(z_.size());
  for (int i = 0; i < n; ++i) {
    const int at = 3 * i;
    const Vec3 z = z_.segment<3>(at);
    const double mu = problem_->friction[i];
    r_.segment<3>(at) = inRegion ? reactionIn(region_.contacts[i], z, mu, G_.contacts[i])
                                 : reactionTo(z, mu, &G_.contacts[i]);
    G_.contacts[i] *= l_.segment<3>(at).asDiagonal();
  }
  for (int i = 0; i < m; ++i) {
    const int at = 3 * n + i;
    const double lower = problem_->lower[i], upper = problem_->upper[i];
    const RowState state = inRegion ? region_.rows[i] : stateAt(z_[at], lower, upper);
    r_[at] = state == RowState::Free ? z_[at] : state == RowState::AtLower ? lower : upper;
    G_.rows[i] = state == RowState::Free ? l_[at] : 0;
  }
}

/// Sets region_ to the region of z.
void CompliancePath::readRegion() {
  const int n = problem_->contacts();
  for (int i = 0; i < n; ++i)
    region_.contacts[i] = modeAt(z_.segment<3>(3 * i), problem_->friction[i]);
  for (int i = 0; i < problem_->rows(); ++i)
    region_.rows[i] = stateAt(z_[3 * n + i], problem_->lower[i], problem_->upper[i]);
}

bool CompliancePath::factorise(WorkDone& count) {
  ++count.factorisations;
  return motion_->factorise(G_);
}

/// Computes E. Returns its size relative to the motion J̃ᵀ (r − r_k).
double CompliancePath::error() {
  change_ = r_ - center_;
  motion_->impulse(change_, felt_);
  error_ = here_.delta - felt_;
  return error_.norm() / std::max(felt_.norm(), smallestFelt_);
}

/// The error that rounding leaves: u is a difference, and l magnifies it.
double CompliancePath::noise() const { return std::max(1e-11, 1e-15 / compliance()); }

/// K⁻¹ J̃ᵀ ∂r/∂ln c: the change of motion per unit of ln c.
void CompliancePath::findDrive() {
  const int n = problem_->contacts();
  change_ = compliance() * scale_.cwiseProduct(l_).cwiseProduct(u_);
  for (int i = 0; i < n; ++i)
    change_.segment<3>(3 * i) = (G_.contacts[i] * change_.segment<3>(3 * i)).eval();
  change_.tail(problem_->rows()).array() *= G_.rows.array();
  motion_->impulse(change_, drive_);
  motion_->solve(drive_);
}

/// The length in δ that counts as a unit of ln c. Motion has a large weight, since it goes on where
/// the curve turns back in c.
double CompliancePath::unit() const {
  constexpr double share = 0.1;
  return std::max(share * drive_.norm(), least_);
}

double CompliancePath::distance(const VectorXd& delta, double tau) const {
  return std::sqrt(delta.squaredNorm() / (unit_ * unit_) + tau * tau);
}

/// Finds the tangent at this point, where K is factored. Returns its product with the last one.
double CompliancePath::findTangent() {
  findDrive();
  const double length = distance(drive_, 1);
  newTangent_.tau = (motion_->isDeterminantNegative() == downward_ ? -1 : 1) / length;
  newTangent_.delta = newTangent_.tau * drive_;
  return newTangent_.delta.dot(tangent_.delta) / (unit_ * unit_) + newTangent_.tau * tangent_.tau;
}

/// Makes the tangent that was found the present one.
void CompliancePath::takeTangent() {
  constexpr double slowly = 0.3;
  std::swap(tangent_, newTangent_);
  unit_ = (1 - slowly) * unit_ + slowly * unit();
  const double length = distance(tangent_.delta, tangent_.tau);
  tangent_.delta /= length;
  tangent_.tau /= length;
}

/// dz for changes of δ and of ln c.
void CompliancePath::changeOfZ(const VectorXd& delta, double tau, VectorXd& change) {
  motion_->relativeVelocity(delta, change);
  change =
      l_.cwiseProduct((tau * compliance()) * scale_.cwiseProduct(l_).cwiseProduct(u_) - change);
}

bool CompliancePath::setOut(const VectorXd& reactions, double compliance, int budget,
                            WorkDone& count) {
  constexpr int mostSteps = 20;
  const int begun = count.factorisations;
  here_.tau = std::log(compliance);
  change_ = reactions - center_;
  motion_->impulse(change_, here_.delta);
  for (int k = 0;; ++k) {
    respond(false);
    const double now = error();
    if (now <= noise()) break;
    if (!std::isfinite(now) || count.factorisations - begun >= budget || k == mostSteps ||
        !factorise(count))
      return false;
    motion_->solve(error_);
    here_.delta -= error_;
  }
  start_ = here_;
  hasTurned_ = false;
  return stand(false, count);
}

/// Stands where the path started, facing less compliance or (`upward`) more.
bool CompliancePath::stand(bool upward, WorkDone& count) {
  constexpr double firstStride = 0.05;
  here_ = start_;
  respond(false);
  readRegion();
  if (!factorise(count)) return false;
  downward_ = motion_->isDeterminantNegative() != upward;
  findDrive();
  unit_ = unit();
  tangent_.delta.setZero(here_.delta.size());
  tangent_.tau = 0;
  findTangent();
  takeTangent();
  strideLength_ = firstStride;
  stepsAtWalls_ = 1;
  return true;
}

bool CompliancePath::descend(double compliance, int budget, WorkDone& count) {
  constexpr double shortest = 1e-4, retried = 2e-3, longest = 3, unanswered = 10;
  constexpr int mostSteps = 16, mostInVain = 5;
  const int begun = count.factorisations;
  const double aim = std::log(compliance);
  int inVain = 0;
  while (here_.tau > aim) {
    if (count.factorisations - begun >= budget) return false;
    if (this->compliance() > unanswered) {
      // Here only one answer exists, and the path has come up to it: the other way from the start
      // is the one that ends at 0.
      if (hasTurned_ || !stand(true, count)) return false;
      hasTurned_ = true;
    }
    const int before = count.factorisations;
    if (strideLength_ > shortest && stride(strideLength_, count)) {
      const int effort = count.factorisations - before;
      strideLength_ = std::min(longest, strideLength_ * (effort <= 4   ? 2
                                                         : effort <= 6 ? 1.3
                                                                       : 0.7));
      stepsAtWalls_ = 1;
      continue;
    }
    // If strides fail again and again, more and more steps are made before the next stride.
    strideLength_ = std::max(strideLength_ / 4, retried);
    bool goesOn = true;
    for (int k = 0; k < stepsAtWalls_ && goesOn && count.factorisations - begun < budget; ++k)
      goesOn = stepToWall(count);
    stepsAtWalls_ = std::min(2 * stepsAtWalls_, mostSteps);
    inVain = goesOn ? 0 : inVain + 1;
    if (inVain > mostInVain) return false;
  }
  return true;
}

/// Moves along the tangent from from_.
void CompliancePath::advance(double length) {
  here_.delta = from_.delta + length * tangent_.delta;
  here_.tau = from_.tau + length * tangent_.tau;
}

/// The distance from the end of this length of tangent.
double CompliancePath::strayed(double length) {
  felt_ = here_.delta - from_.delta - length * tangent_.delta;
  return distance(felt_, here_.tau - from_.tau - length * tangent_.tau);
}

/// Goes back to the curve by Newton's method across the tangent.
bool CompliancePath::meetCurve(bool inRegion, int most, WorkDone& count) {
  constexpr int patience = 3;
  double before = 0;
  for (int k = 0;; ++k) {
    respond(inRegion);
    const double now = error();
    if (!std::isfinite(now)) return false;
    if (now <= noise()) return true;
    if (k == most || (k > patience && now > 0.5 * before)) return now <= 100 * noise();
    before = now;
    if (!factorise(count)) return false;
    findDrive();
    motion_->solve(error_);
    // (−error + x drive, x) is at right angles to the tangent.
    const double x =
        tangent_.delta.dot(error_) / (tangent_.delta.dot(drive_) + unit_ * unit_ * tangent_.tau);
    if (!std::isfinite(x)) return false;
    here_.delta += x * drive_ - error_;
    here_.tau += x;
  }
}

/// Goes along the tangent through any number of regions, and back to the curve.
bool CompliancePath::stride(double length, WorkDone& count) {
  constexpr double mostTau = 1, near = 0.7;
  constexpr int mostSteps = 8;
  length = std::min(length, mostTau / std::abs(tangent_.tau));
  from_ = here_;
  advance(length);
  if (!meetCurve(false, mostSteps, count) || strayed(length) > near * length || !factorise(count) ||
      !(findTangent() > 0)) {
    goBack();
    return false;
  }
  takeTangent();
  readRegion();
  return true;
}

}  // namespace delassus
