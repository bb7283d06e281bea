#pragma once

#include "delassus/wide.h"

namespace delassus {

/// Four numbers that an operation takes at once, at any address.
using Four = double __attribute__((vector_size(32), aligned(8), may_alias));

DELASSUS_WIDE_INLINE const Four& fourAt(const double* x) {
  return *reinterpret_cast<const Four*>(x);
}
DELASSUS_WIDE_INLINE Four& fourAt(double* x) { return *reinterpret_cast<Four*>(x); }

}  // namespace delassus
