#include "delassus/block_factor.h"

#include <algorithm>
#include <utility>

#include "delassus/block_inverse.h"
#include "delassus/block_product.h"
#include "delassus/bytes.h"
#include "delassus/hands.h"

namespace delassus {
namespace {

/// Which of the earlier columns a hand may use that works alone: all.
struct Alone {
  bool waitFor(int) const { return true; }
  bool isReady(int) const { return true; }
};

/// And one that works beside others: those of its own task, from `own` on, and those that are
/// ready.
struct Beside {
  const std::atomic<bool>* ready;
  int own;
  const std::atomic<bool>& hasFailed;

  bool isReady(int column) const {
    return column >= own || ready[column].load(std::memory_order_acquire);
  }
  /// False if another hand has failed: then the column may never be ready.
  bool waitFor(int column) const {
    waitUntil([&] { return isReady(column) || hasFailed; });
    return isReady(column);
  }
};

void setZero(Mat6* blocks, std::size_t count) {
  static_assert(sizeof(Mat6) == Mat6::SizeAtCompileTime * sizeof(double));
  if (count > 0) std::fill_n(blocks->data(), Mat6::SizeAtCompileTime * count, 0.0);
}

}  // namespace

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
    bytesOfPatterns_ = 0;
    for (const BlockPattern& kept : patterns_)
      bytesOfPatterns_ += sizeof(BlockPattern) + kept.bytes();
  }

  slot_.resize(bodies);
  diagonal_.resize(bodies);
  diagonalInverse_.resize(bodies);
  lower_.resize(pattern().offDiagonalBlocks());
  upper_.resize(pattern().offDiagonalBlocks());
}

void BlockFactor::setIdentity(bool isCholesky) {
  isCholesky_ = isCholesky;
  isCleared_ = false;
  std::fill(diagonal_.begin(), diagonal_.end(), Mat6::Identity());
}

/// All columns at once, for blocks that are added before the elimination.
void BlockFactor::clear() {
  if (isCleared_) return;
  setZero(lower_.data(), lower_.size());
  if (!isCholesky_) setZero(upper_.data(), upper_.size());
  isCleared_ = true;
}

void BlockFactor::addDiagonal(int body, const Mat36& A, const Mat36& B) {
  const Mat36 *a = &A, *b = &B;
  addProducts(&a, &b, 1, diagonal_[pattern().place[body]]);
}

void BlockFactor::addOffDiagonal(int edge, const Mat36& Aa, const Mat36& Ba, const Mat36& Ab,
                                 const Mat36& Bb) {
  clear();
  const Mat36 *a = &Aa, *Ga = &Ba, *b = &Ab, *Gb = &Bb;
  const BlockPattern::Target& t = pattern().target[edge];
  if (t.reversed) std::swap(a, b), std::swap(Ga, Gb);
  addProducts(&b, &Ga, 1, lower_[t.at]);
  if (!isCholesky_) addProducts(&Gb, &a, 1, upper_[t.at]);
}

void BlockFactor::addContacts(Responses& contacts, int edge) {
  Mat36 products[Responses::most];  // G J
  const Mat36* response[Responses::most];
  for (int k = 0; k < Responses::most; ++k) response[k] = &products[k];
  const Mat36 *const *own = contacts.own_, *const *other = contacts.other_;
  const int count = std::exchange(contacts.count_, 0);
  multiplyRows(contacts.G_, own, count, products);
  addProducts(own, response, count, diagonal_[pattern().place[contacts.body_]]);
  const int at = blockIn(edge, contacts.side_);
  if (at < 0) return;
  addProducts(other, response, count, lower_[at]);
  if (isCholesky_) return;
  multiplyRows(contacts.G_, other, count, products);
  addProducts(response, own, count, upper_[at]);
}

void BlockFactor::addRows(const ScalarRow* rows, const double* g, int count, int edge, Side side) {
  constexpr int stride = sizeof(ScalarRow) / sizeof(double);
  const bool isA = side == Side::A;
  const double *own = isA ? rows->Ja.data() : rows->Jb.data(),
               *other = isA ? rows->Jb.data() : rows->Ja.data();
  addRowProducts(own, own, stride, g, count, diagonal_[pattern().place[isA ? rows->a : rows->b]]);
  const int at = blockIn(edge, side);
  if (at < 0) return;
  addRowProducts(other, own, stride, g, count, lower_[at]);
  // The products of rows are symmetric: block (column, row) is the transpose of block (row,
  // column), and upper_ stores transposes.
  if (!isCholesky_) addRowProducts(other, own, stride, g, count, upper_[at]);
}

/// The block of an edge if it is in the column of this body; less than 0 if it is in that of the
/// other, or if there is none.
int BlockFactor::blockIn(int edge, Side side) const {
  if (edge < 0) return -1;
  const BlockPattern::Target& t = pattern().target[edge];
  return t.reversed == (side == Side::B) ? t.at : -1;
}

void BlockFactor::assemble(int column, const Rest& rest) {
  const BlockPattern& p = pattern();
  if (!isCleared_) {
    // Not before: now the column comes into the cache where it is needed.
    const int begin = p.begin[column], count = p.begin[column + 1] - begin;
    setZero(lower_.data() + begin, count);
    if (!isCholesky_) setZero(upper_.data() + begin, count);
  }
  rest.addTo(rest.of, p.bodyAt[column]);
}

/// Left-looking: subtracts from a column the products of the earlier ones with a block in its row;
/// columns with the same rows go together, as far as they are ready (that changes no bit). False as
/// `factorise`, or if another hand has failed.
template <class Others>
bool BlockFactor::eliminate(int column, int* slot, const Others& others, bool& isNegative) {
  const BlockPattern& p = pattern();
  const int begin = p.begin[column], below = p.begin[column + 1] - begin;
  for (int i = 0; i < below; ++i) slot[p.row[begin + i]] = begin + i;

  BlockSource lower[mostSources], upper[mostSources];
  const int end = p.ancestorBegin[column + 1];
  for (int k = p.ancestorBegin[column]; k < end;) {
    const auto [j, first] = p.ancestors[k];
    if (!others.waitFor(j)) return false;
    const int count = p.begin[j + 1] - first;
    const int* rows = p.row.data() + first;  // this one, and those below it
    int columns = 0;
    do {
      const Mat6* L = &lower_[p.ancestors[k].at];  // L_{column,j}, already times the inverse pivot
      const Mat6* U = isCholesky_ ? L : &upper_[p.ancestors[k].at];  // U_{j,column} transposed
      lower[columns] = {L, U};
      upper[columns++] = {U, L};
      ++k;
    } while (k < end && columns < mostSources && p.leader[p.ancestors[k].column] == p.leader[j] &&
             others.isReady(p.ancestors[k].column));
    subtractProducts(lower, columns, rows, count, slot, &diagonal_[column], lower_.data());
    if (!isCholesky_ && count > 1)
      subtractProducts(upper, columns, rows, count, slot, nullptr, upper_.data());
  }

  Mat6 &pivot = diagonal_[column], &inverse = diagonalInverse_[column];
  if (isCholesky_) {
    if (!invertCholesky(pivot, inverse, pivot)) return false;
    multiplyByUpper(pivot, lower_.data() + begin, below);
    return true;
  }
  bool isPivotNegative;
  if (!invert(pivot, inverse, isPivotNegative)) return false;
  if (isPivotNegative) isNegative = !isNegative;
  multiplyBy(inverse, lower_.data() + begin, below);
  return true;
}

bool BlockFactor::eliminateAll(const Rest& rest) {
  if (hands_ && pattern().isLarge()) return eliminateTogether(rest);
  isNegative_ = false;
  for (int column = 0; column < pattern().bodies; ++column) {
    assemble(column, rest);
    if (!eliminate(column, slot_.data(), Alone(), isNegative_)) return false;
  }
  return true;
}

/// All hands take one task after the other. A task that needs a column of an earlier one, which
/// another hand has taken, waits for it.
bool BlockFactor::eliminateTogether(const Rest& rest) {
  const BlockPattern& p = pattern();
  const auto tasks = static_cast<int>(p.tasks.size());
  if (isReady_.size() < static_cast<std::size_t>(p.bodies))
    isReady_ = std::vector<std::atomic<bool>>(p.bodies);
  for (int column = 0; column < p.bodies; ++column)
    isReady_[column].store(false, std::memory_order_relaxed);
  slot_.resize(static_cast<std::size_t>(hands_->count()) * p.bodies);
  std::atomic<int> nextTask{0}, negatives{0};
  std::atomic<bool> hasFailed{false};
  const auto work = [&](int hand) {
    int* const slot = slot_.data() + static_cast<std::ptrdiff_t>(hand) * p.bodies;
    bool isNegative = false;
    for (int i = nextTask++; i < tasks && !hasFailed; i = nextTask++) {
      const auto [begin, end] = p.tasks[i];
      const Beside others{isReady_.data(), begin, hasFailed};
      for (int column = begin; column < end; ++column) {
        assemble(column, rest);
        if (!eliminate(column, slot, others, isNegative)) {
          hasFailed = true;
          return;
        }
      }
      for (int column = begin; column < end; ++column)
        isReady_[column].store(true, std::memory_order_release);
    }
    if (isNegative) ++negatives;
  };
  hands_->together(work);
  isNegative_ = negatives % 2 == 1;
  return !hasFailed;
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
  return bytesOfPatterns_ + bytesOf(slot_, isReady_, diagonal_, diagonalInverse_, lower_, upper_,
                                    ordered_, reduced_, sums_, touched_, sixes_, sixesOf_,
                                    rowsOfW_);
}

}  // namespace delassus
