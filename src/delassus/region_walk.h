#pragma once

#include <Eigen/LU>
#include <memory>
#include <vector>

#include "delassus/active_set.h"
#include "delassus/principal_cholesky.h"

namespace delassus {

/// Rows with bounds, scaled so that W has unit diagonal where possible:
///
///     u = W r + q,   lower ≤ r ≤ upper,   u ≥ 0 at lower, u ≤ 0 at upper, u = 0 in between
struct BoundedRows {
  MatrixXd W;
  VectorXd q, lower, upper;
  bool symmetric = true;  ///< positive semi-definite too: Cholesky; otherwise LU

  int size() const { return static_cast<int>(q.size()); }
  VectorXd clamp(const VectorXd& r) const { return r.cwiseMax(lower).cwiseMin(upper); }
  bool bilateral(int i) const;
  bool constant(int i) const { return lower[i] == upper[i]; }
  /// max |r − clamp(r − u)|, u = W r + q.
  double naturalResidual(const VectorXd& r) const;
  /// The error that round-off may leave in u at these reactions: 64 ε max|q| + 16 ε ‖r‖ (algorithms
  /// 3.6, 10).
  double roundOff(const VectorXd& r) const;
  /// A state that a row can take: constant rows stay at their bound, bilateral rows are free, and
  /// no row sits at infinity.
  RowState possible(int i, RowState wished) const;
  /// The states that the signs of q at the reactions nearest to zero suggest.
  std::vector<RowState> firstStates() const;
};

/// Guarded block principal pivoting over the regions of bounded rows (algorithms 4.3, 4.5).
///
/// Every region takes one linear solve; then all rows that object to its answer change their state
/// together. When that has not helped for a while, a guard makes the walk finite. For a symmetric W
/// it is a descent of ½ rᵀW r + qᵀr from face to face, which needs few regions even if W is nearly
/// singular (Murty's rule took thousands on 570 rows of a Kapla tower). Otherwise it is Murty's
/// single changes in a fixed order, finite for every P-matrix.
class RegionWalk {
 public:
  enum class End : unsigned char {
    Settled,      ///< no row objects
    Singular,     ///< the free rows of a region are dependent: use alpha > 0
    OutOfBudget,  ///< too many regions
  };

  RegionWalk(const BoundedRows& problem, std::vector<RowState> start);

  /// Walks to the region of the problem with W + alpha I in place of W and q − alpha anchor in
  /// place of q: a proximal step from `anchor` (algorithms 5.2). alpha = 0 is the problem itself.
  /// Gives up once this walk, in all calls together, has visited `regionBudget` regions.
  End settle(const VectorXd& anchor, double alpha, int regionBudget);

  /// Whether some row at its bound with u = 0 depends on the free rows: then the settled r is one
  /// of many.
  bool redundantTies();

  const VectorXd& r() const {
    return r_;
  }  ///< answer of the last region; at first the values nearest to zero
  const std::vector<RowState>& states() const { return states_; }
  int regions() const { return regions_; }
  int factorisations() const;

 private:
  bool factorFreeRows(double alpha, bool anew);
  VectorXd solveFreeRows(const VectorXd& b) const;
  bool solveRegion(const VectorXd& anchor, double alpha);
  bool answerRegion(const VectorXd& anchor, double alpha);
  End descend(const VectorXd& anchor, double alpha, int regionBudget);
  void holdAtBounds(const VectorXd& r);
  void stepToFirstBound(VectorXd& r);
  std::vector<int> objections() const;
  void changeState(int row);

  const BoundedRows& problem_;
  std::vector<RowState> states_;
  VectorXd r_, u_;  ///< of the current region, u with the proximal term
  double alpha_ = -1;
  std::unique_ptr<PrincipalCholesky> cholesky_;
  Eigen::PartialPivLU<MatrixXd> lu_;
  std::vector<int> free_;
  int regions_ = 0, factorisations_ = 0;
};

}  // namespace delassus
