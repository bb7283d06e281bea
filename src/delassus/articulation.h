#pragma once

#include <Eigen/Cholesky>
#include <vector>

#include "delassus/disjoint_sets.h"
#include "delassus/island.h"
#include "delassus/kept_list.h"

namespace delassus {

using Matrix6X = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// Bodies that move together: articulated trees, in the generalised velocities v of their joints
/// and of their base.
///
///     M⁻¹ = B Bᵀ,   velocity of a limb = L v,   v⁺ = v + M⁻¹ Jᵀ r
///
/// The list of bodies holds each limb with its velocity and unit mass, or immovable if L B = 0:
/// contacts and rows refer to it as to any other body. Its true inertia is in the tree.
///
/// A row may also act on joints. It then refers to the tree's stem, a limb of unit mass with L = 0
/// that only names the tree. Its effect on the joints is given here. The part J v of its velocity
/// that comes from the joints belongs in the target of the row.
struct Articulation {
  struct Tree {
    MatrixXd root;  ///< B
  };
  struct Limb {
    int body, tree;
    Matrix6X motion;  ///< L B
  };
  struct JointRow {
    int row, tree;
    VectorXd effect;  ///< Bᵀ Jᵀ
  };
  KeptList<Tree> trees;
  KeptList<Limb> limbs;          ///< in the order of their bodies
  KeptList<JointRow> jointRows;  ///< in the order of their rows; a row between two trees has two

  void clear();
  /// The limb that this body stands for, or null.
  const Limb* limbOf(int body) const;
  bool moves(const Island& island) const;

  std::size_t bytes() const {
    return trees.bytes([](const Tree& tree) { return bytesOf(tree.root); }) +
           limbs.bytes([](const Limb& limb) { return sizeof(double) * limb.motion.size(); }) +
           jointRows.bytes([](const JointRow& row) { return bytesOf(row.effect); });
  }
};

/// Finds B with M⁻¹ = B Bᵀ by an LDLᵀ factor that takes the largest entries of the diagonal of M⁻¹
/// first. M⁻¹ is symmetric, and positive semi-definite up to rounding: pivots below 0 count as 0.
class RootFinder {
 public:
  void find(const MatrixXd& inverseMass, MatrixXd& B);

 private:
  Eigen::LDLT<MatrixXd> factor_;
  MatrixXd L_;
};

/// The islands of a step, in the assembler's order; islands that a common tree couples are joined.
class IslandJoiner {
 public:
  const KeptList<Island>& join(const Assembler& assembler, const Articulation& articulation);
  /// The result of the last `join`.
  const KeptList<Island>& islands() const { return joined_; }
  std::size_t bytes() const {
    return joined_.bytes([](const Island& island) { return island.bytes(); }) + sets_.bytes() +
           bytesOf(islandOf_, place_);
  }

 private:
  KeptList<Island> joined_;
  DisjointSets sets_;
  std::vector<int> islandOf_;  ///< the first island of each tree
  std::vector<int> place_;     ///< place of a set among the joined, by the set's first island
};

/// M⁻¹ Jᵀ r of each tree: the change of its velocities by the reactions.
struct TreeGains {
  std::vector<VectorXd> of;  ///< by tree; as many as there ever were

  /// Sets all gains to zero.
  void reset(const Articulation& articulation);
  std::size_t bytes() const {
    std::size_t sum = bytesOf(of);
    for (const VectorXd& gain : of) sum += bytesOf(gain);
    return sum;
  }
};

/// Makes the problem of an island with trees: W from the whole motion of each tree, in blocks of
/// six.
class Coupling {
 public:
  /// `apart`: the island's problem as the assembler writes it, with limbs as bodies of unit mass.
  /// The result is good until the next call.
  const Problem& couple(const Articulation& articulation, const Problem& apart,
                        const Island& island);
  /// Adds the effect of reactions on the trees of the island that was coupled last.
  void addGain(const Articulation& articulation, const VectorXd& r, TreeGains& gains);

  std::size_t bytes() const { return problem_.bytes() + bytesOf(firstBlock_, impulse_); }

 private:
  void layOut(const Articulation& articulation, const Island& island);
  template <class Block>
  void addParts(int at, int tree, Eigen::Index columns, const Block& block);

  std::vector<int> firstBlock_;  ///< of each tree, or -1
  int blocks_ = 0;               ///< of the island
  Problem problem_;
  BodySpace* space_ = nullptr;  ///< of problem_.W
  VectorXd impulse_;            ///< on the blocks
};

}  // namespace delassus
