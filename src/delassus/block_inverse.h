#pragma once

#include "delassus/types.h"

namespace delassus {

/// Inverses of the 6x6 pivot blocks of a factor, by vectors as wide as the processor allows. The
/// bits are the same on every processor (block_product.h).

/// A⁻¹, by elimination in the order of the columns, or with pivoting where that order loses digits.
/// `isNegative`: whether det A < 0. False if A is singular or not finite.
bool invert(const Mat6& A, Mat6& inverse, bool& isNegative);

/// C⁻¹ and its transpose, for the Cholesky factor C of a symmetric A = C Cᵀ; A may be one of them.
/// False if A is not positive definite, or not finite.
bool invertCholesky(const Mat6& A, Mat6& inverseC, Mat6& transposed);

}  // namespace delassus
