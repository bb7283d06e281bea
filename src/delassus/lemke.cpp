#include "delassus/lemke.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

namespace delassus {
namespace {

/// A pivot must exceed this part of the largest entry of its column.
constexpr double smallestPivot = 1e-11;

/// w = M z + q, 0 ≤ z ⊥ w ≥ 0 by a tableau [w | z | covering variable | q].
class Tableau {
 public:
  Tableau(const MatrixXd& M, const VectorXd& q)
      : n_(static_cast<int>(q.size())), cover_(2 * n_), T_(n_, 2 * n_ + 2), basis_(n_) {
    T_ << MatrixXd::Identity(n_, n_), -M, VectorXd::Constant(n_, -1), q;
    for (int i = 0; i < n_; ++i) basis_[i] = i;
  }

  std::optional<VectorXd> solve(int pivotBudget, int& pivots) {
    int row = 0;
    if (n_ == 0 || T_.col(2 * n_ + 1).minCoeff(&row) >= 0) return values();

    // The covering variable enters where q is most negative; then every w is non-negative.
    for (int i = 0; i < n_; ++i)
      if (i != row && lexicallyLess(i, 1, row, 1)) row = i;
    int entering = cover_;
    for (int k = 0; k < pivotBudget; ++k) {
      const int leaving = basis_[row];
      pivotOn(row, entering);
      ++pivots;
      if (leaving == cover_) return values();
      entering = leaving < n_ ? leaving + n_ : leaving - n_;
      row = ratioTest(entering);
      if (row < 0) return std::nullopt;
    }
    return std::nullopt;
  }

 private:
  /// Compares [q, B⁻¹] of two rows, each over its divisor.
  bool lexicallyLess(int a, double divisorA, int b, double divisorB) const {
    const int last = 2 * n_ + 1;
    for (int k = -1; k < n_; ++k) {
      const int column = k < 0 ? last : k;
      const double left = T_(a, column) / divisorA, right = T_(b, column) / divisorB;
      const double slack = smallestPivot * std::max(std::abs(left), std::abs(right));
      if (left < right - slack) return true;
      if (left > right + slack) return false;
    }
    return false;
  }

  int ratioTest(int entering) const {
    const double smallest = smallestPivot * std::max(1.0, T_.col(entering).cwiseAbs().maxCoeff());
    int best = -1;
    for (int i = 0; i < n_; ++i) {
      const double t = T_(i, entering);
      if (t > smallest && (best < 0 || lexicallyLess(i, t, best, T_(best, entering)))) best = i;
    }
    return best;
  }

  void pivotOn(int row, int entering) {
    T_.row(row) /= T_(row, entering);
    for (int i = 0; i < n_; ++i)
      if (i != row && T_(i, entering) != 0) T_.row(i) -= T_(i, entering) * T_.row(row);
    basis_[row] = entering;
  }

  VectorXd values() const {
    VectorXd z = VectorXd::Zero(n_);
    for (int i = 0; i < n_; ++i)
      if (basis_[i] >= n_ && basis_[i] < cover_) z[basis_[i] - n_] = T_(i, 2 * n_ + 1);
    return z;
  }

  int n_, cover_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> T_;
  std::vector<int> basis_;
};

/// Rows with at least one bound: r = origin + signs z with z ≥ 0, and z ≤ width for boxes.
std::optional<VectorXd> solveBounded(const MatrixXd& W, const VectorXd& q, const VectorXd& lower,
                                     const VectorXd& upper, int pivotBudget, int& pivots) {
  const int n = static_cast<int>(q.size());
  VectorXd origin = VectorXd::Zero(n);
  std::vector<int> row;
  std::vector<double> sign;
  std::vector<int> boxed;  // variables with a width
  const auto addVariable = [&](int i, double s) {
    row.push_back(i);
    sign.push_back(s);
  };
  for (int i = 0; i < n; ++i) {
    const bool below = std::isfinite(lower[i]), above = std::isfinite(upper[i]);
    if (below || above) origin[i] = below ? lower[i] : upper[i];
    if (below && above && lower[i] == upper[i]) continue;
    if (below && above) boxed.push_back(static_cast<int>(row.size()));
    if (below || !above) addVariable(i, 1);
    if (!below) addVariable(i, -1);
  }

  const int variables = static_cast<int>(row.size()), boxes = static_cast<int>(boxed.size());
  const Eigen::Map<const Eigen::VectorXd> signs(sign.data(), variables);
  MatrixXd M = MatrixXd::Zero(variables + boxes, variables + boxes);
  VectorXd constant(variables + boxes);
  const VectorXd free = W * origin + q;
  M.topLeftCorner(variables, variables) =
      signs.asDiagonal() * MatrixXd(W(row, row)) * signs.asDiagonal();
  constant.head(variables) = signs.cwiseProduct(VectorXd(free(row)));
  for (int k = 0; k < boxes; ++k) {
    // w = … + y ≥ 0 with the slack width − z ≥ 0 ⊥ y ≥ 0.
    M(boxed[k], variables + k) = 1;
    M(variables + k, boxed[k]) = -1;
    constant[variables + k] = upper[row[boxed[k]]] - lower[row[boxed[k]]];
  }

  const auto z = Tableau(M, constant).solve(pivotBudget, pivots);
  if (!z) return std::nullopt;
  VectorXd r = origin;
  for (int k = 0; k < variables; ++k) r[row[k]] += sign[k] * (*z)[k];
  return r;
}

}  // namespace

std::optional<VectorXd> lemke(const BoundedRows& problem, int pivotBudget, int& pivots) {
  std::vector<int> equations, bounded;
  for (int i = 0; i < problem.size(); ++i)
    (problem.bilateral(i) ? equations : bounded).push_back(i);

  Eigen::FullPivLU<MatrixXd> lu;
  if (!equations.empty()) lu.compute(problem.W(equations, equations));
  if (equations.empty() || !lu.isInvertible())
    return solveBounded(problem.W, problem.q, problem.lower, problem.upper, pivotBudget, pivots);

  // r_E = −W_EE⁻¹ (q_E + W_EB r_B).
  const MatrixXd coupling = lu.solve(MatrixXd(problem.W(equations, bounded)));
  const VectorXd alone = lu.solve(VectorXd(problem.q(equations)));
  const MatrixXd row = problem.W(bounded, equations);
  const auto r =
      solveBounded(problem.W(bounded, bounded) - row * coupling, problem.q(bounded) - row * alone,
                   problem.lower(bounded), problem.upper(bounded), pivotBudget, pivots);
  if (!r) return std::nullopt;
  VectorXd all(problem.size());
  all(bounded) = *r;
  all(equations) = -alone - coupling * *r;
  return all;
}

}  // namespace delassus
