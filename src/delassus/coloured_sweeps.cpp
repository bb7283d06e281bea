#include "delassus/coloured_sweeps.h"

#include <algorithm>
#include <cmath>

#include "delassus/lanes.h"

namespace delassus {
namespace {

using Group = ColouredSweeps::Group;
using RowGroup = ColouredSweeps::RowGroup;
using Velocity = ColouredSweeps::Velocity;
constexpr int lanes = ColouredSweeps::lanes, none = ColouredSweeps::none;

/// Of one sweep.
struct Change {
  float energy[lanes] = {};   ///< ‖g(x) − x‖², in the units of the contacts
  float largest[lanes] = {};  ///< of a velocity, m/s
};

/// μ r_n − ‖r_t‖ of the reactions r₀ + d, worked out from that of r₀: what rounding takes from it is a share of d, not of r. And ‖r_t‖.
template <class V>
DELASSUS_WIDE_INLINE void marginOf(const Group& g, int at, const V& friction, const V (&r0)[3],
                                   const V (&d)[3], V& margin, V& length) {
  constexpr float tiny = 1e-30f;
  V length0, margin0;
  load(g.length0 + at, length0);
  load(g.margin0 + at, margin0);
  const V t1 = r0[1] + d[1], t2 = r0[2] + d[2];
  squareRoot(t1 * t1 + t2 * t2, length);
  const V sum = length + length0;
  margin = margin0 + friction * d[0] -
           ((t1 + r0[1]) * d[1] + (t2 + r0[2]) * d[2]) / (sum > tiny ? sum : V{} + tiny);
}

/// The sliding reaction of OneContact for the s that is known, brought to the edge of the cone, and then a Newton step of the search
/// for s: the next sweep is as good as a second step. u: the velocity with the reactions r₀ + x; the answer is r₀ + next.
template <class V, class Flags>
DELASSUS_WIDE_INLINE void slide(Group& g, int at, const Flags& slides, const V& friction,
                                const V (&r0)[3], const V (&x)[3], const V (&u)[3], V (&next)[3]) {
  const V zero = {};
  V w1, w2, s00, s01, s11, s;
  load(g.w1 + at, w1), load(g.w2 + at, w2);
  load(g.s00 + at, s00), load(g.s01 + at, s01), load(g.s11 + at, s11);
  load(g.slip + at, s);
  const V known = s;
  const V r1 = r0[1] + x[1], r2 = r0[2] + x[2];
  const V v1 = u[1] - w1 * u[0], v2 = u[2] - w2 * u[0];
  if (any(s <= zero)) {
    // Where the reaction would have the size that the normal allows if it braked straight against c.
    const V held = r0[0] + x[0] + w1 * r1 + w2 * r2 - u[0];
    const V c1 = v1 - (s00 * r1 + s01 * r2), c2 = v2 - (s01 * r1 + s11 * r2);
    V drift;
    squareRoot(c1 * c1 + c2 * c2, drift);
    const V size = drift / (friction * held), e1 = c1 / drift, e2 = c2 / drift;
    const V straight = size * (1 - friction * (w1 * e1 + w2 * e2)) -
                       (e1 * (s00 * e1 + s01 * e2) + e2 * (s01 * e1 + s11 * e2));
    s = s > zero ? s : (straight > zero ? straight : 0.5f * (size + 1));
  }
  constexpr float least = 1e-12f, most = 1e12f;
  s = s < most ? s : zero + most;
  const V p = s00 + s, q = s11 + s, perDet = 1 / (p * q - s01 * s01);
  const V b1 = v1 + s * r1, b2 = v2 + s * r2;  // what is not yet −s r_t
  const V d1 = (s01 * b2 - q * b1) * perDet, d2 = (s01 * b1 - p * b2) * perDet;
  next[0] = x[0] - u[0] - w1 * d1 - w2 * d2;
  next[1] = x[1] + d1;
  next[2] = x[2] + d2;
  V margin, length;
  marginOf(g, at, friction, r0, next, margin, length);
  const V perLength = 1 / (length > least ? length : zero + least);
  const V excess = margin * perLength, share = 1 + excess;
  const V t1 = r0[1] + next[1], t2 = r0[2] + next[2];
  const auto presses = r0[0] + next[0] > zero;
  next[0] = presses ? next[0] : -r0[0];
  next[1] = presses ? next[1] + excess * t1 : -r0[1];
  next[2] = presses ? next[2] + excess * t2 : -r0[2];
  // Newton on 1/‖r_t‖ − 1/(μ r_n), which is nearly linear in s.
  const V m1 = (s01 * t2 - q * t1) * perDet, m2 = (s01 * t1 - p * t2) * perDet;
  const V along = share * perLength;
  const V newton =
      s + excess * share /
              ((t1 * m1 + t2 * m2) * along * along + friction * perLength * (w1 * m1 + w2 * m2));
  const V guess = share < 1 ? 4 * s : 0.25f * s;
  const V then = (presses & (newton > zero)) ? newton : guess;
  s = then > least ? (then < most ? then : zero + most) : zero + least;
  s = slides ? s : known;
  store(s, g.slip + at);
}

/// The contacts of some lanes of a group, from lane `at` on. β: how far their reactions go beyond the last sweep's before this one.
template <class V>
DELASSUS_WIDE_INLINE void sweepLanes(Group& g, int at, float beta, Velocity* velocities,
                                     Change& change) {
  constexpr int count = sizeof(V) / sizeof(float);
  const V zero = {};
  float *a[count], *b[count];
  for (int k = 0; k < count; ++k) {
    a[k] = velocities[g.a[at + k]].y;
    b[k] = velocities[g.b[at + k]].y;
  }
  V ya[8], yb[8], x[3], u[3], r0[3];
  for (int k = 0; k < 8; k += 4) {
    gather(a, k, ya + k);
    gather(b, k, yb + k);
  }
  for (int k = 0; k < 3; ++k) {
    V now, before, compliance;
    load(g.dr[k] + at, now);
    load(g.drBefore[k] + at, before);
    store(now, g.drBefore[k] + at);
    x[k] = now + beta * (now - before);
    load(g.compliance[k] + at, compliance);
    load(g.u0[k] + at, u[k]);
    load(g.r0[k] + at, r0[k]);
    u[k] += compliance * x[k];
  }
  for (int k = 0; k < 3; ++k) {
    V sum[4], of;
    load(g.Ja[6 * k] + at, of), sum[0] = of * ya[0];
    load(g.Ja[6 * k + 1] + at, of), sum[1] = of * ya[1];
    load(g.Jb[6 * k] + at, of), sum[2] = of * yb[0];
    load(g.Jb[6 * k + 1] + at, of), sum[3] = of * yb[1];
    for (int i = 2; i < 6; ++i) {
      load(g.Ja[6 * k + i] + at, of);
      sum[i % 2] += of * ya[i];
      load(g.Jb[6 * k + i] + at, of);
      sum[2 + i % 2] += of * yb[i];
    }
    u[k] += (sum[0] + sum[1]) + (sum[2] + sum[3]);
  }
  V w1, w2, s00, s01, s11, perDet, friction;
  load(g.w1 + at, w1), load(g.w2 + at, w2);
  load(g.s00 + at, s00), load(g.s01 + at, s01), load(g.s11 + at, s11);
  load(g.perDet + at, perDet), load(g.friction + at, friction);
  // What would stop it.
  const V v1 = u[1] - w1 * u[0], v2 = u[2] - w2 * u[0];
  const V d1 = (s01 * v2 - s11 * v1) * perDet, d2 = (s01 * v1 - s00 * v2) * perDet;
  const V stuck[3] = {x[0] - u[0] - w1 * d1 - w2 * d2, x[1] + d1, x[2] + d2};
  V margin, length;
  marginOf(g, at, friction, r0, stuck, margin, length);
  const V push = x[0] - u[0] + w1 * (r0[1] + x[1]) + w2 * (r0[2] + x[2]);
  const auto opens = r0[0] + push <= zero, rubs = friction > zero;
  const auto sticks = rubs & ~opens & (r0[0] + stuck[0] > zero) & (margin >= zero);
  V next[3];
  for (int k = 0; k < 3; ++k) next[k] = sticks ? stuck[k] : -r0[k];
  next[0] = opens | rubs ? next[0] : push;
  const auto slides = rubs & ~sticks & ~opens;
  if (any(slides)) {
    V sliding[3];
    slide(g, at, slides, friction, r0, x, u, sliding);
    for (int k = 0; k < 3; ++k) next[k] = slides ? sliding[k] : next[k];
  }
  V energy, largest, unit;
  load(change.energy + at, energy);
  load(change.largest + at, largest);
  load(g.unit + at, unit);
  for (int k = 0; k < 3; ++k) {
    store(next[k], g.dr[k] + at);
    const V d = next[k] - x[k], speed = unit * (d < zero ? -d : d);
    energy += d * d;
    largest = speed > largest ? speed : largest;
    V of;
    for (int i = 0; i < 6; ++i) {
      load(g.Ja[6 * k + i] + at, of);
      ya[i] += of * d;
      load(g.Jb[6 * k + i] + at, of);
      yb[i] += of * d;
    }
  }
  store(energy, change.energy + at);
  store(largest, change.largest + at);
  for (int k = 0; k < 8; k += 4) {
    scatter(ya + k, a, k);
    scatter(yb + k, b, k);
  }
}

template <class V>
DELASSUS_WIDE_INLINE void sweepLanes(RowGroup& g, int at, float beta, Velocity* velocities,
                                     Change& change) {
  constexpr int count = sizeof(V) / sizeof(float);
  const V zero = {};
  float *a[count], *b[count];
  for (int k = 0; k < count; ++k) {
    a[k] = velocities[g.a[at + k]].y;
    b[k] = velocities[g.b[at + k]].y;
  }
  V ya[8], yb[8], now, before, compliance, u, lower, upper, of;
  for (int k = 0; k < 8; k += 4) {
    gather(a, k, ya + k);
    gather(b, k, yb + k);
  }
  load(g.dr + at, now);
  load(g.drBefore + at, before);
  store(now, g.drBefore + at);
  load(g.compliance + at, compliance);
  load(g.u0 + at, u);
  load(g.lower + at, lower);
  load(g.upper + at, upper);
  const V x = now + beta * (now - before);
  u += compliance * x;
  V sum[2] = {};
  for (int i = 0; i < 6; ++i) {
    load(g.Ja[i] + at, of);
    sum[0] += of * ya[i];
    load(g.Jb[i] + at, of);
    sum[1] += of * yb[i];
  }
  u += sum[0] + sum[1];
  V next = x - u;
  next = next < lower ? lower : next;
  next = next > upper ? upper : next;
  store(next, g.dr + at);
  V energy, largest, unit;
  load(change.energy + at, energy);
  load(change.largest + at, largest);
  load(g.unit + at, unit);
  const V d = next - x, speed = unit * (d < zero ? -d : d);
  energy += d * d;
  largest = speed > largest ? speed : largest;
  store(energy, change.energy + at);
  store(largest, change.largest + at);
  for (int i = 0; i < 6; ++i) {
    load(g.Ja[i] + at, of);
    ya[i] += of * d;
    load(g.Jb[i] + at, of);
    yb[i] += of * d;
  }
  for (int k = 0; k < 8; k += 4) {
    scatter(ya + k, a, k);
    scatter(yb + k, b, k);
  }
}

template <class V, class Groups>
DELASSUS_WIDE_INLINE void sweepGroups(Groups& groups, float beta, Velocity* velocities,
                                      Change& change) {
  constexpr int step = sizeof(V) / sizeof(float);
  for (auto& group : groups)
    for (int at = 0; at < lanes; at += step) sweepLanes<V>(group, at, beta, velocities, change);
}

void sweepByFour(std::vector<Group>& contacts, std::vector<RowGroup>& rows, float beta,
                 Velocity* velocities, Change& change) {
  sweepGroups<Lanes4>(contacts, beta, velocities, change);
  sweepGroups<Lanes4>(rows, beta, velocities, change);
}
#ifdef DELASSUS_HAS_AVX2
__attribute__((target("avx2"))) void sweepByEight(std::vector<Group>& contacts,
                                                  std::vector<RowGroup>& rows, float beta,
                                                  Velocity* velocities, Change& change) {
  sweepGroups<Lanes8>(contacts, beta, velocities, change);
  sweepGroups<Lanes8>(rows, beta, velocities, change);
}
#endif

/// What the processor can do.
auto chooseWidth([[maybe_unused]] bool isNarrow) {
#ifdef DELASSUS_HAS_AVX2
  if (!isNarrow && __builtin_cpu_supports("avx2")) return sweepByEight;
#endif
  return sweepByFour;
}

/// A lane without a contact: one that stays open.
void clear(int body, int lane, Group& g) {
  g.at[lane] = none;
  g.a[lane] = g.b[lane] = body;
  for (int k = 0; k < 18; ++k) g.Ja[k][lane] = g.Jb[k][lane] = 0;
  for (int k = 0; k < 3; ++k) g.compliance[k][lane] = 0;
  g.w1[lane] = g.w2[lane] = g.s01[lane] = g.friction[lane] = 0;
  g.s00[lane] = g.s11[lane] = g.perDet[lane] = g.unit[lane] = 1;
}

/// And one without a row.
void clear(int body, int lane, RowGroup& g) {
  g.at[lane] = none;
  g.a[lane] = g.b[lane] = body;
  for (int k = 0; k < 6; ++k) g.Ja[k][lane] = g.Jb[k][lane] = 0;
  g.compliance[lane] = 0;
  g.unit[lane] = 1;
}

template <class Rows, class Lanes>
void fill(int body, const Rows& J, double perUnit, int lane, int& place, Lanes* of) {
  if (body < 0) return;
  place = body;
  for (int k = 0; k < J.size(); ++k) of[k][lane] = static_cast<float>(perUnit * J.data()[k]);
}

void fill(const Problem& problem, int i, const Mat3& W, int lane, Group& g) {
  const BodySpace& space = problem.W.bodySpace();
  const ContactRows& c = space.contacts[i];
  const double unit = std::sqrt(W(0, 0)), perUnit = 1 / unit, per = 1 / W(0, 0);
  g.at[lane] = i;
  fill(c.a, c.Ja, perUnit, lane, g.a[lane], g.Ja);
  fill(c.b, c.Jb, perUnit, lane, g.b[lane], g.Jb);
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

void fill(const Problem& problem, int row, double W, int lane, RowGroup& g) {
  const BodySpace& space = problem.W.bodySpace();
  const BodySpace::ScalarRow& c = space.rows[row];
  const double unit = std::sqrt(W), perUnit = 1 / unit;
  g.at[lane] = 3 * problem.contacts() + row;
  fill(c.a, c.Ja, perUnit, lane, g.a[lane], g.Ja);
  fill(c.b, c.Jb, perUnit, lane, g.b[lane], g.Jb);
  g.unit[lane] = static_cast<float>(unit);
  g.compliance[lane] = static_cast<float>(space.compliance[g.at[lane]] / W);
}

}  // namespace

bool ColouredSweeps::setProblem(const Problem& problem, const NaturalMap& map) {
  constexpr double least = 1e-6;
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
  placeContacts(problem, map);
  placeRows(problem, map);
  velocities_.resize(problem.W.bodySpace().bodies + 1);
  return true;
}

/// Finds the places of contacts or rows in groups whose bodies are all different, and returns how many groups there are. `of` gives one
/// with its a and b, or null for what nothing moves and has no place.
template <class Of>
int ColouredSweeps::place(int count, const Problem& problem, const Of& of) {
  constexpr int colours = 64;  // what a body has more of come one by one, at the end
  coloursOf_.assign(problem.W.bodySpace().bodies, 0);
  placeOf_.assign(count, none);
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
  for (int k = 0; k <= colours; ++k) {
    next[k] = lanes * groups;
    groups += k < colours ? (countOf[k] + lanes - 1) / lanes : countOf[k];
  }
  for (int& place : placeOf_) {
    if (place == none) continue;
    const int colour = place;
    place = next[colour];
    next[colour] += colour < colours ? 1 : lanes;
  }
  return groups;
}

void ColouredSweeps::placeContacts(const Problem& problem, const NaturalMap& map) {
  const BodySpace& space = problem.W.bodySpace();
  groups_.resize(place(problem.contacts(), problem, [&](int i) {
    return map.diagonal()[3 * i] > 0 ? &space.contacts[i] : nullptr;
  }));
  for (Group& g : groups_)
    for (int lane = 0; lane < lanes; ++lane) clear(space.bodies, lane, g);
  for (int i = 0; i < problem.contacts(); ++i)
    if (placeOf_[i] != none)
      fill(problem, i, map.contactBlock(i), placeOf_[i] % lanes, groups_[placeOf_[i] / lanes]);
}

void ColouredSweeps::placeRows(const Problem& problem, const NaturalMap& map) {
  const BodySpace& space = problem.W.bodySpace();
  const double* W = map.diagonal().data() + 3 * problem.contacts();
  rows_.resize(
      place(problem.rows(), problem, [&](int i) { return W[i] > 0 ? &space.rows[i] : nullptr; }));
  for (RowGroup& g : rows_)
    for (int lane = 0; lane < lanes; ++lane) clear(space.bodies, lane, g);
  for (int i = 0; i < problem.rows(); ++i)
    if (placeOf_[i] != none)
      fill(problem, i, W[i], placeOf_[i] % lanes, rows_[placeOf_[i] / lanes]);
}

void ColouredSweeps::start(const Problem& problem, const VectorXd& r) {
  problem.W.multiply(r, y_, u_);
  u_ += problem.q;
  startContacts(problem, r);
  startRows(problem, r);
  std::fill(velocities_.begin(), velocities_.end(), Velocity{});
}

void ColouredSweeps::startContacts(const Problem& problem, const VectorXd& r) {
  for (Group& g : groups_)
    for (int lane = 0; lane < lanes; ++lane) {
      const int i = g.at[lane];
      Vec3 r0 = Vec3::Zero(), u0 = Vec3::UnitX();
      double friction = 0;
      if (i != none) {
        r0 = g.unit[lane] * r.segment<3>(3 * i);
        u0 = u_.segment<3>(3 * i) / g.unit[lane];
        friction = problem.friction[i];
      }
      const double braked = r0.tail<2>().norm();
      for (int k = 0; k < 3; ++k) {
        g.r0[k][lane] = static_cast<float>(r0[k]);
        g.u0[k][lane] = static_cast<float>(u0[k]);
        g.dr[k][lane] = g.drBefore[k][lane] = 0;
      }
      g.length0[lane] = static_cast<float>(braked);
      g.margin0[lane] = static_cast<float>(friction * r0[0] - braked);
      g.slip[lane] = braked > 0 ? static_cast<float>(u0.tail<2>().norm() / braked) : 0;
    }
}

void ColouredSweeps::startRows(const Problem& problem, const VectorXd& r) {
  for (RowGroup& g : rows_)
    for (int lane = 0; lane < lanes; ++lane) {
      const int i = g.at[lane], row = i - 3 * problem.contacts();
      const bool isThere = i != none;
      const double unit = g.unit[lane];
      g.u0[lane] = isThere ? static_cast<float>(u_[i] / unit) : 0;
      g.lower[lane] = isThere ? static_cast<float>(unit * (problem.lower[row] - r[i])) : 0;
      g.upper[lane] = isThere ? static_cast<float>(unit * (problem.upper[row] - r[i])) : 0;
      g.dr[lane] = g.drBefore[lane] = 0;
    }
}

int ColouredSweeps::sweep(const Problem& problem, int most, double aim, VectorXd& r) {
  start(problem, r);
  const auto sweepAll = chooseWidth(isNarrow_);
  float beta = 0;
  double last = 0, pace = 1;
  int made = 0;
  while (made < most) {
    for (Velocity& v : velocities_) v.goOn(beta);
    Change change;
    sweepAll(groups_, rows_, beta, velocities_.data(), change);
    ++made;
    double energy = 0;
    for (const float share : change.energy) energy += share;
    if (*std::max_element(std::begin(change.largest), std::end(change.largest)) <= aim) break;
    if (made == 1 || energy > last) pace = 1;
    const double next = 0.5 * (1 + std::sqrt(1 + 4 * pace * pace));
    beta = static_cast<float>((pace - 1) / next);
    pace = next;
    last = energy;
  }
  for (const Group& g : groups_)
    for (int lane = 0; lane < lanes; ++lane)
      for (int k = 0; k < 3 && g.at[lane] != none; ++k)
        r[3 * g.at[lane] + k] += double(g.dr[k][lane]) / g.unit[lane];
  for (const RowGroup& g : rows_)
    for (int lane = 0; lane < lanes; ++lane)
      if (g.at[lane] != none) r[g.at[lane]] += double(g.dr[lane]) / g.unit[lane];
  makeFeasible(problem, r);
  return made;
}

}  // namespace delassus
