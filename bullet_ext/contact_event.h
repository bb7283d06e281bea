#pragma once

#include "LinearMath/btVector3.h"
#include "delassus/active_set.h"

class btPersistentManifold;

namespace delassus {

/// What keeps a contact from being solved.
enum class Trouble : unsigned char {
  None,
  LeftOut,      ///< its numbers, or those of one of its bodies, are not finite or absurd
  OutOfBudget,  ///< the budget ended above the tolerance, and in its island the error is largest here
  Incompatible,  ///< no motion meets its demand and those of others: the nearest one is taken
};

/// A contact whose mode is not what it was after the step before, or that is in trouble.
///
/// `manifold` and `point` are good during the call only: Bullet moves and removes points between
/// steps. A point that the narrow phase has removed is not told here; Bullet's
/// gContactEndedCallback does that.
struct ContactEvent {
  btPersistentManifold* manifold;
  int point;  ///< index in the manifold
  Mode from, to;
  btVector3 reaction;  ///< on body 0 of the manifold, world axes, N·s
  Trouble trouble;     ///< the report says more in words
};

}  // namespace delassus
