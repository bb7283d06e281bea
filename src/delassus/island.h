#pragma once

#include <utility>
#include <vector>

#include "delassus/body.h"
#include "delassus/contact.h"
#include "delassus/disjoint_sets.h"
#include "delassus/problem.h"
#include "delassus/row.h"

namespace delassus {

/// Contacts and rows that can feel each other, linked through movable bodies. Indices ascend.
///
/// The unknowns of its problem are, in this order: three per frictional contact, one per
/// frictionless contact, one per row. Rows with a governor make disks; all others come before them.
struct Island {
  std::vector<int> bodies;        ///< movable bodies
  std::vector<int> frictional;    ///< contacts with friction > 0, or unfit friction (`unfitParts`)
  std::vector<int> frictionless;  ///< contacts with friction = 0: one unknown each
  std::vector<int> rows;

  int unknowns() const {
    return static_cast<int>(3 * frictional.size() + frictionless.size() + rows.size());
  }
  bool hasContacts() const { return !frictional.empty() || !frictionless.empty(); }
  /// Calls work(contact) for all of its contacts, those with friction first.
  template <class Work>
  void eachContact(const Work& work) const {
    for (const int contact : frictional) work(contact);
    for (const int contact : frictionless) work(contact);
  }
  /// Calls work(contact, at, unknowns) for the same, in the same order: `at` is the first of the
  /// contact's unknowns.
  template <class Work>
  void eachContactAt(const Work& work) const {
    int at = 0;
    for (const int contact : frictional) work(contact, std::exchange(at, at + 3), 3);
    for (const int contact : frictionless) work(contact, at++, 1);
  }
  /// Calls work(row, at) for all of its rows, `at` the unknown of each.
  template <class Work>
  void eachRowAt(const Work& work) const {
    auto at = static_cast<int>(3 * frictional.size() + frictionless.size());
    for (const int row : rows) work(row, at++);
  }
  /// The unknown of the normal reaction of one of its contacts.
  int normalOf(int contact) const;
  std::size_t bytes() const { return bytesOf(bodies, frictional, frictionless, rows); }
};

/// Problem::leastDemand of an island.
double leastDemandOf(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
                     const std::vector<Row>& rows, const Island& island);

/// Splits steps into islands and writes their problems, in storage that it keeps from step to step.
class Assembler {
 public:
  /// Finds the islands of a step, ordered by their first body; good until the next call. Contacts
  /// and rows between immovable bodies have no unknowns and belong to no island. With `allTangents`
  /// contacts without friction count as frictional ones with μ = 0.
  void split(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
             const std::vector<Row>& rows, bool allTangents = false);
  int islands() const { return count_; }
  const Island& island(int i) const { return islands_[i]; }

  /// W, q, friction and bounds of one island; good until the next call.
  const Problem& assemble(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
                          const std::vector<Row>& rows, const Island& island);

  std::size_t bytes() const;

 private:
  /// B with M⁻¹ = B Bᵀ: a diagonal for the mass, a lower triangle for the inertia.
  struct RootOfInverseMass {
    Vec3 linear;
    Mat3 angular;
  };
  static RootOfInverseMass rootOf(const Body& body);

  /// Contacts of the same two bodies, one after the other, all with friction or all without.
  struct Run {
    int a, b;  ///< the bodies; fixedWorld for one that does not move
    int begin, end;
    bool isFrictional;
  };
  void findRuns(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
                bool allTangents);
  void addIsland();

  // `assemble`, step by step.
  BodySpace& makeRoom(const Island& island);
  void takeRoots(const std::vector<Body>& bodies, const Island& island);
  void writeFrictional(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
                       const Island& island, BodySpace& space);
  void writeFrictionless(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
                         const Island& island, BodySpace& space);
  void writeRows(const std::vector<Body>& bodies, const std::vector<Row>& rows,
                 const Island& island, BodySpace& space);
  void writeDisks(const std::vector<Body>& bodies, const std::vector<Row>& rows,
                  const Island& island, BodySpace& space);

  void writeRow(const std::vector<Body>& bodies, const ScalarRow& row, double target,
                const Interval& bounds, double compliance, BodySpace& space);
  int placeIn(const std::vector<Body>& bodies, int body) const;
  template <class Rows, class Velocity>
  void takeShare(const std::vector<Body>& bodies, int body, int place, Rows& J, Velocity& q);

  std::vector<Island> islands_;  ///< the first count_ are of this step
  int count_ = 0;
  std::vector<Run> runs_;
  DisjointSets sets_;
  std::vector<int> islandOf_;  ///< of each body
  /// Place of a body among the bodies of the island that is being assembled.
  std::vector<int> placeOf_;
  std::vector<RootOfInverseMass> roots_;
  double largestTerm_ = 0;  ///< largest term of the sums that make q, m/s
  Problem problem_;
};

/// One-off use.
std::vector<Island> splitIslands(const std::vector<Body>& bodies,
                                 const std::vector<Contact>& contacts,
                                 const std::vector<Row>& rows);
Problem assemble(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
                 const std::vector<Row>& rows, const Island& island);

/// v ← v + M⁻¹ Jᵀ r for the bodies of the island.
void applyReaction(std::vector<Body>& bodies, const std::vector<Contact>& contacts,
                   const std::vector<Row>& rows, const Island& island, const VectorXd& r);

}  // namespace delassus
