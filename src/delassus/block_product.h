#pragma once

#include "delassus/types.h"

namespace delassus {

/// to[place[row[i]]] −= blocks[i] Bᵀ for i < count: what one column of a block factor takes from another, nearly all of a
/// factorisation's work. Runs as wide as the processor allows; the bits are those of any other, since nothing is fused and
/// every sum is added in the same order.
void subtractProducts(const Mat6* blocks, const int* row, int count, const Mat6& B,
                      const int* place, Mat6* to);

}  // namespace delassus
