#include "delassus/proximal_newton.h"

#include <algorithm>
#include <cmath>

#include "delassus/cone.h"
#include "delassus/length.h"
#include "delassus/options.h"
#include "delassus/residual.h"
#include "delassus/wall.h"

namespace delassus {

template <class Motion>
void ProximalNewton<Motion>::setProblem(const Problem& problem, const NaturalMap& map) {
  map_ = &map;
  motion_.setProblem(problem);
  map.meanDiagonal(scale_);
  if (problem.W.inBodySpace())
    compliance_ = problem.W.bodySpace().compliance;
  else
    compliance_.setZero(problem.size());
  G_.reset(problem);
  fromU_.resize(problem.size());
  alongU_.resize(problem.size());
  forgetFactor();
}

template <class Motion>
void ProximalNewton<Motion>::forgetFactor() {
  hasFactor_ = false;
}

template <class Motion>
Motion& ProximalNewton<Motion>::motion() {
  forgetFactor();
  return motion_;
}

template <class Motion>
void ProximalNewton<Motion>::setWeights(double alpha) {
  constexpr double finest = 1e-7, coarsest = 1e-2;
  l_ = (compliance_ + alpha * scale_).cwiseInverse();
  enough_ = std::clamp(alpha, finest, coarsest);
}

template <class Motion>
void ProximalNewton<Motion>::setTolerance(double tolerance) {
  // An error of the motion (in energy norm) that no contact can tell from the tolerance.
  fine_ = 0.1 * tolerance / std::sqrt(scale_.maxCoeff());
}

/// The reaction `r` to center + step. Where the law leaves that as it is, the change is the step to all its digits, of which the
/// difference of two large reactions keeps few.
template <class Motion>
void ProximalNewton<Motion>::answer(int at, double step, double r) {
  r_[at] = r;
  change_[at] = r == center_[at] + step ? step : r - center_[at];
}

template <class Motion>
void ProximalNewton<Motion>::respond(const Problem& problem, const VectorXd& u, Stiffness* G) {
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
      answerOfDisk(disk, static_cast<int>(k), mode, z, radius * l_[disk.first] / length,
                   disk.grows(r_), *G);
  }
}

/// −dr/du of a disk: of one that slides along `direction`, its own part is across, where it may turn, and its governor moves
/// the rim along, if the disk still grows with it.
template <class Motion>
void ProximalNewton<Motion>::answerOfDisk(const Disk& disk, int k, Mode mode, const Vec2& direction,
                                          double turn, bool grows, Stiffness& G) const {
  Stiffness::OfDisk& answer = G.disks[k];
  answer = {};
  G.rows.segment(disk.first - 3 * static_cast<int>(G.contacts.size()), disk.unknowns).setZero();
  if (mode == Mode::Stick) answer.own.diagonal().setConstant(l_[disk.first]);
  if (mode != Mode::Slide) return;
  const Vec2 along = direction.normalized();
  answer.own = turn * (Mat2::Identity() - along * along.transpose());
  if (grows) answer.governor = disk.radius * along * G.ofNormal(disk);
}

template <class Motion>
void ProximalNewton<Motion>::respondInRegion(const Problem& problem, const Solution& from) {
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
        G_.contacts[i] << l[0], 0, 0,                    //
            mu * l[0] * c, turn * s * s, -turn * s * c,  //
            mu * l[0] * s, -turn * s * c, turn * c * c;
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
    answerOfDisk(disk, static_cast<int>(k), mode, g, turn, grows, G_);
    const Vec2 held = disk.of(center_) - l * u;
    const double load = grows ? r_[disk.governor] : disk.mostLoad;
    const Vec2 rim = disk.radius * load * g.normalized() - G_.disks[k].own * u;
    disk.put(mode == Mode::Stick ? held : mode == Mode::Slide ? rim : Vec2(Vec2::Zero()), r_);
  }
}

template <class Motion>
bool ProximalNewton<Motion>::factorise(Solution& count) {
  if (keepsFactors_ && hasFactor_ && factored_ == G_) return true;
  ++count.factorisations;
  hasFactor_ = motion_.factorise(G_);
  if (hasFactor_) factored_ = G_;
  return hasFactor_;
}

/// What the bodies feel of r_ beyond the center, J̃ᵀ (r − r_k).
template <class Motion>
const VectorXd& ProximalNewton<Motion>::felt() {
  motion_.impulse(change_, felt_);
  return felt_;
}

/// The norm of the error after this share of the step.
template <class Motion>
double ProximalNewton<Motion>::tryStep(const Problem& problem, double share) {
  trialDelta_ = delta_ + share * step_;
  motion_.relativeVelocity(trialDelta_, trialU_);
  trialU_ += u_;
  respond(problem, trialU_, nullptr);
  trialError_ = trialDelta_ - felt();
  return trialError_.norm();
}

/// As much of the step as lets the energy norm `error` of the error fall; near a solution that is all of it. Elsewhere it is halved
/// until the error falls, which it does as far as some wall of the regions, to rise behind it. Halves alone come ever nearer to that wall
/// and never through it. So the step goes on from wall to wall as long as the error falls, and ends a hair's breadth behind the last:
/// the next one knows the region there. False if it does not fall.
template <class Motion>
bool ProximalNewton<Motion>::stepAlong(const Problem& problem, double& error) {
  constexpr int mostHalvings = 10, mostWalls = 4;
  constexpr double hair = 1e-6;
  double share = 1, least = tryStep(problem, share);
  for (int h = 1; !(least <= (1 - 1e-4 * share) * error); ++h) {
    if (h == mostHalvings) return false;
    share *= 0.5;
    least = tryStep(problem, share);
  }
  if (share < 1) {
    const double tooLong = 2 * share;
    motion_.relativeVelocity(delta_, fromU_);
    fromU_ += u_;
    motion_.relativeVelocity(step_, alongU_);
    double tried = share;
    for (int k = 0; k < mostWalls; ++k) {
      const double wall = nextWallAlong(problem, tried);
      if (!(wall < tooLong)) break;
      tried = (1 + hair) * wall;
      const double now = tryStep(problem, tried);
      if (!(now < least)) break;
      least = now;
      share = tried;
    }
    if (tried != share) tryStep(problem, share);
  }
  error = least;
  return true;
}

/// The first wall after this share of the step.
template <class Motion>
double ProximalNewton<Motion>::nextWallAlong(const Problem& problem, double after) const {
  double first = infinity;
  const int n = problem.contacts();
  for (int i = 0; i < n; ++i) {
    const int at = 3 * i;
    const Vec3 l = l_.segment<3>(at);
    const Vec3 z = center_.segment<3>(at) - l.cwiseProduct(fromU_.segment<3>(at));
    const Vec3 d = -l.cwiseProduct(alongU_.segment<3>(at));
    first = std::min(first, nextWall(z, d, problem.friction[i], after));
  }
  const auto z = [this](int at) { return center_[at] - l_[at] * fromU_[at]; };
  const auto d = [this](int at) { return -l_[at] * alongU_[at]; };
  for (int i = 0; i < problem.rows(); ++i) {
    const int at = 3 * n + i;
    first = std::min(first, nextWall(z(at), d(at), problem.lower[i], problem.upper[i], after));
  }
  for (const Disk& disk : problem.disks) {
    const Vec2 own = disk.of(center_) - l_[disk.first] * disk.of(fromU_);
    const Vec2 along = -l_[disk.first] * disk.of(alongU_);
    const Vec3 from(z(disk.governor), own[0], own[1]), way(d(disk.governor), along[0], along[1]);
    first = std::min(first, nextWall(from, way, disk.radius, after));
  }
  return first;
}

template <class Motion>
typename ProximalNewton<Motion>::Inner ProximalNewton<Motion>::solveProximal(
    const Problem& problem, int& budget, Solution& count, const Solution* region) {
  // An inner answer only has to be better than what the outer step corrects anyway; at round-off the line search stalls.
  constexpr double stalled = 1e-2;
  constexpr int mostSteps = 40;
  delta_.setZero(motion_.size());
  trialU_ = u_;

  if (region) {
    if (budget-- <= 0) return Inner::Failed;
    ++count.regions;
    respondInRegion(problem, *region);
    if (!factorise(count)) return Inner::Failed;
    change_ = r_ - center_;
    delta_ = felt();
    motion_.solve(delta_);
    if (!delta_.allFinite()) return Inner::Failed;
    motion_.relativeVelocity(delta_, trialU_);
    trialU_ += u_;
  }
  respond(problem, trialU_, nullptr);
  error_ = delta_ - felt();
  double error = error_.norm();
  for (int k = 0; k < mostSteps; ++k) {
    const double size = std::max(delta_.norm(), felt_.norm());
    if (error <= std::max(enough_ * size, fine_)) return Inner::Converged;
    if (budget-- <= 0) return Inner::Failed;
    ++count.regions;
    respond(problem, trialU_, &G_);
    if (!factorise(count)) return Inner::Failed;
    step_ = -error_;
    motion_.solve(step_);
    if (!step_.allFinite()) return Inner::Failed;

    if (!stepAlong(problem, error))
      return error <= stalled * size ? Inner::Converged : Inner::Failed;
    delta_.swap(trialDelta_);
    error_.swap(trialError_);
  }
  return Inner::Failed;
}

template <class Motion>
Outcome ProximalNewton<Motion>::walk(const Problem& problem, double tolerance, double alpha,
                                     int regionBudget, Solution& best) {
  return walkFrom(best, problem, tolerance, alpha, regionBudget, best);
}

template <class Motion>
Outcome ProximalNewton<Motion>::walkFrom(const Solution& start, const Problem& problem,
                                         double tolerance, double alpha, int regionBudget,
                                         Solution& best) {
  center_ = start.r;
  u_ = start.u;
  return converge(problem, tolerance, alpha, regionBudget, false, start.residual, best);
}

template <class Motion>
Outcome ProximalNewton<Motion>::walkFromRegion(const Problem& problem, double tolerance,
                                               double alpha, int regionBudget, Solution& best) {
  center_.setZero(problem.size());
  u_ = problem.q;
  constexpr double unknown = infinity;
  return converge(problem, tolerance, alpha, regionBudget, true, unknown, best);
}

template <class Motion>
double ProximalNewton<Motion>::measure(const Problem& problem) {
  problem.W.multiply(r_, felt_, trialU_);
  trialU_ += problem.q;
  return map_->residual(r_, trialU_).max;
}

template <class Motion>
void ProximalNewton<Motion>::moveTo(double residual, Solution& best) {
  center_ = r_;
  u_.swap(trialU_);
  if (!(residual < best.residual)) return;
  best.r = center_;
  best.u = u_;
  best.residual = residual;
}

template <class Motion>
void ProximalNewton<Motion>::polish(const Problem& problem, double tolerance, double alpha,
                                    int regionBudget, Solution& best) {
  center_ = best.r;
  u_ = best.u;
  r_ = center_;
  setTolerance(tolerance);
  setWeights(alpha);
  if (solveProximal(problem, regionBudget, best, nullptr) == Inner::Failed) return;
  moveTo(measure(problem), best);
}

template <class Motion>
Outcome ProximalNewton<Motion>::converge(const Problem& problem, double tolerance, double alpha,
                                         int regionBudget, bool fromRegion, double residual,
                                         Solution& best) {
  constexpr double smallest = 1e-12, largest = 10, hardly = 1e-7, growth = 10;
  // How the weight shrinks: less boldly after a failure, and more so again once two steps in a row were easy.
  constexpr double boldest = 0.01;
  constexpr int fewRegions = 6;
  constexpr int mostOuters = 1000;  // budgets end before, unless steps take no regions
  setTolerance(tolerance);
  r_ = center_;
  double shrink = boldest;
  int easySteps = 0;
  for (int outer = 0; outer < mostOuters; ++outer) {
    setWeights(alpha);
    const int regionsBefore = regionBudget;
    const Solution* region = fromRegion && outer == 0 ? &best : nullptr;
    if (solveProximal(problem, regionBudget, best, region) == Inner::Failed) {
      // Where the budget ends, what is half done may be better than nothing.
      if (regionBudget <= 0) moveTo(measure(problem), best);
      if (best.residual <= tolerance) return Outcome::Reached;
      if (fromRegion || regionBudget <= 0 || alpha >= largest) return Outcome::Lost;
      shrink = std::sqrt(shrink);
      easySteps = 0;
      alpha *= growth;
      continue;
    }
    easySteps = regionsBefore - regionBudget <= fewRegions ? easySteps + 1 : 0;
    if (easySteps > 1) shrink = std::max(boldest, shrink * std::sqrt(shrink));
    const double now = measure(problem);
    if (now > std::max(0.5 * residual, tolerance) && alpha <= hardly &&
        growsInVain(problem, tolerance, now)) {
      compromise(problem, best);
      return Outcome::Incompatible;
    }
    moveTo(now, best);
    // Some digits more if they come by themselves: then the next step may stand on these reactions.
    const double aim = now > 0.3 * residual ? tolerance : polishedShare * tolerance;
    if (now <= std::max(aim, map_->roundOff(center_))) return Outcome::Reached;
    // A region that is known needs a small weight to finish; one that still changes needs a larger one.
    if (now > 0.1 * residual && alpha <= smallest) return Outcome::Lost;
    if (now > 0.01 * residual) alpha = std::max(smallest, shrink * alpha);
    residual = now;
  }
  return Outcome::Lost;
}

template class ProximalNewton<BodyMotion>;
template class ProximalNewton<FactoredMotion>;

}  // namespace delassus
