#include "delassus/principal_cholesky.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace delassus {

PrincipalCholesky::PrincipalCholesky(const MatrixXd& W, double shift, double redundant)
    : W_(W), shift_(shift), redundant_(redundant) {}

double PrincipalCholesky::entry(int i, int j) const {
  return i == j ? W_(i, i) + shift_ : i > j ? W_(i, j) : W_(j, i);
}

bool PrincipalCholesky::factor(const std::vector<int>& rows) {
  const int s = static_cast<int>(rows.size());
  edits_ = 0;
  rows_.clear();
  if (s == 0) return true;
  ++factorisations_;
  if (L_.rows() < s) L_.resize(W_.rows(), W_.rows());
  for (int j = 0; j < s; ++j)
    for (int i = j; i < s; ++i) L_(i, j) = entry(rows[i], rows[j]);

  // All at once. If a pivot vanishes, rows are added one by one, which can leave some out.
  Eigen::Ref<MatrixXd> block = L_.topLeftCorner(s, s);
  const Eigen::LLT<Eigen::Ref<MatrixXd>> llt(block);
  bool independent = llt.info() == Eigen::Success;
  for (int j = 0; j < s && independent; ++j)
    independent = L_(j, j) * L_(j, j) > redundant_ * entry(rows[j], rows[j]);
  if (independent) {
    rows_ = rows;
    return true;
  }
  bool complete = true;
  for (const int k : rows) complete = append(k) && complete;
  edits_ = 0;
  return complete;
}

bool PrincipalCholesky::retarget(const std::vector<int>& rows) {
  std::vector<char> wanted(W_.rows(), 0), present(W_.rows(), 0);
  for (const int k : rows) wanted[k] = 1;
  for (const int k : rows_) present[k] = 1;
  const auto leaving = [&](int k) { return !wanted[k]; };
  const auto arriving = [&](int k) { return !present[k]; };
  const auto changes = std::count_if(rows_.begin(), rows_.end(), leaving) +
                       std::count_if(rows.begin(), rows.end(), arriving);

  // An edit costs about s², a factorisation s³/3; round-off also builds up over more than s/4
  // edits.
  if (4 * (edits_ + changes) > static_cast<long>(rows.size())) return factor(rows);
  for (int p = static_cast<int>(rows_.size()) - 1; p >= 0; --p)
    if (leaving(rows_[p])) remove(p);
  bool complete = true;
  for (const int k : rows)
    if (arriving(k)) complete = append(k) && complete;
  return complete;
}

bool PrincipalCholesky::append(int k) {
  const int s = static_cast<int>(rows_.size());
  assert(k >= 0 && k < W_.rows() && "PrincipalCholesky: no such row");
  if (L_.rows() <= s) L_.conservativeResize(W_.rows(), W_.rows());

  // L y = W_Sk, pivot = W_kk − yᵀy: the compliance of k once S holds.
  VectorXd y(s);
  for (int i = 0; i < s; ++i) y[i] = entry(k, rows_[i]);
  L_.topLeftCorner(s, s).triangularView<Eigen::Lower>().solveInPlace(y);
  const double pivot = entry(k, k) - y.squaredNorm();
  if (!(pivot > redundant_ * entry(k, k))) return false;
  L_.row(s).head(s) = y.transpose();
  L_(s, s) = std::sqrt(pivot);
  rows_.push_back(k);
  ++edits_;
  return true;
}

void PrincipalCholesky::remove(int position) {
  const int s = static_cast<int>(rows_.size());
  assert(position >= 0 && position < s && "PrincipalCholesky: no such position");
  VectorXd l = L_.col(position).segment(position + 1, s - position - 1);

  // Close the gap: rows below move up, then columns to the right move left.
  for (int j = 0; j < position; ++j)
    for (int i = position; i < s - 1; ++i) L_(i, j) = L_(i + 1, j);
  for (int j = position; j < s - 1; ++j)
    L_.col(j).segment(j, s - 1 - j) = L_.col(j + 1).segment(j + 1, s - 1 - j);

  // L33' L33'ᵀ = L33 L33ᵀ + l lᵀ: one Givens rotation a column.
  for (int j = position; j < s - 1; ++j) {
    double& x = l[j - position];
    const double radius = std::hypot(L_(j, j), x);
    const double cosine = L_(j, j) / radius, sine = x / radius;
    L_(j, j) = radius;
    for (int i = j + 1; i < s - 1; ++i) {
      const double old = L_(i, j);
      L_(i, j) = cosine * old + sine * l[i - position];
      l[i - position] = cosine * l[i - position] - sine * old;
    }
  }
  rows_.erase(rows_.begin() + position);
  ++edits_;
}

VectorXd PrincipalCholesky::solve(const VectorXd& b) const {
  const auto s = static_cast<Eigen::Index>(rows_.size());
  const auto L = L_.topLeftCorner(s, s).triangularView<Eigen::Lower>();
  return L.transpose().solve(L.solve(b));
}

}  // namespace delassus
