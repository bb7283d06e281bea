#pragma once

#include <cstddef>

namespace delassus {

/// Block Gauss-Seidel sweeps over eight contacts, rows or disks at a time, in single precision; no
/// two of them have a body in common. Each contact is in units with W_nn = 1, each row in units
/// with W = 1, each disk in units in which the largest eigenvalue of its W is 1; and all of them
/// times a scale by which they are about 1 at most. Reactions and velocities are r₀ + Δr and
/// u₀ + C Δr + J̃ Δy.
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
  Lanes unit;  ///< √W_nn: of r, and 1 / m/s of u, but for the scale
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

/// The same for disks. The second unknown of spinning friction moves nothing.
struct DiskGroup {
  int at[lanes];  ///< which disks
  int a[lanes], b[lanes];
  const float* load[lanes];  ///< Δr_n of their governors, in units of these
  alignas(32) Lanes Ja[12];
  Lanes Jb[12];
  Lanes w00, w01, w11;
  Lanes p00, p01, p11;                ///< W⁻¹; if W is singular, 1
  Lanes unit, loadUnit;               ///< its own, and that of r_n
  Lanes perLoad;                      ///< κ: the change of the radius with Δr_n
  Lanes leastLoad, mostLoad, noLoad;  ///< bounds of the Δr_n that counts; what counts of Δr_n = 0
  Lanes u0[2], r0[2];
  Lanes length0, margin0;  ///< ‖r‖ and κ r_n − ‖r‖ of r₀
  Lanes slip0, dslip;      ///< s = s₀ + Δs with u + s r = 0, as far as known; ≤ 0: unknown
  Lanes unslowed0[2];      ///< u₀ + s₀ r₀
  Lanes dr[2], drBefore[2];
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
  Lanes largest = {};  ///< largest change of a velocity, m/s times the scale
};

/// One sweep over some groups, from reactions that go β beyond those of the last sweep.
template <class Group>
using SweepGroups = void (*)(Group* groups, std::size_t count, float beta,
                             SweptVelocity* velocities, SweepChange& change);
struct GroupSweeps {
  SweepGroups<ContactGroup> contacts;
  SweepGroups<RowGroup> rows;
  SweepGroups<DiskGroup> disks;
};
/// The widest sweeps that the processor can do. Narrow: half a group at a time, as on processors
/// without wider vectors. The bits are the same.
GroupSweeps groupSweeps(bool isNarrow);

}  // namespace delassus
