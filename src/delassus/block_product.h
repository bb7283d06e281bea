#pragma once

#include "delassus/types.h"

namespace delassus {

/// The products of 6x6 blocks that a block factor and its solutions are made of, nearly all of
/// their work. They run as wide as the processor allows; the bits are those of any other, since
/// nothing is fused and every sum is added in the same order.

/// What a column of a factor takes from another: that one's blocks, and B.
struct BlockSource {
  const Mat6* blocks;
  const Mat6* B;
};
constexpr int mostSources = 8;

/// diagonal −= blocks[0] Bᵀ, unless there is none (null), and to[place[row[i]]] −= blocks[i] Bᵀ for
/// 0 < i < count, of up to mostSources columns that have the same rows, one after the other.
void subtractProducts(const BlockSource* sources, int columns, const int* row, int count,
                      const int* place, Mat6* diagonal, Mat6* to);

/// blocks[i] ← blocks[i] B for i < count.
void multiplyBy(const Mat6& B, Mat6* blocks, int count);

/// to += Aᵀ B.
void addProduct(const Mat36& A, const Mat36& B, Mat6& to);

/// to += Σ weight[k] a_kᵀ b_k over `count` rows of six numbers, each `stride` numbers behind the
/// one before.
void addRowProducts(const double* a, const double* b, int stride, const double* weight, int count,
                    Mat6& to);

/// A⁻¹, by elimination in the order of the columns, or with pivoting where that loses digits.
/// `isNegative`: whether det A < 0. False if A is singular or not finite.
bool invert(const Mat6& A, Mat6& inverse, bool& isNegative);

/// Columns of blocks below the diagonal: those of column j are blocks[begin[j]] up to
/// blocks[begin[j + 1]], in rows row[…].
struct BlockColumns {
  int columns;
  const int *begin, *row;
  const Mat6* blocks;
};

/// Vectors of six numbers stand in the room of eight, so that they are read as they were written.
/// What is left of the room is read by nobody.
constexpr int paddedSize = 8;

/// z ← L⁻¹ z, L = 1 + the blocks.
void solveLower(const BlockColumns& L, double* z);
/// The same where z has entries in few columns: those that are `touched`, to which it adds what
/// they become part of. What is not touched is not read.
void solveLower(const BlockColumns& L, char* touched, double* z);
/// z ← U⁻¹ z, U = D + the blocksᵀ.
void solveUpper(const BlockColumns& U, const Mat6* inverseD, double* z);

/// W[at[i]][at[j]] += y_iᵀ A y_j for j ≤ i < count, y_i six numbers. `scratch`: room for 7 numbers
/// times `count`, rounded up to four.
void addSquares(const Mat6& A, const double* const* y, const int* at, int count, double* scratch,
                double* const* W);

}  // namespace delassus
