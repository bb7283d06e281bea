#include "delassus/swept_groups.h"

#include "delassus/lanes.h"

namespace delassus {
namespace {

/// The addresses of the velocities of both bodies of some lanes.
template <class V>
struct BodyLanes {
  static constexpr int count = sizeof(V) / sizeof(float);
  float *a[count], *b[count];

  DELASSUS_WIDE_INLINE BodyLanes(const int* as, const int* bs, SweptVelocity* velocities) {
    for (int k = 0; k < count; ++k) {
      a[k] = velocities[as[k]].y;
      b[k] = velocities[bs[k]].y;
    }
  }
  DELASSUS_WIDE_INLINE void gatherTo(V* ya, V* yb) const {
    for (int k = 0; k < 8; k += 4) {
      gather(a, k, ya + k);
      gather(b, k, yb + k);
    }
  }
  /// Transposes ya and yb in place on the way.
  DELASSUS_WIDE_INLINE void scatterFrom(V* ya, V* yb) const {
    for (int k = 0; k < 8; k += 4) {
      scatter(ya + k, a, k);
      scatter(yb + k, b, k);
    }
  }
};

/// Stores reactions, and lets the bodies feel how they differ from x.
template <int count, class V, class Group>
DELASSUS_WIDE_INLINE void react(Group& g, int at, const V (&x)[count], const V (&next)[count],
                                V* ya, V* yb, SweepChange& change) {
  const V zero = {};
  V energy, largest, unit;
  load(change.energy + at, energy);
  load(change.largest + at, largest);
  load(g.unit + at, unit);
  for (int k = 0; k < count; ++k) {
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
}

/// Computes μ r_n − ‖r_t‖ of the reactions r₀ + d from that of r₀, and ‖r_t‖. The rounding error is
/// thus a share of d, not of r.
template <class V>
DELASSUS_WIDE_INLINE void marginOf(const ContactGroup& g, int at, const V& friction,
                                   const V (&r0)[3], const V (&d)[3], V& margin, V& length) {
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

/// The sliding reaction of OneContact for the known s, brought to the edge of the cone. Then s
/// makes one Newton step of its search: the next sweep is as good as a second step. u: the velocity
/// with the reactions r₀ + x; the answer is r₀ + next.
template <class V, class Flags>
DELASSUS_WIDE_INLINE void slide(ContactGroup& g, int at, const Flags& slides, const V& friction,
                                const V (&r0)[3], const V (&x)[3], const V (&u)[3],
                                const V (&du)[3], V (&next)[3]) {
  const V zero = {};
  V w1, w2, s00, s01, s11, s0, ds, b1, b2;
  load(g.w1 + at, w1), load(g.w2 + at, w2);
  load(g.s00 + at, s00), load(g.s01 + at, s01), load(g.s11 + at, s11);
  load(g.slip0 + at, s0), load(g.dslip + at, ds);
  load(g.unslowed0[0] + at, b1), load(g.unslowed0[1] + at, b2);
  const V known = ds;
  V s = s0 + ds;
  const V r1 = r0[1] + x[1], r2 = r0[2] + x[2];
  const V v1 = u[1] - w1 * u[0], v2 = u[2] - w2 * u[0];
  if (any(s <= zero)) {
    // The s at which a reaction straight against c would have the size that the normal one allows.
    const V held = r0[0] + x[0] + w1 * r1 + w2 * r2 - u[0];
    const V c1 = v1 - (s00 * r1 + s01 * r2), c2 = v2 - (s01 * r1 + s11 * r2);
    V drift;
    squareRoot(c1 * c1 + c2 * c2, drift);
    const V size = drift / (friction * held), e1 = c1 / drift, e2 = c2 / drift;
    const V straight = size * (1 - friction * (w1 * e1 + w2 * e2)) -
                       (e1 * (s00 * e1 + s01 * e2) + e2 * (s01 * e1 + s11 * e2));
    ds = s > zero ? ds : (straight > zero ? straight : 0.5f * (size + 1)) - s0;
  }
  constexpr float least = 1e-12f;
  ds = s0 + ds < mostSlip ? ds : mostSlip - s0;
  s = s0 + ds;
  const V p = s00 + s, q = s11 + s, perDet = 1 / (p * q - s01 * s01);
  // v + s r_t, which sliding makes zero. Near s₀ it comes from its value at s₀ and the changes
  // since: in the sum itself the digits that count would cancel.
  const auto isNear = (ds < zero ? -ds : ds) < 0.5f * s0;
  b1 = isNear ? b1 + (du[1] - w1 * du[0] + s0 * x[1] + ds * r1) : v1 + s * r1;
  b2 = isNear ? b2 + (du[2] - w2 * du[0] + s0 * x[2] + ds * r2) : v2 + s * r2;
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
  const V correction =
      excess * share /
      ((t1 * m1 + t2 * m2) * along * along + friction * perLength * (w1 * m1 + w2 * m2));
  const V guess = share < 1 ? 3 * s : -0.75f * s;
  ds += presses & (s + correction > zero) ? correction : guess;
  ds = s0 + ds > least ? (s0 + ds < mostSlip ? ds : mostSlip - s0) : least - s0;
  ds = slides ? ds : known;
  store(ds, g.dslip + at);
}

/// Sweeps over some lanes of a group, from lane `at` on. Before that their reactions go β beyond
/// those of the last sweep.
template <class V>
DELASSUS_WIDE_INLINE void sweepLanes(ContactGroup& g, int at, float beta, SweptVelocity* velocities,
                                     SweepChange& change) {
  const V zero = {};
  const BodyLanes<V> bodies(g.a + at, g.b + at, velocities);
  V ya[8], yb[8], x[3], u[3], du[3], r0[3];
  bodies.gatherTo(ya, yb);
  for (int k = 0; k < 3; ++k) {
    V now, before, compliance;
    load(g.dr[k] + at, now);
    load(g.drBefore[k] + at, before);
    store(now, g.drBefore[k] + at);
    x[k] = now + beta * (now - before);
    load(g.compliance[k] + at, compliance);
    load(g.u0[k] + at, u[k]);
    load(g.r0[k] + at, r0[k]);
    du[k] = compliance * x[k];
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
    du[k] += (sum[0] + sum[1]) + (sum[2] + sum[3]);
    u[k] += du[k];
  }
  V w1, w2, s00, s01, s11, perDet, friction;
  load(g.w1 + at, w1), load(g.w2 + at, w2);
  load(g.s00 + at, s00), load(g.s01 + at, s01), load(g.s11 + at, s11);
  load(g.perDet + at, perDet), load(g.friction + at, friction);
  // The change of r_t that would stop the contact.
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
    slide(g, at, slides, friction, r0, x, u, du, sliding);
    for (int k = 0; k < 3; ++k) next[k] = slides ? sliding[k] : next[k];
  }
  react(g, at, x, next, ya, yb, change);
  bodies.scatterFrom(ya, yb);
}

template <class V>
DELASSUS_WIDE_INLINE void sweepLanes(RowGroup& g, int at, float beta, SweptVelocity* velocities,
                                     SweepChange& change) {
  const V zero = {};
  const BodyLanes<V> bodies(g.a + at, g.b + at, velocities);
  V ya[8], yb[8], now, before, compliance, u, lower, upper, of;
  bodies.gatherTo(ya, yb);
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
  bodies.scatterFrom(ya, yb);
}

/// Sweeps over disks: r ← r − W⁻¹ u, or where that is outside, the r on the rim with
///
///     (W + s) r = W r − u,   s > 0
///
/// As for contacts, s makes one Newton step in each sweep.
template <class V>
DELASSUS_WIDE_INLINE void sweepLanes(DiskGroup& g, int at, float beta, SweptVelocity* velocities,
                                     SweepChange& change) {
  constexpr float tiny = 1e-30f, least = 1e-12f;
  const V zero = {};
  const BodyLanes<V> bodies(g.a + at, g.b + at, velocities);
  V ya[8], yb[8], x[2], u[2], du[2], r0[2];
  bodies.gatherTo(ya, yb);
  for (int k = 0; k < 2; ++k) {
    V now, before, sum[2] = {}, of;
    load(g.dr[k] + at, now);
    load(g.drBefore[k] + at, before);
    store(now, g.drBefore[k] + at);
    x[k] = now + beta * (now - before);
    load(g.u0[k] + at, u[k]);
    load(g.r0[k] + at, r0[k]);
    for (int i = 0; i < 6; ++i) {
      load(g.Ja[6 * k + i] + at, of);
      sum[0] += of * ya[i];
      load(g.Jb[6 * k + i] + at, of);
      sum[1] += of * yb[i];
    }
    du[k] = sum[0] + sum[1];
    u[k] += du[k];
  }
  V length0, margin0, load0, low, high, perLoad, loads;
  for (int k = 0; k < bodies.count; ++k) loads[k] = *g.load[at + k];
  load(g.length0 + at, length0), load(g.margin0 + at, margin0);
  load(g.leastLoad + at, low), load(g.mostLoad + at, high), load(g.noLoad + at, load0);
  load(g.perLoad + at, perLoad);
  loads = loads < low ? low : loads;
  loads = loads > high ? high : loads;
  const V growth = perLoad * (loads - load0), radius = length0 + margin0 + growth;
  // The radius less ‖r₀ + d‖, and this length. The rounding error is a share of d and the growth.
  const auto marginAt = [&](const V(&d)[2], V& margin, V& length) {
    const V t1 = r0[0] + d[0], t2 = r0[1] + d[1];
    squareRoot(t1 * t1 + t2 * t2, length);
    const V sum = length + length0;
    margin = margin0 + growth -
             ((t1 + r0[0]) * d[0] + (t2 + r0[1]) * d[1]) / (sum > tiny ? sum : zero + tiny);
  };
  V p00, p01, p11, margin, length;
  load(g.p00 + at, p00), load(g.p01 + at, p01), load(g.p11 + at, p11);
  const V held[2] = {x[0] - (p00 * u[0] + p01 * u[1]), x[1] - (p01 * u[0] + p11 * u[1])};
  marginAt(held, margin, length);
  const auto sticks = margin >= zero, presses = radius > zero;
  V onRim[2] = {held[0], held[1]};
  if (any(presses & ~sticks)) {
    V w00, w01, w11, s0, ds, b1, b2;
    load(g.w00 + at, w00), load(g.w01 + at, w01), load(g.w11 + at, w11);
    load(g.slip0 + at, s0), load(g.dslip + at, ds);
    load(g.unslowed0[0] + at, b1), load(g.unslowed0[1] + at, b2);
    const V known = ds, r1 = r0[0] + x[0], r2 = r0[1] + x[1];
    // The s for W = 1.
    V free;
    squareRoot((r1 - u[0]) * (r1 - u[0]) + (r2 - u[1]) * (r2 - u[1]), free);
    const V guess = free / (radius > tiny ? radius : zero + tiny) - 1;
    ds = s0 + ds > zero ? ds : (guess > least ? guess : zero + least) - s0;
    ds = s0 + ds < mostSlip ? ds : mostSlip - s0;
    const V s = s0 + ds, p = w00 + s, q = w11 + s, perDet = 1 / (p * q - w01 * w01);
    // u + s r, which sliding makes zero, from its value at s₀ and the changes since.
    const auto isNear = (ds < zero ? -ds : ds) < 0.5f * s0;
    b1 = isNear ? b1 + (du[0] + s0 * x[0] + ds * r1) : u[0] + s * r1;
    b2 = isNear ? b2 + (du[1] + s0 * x[1] + ds * r2) : u[1] + s * r2;
    const V slid[2] = {x[0] + (w01 * b2 - q * b1) * perDet, x[1] + (w01 * b1 - p * b2) * perDet};
    marginAt(slid, margin, length);
    const V excess = margin / (length > least ? length : zero + least);
    const V t1 = r0[0] + slid[0], t2 = r0[1] + slid[1];
    onRim[0] = slid[0] + excess * t1;
    onRim[1] = slid[1] + excess * t2;
    // Newton on 1/‖r‖ − 1/R, which is nearly linear in s.
    const V along = (q * t1 - w01 * t2) * t1 + (p * t2 - w01 * t1) * t2;
    const V correction = -margin * length * length /
                         (radius * along * perDet > tiny ? radius * along * perDet : zero + tiny);
    ds += correction;
    ds = s0 + ds > least ? ds : least - s0;
    ds = presses & ~sticks ? ds : known;
    store(ds, g.dslip + at);
  }
  V next[2];
  for (int k = 0; k < 2; ++k) next[k] = presses ? (sticks ? held[k] : onRim[k]) : -r0[k];
  react(g, at, x, next, ya, yb, change);
  bodies.scatterFrom(ya, yb);
}

template <class V, class Group>
DELASSUS_WIDE_INLINE void sweepAll(Group* groups, std::size_t count, float beta,
                                   SweptVelocity* velocities, SweepChange& change) {
  constexpr int step = sizeof(V) / sizeof(float);
  for (std::size_t k = 0; k < count; ++k)
    for (int at = 0; at < lanes; at += step) sweepLanes<V>(groups[k], at, beta, velocities, change);
}

template <class Group>
void sweepByFour(Group* groups, std::size_t count, float beta, SweptVelocity* velocities,
                 SweepChange& change) {
  sweepAll<Lanes4>(groups, count, beta, velocities, change);
}
#ifdef DELASSUS_HAS_AVX2
template <class Group>
__attribute__((target("avx2"))) void sweepByEight(Group* groups, std::size_t count, float beta,
                                                  SweptVelocity* velocities, SweepChange& change) {
  sweepAll<Lanes8>(groups, count, beta, velocities, change);
}
#endif

}  // namespace

GroupSweeps groupSweeps([[maybe_unused]] bool isNarrow) {
#ifdef DELASSUS_HAS_AVX2
  if (!isNarrow && __builtin_cpu_supports("avx2"))
    return {sweepByEight<ContactGroup>, sweepByEight<RowGroup>, sweepByEight<DiskGroup>};
#endif
  return {sweepByFour<ContactGroup>, sweepByFour<RowGroup>, sweepByFour<DiskGroup>};
}

}  // namespace delassus
