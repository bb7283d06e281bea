#pragma once

#include <cstddef>

namespace delassus {

/// Block Gauss-Seidel sweeps over eight contacts, or eight rows, at a time, in single precision; no
/// two of them have a body in common. Each contact is in units with W_nn = 1, each row in units
/// with W = 1. Reactions and velocities are r₀ + Δr and u₀ + C Δr + J̃ Δy.
constexpr int lanes = 8;
using Lanes = float[lanes];
constexpr float mostSlip = 1e12f;  ///< s of OneContact for a reaction that hardly slows
constexpr int vacant = -1;         ///< index in a lane without a contact or row

/// Contacts of one colour, as many as there are lanes or fewer.
struct ContactGroup {
  int at[lanes];           ///< which contacts
  int a[lanes], b[lanes];  ///< their bodies; a missing one has a place behind the others
  alignas(32) Lanes Ja[18];
  Lanes Jb[18];
  Lanes w1, w2;         ///< W_nt
  Lanes s00, s01, s11;  ///< S = W_tt − W_tn W_nt
  Lanes perDet;         ///< 1 / det S
  Lanes compliance[3];
  Lanes friction;
  Lanes unit;  ///< √W_nn: of r, and 1 / m/s of u
  Lanes u0[3], r0[3];
  Lanes length0, margin0;    ///< ‖r_t‖ and μ r_n − ‖r_t‖ of r₀
  Lanes dr[3], drBefore[3];  ///< after the last sweep, and after the one before
  Lanes slip0, dslip;        ///< s = s₀ + Δs of OneContact, as far as known; ≤ 0: unknown
  Lanes unslowed0[2];        ///< v + s₀ r_t at r₀, v = u_t − W_tn u_n; zero where it slides
};

/// The same for rows.
struct RowGroup {
  int at[lanes];  ///< their unknowns
  int a[lanes], b[lanes];
  alignas(32) Lanes Ja[6];
  Lanes Jb[6];
  Lanes compliance, unit;
  Lanes u0, lower, upper;  ///< bounds of Δr
  Lanes dr, drBefore;
};

/// The velocity Δy of a body, six numbers and two unused ones, after the last sweep and after the
/// one before.
struct SweptVelocity {
  alignas(32) float y[8];
  float before[8];

  /// Extrapolates by β beyond the last sweep.
  void goOn(float beta) {
    for (int k = 0; k < 8; ++k) {
      const float now = y[k];
      y[k] = now + beta * (now - before[k]);
      before[k] = now;
    }
  }
};

/// The change by one sweep. It fills a cache line of its own, so that several hands can each write
/// one.
struct alignas(64) SweepChange {
  Lanes energy = {};   ///< ‖g(x) − x‖², in the units of the contacts
  Lanes largest = {};  ///< largest change of a velocity, m/s
};

/// One sweep over some groups, from reactions that go β beyond those of the last sweep.
template <class Group>
using SweepGroups = void (*)(Group* groups, std::size_t count, float beta,
                             SweptVelocity* velocities, SweepChange& change);
struct GroupSweeps {
  SweepGroups<ContactGroup> contacts;
  SweepGroups<RowGroup> rows;
};
/// The widest sweeps that the processor can do. Narrow: half a group at a time, as on processors
/// without wider vectors. The bits are the same.
GroupSweeps groupSweeps(bool isNarrow);

}  // namespace delassus
