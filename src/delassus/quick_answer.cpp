#include "delassus/quick_answer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "delassus/dense_newton.h"
#include "delassus/read_mode.h"
#include "delassus/row_product.h"
#include "delassus/tolerance.h"

namespace delassus {
namespace {

constexpr double gain = 0.2;  ///< share of the residual that a good sweep leaves

}  // namespace

QuickAnswer::QuickAnswer(const Problem& problem, const Options& options)
    : problem_(problem),
      options_(options),
      friction_(problem.friction.maxCoeff()),
      tolerance_(toleranceOf(options, problem)),
      isFull_(problem.W.isFull()),
      contacts_(problem.contacts()) {
  for (int i = 0; i < problem.contacts(); ++i) contacts_[i].isAlone = isAlone(i);
  approaching_.reserve(problem.contacts());
  best_.start(problem.q);
  best_.tier = Tier::Walk;
}

bool QuickAnswer::isSmall() const { return problem_.size() <= fewUnknowns; }

bool QuickAnswer::find(Solution& answer) {
  if (options_.sweepBudget > 0) sweep();
  if (isReached()) {
    best_.activeSet.contacts.resize(problem_.contacts());
    for (int i = 0; i < problem_.contacts(); ++i) best_.activeSet.contacts[i] = modeOf(i);
  } else if (!isSmall() || !walk()) {
    // What a rocking sweep has left, or no sweeps.
    if (isSmall() && !std::isfinite(best_.residual)) measure();
    return false;
  }
  answer = std::move(best_);
  return true;
}

/// Whether all entries of its rows are in its own block; columns ascend.
bool QuickAnswer::isAlone(int contact) const {
  if (isFull_) return problem_.contacts() == 1;
  const DelassusMatrix::Sparse& W = problem_.W.entries();
  const int own = 3 * contact, *begin = W.outerIndexPtr() + own, *column = W.innerIndexPtr();
  for (int k = 0; k < 3; ++k)
    if (begin[k] < begin[k + 1] && (column[begin[k]] < own || column[begin[k + 1] - 1] > own + 2))
      return false;
  return true;
}

/// u_i = W_i r + q_i.
Vec3 QuickAnswer::velocityOf(int contact) const {
  Vec3 u = problem_.q.segment<3>(3 * contact);
  if (approaching_.empty()) return u;  // there are no reactions yet
  const Contact& c = contacts_[contact];
  if (c.isAlone) {
    if (c.place >= 0) u += approaching_[c.place].block.W() * best_.r.segment<3>(3 * contact);
    return u;
  }
  const DelassusMatrix::Sparse& W = problem_.W.entries();
  const int* begin = W.outerIndexPtr() + 3 * contact;
  const double *entry = W.valuePtr(), *r = best_.r.data();
  if (isFull_) return u + timesRows(entry + begin[0], problem_.size(), r, problem_.size());
  const int* column = W.innerIndexPtr();
  for (int k = 0; k < 3; ++k) {
    double sum = 0;
    for (int at = begin[k]; at < begin[k + 1]; ++at) sum += entry[at] * r[column[at]];
    u[k] += sum;
  }
  return u;
}

/// W_aa. The rows of a contact that is alone hold nothing else, and if all nine entries are stored,
/// they are in one piece.
Mat3 QuickAnswer::blockOf(int contact) const {
  const DelassusMatrix::Sparse& W = problem_.W.entries();
  const int* begin = W.outerIndexPtr() + 3 * contact;
  if (contacts_[contact].isAlone && begin[3] - begin[0] == 9)
    return Eigen::Map<const Mat3>(W.valuePtr() + begin[0]).transpose();
  return problem_.W.contactBlock(3 * contact);
}

const QuickAnswer::Approaching& QuickAnswer::approaching(int contact) {
  int& place = contacts_[contact].place;
  if (place < 0) {
    place = static_cast<int>(approaching_.size());
    approaching_.emplace_back(blockOf(contact));
  }
  return approaching_[place];
}

double QuickAnswer::sizeOf(int contact) {
  approaching(contact);
  Approaching& a = approaching_[contacts_[contact].place];
  if (a.size == 0) a.size = contactSize(a.block.W());
  return a.size;
}

/// Whether earlier contacts of the first sweep have added nearly as much approach to a contact as
/// it had: then the sweep has not come nearer to an answer.
bool QuickAnswer::isRocking(int contact, double normalVelocity) const {
  const double approach = problem_.q[3 * contact];
  return best_.sweeps == 0 && isSmall() && approach < 0 && normalVelocity < (2 - gain) * approach;
}

/// Solves each contact in turn with the others held. Returns the largest change that a contact made
/// to its own velocity, m/s; infinite if it would be no use to go on.
double QuickAnswer::sweepOnce() {
  double change = 0;
  for (int i = 0; i < problem_.contacts(); ++i) {
    if (staysApart(i)) continue;
    const Vec3 u = velocityOf(i);
    if (contacts_[i].place < 0 && u[0] >= 0) continue;
    if (isRocking(i, u[0])) return infinity;
    if (best_.sweeps == 0)
      felt_ = std::max(felt_, (u - problem_.q.segment<3>(3 * i)).cwiseAbs().maxCoeff());
    const Approaching& a = approaching(i);
    if (!(a.block.W()(0, 0) > 0)) continue;  // it moves nothing, and keeps its residual
    auto r = best_.r.segment<3>(3 * i);
    const Vec3 next = a.block.solve(u - a.block.W() * r, problem_.friction[i], r);
    change = std::max(change, a.squaredNorm * (next - r).squaredNorm());
    r = next;
  }
  ++best_.sweeps;
  return std::sqrt(change);
}

/// Makes sweeps as long as each removes most of the residual; at most two where regions are cheap.
/// Contacts that feel little or nothing of each other need no more.
void QuickAnswer::sweep() {
  constexpr int few = 2;
  const double first = sweepOnce();
  if (!std::isfinite(first)) return;
  // If no contact feels those before it, these do not feel it either: then one sweep is enough.
  if (isSmall() || felt_ <= tolerance_ || best_.sweeps == options_.sweepBudget) measure();
  double before = 2 * first;  // doubled, since the first sweep sets out from nothing
  firstGains_ = best_.residual <= gain * first;
  bool gains = !isSmall() || firstGains_;
  while (gains && !isReached() && best_.sweeps < options_.sweepBudget) {
    const double change = sweepOnce(), ratio = change / before;
    gains = ratio <= gain && !(isSmall() && best_.sweeps >= few);
    // The change by the next sweep would be about as large as the residual is now.
    if (!gains || best_.sweeps == options_.sweepBudget || ratio * change <= tolerance_) measure();
    before = change;
  }
}

void QuickAnswer::measure() {
  best_.residual = 0;
  double squares = 0;
  for (int i = 0; i < problem_.contacts(); ++i) {
    if (staysApart(i)) {
      contacts_[i].residual = 0;
      continue;
    }
    const Vec3 r = best_.r.segment<3>(3 * i), u = velocityOf(i);
    best_.u.segment<3>(3 * i) = u;
    const bool isOpen = u[0] >= 0 && r[0] == 0 && r[1] == 0 && r[2] == 0;
    double& residual = contacts_[i].residual;
    residual = isOpen ? 0 : naturalResidual(sizeOf(i), problem_.friction[i], r, u);
    if (!std::isfinite(residual)) residual = infinity;  // some numbers overflow
    best_.residual = std::max(best_.residual, residual);
    squares += residual * residual;
  }
  best_.residualRms = std::sqrt(squares / problem_.contacts());
}

/// Walks from region to region: from the reactions of the sweeps, or, if the first sweep gained
/// little, from no reactions.
bool QuickAnswer::walk() {
  std::vector<Mat3> blocks(problem_.contacts());
  VectorXd sizes(problem_.contacts());
  for (int i = 0; i < problem_.contacts(); ++i) {
    blocks[i] = approaching(i).block.W();
    sizes[i] = sizeOf(i);
  }
  NaturalMap map;
  map.setProblem(problem_, std::move(blocks), sizes);
  if (!fitsDenseNewton(problem_, map)) return false;
  if (!DenseNewton<fewUnknowns>().solve(problem_, map, tolerance_, options_.regionsInVain(),
                                        firstGains_ ? Start::Best : Start::Rest, best_))
    return false;
  readActiveSet(problem_, map.diagonal(), best_.r, best_.u, best_.activeSet);
  return true;
}

bool QuickAnswer::answers(const ProblemParts& parts, int part) const {
  double demand = problem_.leastDemand;
  for (int k = 0; k < parts.sizeOf(part); k += 3) {
    const int at = parts.unknown(part, k);
    demand = std::max(demand, contactDemand(problem_.q.segment<3>(at), problem_.friction[at / 3]));
  }
  const double tolerance = toleranceOf(options_, friction_, demand, problem_.roundOff);
  for (int k = 0; k < parts.sizeOf(part); k += 3)
    if (!(residualOf(parts.unknown(part, k) / 3) <= tolerance)) return false;
  return true;
}

Mode QuickAnswer::modeOf(int contact) const {
  const int place = contacts_[contact].place;
  if (place < 0) return Mode::Open;
  return delassus::modeOf(best_.r.segment<3>(3 * contact), best_.u.segment<3>(3 * contact),
                          problem_.friction[contact],
                          approaching_[place].block.W().diagonal().mean());
}

}  // namespace delassus
