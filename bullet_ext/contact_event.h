#pragma once

#include "LinearMath/btVector3.h"
#include "delassus/active_set.h"

class btPersistentManifold;

namespace delassus {

/// Why a contact was not solved.
enum class Trouble : unsigned char {
  None,
  LeftOut,  ///< its numbers, or those of one of its bodies, are not finite or absurd
  /// The budget ended above the tolerance, and in its island the error is largest here.
  OutOfBudget,
  /// No motion meets its demand together with those of others, and a compromise is taken; or
  /// the motion that meets them would throw or wedge a body (soft_answer.h).
  Incompatible,
};

/// A contact that changed mode since the step before, is in trouble, or resists turning.
///
/// Body 0 feels the `reaction` at the point and the `moment` of rolling and spinning friction; body
/// 1 feels the opposite. Both are sums over the step: divided by its length they are N and N·m.
/// With the point's normal n, n·moment is the spinning part, and the rest is the rolling part.
///
/// `manifold` and `point` are good only during the call: Bullet moves and removes points between
/// steps. Points that the narrow phase has removed are not reported here, but by Bullet's
/// gContactEndedCallback.
struct ContactEvent {
  btPersistentManifold* manifold;
  int point;  ///< index in the manifold
  Mode from, to;
  btVector3 reaction;  ///< on body 0 of the manifold, world axes, N·s
  btVector3 moment;    ///< the same, N·m·s; zero without rolling and spinning friction
  Trouble trouble;     ///< the report explains it in words
};

}  // namespace delassus
