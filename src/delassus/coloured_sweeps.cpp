#include "delassus/coloured_sweeps.h"

#include <algorithm>
#include <cmath>

#include "delassus/flush_to_zero.h"
#include "delassus/hands.h"

namespace delassus {
namespace {

constexpr int unplaced = -1;
constexpr int shares = 8;  ///< of a colour: at most this many hands sweep
/// Where the k-th of `parts` parts of `count` things begins.
int partBegin(int count, int k, int parts) {
  return static_cast<int>(static_cast<long long>(count) * k / parts);
}

/// Empties the groups of some colours. Missing bodies have a place behind the others, one for each
/// share, since hands write there too.
template <class Group>
void clear(int bodies, const std::vector<int>& colours, std::vector<Group>& groups) {
  for (std::size_t k = 1; k < colours.size(); ++k) {
    const int begin = colours[k - 1], count = colours[k] - begin;
    for (int share = 0; share < shares; ++share)
      for (int g = partBegin(count, share, shares); g < partBegin(count, share + 1, shares); ++g) {
        Group& group = groups[begin + g];
        std::fill_n(group.at, lanes, vacant);
        std::fill_n(group.a, lanes, bodies + share);
        std::fill_n(group.b, lanes, bodies + share);
      }
  }
}

}  // namespace

bool ColouredSweeps::setProblem(const Problem& problem, const NaturalMap& map) {
  constexpr double least = 1e-6;
  problem_ = &problem;
  map_ = &map;
  if (!problem.W.inBodySpace() || !problem.W.bodySpace().parts.empty()) return false;
  for (int i = 0; i < problem.contacts(); ++i) {
    const Mat3& W = map.contactBlock(i);
    if (!(W(0, 0) > 0)) continue;
    const Mat2 S = W.bottomRightCorner<2, 2>() -
                   W.bottomLeftCorner<2, 1>() * W.topRightCorner<1, 2>() / W(0, 0);
    const double trace = S.trace(), det = S(0, 0) * S(1, 1) - S(0, 1) * S(1, 0);
    if (!(trace > least * W(0, 0) && det > least * trace * trace)) return false;
  }
  loads_.assign(problem.disks.size(), {});
  const int contactsEnd = 3 * problem.contacts();
  placeContacts(map);
  findLoads(contacts_, [=](int governor) { return governor < contactsEnd ? governor / 3 : -1; });
  placeRows(map);
  findLoads(rows_, [=](int governor) { return governor - contactsEnd; });
  placeDisks(map);
  velocities_.resize(problem.W.bodySpace().bodies + shares);
  return true;
}

/// Finds places for contacts or rows in groups whose bodies are all different, and where the groups
/// of each colour begin. `of` gives a contact or row with its a and b, or null if nothing moves it:
/// then it gets no place.
template <class Of>
void ColouredSweeps::place(int count, const Of& of, Colours& begins) {
  constexpr int colours = 64;  // if a body has more, the rest come one by one at the end
  coloursOf_.assign(problem_->W.bodySpace().bodies, 0);
  placeOf_.assign(count, unplaced);
  int countOf[colours + 1] = {};
  for (int i = 0; i < count; ++i) {
    const auto* c = of(i);
    if (!c) continue;
    const std::uint64_t taken =
        (c->a >= 0 ? coloursOf_[c->a] : 0) | (c->b >= 0 ? coloursOf_[c->b] : 0);
    int colour = 0;
    while (colour < colours && (taken >> colour & 1)) ++colour;
    placeOf_[i] = colour;
    ++countOf[colour];
    if (colour == colours) continue;
    if (c->a >= 0) coloursOf_[c->a] |= std::uint64_t(1) << colour;
    if (c->b >= 0) coloursOf_[c->b] |= std::uint64_t(1) << colour;
  }
  int next[colours + 1], groups = 0;
  begins.assign(1, 0);
  for (int k = 0; k < colours; ++k) {
    next[k] = lanes * groups;
    groups += (countOf[k] + lanes - 1) / lanes;
    if (countOf[k] > 0) begins.push_back(groups);
  }
  next[colours] = lanes * groups;
  for (int k = 0; k < countOf[colours]; ++k) begins.push_back(++groups);
  for (int& place : placeOf_) {
    if (place == unplaced) continue;
    const int colour = place;
    place = next[colour];
    next[colour] += colour < colours ? 1 : lanes;
  }
}

void ColouredSweeps::placeContacts(const NaturalMap& map) {
  const BodySpace& space = problem_->W.bodySpace();
  const auto of = [&](int i) { return map.diagonal()[3 * i] > 0 ? &space.contacts[i] : nullptr; };
  place(problem_->contacts(), of, contactColours_);
  putInPlace(0, contactColours_, contacts_);
  for (ContactGroup& g : contacts_) fill(*problem_, map, g);
}

void ColouredSweeps::placeRows(const NaturalMap& map) {
  const BodySpace& space = problem_->W.bodySpace();
  const int begin = 3 * problem_->contacts();
  const auto of = [&](int i) { return map.diagonal()[begin + i] > 0 ? &space.rows[i] : nullptr; };
  place(problem_->plainRows(), of, rowColours_);
  putInPlace(begin, rowColours_, rows_);
  for (RowGroup& g : rows_) fill(*problem_, map, g);
}

void ColouredSweeps::placeDisks(const NaturalMap& map) {
  const BodySpace& space = problem_->W.bodySpace();
  const auto of = [&](int k) -> const ScalarRow* {
    const Disk& disk = problem_->disks[k];
    const bool moves = map.diagonal().segment(disk.first, disk.unknowns).maxCoeff() > 0;
    return moves ? &space.rows[disk.first - 3 * problem_->contacts()] : nullptr;
  };
  place(static_cast<int>(problem_->disks.size()), of, diskColours_);
  putInPlace(0, diskColours_, disks_);
  for (DiskGroup& g : disks_) fill(*problem_, loads_, g);
}

/// Notes the loads of disks that `place` has put in these groups. `indexOf`: the index of a contact
/// or row, from its unknown; negative for others.
template <class Group, class IndexOf>
void ColouredSweeps::findLoads(const std::vector<Group>& groups, const IndexOf& indexOf) {
  for (std::size_t k = 0; k < loads_.size(); ++k) {
    const int index = indexOf(problem_->disks[k].governor);
    const int place = index >= 0 ? placeOf_[index] : unplaced;
    if (place == unplaced) continue;
    const Group& g = groups[place / lanes];
    loads_[k] = loadIn(g, place % lanes);
  }
}

/// Puts all that `place` has found a place for into the groups; the index of the first is `begin`.
template <class Group>
void ColouredSweeps::putInPlace(int begin, const Colours& colours, std::vector<Group>& groups) {
  groups.resize(colours.back());
  clear(problem_->W.bodySpace().bodies, colours, groups);
  for (std::size_t i = 0; i < placeOf_.size(); ++i)
    if (const int place = placeOf_[i]; place != unplaced)
      groups[place / lanes].at[place % lanes] = begin + static_cast<int>(i);
}

struct ColouredSweeps::Pass {
  Pass(int mostSweeps, bool withMomentum, bool isNarrow)
      : most(mostSweeps), hasMomentum(withMomentum), sweeps(groupSweeps(isNarrow)) {}

  const int most;
  const bool hasMomentum;
  const GroupSweeps sweeps;
  double aim = 0;               ///< times the scale
  SweepChange changes[shares];  ///< by share, whichever hand sweeps it
  float beta = 0;
  double last = 0, pace = 1;
  int made = 0;

  /// Called after a sweep: sets how far the next one goes beyond it. False if it was the last.
  bool goOn() {
    ++made;
    double energy = 0, largest = 0;
    for (SweepChange& change : changes) {
      for (const float share : change.energy) energy += share;
      for (const float share : change.largest) largest = std::max<double>(largest, share);
      change = {};
    }
    if (!hasMomentum || made == 1 || energy > last) pace = 1;
    const double next = 0.5 * (1 + std::sqrt(1 + 4 * pace * pace));
    beta = static_cast<float>((pace - 1) / next);
    pace = next;
    last = energy;
    return made < most && largest > aim;
  }
};

template <class Group>
void ColouredSweeps::sweepShare(Pass& pass, int colour, int share, const Colours& colours,
                                std::vector<Group>& groups, SweepGroups<Group> sweep) {
  const int begin = colours[colour], count = colours[colour + 1] - begin;
  const int from = partBegin(count, share, shares), to = partBegin(count, share + 1, shares);
  if (from < to)
    sweep(&groups[begin + from], to - from, pass.beta, velocities_.data(), pass.changes[share]);
}

/// Does one share of one round of a sweep. In the first round the velocities are extrapolated, then
/// each colour of contacts has a round, then each colour of rows, then each of disks.
void ColouredSweeps::work(Pass& pass, int round, int share) {
  const auto contactColours = static_cast<int>(contactColours_.size()) - 1;
  const auto rowsEnd = contactColours + static_cast<int>(rowColours_.size()) - 1;
  if (round == 0) {
    const auto bodies = static_cast<int>(velocities_.size());
    for (int k = partBegin(bodies, share, shares); k < partBegin(bodies, share + 1, shares); ++k)
      velocities_[k].goOn(pass.beta);
  } else if (round <= contactColours) {
    sweepShare(pass, round - 1, share, contactColours_, contacts_, pass.sweeps.contacts);
  } else if (round <= rowsEnd) {
    sweepShare(pass, round - 1 - contactColours, share, rowColours_, rows_, pass.sweeps.rows);
  } else {
    sweepShare(pass, round - 1 - rowsEnd, share, diskColours_, disks_, pass.sweeps.disks);
  }
}

/// Makes one sweep after the other; `inShares` does all shares of a round.
template <class InShares>
void ColouredSweeps::lead(Pass& pass, const InShares& inShares) {
  const auto rounds =
      static_cast<int>(contactColours_.size() + rowColours_.size() + diskColours_.size()) - 2;
  do {
    for (int round = 0; round < rounds; ++round) inShares(round);
  } while (pass.goOn());
}

int ColouredSweeps::sweep(int most, double aim, const VectorXd& u, VectorXd& r) {
  if (most <= 0) return 0;
  Pass pass(most, true, isNarrow_);
  sweepAs(pass, aim, u, r);
  return pass.made;
}

void ColouredSweeps::sweepPlainly(int count, VectorXd& r) {
  // If each sweep adds little, the change after this many sweeps is large for single precision.
  constexpr int fromOneStart = 100;
  for (int left = count; left > 0; left -= fromOneStart) {
    Pass pass(std::min(left, fromOneStart), false, isNarrow_);
    problem_->W.multiply(r, y_, u_);
    u_ += problem_->q;
    sweepAs(pass, 0, u_, r);
  }
}

/// A power of two (it changes no digit) by which the largest r √W and u / √W are between 1 and 2.
double ColouredSweeps::scaleFor(const VectorXd& u, const VectorXd& r) const {
  double largest = 0;
  for (int k = 0; k < problem_->size(); ++k)
    if (const double W = map_->diagonal()[k]; W > 0)
      largest = std::max({largest, std::abs(r[k]) * std::sqrt(W), std::abs(u[k]) / std::sqrt(W)});
  return largest > 0 && std::isfinite(largest) ? std::ldexp(1, -std::ilogb(largest)) : 1;
}

void ColouredSweeps::sweepAs(Pass& pass, double aim, const VectorXd& u, VectorXd& r) {
  constexpr int worthwhile = 1000;  // parts; fewer are swept before other hands have come
  const double scale = scaleFor(u, r);
  pass.aim = scale * aim;
  const auto startAll = [&](auto& groups) {
    for (auto& g : groups) start(*problem_, r, u, scale, g);
  };
  startAll(contacts_);
  startAll(rows_);
  startAll(disks_);
  std::fill(velocities_.begin(), velocities_.end(), SweptVelocity{});
  const auto part = [&](int round, int share) { work(pass, round, share); };
  if (!hands_ || problem_->parts() < worthwhile) {
    const FlushToZero quick;
    lead(pass, [&](int round) {
      for (int share = 0; share < shares; ++share) part(round, share);
    });
  } else {
    Rounds rounds;
    const auto task = [&](int hand) {
      const FlushToZero quick;
      if (hand > 0) return rounds.help(part);
      lead(pass, [&](int round) { rounds.lead(round, shares, part); });
      rounds.end();
    };
    hands_->together(task);
  }
  finish(scale, r);
}

void ColouredSweeps::finish(double scale, VectorXd& r) const {
  for (const ContactGroup& g : contacts_)
    for (int lane = 0; lane < lanes; ++lane)
      for (int k = 0; k < 3 && g.at[lane] != vacant; ++k)
        r[3 * g.at[lane] + k] += double(g.dr[k][lane]) / (scale * g.unit[lane]);
  for (const RowGroup& g : rows_)
    for (int lane = 0; lane < lanes; ++lane)
      if (g.at[lane] != vacant) r[g.at[lane]] += double(g.dr[lane]) / (scale * g.unit[lane]);
  for (const DiskGroup& g : disks_)
    for (int lane = 0; lane < lanes; ++lane)
      if (g.at[lane] != vacant) {
        const Disk& disk = problem_->disks[g.at[lane]];
        const Vec2 change(g.dr[0][lane], g.dr[1][lane]);
        disk.put(disk.of(r) + change / (scale * g.unit[lane]), r);
      }
  makeFeasible(*problem_, r);
}

}  // namespace delassus
