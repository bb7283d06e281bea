#pragma once

#include <cstdint>
#include <vector>

#include "delassus/problem.h"
#include "delassus/residual.h"

namespace delassus {

/// Block Gauss-Seidel over the contacts, then the rows, of a problem in body space, eight at a time, with Nesterov's acceleration.
///
/// Contacts (rows) of one colour have no body in common: in which order they come does not matter, and eight of them are swept at once. In
/// single precision, but only what the sweeps change: reactions r₀ + Δr and velocities u₀ + C Δr + J̃ Δy, with r₀ and u₀ worked out in
/// double precision when sweeps begin, and how far r is from the edge of its cone too. Each contact is in units in which W_nn = 1, each
/// row in those of W = 1. What rounding leaves of a residual is then about 1e-7 of the velocities that remain.
///
/// With g = g(x) swept from x, the next sweep begins from x⁺ = g + β (g − g_before), β as in Nesterov 1983, and β = 0 anew whenever
/// ‖g(x) − x‖ has grown (O'Donoghue and Candès 2015).
class ColouredSweeps {
 public:
  /// False, and no sweeps are to be asked for, where there are disks, articulated bodies, or contacts that friction cannot stop in all
  /// directions.
  bool setProblem(const Problem& problem, const NaturalMap& map);

  /// Sweeps till none changes the velocity of its contact by more than `aim`, m/s, and at most `most` times. Returns how often. The
  /// reactions end in their cones.
  int sweep(const Problem& problem, int most, double aim, VectorXd& r);

  /// From now on by half a group at a time, as where processors cannot do more: the same bits.
  void narrow() { isNarrow_ = true; }

  std::size_t bytes() const {
    return bytesOf(groups_, rows_, velocities_, coloursOf_, placeOf_, u_, y_);
  }

  static constexpr int lanes = 8;
  static constexpr int none = -1;
  /// Contacts of one colour, as many as there are lanes or fewer.
  struct Group {
    using Lanes = float[lanes];
    int at[lanes];           ///< which; none: no more
    int a[lanes], b[lanes];  ///< their bodies; one that is not there is the last
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
    Lanes slip;                ///< s of OneContact as far as it is known, 0: not at all
  };
  /// The same of rows.
  struct RowGroup {
    using Lanes = float[lanes];
    int at[lanes];  ///< their unknowns
    int a[lanes], b[lanes];
    alignas(32) Lanes Ja[6];
    Lanes Jb[6];
    Lanes compliance, unit;
    Lanes u0, lower, upper;  ///< the bounds are those of Δr
    Lanes dr, drBefore;
  };
  /// What a body moves with, Δy: six numbers, and two that are not used; after the last sweep, and the one before.
  struct Velocity {
    alignas(32) float y[8];
    float before[8];

    void goOn(float beta) {
      for (int k = 0; k < 8; ++k) {
        const float now = y[k];
        y[k] = now + beta * (now - before[k]);
        before[k] = now;
      }
    }
  };

 private:
  template <class Of>
  int place(int count, const Problem& problem, const Of& of);
  void placeContacts(const Problem& problem, const NaturalMap& map);
  void placeRows(const Problem& problem, const NaturalMap& map);
  void start(const Problem& problem, const VectorXd& r);
  void startContacts(const Problem& problem, const VectorXd& r);
  void startRows(const Problem& problem, const VectorXd& r);

  bool isNarrow_ = false;
  std::vector<Group> groups_;
  std::vector<RowGroup> rows_;
  std::vector<Velocity> velocities_;
  std::vector<std::uint64_t> coloursOf_;  ///< that the contacts of a body have, a bit each
  std::vector<int> placeOf_;  ///< of a contact or row: eight times its group, and its lane
  VectorXd u_, y_;            ///< scratch
};

}  // namespace delassus
