#include "delassus/coloured_sweeps.h"

#include <algorithm>
#include <cmath>

#include "delassus/flush_to_zero.h"
#include "delassus/hands.h"
#include "delassus/lanes.h"
#include "delassus/length.h"

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

/// J̃ of the contacts or rows of a group, `count` numbers per body, in their units; zero for a
/// missing body.
template <int count>
class JacobiansOfLanes {
 public:
  /// Also notes the bodies in the group.
  template <class Part, class Group>
  void put(const Part& part, double perUnit, int lane, Group& g) {
    put(part.a, part.Ja, perUnit, a_[lane], g.a[lane]);
    put(part.b, part.Jb, perUnit, b_[lane], g.b[lane]);
  }
  template <class Group>
  void turnOver(Group& g) const {
    turnOver(a_, g.Ja);
    turnOver(b_, g.Jb);
  }

 private:
  static constexpr int padded = (count + 3) / 4 * 4;  ///< four numbers at a time are transposed
  using Jacobians = float[lanes][padded];

  template <class Rows>
  static void put(int body, const Rows& J, double perUnit, float* to, int& place) {
    if (body < 0) return;
    place = body;
    for (int k = 0; k < count; ++k) to[k] = static_cast<float>(perUnit * J.data()[k]);
  }
  static void turnOver(const Jacobians& from, Lanes* to) {
    const float* rows[lanes];
    for (int lane = 0; lane < lanes; ++lane) rows[lane] = from[lane];
    for (int k = 0; k < count; k += 4) {
      Lanes4 low[4], high[4];
      gather(rows, k, low);
      gather(rows + 4, k, high);
      for (int i = 0; i < 4 && k + i < count; ++i) {
        store(low[i], to[k + i]);
        store(high[i], to[k + i] + 4);
      }
    }
  }

  Jacobians a_ = {}, b_ = {};
};

void fill(const Problem& problem, const NaturalMap& map, ContactGroup& g) {
  const BodySpace& space = problem.W.bodySpace();
  JacobiansOfLanes<18> jacobians;
  for (int lane = 0; lane < lanes; ++lane) {
    const int i = g.at[lane];
    if (i == vacant) {  // the lane acts as a contact that stays open
      for (int k = 0; k < 3; ++k) g.compliance[k][lane] = 0;
      g.w1[lane] = g.w2[lane] = g.s01[lane] = g.friction[lane] = 0;
      g.s00[lane] = g.s11[lane] = g.perDet[lane] = g.unit[lane] = 1;
      continue;
    }
    const Mat3& W = map.contactBlock(i);
    const double per = 1 / W(0, 0), unit = std::sqrt(W(0, 0));
    jacobians.put(space.contacts[i], unit * per, lane, g);
    g.unit[lane] = static_cast<float>(unit);
    for (int k = 0; k < 3; ++k)
      g.compliance[k][lane] = static_cast<float>(per * space.compliance[3 * i + k]);
    const double w1 = W(1, 0) * per, w2 = W(2, 0) * per;
    const double s00 = W(1, 1) * per - w1 * w1, s01 = W(1, 2) * per - w1 * w2,
                 s11 = W(2, 2) * per - w2 * w2;
    g.w1[lane] = static_cast<float>(w1);
    g.w2[lane] = static_cast<float>(w2);
    g.s00[lane] = static_cast<float>(s00);
    g.s01[lane] = static_cast<float>(s01);
    g.s11[lane] = static_cast<float>(s11);
    g.perDet[lane] = static_cast<float>(1 / (s00 * s11 - s01 * s01));
    g.friction[lane] = static_cast<float>(problem.friction[i]);
  }
  jacobians.turnOver(g);
}

void fill(const Problem& problem, const NaturalMap& map, RowGroup& g) {
  const BodySpace& space = problem.W.bodySpace();
  JacobiansOfLanes<6> jacobians;
  for (int lane = 0; lane < lanes; ++lane) {
    const int at = g.at[lane];
    if (at == vacant) {
      g.compliance[lane] = 0;
      g.unit[lane] = 1;
      continue;
    }
    const double W = map.diagonal()[at], unit = std::sqrt(W);
    jacobians.put(space.rows[at - 3 * problem.contacts()], 1 / unit, lane, g);
    g.unit[lane] = static_cast<float>(unit);
    g.compliance[lane] = static_cast<float>(space.compliance[at] / W);
  }
  jacobians.turnOver(g);
}

}  // namespace

bool ColouredSweeps::setProblem(const Problem& problem, const NaturalMap& map) {
  constexpr double least = 1e-6;
  problem_ = &problem;
  if (!problem.W.inBodySpace() || !problem.disks.empty() || !problem.W.bodySpace().parts.empty())
    return false;
  for (int i = 0; i < problem.contacts(); ++i) {
    const Mat3& W = map.contactBlock(i);
    if (!(W(0, 0) > 0)) continue;
    const Mat2 S = W.bottomRightCorner<2, 2>() -
                   W.bottomLeftCorner<2, 1>() * W.topRightCorner<1, 2>() / W(0, 0);
    const double trace = S.trace(), det = S(0, 0) * S(1, 1) - S(0, 1) * S(1, 0);
    if (!(trace > least * W(0, 0) && det > least * trace * trace)) return false;
  }
  placeContacts(map);
  placeRows(map);
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
  putInPlace(0, contactColours_, map, contacts_);
}

void ColouredSweeps::placeRows(const NaturalMap& map) {
  const BodySpace& space = problem_->W.bodySpace();
  const int begin = 3 * problem_->contacts();
  const auto of = [&](int i) { return map.diagonal()[begin + i] > 0 ? &space.rows[i] : nullptr; };
  place(problem_->rows(), of, rowColours_);
  putInPlace(begin, rowColours_, map, rows_);
}

/// Fills the groups with all that `place` has found a place for; the index of the first is `begin`.
template <class Group>
void ColouredSweeps::putInPlace(int begin, const Colours& colours, const NaturalMap& map,
                                std::vector<Group>& groups) {
  groups.resize(colours.back());
  clear(problem_->W.bodySpace().bodies, colours, groups);
  for (std::size_t i = 0; i < placeOf_.size(); ++i)
    if (const int place = placeOf_[i]; place != unplaced)
      groups[place / lanes].at[place % lanes] = begin + static_cast<int>(i);
  for (Group& g : groups) fill(*problem_, map, g);
}

void ColouredSweeps::startContacts(const VectorXd& r, const VectorXd& u) {
  for (ContactGroup& g : contacts_)
    for (int lane = 0; lane < lanes; ++lane) {
      const int i = g.at[lane];
      Vec3 r0 = Vec3::Zero(), u0 = Vec3::UnitX();
      double friction = 0;
      if (i != vacant) {
        const double unit = g.unit[lane], perUnit = 1 / unit;
        r0 = unit * r.segment<3>(3 * i);
        u0 = perUnit * u.segment<3>(3 * i);
        friction = problem_->friction[i];
      }
      const double braked = lengthOf(r0[1], r0[2]);
      for (int k = 0; k < 3; ++k) {
        g.r0[k][lane] = static_cast<float>(r0[k]);
        g.u0[k][lane] = static_cast<float>(u0[k]);
        g.dr[k][lane] = g.drBefore[k][lane] = 0;
      }
      g.length0[lane] = static_cast<float>(braked);
      g.margin0[lane] = static_cast<float>(friction * r0[0] - braked);
      const double slip = braked > 0 ? lengthOf(u0[1], u0[2]) / braked : 0;
      const float s = g.slip0[lane] = static_cast<float>(std::min<double>(slip, mostSlip));
      g.dslip[lane] = 0;
      g.unslowed0[0][lane] = static_cast<float>(u0[1] - g.w1[lane] * u0[0] + s * r0[1]);
      g.unslowed0[1][lane] = static_cast<float>(u0[2] - g.w2[lane] * u0[0] + s * r0[2]);
    }
}

void ColouredSweeps::startRows(const VectorXd& r, const VectorXd& u) {
  for (RowGroup& g : rows_)
    for (int lane = 0; lane < lanes; ++lane) {
      const int i = g.at[lane], row = i - 3 * problem_->contacts();
      const bool isThere = i != vacant;
      const double unit = g.unit[lane];
      g.u0[lane] = isThere ? static_cast<float>(u[i] / unit) : 0;
      g.lower[lane] = isThere ? static_cast<float>(unit * (problem_->lower[row] - r[i])) : 0;
      g.upper[lane] = isThere ? static_cast<float>(unit * (problem_->upper[row] - r[i])) : 0;
      g.dr[lane] = g.drBefore[lane] = 0;
    }
}

struct ColouredSweeps::Pass {
  Pass(int mostSweeps, double aimedChange, bool withMomentum, bool isNarrow)
      : most(mostSweeps),
        aim(aimedChange),
        hasMomentum(withMomentum),
        sweeps(groupSweeps(isNarrow)) {}

  const int most;
  const double aim;
  const bool hasMomentum;
  const GroupSweeps sweeps;
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
/// each colour of contacts has a round, then each colour of rows.
void ColouredSweeps::work(Pass& pass, int round, int share) {
  const auto contactColours = static_cast<int>(contactColours_.size()) - 1;
  if (round == 0) {
    const auto bodies = static_cast<int>(velocities_.size());
    for (int k = partBegin(bodies, share, shares); k < partBegin(bodies, share + 1, shares); ++k)
      velocities_[k].goOn(pass.beta);
  } else if (round <= contactColours) {
    sweepShare(pass, round - 1, share, contactColours_, contacts_, pass.sweeps.contacts);
  } else {
    sweepShare(pass, round - 1 - contactColours, share, rowColours_, rows_, pass.sweeps.rows);
  }
}

/// Makes one sweep after the other; `inShares` does all shares of a round.
template <class InShares>
void ColouredSweeps::lead(Pass& pass, const InShares& inShares) {
  const auto rounds = static_cast<int>(contactColours_.size() + rowColours_.size()) - 1;
  do {
    for (int round = 0; round < rounds; ++round) inShares(round);
  } while (pass.goOn());
}

int ColouredSweeps::sweep(int most, double aim, const VectorXd& u, VectorXd& r) {
  if (most <= 0) return 0;
  Pass pass(most, aim, true, isNarrow_);
  sweepAs(pass, u, r);
  return pass.made;
}

void ColouredSweeps::sweepPlainly(int count, VectorXd& r) {
  // If each sweep adds little, the change after this many sweeps is large for single precision.
  constexpr int fromOneStart = 100;
  for (int left = count; left > 0; left -= fromOneStart) {
    Pass pass(std::min(left, fromOneStart), 0, false, isNarrow_);
    problem_->W.multiply(r, y_, u_);
    u_ += problem_->q;
    sweepAs(pass, u_, r);
  }
}

void ColouredSweeps::sweepAs(Pass& pass, const VectorXd& u, VectorXd& r) {
  constexpr int worthwhile = 1000;  // parts; fewer are swept before other hands have come
  startContacts(r, u);
  startRows(r, u);
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
    hands_->together(
        [](const void* context, int hand) { (*static_cast<decltype(&task)>(context))(hand); },
        &task);
  }
  finish(r);
}

void ColouredSweeps::finish(VectorXd& r) const {
  for (const ContactGroup& g : contacts_)
    for (int lane = 0; lane < lanes; ++lane)
      for (int k = 0; k < 3 && g.at[lane] != vacant; ++k)
        r[3 * g.at[lane] + k] += double(g.dr[k][lane]) / g.unit[lane];
  for (const RowGroup& g : rows_)
    for (int lane = 0; lane < lanes; ++lane)
      if (g.at[lane] != vacant) r[g.at[lane]] += double(g.dr[lane]) / g.unit[lane];
  makeFeasible(*problem_, r);
}

}  // namespace delassus
