#pragma once

#include <cstdint>
#include <vector>

#include "delassus/fill_groups.h"
#include "delassus/problem.h"
#include "delassus/residual.h"
#include "delassus/swept_groups.h"

namespace delassus {

class Hands;

/// Block Gauss-Seidel over the contacts, then the rows, then the disks of a problem in body space,
/// eight at a time, with Nesterov's acceleration.
///
/// Contacts (rows, disks) of one colour have no body in common. Their order does not matter, and
/// eight of them are swept at once, by several hands if there are any. The sweeps are in single
/// precision, but only for what they change (swept_groups.h): r₀ and u₀, and all differences of
/// them that an answer makes small, are computed in double precision when sweeps begin. Rounding
/// then costs about 1e-7 of what the sweeps change, and sweeps that begin where others have ended
/// go on as far as double precision does. The units are such that the largest of r₀ and u₀ is
/// about 1, so that the sweeps are the same in all units of length and mass.
///
/// With g = g(x) swept from x, the next sweep begins from x⁺ = g + β (g − g_before), with β as in
/// Nesterov 1983. β restarts at 0 whenever ‖g(x) − x‖ has grown (O'Donoghue and Candès 2015).
class ColouredSweeps {
 public:
  /// False where there are articulated bodies, or contacts that friction cannot stop in all
  /// directions: then no sweeps may be asked for. Problem and map must outlive the sweeps.
  bool setProblem(const Problem& problem, const NaturalMap& map);

  /// Sweeps from r, u = W r + q, until no contact changes its velocity by more than `aim`, m/s, and
  /// at most `most` times. Returns the number of sweeps. The reactions end in their cones.
  int sweep(int most, double aim, const VectorXd& u, VectorXd& r);

  /// Makes this many sweeps without acceleration.
  void sweepPlainly(int count, VectorXd& r);

  /// Sweeps half a group at a time from now on, as on processors without wider vectors: same bits.
  void narrow() { isNarrow_ = true; }
  /// The threads that help with large problems from now on; null: none. The same bits.
  void setHands(Hands* hands) { hands_ = hands; }

  std::size_t bytes() const {
    return bytesOf(contacts_, rows_, disks_, contactColours_, rowColours_, diskColours_,
                   velocities_, coloursOf_, placeOf_, loads_, u_, y_);
  }

 private:
  /// Where the groups of each colour begin, and where those of the last colour end.
  using Colours = std::vector<int>;
  /// The sweeps from one start.
  struct Pass;

  template <class Of>
  void place(int count, const Of& of, Colours& colours);
  void placeContacts(const NaturalMap& map);
  void placeRows(const NaturalMap& map);
  void placeDisks(const NaturalMap& map);
  template <class Group>
  void putInPlace(int begin, const Colours& colours, std::vector<Group>& groups);
  template <class Group, class IndexOf>
  void findLoads(const std::vector<Group>& groups, const IndexOf& indexOf);
  void work(Pass& pass, int round, int share);
  template <class Group>
  void sweepShare(Pass& pass, int colour, int share, const Colours& colours,
                  std::vector<Group>& groups, SweepGroups<Group> sweep);
  template <class InShares>
  void lead(Pass& pass, const InShares& inShares);
  double scaleFor(const VectorXd& u, const VectorXd& r) const;
  void sweepAs(Pass& pass, double aim, const VectorXd& u, VectorXd& r);
  void finish(double scale, VectorXd& r) const;

  const Problem* problem_ = nullptr;
  const NaturalMap* map_ = nullptr;
  bool isNarrow_ = false;
  Hands* hands_ = nullptr;
  std::vector<ContactGroup> contacts_;
  std::vector<RowGroup> rows_;
  std::vector<DiskGroup> disks_;
  Colours contactColours_, rowColours_, diskColours_;
  std::vector<SweptVelocity> velocities_;
  std::vector<std::uint64_t> coloursOf_;  ///< colours that the contacts of a body have, a bit each
  std::vector<int> placeOf_;  ///< of a contact, row or disk: eight times its group, and its lane
  std::vector<SweptLoad> loads_;  ///< of the disks
  VectorXd u_, y_;                ///< scratch
};

}  // namespace delassus
