#include "delassus/quick_answer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "delassus/dense_newton.h"
#include "delassus/read_mode.h"

namespace delassus {
namespace {

constexpr double gain = 0.2;  ///< what a sweep that takes away most leaves

}  // namespace

QuickAnswer::QuickAnswer(const Problem& problem, const Options& options)
    : problem_(problem),
      options_(options),
      demand_(problem.q.cwiseAbs().maxCoeff()),
      place_(problem.contacts(), -1),
      residuals_(problem.contacts(), std::numeric_limits<double>::infinity()) {
  approaching_.reserve(problem.contacts());
  best_.start(problem.q);
  best_.tier = Tier::Walk;
}

bool QuickAnswer::isSmall() const { return problem_.size() <= fewUnknowns; }

double QuickAnswer::toleranceFor(double demand) const {
  return std::max(options_.tolerance * demand, problem_.roundOff);
}

bool QuickAnswer::find(Solution& answer) {
  if (options_.sweepBudget > 0) sweep();
  if (isReached()) {
    for (int i = 0; i < problem_.contacts(); ++i) best_.activeSet.contacts.push_back(modeOf(i));
  } else if (!isSmall() || !walk()) {
    return false;
  }
  answer = std::move(best_);
  return true;
}

/// u_i = W_i r + q_i.
Vec3 QuickAnswer::velocityOf(int contact) const {
  const DelassusMatrix::Sparse& W = problem_.W.entries();
  const double* entry = W.valuePtr();
  Vec3 u = problem_.q.segment<3>(3 * contact);
  if (approaching_.empty()) return u;  // there are no reactions yet
  if (problem_.W.isFull()) {
    const int n = problem_.size();
    for (int k = 0; k < 3; ++k)
      u[k] += Eigen::Map<const Eigen::VectorXd>(entry + (3 * contact + k) * n, n).dot(best_.r);
    return u;
  }
  const int* begin = W.outerIndexPtr() + 3 * contact;
  const int* column = W.innerIndexPtr();
  const double* r = best_.r.data();
  const int own = 3 * contact;
  const auto isMovedByOthers = [&](int k) {
    return begin[k] < begin[k + 1] &&
           (column[begin[k]] < own || column[begin[k + 1] - 1] > own + 2);
  };
  if (r[own] == 0 && r[own + 1] == 0 && r[own + 2] == 0 && !isMovedByOthers(0) &&
      !isMovedByOthers(1) && !isMovedByOthers(2))
    return u;
  for (int k = 0; k < 3; ++k) {
    double sum = 0;
    for (int at = begin[k]; at < begin[k + 1]; ++at) sum += entry[at] * r[column[at]];
    u[k] += sum;
  }
  return u;
}

const QuickAnswer::Approaching& QuickAnswer::approaching(int contact) {
  if (place_[contact] < 0) {
    place_[contact] = static_cast<int>(approaching_.size());
    const Mat3 W = problem_.W.contactBlock(3 * contact);
    approaching_.push_back({OneContact(W), contactSize(W)});
  }
  return approaching_[place_[contact]];
}

/// Whether those before it in the first sweep have given a contact nearly as much approach as it had: by then it has come no nearer.
bool QuickAnswer::isRocking(int contact, double normalVelocity) const {
  const double approach = problem_.q[3 * contact];
  return best_.sweeps == 0 && isSmall() && approach < 0 && normalVelocity < (2 - gain) * approach;
}

/// Each contact in turn with the others held. Returns by how much the most changed one changed its own velocity, m/s; infinite if
/// it would be no use to go on.
double QuickAnswer::sweepOnce() {
  double change = 0;
  for (int i = 0; i < problem_.contacts(); ++i) {
    const Vec3 u = velocityOf(i);
    if (place_[i] < 0 && u[0] >= 0) continue;
    if (isRocking(i, u[0])) return std::numeric_limits<double>::infinity();
    const Approaching& a = approaching(i);
    if (!(a.block.W()(0, 0) > 0)) continue;  // moves nothing, and keeps its residual
    auto r = best_.r.segment<3>(3 * i);
    const Vec3 next = a.block.solve(u - a.block.W() * r, problem_.friction[i], r);
    change = std::max(change, a.size * a.size * (next - r).squaredNorm());
    r = next;
  }
  ++best_.sweeps;
  return std::sqrt(change);
}

/// As long as each takes away most of what is left; where regions are cheap, two at most. Contacts that feel little of each other,
/// or nothing, need no more.
void QuickAnswer::sweep() {
  constexpr int few = 2;
  const double first = sweepOnce();
  if (!std::isfinite(first)) return;
  measure();
  double before = 2 * first;  // as if from nearer: the first sets out from nothing
  firstGains_ = best_.residual <= gain * first;
  bool gains = !isSmall() || firstGains_;
  while (gains && !isReached() && best_.sweeps < options_.sweepBudget) {
    const double change = sweepOnce(), ratio = change / before;
    gains = ratio <= gain && !(isSmall() && best_.sweeps >= few);
    // The next sweep would change about as much as the residual is now.
    if (!gains || best_.sweeps == options_.sweepBudget || ratio * change <= toleranceFor(demand_))
      measure();
    before = change;
  }
}

void QuickAnswer::measure() {
  best_.residual = 0;
  double squares = 0;
  for (int i = 0; i < problem_.contacts(); ++i) {
    const Vec3 r = best_.r.segment<3>(3 * i), u = velocityOf(i);
    best_.u.segment<3>(3 * i) = u;
    const bool isOpen = u[0] >= 0 && r.isZero(0);
    const double residual =
        isOpen ? 0 : naturalResidual(approaching(i).size, problem_.friction[i], r, u);
    // No number: what moves nothing has no measure of its own, and is not answered here.
    residuals_[i] = std::isfinite(residual) ? residual : std::numeric_limits<double>::infinity();
    best_.residual = std::max(best_.residual, residuals_[i]);
    squares += residuals_[i] * residuals_[i];
  }
  best_.residualRms = std::sqrt(squares / problem_.contacts());
}

/// From region to region: from what the sweeps found, or where the first gained little from no reactions.
bool QuickAnswer::walk() {
  std::vector<Mat3> blocks(problem_.contacts());
  VectorXd sizes(problem_.contacts());
  for (int i = 0; i < problem_.contacts(); ++i) {
    blocks[i] = approaching(i).block.W();
    sizes[i] = approaching(i).size;
  }
  NaturalMap map;
  map.setProblem(problem_, std::move(blocks), sizes);
  if (!fitsDenseNewton(problem_, map)) return false;
  Solution answer = best_;
  if (!firstGains_) {
    answer.r.setZero();
    answer.u = problem_.q;
  }
  const bool isFound = DenseNewton<fewUnknowns>().solve(problem_, map, toleranceFor(demand_),
                                                        options_.newtonBudget, answer);
  if (isFound) {
    best_ = std::move(answer);
    readActiveSet(problem_, map.diagonal(), best_.r, best_.u, best_.activeSet);
  } else {
    best_.regions = answer.regions;
    best_.factorisations = answer.factorisations;
  }
  return isFound;
}

bool QuickAnswer::answers(const ProblemParts& parts, int part) const {
  double demand = 0;
  for (int k = 0; k < parts.sizeOf(part); ++k)
    demand = std::max(demand, std::abs(problem_.q[parts.unknown(part, k)]));
  for (int k = 0; k < parts.sizeOf(part); k += 3)
    if (!(residualOf(parts.unknown(part, k) / 3) <= toleranceFor(demand))) return false;
  return true;
}

Mode QuickAnswer::modeOf(int contact) const {
  if (place_[contact] < 0) return Mode::Open;
  return delassus::modeOf(best_.r.segment<3>(3 * contact), best_.u.segment<3>(3 * contact),
                          problem_.friction[contact],
                          approaching_[place_[contact]].block.W().diagonal().mean());
}

}  // namespace delassus
