#include "delassus/block_factor.h"

#include <algorithm>

#include "delassus/block_inverse.h"
#include "delassus/block_product.h"
#include "delassus/bytes.h"

namespace delassus {
void BlockFactor::analyse(int bodies, const std::vector<Edge>& edges) {
  // There are only a few shapes of large islands at a time, so the limit counts edges. The largest
  // pattern does not count, since it would drive out all others.
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

void BlockFactor::setIdentity(bool isCholesky) {
  isCholesky_ = isCholesky;
  std::fill(diagonal_.begin(), diagonal_.end(), Mat6::Identity());
  std::fill(lower_.begin(), lower_.end(), Mat6::Zero());
  if (!isCholesky) std::fill(upper_.begin(), upper_.end(), Mat6::Zero());
}

void BlockFactor::addDiagonal(int body, const Mat36& A, const Mat36& B) {
  const Mat36 *a = &A, *b = &B;
  addProducts(&a, &b, 1, diagonal_[pattern().place[body]]);
}

void BlockFactor::addOffDiagonal(int edge, const Mat36& Aa, const Mat36& Ba, const Mat36& Ab,
                                 const Mat36& Bb) {
  const Mat36 *first[2] = {&Aa, &Ba}, *second[2] = {&Ab, &Bb};
  addOffDiagonal(edge, first, first + 1, second, second + 1, 1);
}

void BlockFactor::addOffDiagonal(int edge, const Mat36* const* Aa, const Mat36* const* Ba,
                                 const Mat36* const* Ab, const Mat36* const* Bb, int count) {
  const BlockPattern::Target& t = pattern().target[edge];
  if (t.reversed) {
    addProducts(Aa, Bb, count, lower_[t.at]);
    if (!isCholesky_) addProducts(Ba, Ab, count, upper_[t.at]);
  } else {
    addProducts(Ab, Ba, count, lower_[t.at]);
    if (!isCholesky_) addProducts(Bb, Aa, count, upper_[t.at]);
  }
}

void BlockFactor::addContacts(const Response* contacts, int count, int edge) {
  Mat36 ofA[mostContacts], ofB[mostContacts];  // G J
  const Mat36 *Ja[mostContacts], *Jb[mostContacts], *Ga[mostContacts], *Gb[mostContacts];
  const Mat3* G[mostContacts];
  const int a = contacts->J->a, b = contacts->J->b;
  for (int k = 0; k < count; ++k) {
    G[k] = contacts[k].G;
    Ja[k] = &contacts[k].J->Ja;
    Jb[k] = &contacts[k].J->Jb;
    Ga[k] = &ofA[k];
    Gb[k] = &ofB[k];
  }
  if (a >= 0) {
    multiplyRows(G, Ja, count, ofA);
    addProducts(Ja, Ga, count, diagonal_[pattern().place[a]]);
  }
  if (b >= 0) {
    multiplyRows(G, Jb, count, ofB);
    addProducts(Jb, Gb, count, diagonal_[pattern().place[b]]);
  }
  if (edge >= 0) addOffDiagonal(edge, Ja, Ga, Jb, Gb, count);
}

void BlockFactor::addRows(const ScalarRow* rows, const double* g, int count, int edge) {
  constexpr int stride = sizeof(ScalarRow) / sizeof(double);
  const int a = rows->a, b = rows->b;
  const double *Ja = rows->Ja.data(), *Jb = rows->Jb.data();
  if (a >= 0) addRowProducts(Ja, Ja, stride, g, count, diagonal_[pattern().place[a]]);
  if (b >= 0) addRowProducts(Jb, Jb, stride, g, count, diagonal_[pattern().place[b]]);
  if (edge < 0) return;
  const BlockPattern::Target& t = pattern().target[edge];
  const double *first = t.reversed ? Ja : Jb, *second = t.reversed ? Jb : Ja;
  addRowProducts(first, second, stride, g, count, lower_[t.at]);
  // The products of rows are symmetric: block (column, row) is the transpose of block (row,
  // column), and upper_ stores transposes.
  if (!isCholesky_) addRowProducts(first, second, stride, g, count, upper_[t.at]);
}

void BlockFactor::eliminate(int column) {
  const BlockPattern& p = pattern();
  for (int at = p.begin[column]; at < p.begin[column + 1]; ++at) slot_[p.row[at]] = at;

  // Left-looking: subtracts the products of earlier columns j with a block in this row; columns
  // with the same rows go together.
  BlockSource lower[mostSources], upper[mostSources];
  const int end = p.ancestorBegin[column + 1];
  for (int k = p.ancestorBegin[column]; k < end;) {
    const auto [j, first] = p.ancestors[k];
    const int count = p.begin[j + 1] - first;
    const int* rows = p.row.data() + first;  // this one, and those below it
    int columns = 0;
    for (; k < end && columns < mostSources && p.leader[p.ancestors[k].column] == p.leader[j];
         ++k) {
      const Mat6* L = &lower_[p.ancestors[k].at];  // L_{column,j}, already times the inverse pivot
      const Mat6* U = isCholesky_ ? L : &upper_[p.ancestors[k].at];  // U_{j,column} transposed
      lower[columns] = {L, U};
      upper[columns++] = {U, L};
    }
    subtractProducts(lower, columns, rows, count, slot_.data(), &diagonal_[column], lower_.data());
    if (!isCholesky_ && count > 1)
      subtractProducts(upper, columns, rows, count, slot_.data(), nullptr, upper_.data());
  }
}

bool BlockFactor::factorise() {
  const BlockPattern& p = pattern();
  isNegative_ = false;
  for (int column = 0; column < p.bodies; ++column) {
    eliminate(column);
    const int first = p.begin[column], count = p.begin[column + 1] - first;
    Mat6 &pivot = diagonal_[column], &inverse = diagonalInverse_[column];
    if (isCholesky_) {
      if (!invertCholesky(pivot, inverse, pivot)) return false;
      multiplyByUpper(pivot, lower_.data() + first, count);
      continue;
    }
    bool isNegative;
    if (!invert(pivot, inverse, isNegative)) return false;
    if (isNegative) isNegative_ = !isNegative_;
    multiplyBy(inverse, lower_.data() + first, count);
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
  if (isCholesky_) {
    solveLower(L, diagonalInverse_.data(), z);
    solveUpper(L, diagonal_.data(), z);
  } else {
    const BlockColumns U{p.bodies, p.begin.data(), p.row.data(), upper_.data()};
    solveLower(L, z);
    solveUpper(U, diagonalInverse_.data(), z);
  }
  for (int body = 0; body < p.bodies; ++body)
    std::copy_n(z + paddedSize * p.place[body], 6, x.data() + 6 * body);
}

void BlockFactor::condense(const std::vector<RowBlock>& blocks, const std::vector<int>& begin,
                           KeptMatrix& W) {
  const BlockPattern& p = pattern();
  const int rows = static_cast<int>(begin.size()) - 1, length = paddedSize * p.bodies;
  // A = L Lᵀ: W = Yᵀ Y with Y = L⁻¹ Jᵀ.
  const BlockColumns L{p.bodies, p.begin.data(), p.row.data(), lower_.data()};
  reduced_.resize(static_cast<Eigen::Index>(rows) * length);
  touched_.assign(static_cast<std::size_t>(rows) * p.bodies, 0);
  for (int i = 0; i < rows; ++i) {
    double* const z = reduced_.data() + i * length;
    char* const touched = touched_.data() + i * p.bodies;
    for (int k = begin[i]; k < begin[i + 1]; ++k) {
      const int place = p.place[blocks[k].body];
      std::copy_n(blocks[k].entries.data(), 6, z + paddedSize * place);
      touched[place] = 1;
    }
    solveLower(L, diagonalInverse_.data(), touched, z);
  }

  W.resize(rows, rows);
  W.setZero();
  rowsOfW_.clear();
  for (int i = 0; i < rows; ++i) rowsOfW_.push_back(&W(i, 0));
  sums_.resize(7 * (rows + 4));
  for (int column = 0; column < p.bodies; ++column) {
    sixes_.clear();
    sixesOf_.clear();
    for (int i = 0; i < rows; ++i) {
      if (!touched_[i * p.bodies + column]) continue;
      sixes_.push_back(reduced_.data() + i * length + paddedSize * column);
      sixesOf_.push_back(i);
    }
    addSquares(sixes_.data(), sixesOf_.data(), static_cast<int>(sixes_.size()), sums_.data(),
               rowsOfW_.data());
  }
  W.triangularView<Eigen::StrictlyUpper>() = W.transpose();
}

std::size_t BlockFactor::bytes() const {
  std::size_t sum = bytesOf(slot_, diagonal_, diagonalInverse_, lower_, upper_, ordered_, reduced_,
                            sums_, touched_, sixes_, sixesOf_, rowsOfW_);
  for (const BlockPattern& kept : patterns_) sum += sizeof(BlockPattern) + kept.bytes();
  return sum;
}

}  // namespace delassus
