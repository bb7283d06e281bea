#include "tests/peers/siconos_problem.h"

#include <NumericsMatrix.h>
#include <SparseBlockMatrix.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <vector>

namespace delassus::peers {

namespace {

/// Siconos frees what it is given.
template <class Number>
Number* allocated(std::size_t count) {
  return static_cast<Number*>(std::calloc(std::max<std::size_t>(count, 1), sizeof(Number)));
}

double* allocated(const VectorXd& numbers) {
  double* copy = allocated<double>(std::size_t(numbers.size()));
  std::copy(numbers.data(), numbers.data() + numbers.size(), copy);
  return copy;
}

template <class Visit>
void visitEntries(const DelassusMatrix::Sparse& W, Visit visit) {
  for (int row = 0; row < W.outerSize(); ++row)
    for (DelassusMatrix::Sparse::InnerIterator entry(W, row); entry; ++entry)
      visit(row, int(entry.col()), entry.value());
}

NumericsMatrix* denseMatrix(const DelassusMatrix::Sparse& W) {
  const int size = int(W.rows());
  NumericsMatrix* M = NM_create(NM_DENSE, size, size);
  std::fill_n(M->matrix0, std::size_t(size) * size, 0.0);
  visitEntries(W, [&](int row, int column, double value) {
    M->matrix0[std::size_t(column) * size + row] = value;
  });
  return M;
}

/// Columns of the blocks that are not zero, one row of blocks after the other. Those of row a begin
/// at begin[a].
struct Pattern {
  std::vector<std::size_t> begin{0}, columns;

  explicit Pattern(const DelassusMatrix::Sparse& W) {
    for (int a = 0; a < W.rows() / 3; ++a) {
      std::set<std::size_t> inRow;
      for (int row = 3 * a; row < 3 * a + 3; ++row)
        for (DelassusMatrix::Sparse::InnerIterator entry(W, row); entry; ++entry)
          inRow.insert(std::size_t(entry.col() / 3));
      columns.insert(columns.end(), inRow.begin(), inRow.end());
      begin.push_back(columns.size());
    }
  }

  std::size_t find(int a, int b) const {
    const auto first = columns.begin() + std::ptrdiff_t(begin[a]);
    const auto last = columns.begin() + std::ptrdiff_t(begin[a + 1]);
    return std::size_t(std::lower_bound(first, last, std::size_t(b)) - columns.begin());
  }
};

NumericsMatrix* blockMatrix(const DelassusMatrix::Sparse& W) {
  const Pattern pattern(W);
  SparseBlockStructuredMatrix* M = SBM_new();

  const std::size_t contacts = pattern.begin.size() - 1, blocks = pattern.columns.size();
  M->blocknumber0 = M->blocknumber1 = unsigned(contacts);
  M->blocksize0 = allocated<unsigned>(contacts);
  M->blocksize1 = allocated<unsigned>(contacts);
  for (std::size_t a = 0; a < contacts; ++a)
    M->blocksize0[a] = M->blocksize1[a] = 3 * (unsigned(a) + 1);

  M->nbblocks = unsigned(blocks);
  M->filled1 = contacts + 1;
  M->filled2 = blocks;
  M->index1_data = allocated<std::size_t>(contacts + 1);
  M->index2_data = allocated<std::size_t>(blocks);
  std::copy(pattern.begin.begin(), pattern.begin.end(), M->index1_data);
  std::copy(pattern.columns.begin(), pattern.columns.end(), M->index2_data);

  M->block = allocated<double*>(blocks);
  for (std::size_t i = 0; i < blocks; ++i) M->block[i] = allocated<double>(9);
  visitEntries(W, [&](int row, int column, double value) {
    double* const block = M->block[pattern.find(row / 3, column / 3)];
    block[3 * (column % 3) + row % 3] = value;
  });
  return NM_new_SBM(int(W.rows()), int(W.cols()), M);
}

}  // namespace

SiconosProblem siconosProblem(const Problem& problem, Storage storage) {
  const DelassusMatrix::Sparse& W = problem.W.entries();
  NumericsMatrix* const M = storage == Storage::Dense ? denseMatrix(W) : blockMatrix(W);
  return {frictionContactProblem_new_with_data(3, problem.contacts(), M, allocated(problem.q),
                                               allocated(problem.friction)),
          frictionContactProblem_free};
}

}  // namespace delassus::peers
