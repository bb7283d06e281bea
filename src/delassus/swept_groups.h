#pragma once

#include <cstddef>

namespace delassus {

/// What block Gauss-Seidel sweeps over eight at a time, in single precision: contacts, or rows,
/// that have no body in common. Each contact is in units in which W_nn = 1, each row in those of W
/// = 1. Reactions and velocities are r₀ + Δr and u₀ + C Δr + J̃ Δy.
constexpr int lanes = 8;
using Lanes = float[lanes];
constexpr float mostSlip = 1e12f;  ///< s of OneContact for a reaction that hardly slows
constexpr int vacant = -1;         ///< in the place of a contact or row where a group has no more

/// Contacts of one colour, as many as there are lanes or fewer.
struct ContactGroup {
  int at[lanes];           ///< which
  int a[lanes], b[lanes];  ///< their bodies; one that is not there has a place behind the others
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
  Lanes dr[3], drBefore[3];  ///< after the last sweep, and the one before
  Lanes slip0, dslip;  ///< s = s₀ + Δs of OneContact as far as it is known, ≤ 0: not at all
  Lanes unslowed0[2];  ///< v + s₀ r_t of r₀, v = u_t − W_tn u_n: what sliding makes zero
};

/// The same of rows.
struct RowGroup {
  int at[lanes];  ///< their unknowns
  int a[lanes], b[lanes];
  alignas(32) Lanes Ja[6];
  Lanes Jb[6];
  Lanes compliance, unit;
  Lanes u0, lower, upper;  ///< the bounds are those of Δr
  Lanes dr, drBefore;
};

/// What a body moves with, Δy: six numbers, and two that are not used; after the last sweep, and
/// the one before.
struct SweptVelocity {
  alignas(32) float y[8];
  float before[8];

  /// β beyond the last sweep.
  void goOn(float beta) {
    for (int k = 0; k < 8; ++k) {
      const float now = y[k];
      y[k] = now + beta * (now - before[k]);
      before[k] = now;
    }
  }
};

/// Of one sweep. A line of the cache: several hands may count, each for itself.
struct alignas(64) SweepChange {
  Lanes energy = {};   ///< ‖g(x) − x‖², in the units of the contacts
  Lanes largest = {};  ///< of a velocity, m/s
};

/// One sweep over some groups, from reactions that go β beyond the last sweep's.
template <class Group>
using SweepGroups = void (*)(Group* groups, std::size_t count, float beta,
                             SweptVelocity* velocities, SweepChange& change);
struct GroupSweeps {
  SweepGroups<ContactGroup> contacts;
  SweepGroups<RowGroup> rows;
};
/// What the processor can do; narrow: half a group at a time, as where it cannot do more. The same
/// bits.
GroupSweeps groupSweeps(bool isNarrow);

}  // namespace delassus
