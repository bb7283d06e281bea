#pragma once

#include "LinearMath/btVector3.h"
#include "delassus/active_set.h"

class btPersistentManifold;

namespace delassus {

/// What keeps a contact from being solved.
enum class Trouble : unsigned char {
  None,
  LeftOut,  ///< its numbers, or those of one of its bodies, are not finite or absurd
  /// The budget ended above the tolerance, and in its island the error is largest here.
  OutOfBudget,
  /// No motion meets its demand and those of others, and the nearest one is taken; or that which
  /// does would throw a body (thrown_bodies.h).
  Incompatible,
};

/// A contact whose mode is not what it was after the step before, that is in trouble, or that
/// resists turning.
///
/// What acts on body 0 is the `reaction` at its point and the `moment` of rolling and spinning
/// friction; body 1 feels the opposite. Both are sums over the step: divided by it they are N and
/// N·m. With the point's normal n, n·moment is the spinning part and the rest the rolling one.
///
/// `manifold` and `point` are good during the call only: Bullet moves and removes points between
/// steps. A point that the narrow phase has removed is not told here; Bullet's
/// gContactEndedCallback does that.
struct ContactEvent {
  btPersistentManifold* manifold;
  int point;  ///< index in the manifold
  Mode from, to;
  btVector3 reaction;  ///< on body 0 of the manifold, world axes, N·s
  btVector3 moment;    ///< the same, N·m·s; zero without rolling and spinning friction
  Trouble trouble;     ///< the report says more in words
};

}  // namespace delassus
