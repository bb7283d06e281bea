#pragma once

#include <vector>

#include "delassus/types.h"

namespace delassus {

/// A pivot below this share of the diagonal shows that a row depends on those before it (algorithms
/// 3.5).
constexpr double dependentPivot = 1e-10;

/// Cholesky factor L Lᵀ = (W + shift I)_SS of the rows S that a region keeps, edited as contacts
/// come and go (algorithms 4.2). Only the lower triangle of W is read; W must outlive the factor.
///
/// To add a row costs s² flops, to delete the p-th one 2 (s − p)². Both are stable; after many
/// edits the matrix is factored anew.
class PrincipalCholesky {
 public:
  /// A row whose pivot falls to `redundant` times its diagonal entry or below depends on the rows
  /// before it.
  explicit PrincipalCholesky(const MatrixXd& W, double shift = 0,
                             double redundant = dependentPivot);

  /// Factors the rows in this order. False if some are redundant; these are left out.
  bool factor(const std::vector<int>& rows);
  /// Gives the same set as `factor(rows)`, in any order, by edits where they are cheaper.
  bool retarget(const std::vector<int>& rows);
  /// Adds row k at the end. False, and nothing is added, if it is redundant.
  bool append(int k);
  /// Deletes the row at `position` in `rows()`.
  void remove(int position);

  /// (W + shift I)_SS⁻¹ b, with b ordered as `rows()`.
  VectorXd solve(const VectorXd& b) const;

  const std::vector<int>& rows() const { return rows_; }
  bool edited() const { return edits_ > 0; }  ///< since the last factorisation from scratch
  int factorisations() const { return factorisations_; }  ///< from scratch

 private:
  double entry(int i, int j) const;

  const MatrixXd& W_;
  double shift_, redundant_;
  MatrixXd L_;
  std::vector<int> rows_;
  int edits_ = 0, factorisations_ = 0;
};

}  // namespace delassus
