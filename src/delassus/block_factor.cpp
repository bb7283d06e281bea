#include "delassus/block_factor.h"

#include <Eigen/LU>
#include <algorithm>

#include "delassus/block_product.h"
#include "delassus/bytes.h"

namespace delassus {
namespace {

/// A⁻¹ column by column, which for blocks this small is several times as fast as what Eigen does for all columns at once; Gauss and
/// Jordan's way would be faster still, but loses digits of stiff contacts. `isNegative`: whether det A < 0. False if A is singular or
/// not finite.
bool invert(const Mat6& A, Mat6& inverse, bool& isNegative) {
  const Eigen::PartialPivLU<Mat6> lu(A);
  isNegative = lu.determinant() < 0;
  inverse = lu.permutationP() * Mat6::Identity();
  for (int k = 0; k < 6; ++k) {
    Vec6 x = inverse.col(k);
    lu.matrixLU().triangularView<Eigen::UnitLower>().solveInPlace(x);
    lu.matrixLU().triangularView<Eigen::Upper>().solveInPlace(x);
    inverse.col(k) = x;
  }
  return inverse.allFinite();
}

}  // namespace

void BlockFactor::analyse(int bodies, const std::vector<Edge>& edges) {
  // Of large islands there are few kinds at a time: room is counted in edges, but for the largest, which is not to drive out all others.
  constexpr std::size_t mostPatterns = 64, mostEdges = 4096;
  const auto known = std::find_if(patterns_.begin(), patterns_.end(),
                                  [&](const BlockPattern& p) { return p.isOf(bodies, edges); });
  if (known != patterns_.end()) {
    patterns_.splice(patterns_.begin(), patterns_, known);
  } else {
    patterns_.emplace_front(bodies, edges);
    std::size_t count = 0, sum = 0, largest = 0;
    patterns_.remove_if([&](const BlockPattern& p) {
      sum += p.edges.size();
      largest = std::max(largest, p.edges.size());
      return ++count > 1 && (count > mostPatterns || sum - largest > mostEdges);
    });
  }

  slot_.resize(bodies);
  diagonal_.resize(bodies);
  diagonalInverse_.resize(bodies);
  lower_.resize(pattern().offDiagonalBlocks());
  upper_.resize(pattern().offDiagonalBlocks());
}

void BlockFactor::setIdentity(bool symmetric) {
  symmetric_ = symmetric;
  std::fill(diagonal_.begin(), diagonal_.end(), Mat6::Identity());
  std::fill(lower_.begin(), lower_.end(), Mat6::Zero());
  if (!symmetric) std::fill(upper_.begin(), upper_.end(), Mat6::Zero());
}

void BlockFactor::eliminate(int column) {
  const BlockPattern& p = pattern();
  for (int at = p.begin[column]; at < p.begin[column + 1]; ++at) slot_[p.row[at]] = at;

  // Left-looking: subtract what earlier columns j with a block in this row contribute.
  for (int k = p.ancestorBegin[column]; k < p.ancestorBegin[column + 1]; ++k) {
    const auto [j, at] = p.ancestors[k];
    const Mat6& L = lower_[at];  // L_{column,j}, already times the inverse pivot
    const Mat6& U = upper_[at];  // U_{j,column} transposed
    diagonal_[column].noalias() -= L * U.transpose();
    const int next = at + 1, count = p.begin[j + 1] - next;
    const int* rows = p.row.data() + next;
    subtractProducts(lower_.data() + next, rows, count, U, slot_.data(), lower_.data());
    if (!symmetric_)
      subtractProducts(upper_.data() + next, rows, count, L, slot_.data(), upper_.data());
  }
}

bool BlockFactor::factorise() {
  const BlockPattern& p = pattern();
  isNegative_ = false;
  for (int column = 0; column < p.bodies; ++column) {
    eliminate(column);
    Mat6& inverse = diagonalInverse_[column];
    bool isNegative;
    if (!invert(diagonal_[column], inverse, isNegative)) return false;
    if (isNegative) isNegative_ = !isNegative_;
    for (int at = p.begin[column]; at < p.begin[column + 1]; ++at) {
      if (symmetric_) upper_[at] = lower_[at];
      lower_[at] = (lower_[at] * inverse).eval();
    }
  }
  return true;
}

void BlockFactor::solve(VectorXd& x) const {
  const BlockPattern& p = pattern();
  ordered_.resize(paddedSize * p.bodies);
  double* z = ordered_.data();
  for (int body = 0; body < p.bodies; ++body)
    std::copy_n(x.data() + 6 * body, 6, z + paddedSize * p.place[body]);
  const BlockColumns L{p.bodies, p.begin.data(), p.row.data(), lower_.data()};
  const BlockColumns U{p.bodies, p.begin.data(), p.row.data(), upper_.data()};
  solveLower(L, z);
  solveUpper(U, diagonalInverse_.data(), z);
  for (int body = 0; body < p.bodies; ++body)
    std::copy_n(z + paddedSize * p.place[body], 6, x.data() + 6 * body);
}

std::size_t BlockFactor::bytes() const {
  std::size_t sum = bytesOf(slot_, diagonal_, diagonalInverse_, lower_, upper_, ordered_);
  for (const BlockPattern& kept : patterns_) sum += sizeof(BlockPattern) + kept.bytes();
  return sum;
}

}  // namespace delassus
