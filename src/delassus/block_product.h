#pragma once

#include "delassus/types.h"

namespace delassus {

/// The products of 6x6 blocks that a block factor and its solutions are made of, nearly all of their work. They run as wide as the
/// processor allows; the bits are those of any other, since nothing is fused and every sum is added in the same order.

/// to[place[row[i]]] −= blocks[i] Bᵀ for i < count: what one column of a factor takes from another.
void subtractProducts(const Mat6* blocks, const int* row, int count, const Mat6& B,
                      const int* place, Mat6* to);

/// Columns of blocks below the diagonal: those of column j are blocks[begin[j]] up to blocks[begin[j + 1]], in rows row[…].
struct BlockColumns {
  int columns;
  const int *begin, *row;
  const Mat6* blocks;
};

/// Vectors of six numbers stand in the room of eight, so that they are read as they were written. What is left of the room is read by
/// nobody.
constexpr int paddedSize = 8;

/// z ← L⁻¹ z, L = 1 + the blocks.
void solveLower(const BlockColumns& L, double* z);
/// z ← U⁻¹ z, U = D + the blocksᵀ.
void solveUpper(const BlockColumns& U, const Mat6* inverseD, double* z);

}  // namespace delassus
