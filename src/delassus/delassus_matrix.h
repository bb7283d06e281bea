#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "delassus/bytes.h"
#include "delassus/contact_rows.h"
#include "delassus/types.h"

namespace delassus {

/// W factored in body space: W = J̃ J̃ᵀ + diag(compliance), with the mass-normalised Jacobian J̃ =
/// J B, M⁻¹ = B Bᵀ.
///
/// Its generalised velocity y has M = I: y = J̃ᵀ r, and ½ yᵀy is the kinetic energy that the
/// reactions add. A locked axis is a zero column. Body blocks have six columns; an articulated body
/// has as many blocks as its freedoms fill. J̃ is in 1/√kg, y in √J. For n contacts and m rows: n
/// entries in `contacts`, m in `rows`, 3n + m in `compliance`.
struct BodySpace {
  /// Three rows of a contact, or one.
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor, 3, 6>;
  /// A block of an articulated body that a contact or row moves beside its a and b.
  struct Part {
    int at;  ///< its first unknown
    int body;
    Rows J;
  };

  int bodies = 0;
  std::vector<ContactRows> contacts;
  std::vector<ScalarRow> rows;
  std::vector<Part> parts;  ///< in the order of the unknowns, no block twice in one contact or row
  VectorXd compliance;      ///< one entry per unknown, 1/kg

  void impulse(const VectorXd& r, VectorXd& y) const;           ///< y = J̃ᵀ r
  void relativeVelocity(const VectorXd& y, VectorXd& u) const;  ///< u = J̃ y

  struct PartRange {
    const Part *first, *last;
    const Part* begin() const { return first; }
    const Part* end() const { return last; }
  };
  /// Parts of the contact or row whose first unknown is `at`.
  PartRange partsOf(int at) const;

  std::size_t bytes() const { return bytesOf(contacts, rows, parts, compliance); }
};

/// The Delassus matrix W = J M⁻¹ Jᵀ of one island: n contacts with three rows each, then m scalar
/// rows.
///
/// One type, two storages: factored in body space (worlds), or explicit entries (problem files),
/// which are kept exactly as read: neither symmetrised nor scaled.
class DelassusMatrix {
 public:
  using Sparse = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  DelassusMatrix() = default;
  explicit DelassusMatrix(const Sparse& entries);
  explicit DelassusMatrix(BodySpace space);

  int size() const { return size_; }
  bool inBodySpace() const { return inBodySpace_; }
  const BodySpace& bodySpace() const { return others_ ? *others_ : space_; }
  /// Becomes a factored matrix of `size` unknowns. Returns its storage, to be filled anew.
  BodySpace& refill(int size) {
    size_ = size;
    inBodySpace_ = true;
    others_ = nullptr;
    space_.parts.clear();
    return space_;
  }
  /// Refers to the entries of a factored matrix, without a copy; that matrix must outlive this one.
  void refer(const DelassusMatrix& factored) {
    size_ = factored.size_;
    inBodySpace_ = true;
    others_ = &factored.bodySpace();
  }
  const Sparse& entries() const { return entries_; }  ///< explicit storage only
  /// Whether all entries are stored, so that the values are those of a row-major n x n matrix.
  bool isFull() const {
    return !inBodySpace_ && entries_.nonZeros() == Eigen::Index(size_) * size_;
  }

  VectorXd operator*(const VectorXd& r) const;  ///< W r
  /// u = W r; y is scratch (J̃ᵀ r afterwards, if factored).
  void multiply(const VectorXd& r, VectorXd& y, VectorXd& u) const;
  /// The 3x3 diagonal block of the contact whose unknowns start at `first`.
  Mat3 contactBlock(int first) const;
  /// The 2x2 diagonal block of the two rows whose unknowns start at `first`.
  Mat2 pairBlock(int first) const;
  /// The diagonal entry of the row with this unknown.
  double diagonalOfRow(int unknown) const;
  VectorXd diagonal() const;
  /// The same if the contactBlock of each contact is known.
  void diagonal(const std::vector<Mat3>& contactBlocks, VectorXd& d) const;
  MatrixXd dense() const;
  /// As entries, whatever the storage. For a factored matrix they are exactly symmetric: both
  /// triangles sum the same products in the same order.
  Sparse asEntries() const;
  /// Size of its own body space, not of one that it refers to.
  std::size_t bytes() const { return space_.bytes(); }

 private:
  int size_ = 0;
  bool inBodySpace_ = false;
  BodySpace space_;
  const BodySpace* others_ = nullptr;  ///< body space of the matrix it refers to
  Sparse entries_;
};

}  // namespace delassus
