#pragma once

#include <cstddef>
#include <vector>

#include "delassus/types.h"

namespace delassus {

/// Sparse LU factor of a matrix of 6x6 blocks whose pattern is the body graph: one block row a body, an off-diagonal
/// block for each pair of bodies that share a contact or row.
///
/// The pattern is symmetric, the values need not be. Blocks are eliminated in minimum-degree order without pivoting
/// between blocks (with partial pivoting inside the diagonal blocks): the matrices are identity plus a compression.
/// The symbolic analysis is kept as long as the pattern stands.
class BlockFactor {
 public:
  struct Edge {
    int a, b;  ///< a ≠ b
    bool operator==(const Edge& other) const { return a == other.a && b == other.b; }
  };

  /// Prepares for `bodies` block rows and these couplings (repeated and reversed pairs are welcome). Does nothing if
  /// pattern and size are those of the last call.
  void analyse(int bodies, const std::vector<Edge>& edges);

  /// Sets the matrix to the identity; then blocks are added: on the diagonal, and for the edge with index `edge` the
  /// blocks (a, b) and (b, a).
  void setIdentity();
  void addDiagonal(int body, const Mat6& block) { diagonal_[place_[body]] += block; }
  void addOffDiagonal(int edge, const Mat6& ab, const Mat6& ba);

  /// False if a pivot block is singular or not finite.
  bool factorise();
  /// Overwrites x with the solution.
  void solve(VectorXd& x) const;

  std::size_t bytes() const;

 private:
  struct Target {
    int at;         ///< position among the off-diagonal blocks
    bool reversed;  ///< a comes after b in the elimination order
  };
  struct Ancestor {
    int column;  ///< an earlier column with a block in this row
    int at;      ///< where that block is
  };

  void eliminate(int column);

  int bodies_ = -1;
  std::vector<Edge> edges_;
  std::vector<int> place_;          ///< body -> place in the elimination order
  std::vector<Target> target_;      ///< edge -> off-diagonal block
  std::vector<int> begin_;          ///< column -> its first off-diagonal block; size bodies + 1
  std::vector<int> row_;            ///< off-diagonal block -> its row
  std::vector<int> ancestorBegin_;  ///< row -> its first ancestor; size bodies + 1
  std::vector<Ancestor> ancestors_;
  std::vector<int> slot_;  ///< scratch: row -> block of the column being eliminated

  std::vector<Mat6> diagonal_, diagonalInverse_;
  std::vector<Mat6> lower_,
      upper_;                 ///< block (row, column) of L and block (column, row) of U, transposed
  mutable VectorXd ordered_;  ///< scratch: a right-hand side in the elimination order
};

}  // namespace delassus
