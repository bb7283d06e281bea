#pragma once

#include "LinearMath/btVector3.h"
#include "delassus/active_set.h"

class btPersistentManifold;

namespace delassus {

/// A contact whose mode is not what it was after the step before.
///
/// `manifold` and `point` are good during the call only: Bullet moves and removes points between
/// steps. A point that the narrow phase has removed is not told here; Bullet's
/// gContactEndedCallback does that.
struct ContactEvent {
  btPersistentManifold* manifold;
  int point;  ///< index in the manifold
  Mode from, to;
  btVector3 reaction;  ///< on body 0 of the manifold, world axes, N·s
};

}  // namespace delassus
