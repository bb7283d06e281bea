#pragma once

#include "delassus/types.h"

namespace delassus {

/// Products of 6x6 blocks, which are nearly all the work of a block factor and its solutions. They
/// use vectors as wide as the processor allows. The bits are the same on every processor, since
/// nothing is fused and every sum is added in the same order.

/// A product to subtract from a column of a factor: the blocks of another column, times Bᵀ.
struct BlockSource {
  const Mat6* blocks;
  const Mat6* B;
};
constexpr int mostSources = 8;

/// diagonal −= blocks[0] Bᵀ, if it is not null, and to[place[row[i]]] −= blocks[i] Bᵀ for the other
/// i < count; for up to mostSources columns with the same rows, one after the other.
void subtractProducts(const BlockSource* sources, int columns, const int* row, int count,
                      const int* place, Mat6* diagonal, Mat6* to);

/// blocks[i] ← blocks[i] B for i < count.
void multiplyBy(const Mat6& B, Mat6* blocks, int count);
/// The same for an upper triangle B.
void multiplyByUpper(const Mat6& B, Mat6* blocks, int count);

/// products[k] ← G_k J_k over `count` pairs.
void multiplyRows(const Mat3* const* G, const Mat36* const* J, int count, Mat36* products);

/// to += Σ A_kᵀ B_k over `count` pairs.
void addProducts(const Mat36* const* A, const Mat36* const* B, int count, Mat6& to);

/// to += Σ weight[k] a_kᵀ b_k over `count` rows of six numbers, which begin `stride` numbers apart.
void addRowProducts(const double* a, const double* b, int stride, const double* weight, int count,
                    Mat6& to);

/// Columns of blocks below the diagonal: column j has blocks[begin[j]] up to blocks[begin[j + 1]],
/// in the rows row[…].
struct BlockColumns {
  int columns;
  const int *begin, *row;
  const Mat6* blocks;
};

/// Vectors of six numbers take the room of eight, so that they are read in the pieces in which they
/// were written. The last two numbers are never used.
constexpr int paddedSize = 8;

/// z ← L⁻¹ z, L = 1 + the blocks.
void solveLower(const BlockColumns& L, double* z);
/// The same for L = C + the blocks.
void solveLower(const BlockColumns& L, const Mat6* inverseC, double* z);
/// The same for a z with entries in few columns. `touched` marks these, and afterwards also the
/// columns to which they spread. Columns that are not touched are not read.
void solveLower(const BlockColumns& L, const Mat6* inverseC, char* touched, double* z);
/// z ← U⁻¹ z, U = D + the blocksᵀ.
void solveUpper(const BlockColumns& U, const Mat6* inverseD, double* z);

/// W[at[i]][at[j]] += y_iᵀ y_j for j ≤ i < count, with y_i of six numbers. `scratch`: room for 7
/// times `count` numbers, with `count` rounded up to a multiple of four.
void addSquares(const double* const* y, const int* at, int count, double* scratch,
                double* const* W);

}  // namespace delassus
