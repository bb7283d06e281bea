#pragma once

#include <atomic>
#include <cstddef>
#include <list>
#include <vector>

#include "delassus/block_pattern.h"
#include "delassus/contact_rows.h"
#include "delassus/kept_matrix.h"
#include "delassus/types.h"

namespace delassus {

class Hands;

/// Sparse LU or Cholesky factor of a matrix of 6x6 blocks: one block row per body, and an
/// off-diagonal block for each pair of coupled bodies. Contacts and rows couple their bodies: those
/// that press (BodyMotion), or all.
///
/// The pattern is symmetric, the values need not be. Blocks are eliminated in minimum-degree order
/// without pivoting between blocks (with partial pivoting inside the diagonal blocks): the matrices
/// are identity plus a compression. Symmetric matrices have a Cholesky factor: half the work, and
/// half the memory to read. The last analysed patterns are kept, as islands of the same shapes come
/// again.
class BlockFactor {
 public:
  using Edge = BlockPattern::Edge;

  /// Prepares for `bodies` block rows and these couplings (repeated and reversed pairs are
  /// welcome).
  void analyse(int bodies, const std::vector<Edge>& edges);

  /// Sets the matrix to the identity; then blocks are added: on the diagonal, and for the edge with
  /// index `edge` the blocks (a, b) and (b, a). `isCholesky`: the sum will be symmetric and
  /// positive definite, and is to have a Cholesky factor. Blocks may be product expressions: these
  /// are evaluated while they are added.
  void setIdentity(bool isCholesky = false);
  template <class Block>
  void addDiagonal(int body, const Block& block) {
    diagonal_[pattern().place[body]].noalias() += block;
  }
  template <class BlockAB, class BlockBA>
  void addOffDiagonal(int edge, const BlockAB& ab, const BlockBA& ba) {
    clear();
    const BlockPattern::Target& t = pattern().target[edge];
    if (t.reversed)
      lower_[t.at].noalias() += ab;
    else
      lower_[t.at].noalias() += ba;
    if (isCholesky_) return;
    if (t.reversed)
      upper_[t.at] += Mat6(ba).transpose();
    else
      upper_[t.at] += Mat6(ab).transpose();
  }

  /// Adds Aᵀ B, and [Aa Ab]ᵀ [Ba Bb] off the diagonal. These are products of three rows; a sum that
  /// shall be symmetric needs symmetric products.
  void addDiagonal(int body, const Mat36& A, const Mat36& B);
  void addOffDiagonal(int edge, const Mat36& Aa, const Mat36& Ba, const Mat36& Ab, const Mat36& Bb);

  /// Factorises the matrix. Before a block column is eliminated, calls add(body), which adds the
  /// rest of it by addContacts and addRows, calls nothing else here, and must not throw. Columns
  /// come in any order, those of large matrices also at the same time. False if a pivot block is
  /// singular or not finite, or not positive definite as it should be.
  template <class Add>
  bool factorise(const Add& add) {
    return eliminateAll(
        Rest{&add, [](const void* of, int body) { (*static_cast<const Add*>(of))(body); }});
  }
  bool factorise() {
    return factorise([](int) {});
  }

  /// Which of the bodies of a contact or row has the block column to which it is added.
  enum class Side : unsigned char { A, B };
  /// Up to `most` contacts of the same two bodies, and how they answer the motion in a region: r =
  /// −G J y.
  class Responses {
   public:
    static constexpr int most = 8;
    /// For the column of the body on this side.
    explicit Responses(Side side) : side_(side) {}
    void add(const ContactRows& J, const Mat3& G) {
      own_[count_] = side_ == Side::A ? &J.Ja : &J.Jb;
      other_[count_] = side_ == Side::A ? &J.Jb : &J.Ja;
      body_ = side_ == Side::A ? J.a : J.b;
      G_[count_++] = &G;
    }
    bool isEmpty() const { return count_ == 0; }
    bool isFull() const { return count_ == most; }

   private:
    friend class BlockFactor;
    Side side_;
    int count_ = 0, body_ = 0;
    const Mat36 *own_[most], *other_[most];
    const Mat3* G_[most];
  };
  /// Adds Σ [Ja Jb]ᵀ G [Ja Jb] as far as it belongs to the column of the body on their side;
  /// `edge`: the edge of both bodies, less than 0 if they are not coupled. Then takes them out.
  void addContacts(Responses& contacts, int edge);
  /// The same for `count` rows of the same two bodies, with the weights `g`.
  void addRows(const ScalarRow* rows, const double* g, int count, int edge, Side side);

  /// The threads that help with large matrices from now on; null: none. The same bits.
  void setHands(Hands* hands) { hands_ = hands; }
  /// The sign of the determinant of the factored matrix.
  bool isDeterminantNegative() const { return isNegative_; }
  bool isCholesky() const { return isCholesky_; }
  /// Overwrites x with the solution.
  void solve(VectorXd& x) const;

  /// The six entries of a row that belong to one body.
  struct RowBlock {
    int body;
    Vec6 entries;
  };
  /// W = J A⁻¹ Jᵀ, for an A that has a Cholesky factor. Row i of J has the entries
  /// blocks[begin[i]] up to blocks[begin[i + 1]], each of another body, and is zero elsewhere.
  void condense(const std::vector<RowBlock>& blocks, const std::vector<int>& begin, KeptMatrix& W);

  std::size_t bytes() const;

 private:
  const BlockPattern& pattern() const { return patterns_.front(); }
  /// What is added to a column when its turn comes.
  struct Rest {
    const void* of;
    void (*addTo)(const void* of, int body);
  };

  void clear();
  bool eliminateAll(const Rest& rest);
  bool eliminateTogether(const Rest& rest);
  int blockIn(int edge, Side side) const;
  void assemble(int column, const Rest& rest);
  template <class Others>
  bool eliminate(int column, int* slot, const Others& others, bool& isNegative);

  std::list<BlockPattern> patterns_;  ///< most recently used first
  std::size_t bytesOfPatterns_ = 0;
  bool isCholesky_ = false, isNegative_ = false;
  bool isCleared_ = false;  ///< beside the diagonal; otherwise each column when its turn comes
  std::vector<int> slot_;   ///< scratch, for each hand: row -> block of the column being eliminated
  Hands* hands_ = nullptr;
  std::vector<std::atomic<bool>> isReady_;  ///< column -> whether its task is done; with hands only

  /// Pivot blocks and their inverses; of a Cholesky factor C⁻ᵀ and C⁻¹ of each.
  std::vector<Mat6> diagonal_, diagonalInverse_;
  /// Block (row, column) of L and block (column, row) of U, transposed. A Cholesky factor has no U.
  std::vector<Mat6> lower_, upper_;
  mutable VectorXd ordered_;  ///< scratch: a right-hand side in the elimination order
  // Scratch of condense: L⁻¹ Jᵀ, one row of J after the other, and its blocks that are not zero.
  VectorXd reduced_, sums_;
  std::vector<char> touched_;
  std::vector<const double*> sixes_;
  std::vector<int> sixesOf_;
  std::vector<double*> rowsOfW_;
};

}  // namespace delassus
