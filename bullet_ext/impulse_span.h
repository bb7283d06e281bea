#pragma once

#include <cstddef>
#include <vector>

#include "delassus/body.h"
#include "delassus/bytes.h"
#include "delassus/types.h"

namespace delassus::bullet {

/// Impulses along rows or contacts, each on one or two bodies, and what they span. What two of them
/// do together is measured as
///
///     (p, p') = pᵀ M⁻¹ p',   (p, p) of rows with their compliance
class ImpulseSpan {
 public:
  /// The velocity that rows ask for, m/s.
  struct Wanted {
    double ofErrors = 0;  ///< to mend them
    double ofDrives = 0;  ///< of joints
    double ofMovers = 0;  ///< that bodies have which nothing can stop
    double all() const { return ofErrors + ofDrives + ofMovers; }
    void add(const Wanted& other, double times = 1) {
      ofErrors += times * other.ofErrors;
      ofDrives += times * other.ofDrives;
      ofMovers += times * other.ofMovers;
    }
  };
  /// On bodies that can move; −1: on none.
  struct Impulse {
    int a = -1, b = -1;
    Vec6 onA = Vec6::Zero(), onB = Vec6::Zero();
    Wanted wanted = {};  ///< of a row: what it asks of these bodies
  };
  static double product(const std::vector<Body>& bodies, const Impulse& p, const Impulse& q);

  int size() const { return static_cast<int>(impulses_.size()); }
  void truncate(int size);
  /// Coordinates of p in the orthonormal basis that the impulses make, in the order in which they
  /// were added: y = L⁻¹ (p_i, p) with L Lᵀ = (p_i, p_j).
  void coordinates(const std::vector<Body>& bodies, const Impulse& p,
                   std::vector<double>& of) const;
  /// Adds p, whose coordinates and (p, p) less their squares these are.
  void add(const Impulse& p, const std::vector<double>& coordinates, double left);
  /// What the rows ask for along what has these coordinates, as far as it lies in their span:
  /// y·L⁻¹ w, w what each of them asks for.
  Wanted wantedAlong(const std::vector<double>& of) const {
    Wanted sum;
    for (std::size_t k = 0; k < of.size(); ++k) sum.add(impulses_[k].wanted, of[k]);
    return sum;
  }
  std::size_t bytes() const { return bytesOf(impulses_, begins_, factor_); }

 private:
  std::vector<Impulse> impulses_;
  std::vector<int> begins_;     ///< which coordinate of each is the first that is not zero
  std::vector<double> factor_;  ///< L by rows: the coordinates of each
};

}  // namespace delassus::bullet
